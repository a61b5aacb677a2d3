//! Intersections, normals and texture coordinates. `block` intersects boxes (`cuboid`), cylinders and capsules along their own axes.

pub(crate) mod block;
mod capsule;
mod cuboid;
mod cylinder;
pub(crate) mod plane;
pub(crate) mod solid_distance;
pub(crate) mod sphere;

use crate::lanes::*;

pub(crate) struct TexturePoint<S: Isa> {
    /// Relative to the object's centre, along its own axes, in scene units.
    pub own: Vec3x<S>,
    /// The normal, of length 1, with either sign.
    pub n: Vec3x<S>,
}
