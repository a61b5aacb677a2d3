//! Intersections, normals and texture coordinates. `block` intersects boxes (`cuboid`), cylinders
//! and capsules along their own axes.

pub(crate) mod block;
mod capsule;
mod cuboid;
mod cylinder;
pub(crate) mod plane;
pub(crate) mod solid_distance;
pub(crate) mod sphere;
mod texture_point;

pub(crate) use texture_point::TexturePoint;
