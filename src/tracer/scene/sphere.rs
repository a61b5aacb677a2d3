use super::Material;
use super::ranges::{EXTENT, POINT};
use crate::range_error::{Checked, RangeError};
use glam::Vec3;

/// A sphere. Shadow rays treat it as hollow: a light wholly inside illuminates its inside, and the outside only through
/// [`Material::tint`].
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
