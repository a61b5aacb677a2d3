//! Boxes and cylinders with any orientation.

use super::validate::{EXTENTS, POINT, UNIT};
use super::{Material, Shape};
use glam::{Mat3A, Vec3A};

fields! {
    /// A box, or a cylinder with flat ends. If its material is transparent, rays enter and leave it, refracted at each side.
    pub struct Block in "" {
        /// Whether it is a box or a cylinder.
        shape: Shape = Shape::Box;
        /// The centre, in scene units.
        centre: Vec3A, in POINT;
        /// Half the extent along each of the block's own axes, [`MIN_LENGTH`](super::MIN_LENGTH) to
        /// [`MAX_LENGTH`](super::MAX_LENGTH). A cylinder stands along its own y axis; `half.x` is its radius, and `half.z` has to be
        /// the same.
        half: Vec3A, in EXTENTS, if |it| it.is_round() => "the same along x and z of a cylinder";
        /// The block's own axes in scene coordinates: three perpendicular vectors of length 1. The identity aligns it with the
        /// scene's axes.
        axes: Mat3A = Mat3A::IDENTITY, in UNIT;
        /// The surface.
        material: Material;
    }
}

impl Block {
    /// Whether it is as wide as it is deep, if it is a cylinder.
    fn is_round(&self) -> bool {
        match self.shape {
            Shape::Box => true,
            Shape::Cylinder => self.half.x == self.half.z,
        }
    }
}
