//! Ambient light that varies from point to point.

use super::ranges::{LENGTH, SHARE};
use crate::range_error::{Checked, RangeError};
use glam::Vec3;

/// Ambient light from a sky above and a ground below, which near solids occlude and reflect.
///
/// A surface with the normal n receives
/// `open (sky (1 + n.y) / 2 + ground (1 - n.y) / 2) + bounced`. Here `sky` is
/// [`Scene::ambient`](super::Scene::ambient), and `open` is the product of the shares of the
/// hemisphere, weighted by the cosine, that each solid leaves uncovered. A covering solid reflects
/// the light on its side that faces the point.
///
/// A sphere's share is exact above the horizon (Quilez, "sphere ambient occlusion") and fades to 0
/// at `reach` from the sphere. A block's share is estimated from its distances from two points on
/// the normal. Glass covers `1 - kt` of its share. Near the first plane the light from below fades.
/// Not covered are points inside solids, and rays with a weight up to [`Ambience::FAINT`] or a
/// depth of 2 or more.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(default, deny_unknown_fields))]
pub struct Ambience {
    /// The factor on the shares that solids cover, 0 to 1. At 0 the ambient light is uniform.
    pub occlusion: f32,
    /// The largest distance at which solids cover light, in scene units, 0 to 1e9.
    pub reach: f32,
    /// The ambient light from below, 0 to 1e9 in each channel.
    pub ground: Vec3,
    /// The factor on the light that covering solids reflect, 0 to 1.
    pub bounce: f32,
}

impl Ambience {
    /// The largest weight of rays whose ambient light is not occluded.
    pub const FAINT: f32 = 0.1;

    /// Uniform light.
    pub const UNIFORM: Self = Self { occlusion: 0.0, reach: 0.0, ground: Vec3::ZERO, bounce: 0.0 };

    pub(super) fn check(&self, of: Checked) -> Result<(), RangeError> {
        of.field("occlusion", self.occlusion, SHARE)?;
        of.field("reach", self.reach, LENGTH)?;
        of.field("ground", self.ground, LENGTH)?;
        of.field("bounce", self.bounce, SHARE)
    }
}
