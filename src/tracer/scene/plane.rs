use super::Material;
use super::ranges::{EXTENT, POINT};
use crate::range_error::{Checked, RangeError};
use glam::Vec3;

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
