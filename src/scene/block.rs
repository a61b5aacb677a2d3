//! Boxes and cylinders with any orientation.

use super::Material;
use glam::{Mat3A, Vec3A};

/// A box, or a cylinder with flat ends. If its material is transparent, rays enter and leave it, refracted at each side.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Block {
    /// The centre, in scene units.
    pub centre: Vec3A,
    /// Half the extent along each of the block's own axes, [`MIN_LENGTH`](super::MIN_LENGTH) to
    /// [`MAX_LENGTH`](super::MAX_LENGTH). A cylinder stands along its own y axis; `half.x` is its radius, and `half.z` has to be
    /// the same.
    pub half: Vec3A,
    /// The block's own axes in scene coordinates: three perpendicular vectors of length 1. The identity aligns it with the
    /// scene's axes.
    pub axes: Mat3A,
    /// Whether it is a box or a cylinder.
    pub shape: Shape,
    /// The surface.
    pub material: Material,
}

/// The shape of a [`Block`].
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Shape {
    /// A box.
    #[default]
    Box,
    /// A cylinder about the block's own y axis.
    Cylinder,
}
