//! Boxes, cylinders and capsules with any orientation.

use super::validate::{EXTENTS, POINT, UNIT};
use super::{Material, Shape};
use glam::{Mat3A, Vec3A};

fields! {
    /// A box, a cylinder with flat ends, or a capsule, whose ends are half spheres. If its material is transparent, rays enter and leave it, refracted at each side.
    pub struct Block in "" {
        /// Whether it is a box, a cylinder or a capsule.
        shape: Shape = Shape::Box;
        /// The centre, in scene units.
        centre: Vec3A, in POINT;
        /// Half the extent along each of the block's own axes, [`MIN_LENGTH`](super::MIN_LENGTH) to
        /// [`MAX_LENGTH`](super::MAX_LENGTH). A cylinder or a capsule stands along its own y axis; `half.x` is its radius, and
        /// `half.z` has to be the same. `half.y` of a capsule, which is at least that, includes an end.
        half: Vec3A, in EXTENTS, if |it| it.is_round() => "the same along x and z if it is round, and as much along y of a capsule";
        /// The block's own axes in scene coordinates: three perpendicular vectors of length 1. The identity aligns it with the
        /// scene's axes.
        axes: Mat3A = Mat3A::IDENTITY, in UNIT;
        /// The surface.
        material: Material;
    }
}

impl Block {
    /// A block along the axes of the scene, by its centre and half its extents.
    #[must_use]
    pub const fn new(shape: Shape, centre: Vec3A, half: Vec3A, material: Material) -> Self {
        Self {
            shape,
            centre,
            half,
            axes: Mat3A::IDENTITY,
            material,
        }
    }

    /// Whether it is as wide as it is deep, if it is round, and a capsule long enough for its ends.
    fn is_round(&self) -> bool {
        match self.shape {
            Shape::Box => true,
            Shape::Cylinder => self.half.x == self.half.z,
            Shape::Capsule => self.half.x == self.half.z && self.half.x <= self.half.y,
        }
    }
}
