//! The shapes: for each its intersection, normal and texture coordinates. `prepare` builds the bounding volume hierarchy of them,
//! `trace` the packets of rays.
//!
//! | shape | file |
//! | --- | --- |
//! | sphere | `sphere` |
//! | plane: a horizontal rectangle | `plane` |
//! | block: a box, a cylinder or a capsule with any orientation | `block` transforms rays to the block's own axes |
//! | box (`box` is a reserved word of Rust) | `cuboid` |
//! | cylinder | `cylinder` |
//! | capsule: a cylinder with a half sphere at each end | `capsule` |

pub(crate) mod block;
mod capsule;
mod cuboid;
mod cylinder;
pub(crate) mod plane;
pub(crate) mod sphere;

use crate::lanes::*;

/// The points of a packet at which textures are evaluated.
pub(crate) struct TexturePoint<S: Isa> {
    /// The point relative to the object's centre, along the object's own axes, in scene units.
    pub own: Vec3x<S>,
    /// The normal, of length 1, with either sign.
    pub n: Vec3x<S>,
}
