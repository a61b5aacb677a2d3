//! The shapes that rays meet. What only one shape knows is in a file of its own; what is made of it, for all shapes alike, is in the
//! stages: the tree and the outlines in `prepare`, the packets' way through the scene in `trace`.
//!
//! | shape | file |
//! | --- | --- |
//! | a sphere | `sphere` |
//! | a plane: a horizontal rectangle | `plane` |
//! | a block: a box, a cylinder or a capsule with any orientation | `block`, which has what these share: the coordinates along a block's own axes, in which it asks the three below |
//! | a box, whose word Rust reserves | `cuboid` |
//! | a cylinder | `cylinder` |
//! | a capsule: a cylinder with a half sphere at each end | `capsule` |
//!
//! Functions of the same name answer the same question. Kernels are generic over lanes, as `lanes` says.

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
