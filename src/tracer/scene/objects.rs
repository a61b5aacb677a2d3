//! Spheres, planes and blocks.

use super::Material;
use super::ranges::{EXTENT, POINT, is_unit};
use crate::range_error::{Checked, RangeError};
use glam::{Mat3, Vec3};

/// A sphere. Shadow rays treat it as hollow: a light wholly inside illuminates its inside, and the
/// outside only through [`Material::tint`].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(deny_unknown_fields))]
pub struct Sphere {
    /// The centre in scene units, coordinates -1e9 to 1e9.
    pub centre: Vec3,
    /// The radius in scene units, 1e-9 to 1e9.
    pub radius: f32,
    /// The surface.
    pub material: Material,
}

impl Sphere {
    /// Returns a sphere.
    #[must_use]
    pub const fn new(centre: Vec3, radius: f32, material: Material) -> Self {
        Self { centre, radius, material }
    }

    pub(super) fn check(&self, of: Checked) -> Result<(), RangeError> {
        of.field("centre", self.centre, POINT)?;
        of.field("radius", self.radius, EXTENT)?;
        self.material.check(of)
    }
}

/// A horizontal rectangle, visible from both sides. It casts a black shadow, whatever its `tint`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(deny_unknown_fields))]
pub struct Plane {
    /// The centre in scene units, coordinates -1e9 to 1e9.
    pub centre: Vec3,
    /// Half the extent along x in scene units, 1e-9 to 1e9.
    pub half_x: f32,
    /// Half the extent along z, 1e-9 to 1e9.
    pub half_z: f32,
    /// The surface.
    pub material: Material,
}

impl Plane {
    /// Returns a rectangle.
    #[must_use]
    pub const fn new(centre: Vec3, half_x: f32, half_z: f32, material: Material) -> Self {
        Self { centre, half_x, half_z, material }
    }

    pub(super) fn check(&self, of: Checked) -> Result<(), RangeError> {
        of.field("centre", self.centre, POINT)?;
        of.field("half_x", self.half_x, EXTENT)?;
        of.field("half_z", self.half_z, EXTENT)?;
        self.material.check(of)
    }
}

/// A box, cylinder or capsule. Transparent blocks refract entering and leaving rays.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(deny_unknown_fields))]
pub struct Block {
    /// The shape.
    #[cfg_attr(feature = "serde", serde(default))]
    pub shape: Shape,
    /// The centre in scene units, coordinates -1e9 to 1e9.
    pub centre: Vec3,
    /// Half the extent along each of the block's own axes, 1e-9 to 1e9. Cylinders and capsules are
    /// along y; their radius is `half.x`, equal to `half.z`. A capsule's `half.y` includes an end,
    /// so it is at least the radius.
    pub half: Vec3,
    /// The block's own axes in scene coordinates: three perpendicular vectors of length 1.
    #[cfg_attr(feature = "serde", serde(default))]
    pub axes: Mat3,
    /// The surface.
    pub material: Material,
}

impl Block {
    /// Returns a block aligned with the scene.
    #[must_use]
    pub const fn new(shape: Shape, centre: Vec3, half: Vec3, material: Material) -> Self {
        Self { shape, centre, half, axes: Mat3::IDENTITY, material }
    }

    pub(super) fn check(&self, of: Checked) -> Result<(), RangeError> {
        let is_equal = self.half.x == self.half.z;
        let is_high = self.half.x <= self.half.y;
        let (is_valid, range) = match self.shape {
            Shape::Box => (true, ""),
            Shape::Cylinder => (is_equal, "equal in x and z"),
            Shape::Capsule => (is_equal && is_high, "equal in x and z, and no smaller in y"),
        };
        of.field("centre", self.centre, POINT)?;
        of.field("half", self.half, EXTENT)?;
        of.rule("half", self.half, is_valid, range)?;
        let square = "of length 1, perpendicular to the others";
        let [x, y, z] = [0, 1, 2].map(|i| self.axes.col(i));
        for (name, axis, next) in
            [("axes.x_axis", x, y), ("axes.y_axis", y, z), ("axes.z_axis", z, x)]
        {
            let is_square = is_unit(axis) && axis.dot(next).abs() < 1e-4;
            of.rule(name, axis, is_square, square)?;
        }
        self.material.check(of)
    }
}

/// The shape of a [`Block`].
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub enum Shape {
    /// A box.
    #[default]
    Box,
    /// A cylinder along the block's own y axis, with flat ends.
    Cylinder,
    /// A cylinder along the block's own y axis with a half sphere at each end.
    Capsule,
}
