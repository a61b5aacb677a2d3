use super::ranges::{EXTENT, LENGTH, POINT};
use crate::range_error::{Checked, Range, RangeError};
use crate::zero::Zero;
use core::f32::consts::PI;
use glam::Vec3;

/// A light whose brightness does not fall off with distance.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(default, deny_unknown_fields))]
pub struct Light {
    /// The position in scene units, coordinates -1e9 to 1e9.
    pub position: Vec3,
    /// The colour times the brightness, 0 to 1e9 in each channel.
    pub colour: Vec3,
    /// The radius of the visible light, 1e-9 to 1e9; 0 makes it invisible. Lights cast no shadows,
    /// and haze does not dim them.
    pub drawn_radius: f32,
    /// Whether the rays are nearly parallel: `position`, `diameter`, `glow` and `core` are
    /// multiplied by [`Light::FAR`], and the light is invisible.
    pub parallel: bool,
    /// The diameter for shadows, 0 to 1e9. Above 0, solids cast penumbrae coloured by their `tint`;
    /// at 0 shadows are hard and black.
    pub diameter: f32,
    /// The radius of the glow, 0 to 1e9. A ray through the position sees the light's colour, a ray
    /// at this distance half of it; far away the glow falls off with the squared distance. An
    /// object hides the glow behind it. The glow of a parallel light is the sun's disc.
    pub glow: f32,
    /// The radius of a sphere from which the glow's distances count, 0 to 1e9, for the rim of air
    /// around a planet, or a corona. The glow is as bright as the light where the ray is nearest to
    /// the position. The cone of a spotlight that aims at the sun restricts it to the sun's side.
    pub core: f32,
    /// The cone of a spotlight; `None` shines in all directions.
    pub spot: Option<Spot>,
}

default!(
    /// A white light above and to the left of the default camera.
    Light = Self::new(Vec3::new(-2.0, 3.0, 2.0), Vec3::ONE)
);

zero! { Light { position, colour, drawn_radius, parallel, diameter, glow, core, spot } }

impl Light {
    /// The factor on lengths of parallel lights: across a scene as wide as the distance to
    /// `position`, rays differ by at most 0.001 radians.
    pub const FAR: f32 = 1000.0;

    /// Black and invisible.
    pub const DARK: Self = Self::ZERO;

    /// Returns an invisible point light.
    #[must_use]
    pub const fn new(position: Vec3, colour: Vec3) -> Self {
        Self { position, colour, ..Self::DARK }
    }

    /// Returns a sun in the direction of `position` from the origin.
    #[must_use]
    pub const fn sun(position: Vec3, colour: Vec3) -> Self {
        Self { parallel: true, ..Self::new(position, colour) }
    }

    /// Returns a spotlight, see [`Spot::new`].
    #[must_use]
    pub const fn spotlight(position: Vec3, aim: Vec3, outer_angle: f32, colour: Vec3) -> Self {
        Self { spot: Some(Spot::new(aim, outer_angle)), ..Self::new(position, colour) }
    }

    pub(crate) fn far(&self) -> f32 {
        if self.parallel { Self::FAR } else { 1.0 }
    }

    /// Returns the upper limit of a penumbra's width at its occluder: for parallel rays the width
    /// at four times the distance of `position`.
    pub(crate) fn max_penumbra(&self) -> f32 {
        if self.parallel { 4.0 * self.diameter } else { self.diameter }
    }

    /// Returns whether the light has neither a diameter nor a cone, and is not parallel.
    pub(crate) fn is_point(&self) -> bool {
        self.diameter == 0.0 && !self.parallel && self.spot.is_none()
    }

    pub(super) fn check(&self, of: Checked) -> Result<(), RangeError> {
        let is_drawable = self.drawn_radius == 0.0 || EXTENT.contains(self.drawn_radius);
        of.field("position", self.position, POINT)?;
        of.field("colour", self.colour, LENGTH)?;
        of.rule("drawn_radius", self.drawn_radius, is_drawable, "0 or 1e-9 to 1e9")?;
        of.field("diameter", self.diameter, LENGTH)?;
        of.field("glow", self.glow, LENGTH)?;
        of.field("core", self.core, LENGTH)?;
        self.spot.map_or(Ok(()), |spot| spot.check(of))
    }
}

/// The cone of a spotlight, with a soft edge.
///
/// Between the angles the brightness is `s^2 (3 - 2 s)`, where s rises linearly with the cosine of
/// the angle.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(default, deny_unknown_fields))]
pub struct Spot {
    /// The direction of the light, of any length above 0.
    pub aim: Vec3,
    /// The angle from `aim` in radians up to which the brightness is 1, at least 0 and below
    /// `outer_angle`.
    pub inner_angle: f32,
    /// The angle from `aim` in radians from which the brightness is 0, up to pi.
    pub outer_angle: f32,
}

default!(
    /// Points down, with an outer angle of 30 degrees.
    Spot = Self::new(Vec3::NEG_Y, PI / 6.0)
);

impl Spot {
    /// Returns a cone whose inner angle is three quarters of the outer one.
    #[must_use]
    pub const fn new(aim: Vec3, outer_angle: f32) -> Self {
        Self { aim, inner_angle: 0.75 * outer_angle, outer_angle }
    }

    pub(super) fn check(&self, of: Checked) -> Result<(), RangeError> {
        let is_aimed = self.aim.normalize_or_zero() != Vec3::ZERO;
        let is_narrower = 0.0 <= self.inner_angle && self.inner_angle < self.outer_angle;
        let angle = Range(0.0, PI, "0 to pi");
        of.field("spot.aim", self.aim, POINT)?;
        of.rule("spot.aim", self.aim, is_aimed, "longer than 0")?;
        of.field("spot.outer_angle", self.outer_angle, angle)?;
        let narrower = "at least 0 and below outer_angle";
        of.rule("spot.inner_angle", self.inner_angle, is_narrower, narrower)
    }
}
