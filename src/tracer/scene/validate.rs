use super::{Block, Light, Plane, Scene, Softbox, Sphere};
use crate::range_error::{Checked, Range, RangeError};
use glam::Vec3;

/// The largest coordinate and extent, in scene units: a few times its square is finite in f32.
pub const MAX_LENGTH: f32 = 1e9;
/// The smallest radius and extent, in scene units: its square is a normal number.
pub const MIN_LENGTH: f32 = 1e-9;

pub(super) const POINT: Range = Range(-MAX_LENGTH, MAX_LENGTH, "-1e9 to 1e9");
pub(super) const EXTENT: Range = Range(MIN_LENGTH, MAX_LENGTH, "1e-9 to 1e9");
pub(super) const LENGTH: Range = Range(0.0, MAX_LENGTH, "0 to 1e9");
pub(super) const SHARE: Range = Range(0.0, 1.0, "0 to 1");
pub(super) const SIGNED: Range = Range(-1.0, 1.0, "-1 to 1");
pub(super) const THOUSAND: Range = Range(0.0, 1e3, "0 to 1000");

pub(super) fn is_unit(v: Vec3) -> bool {
    (v.length() - 1.0).abs() < 1e-4
}

pub(super) fn each<T>(
    object: &'static str,
    items: &[T],
    check: fn(&T, Checked) -> Result<(), RangeError>,
) -> Result<(), RangeError> {
    let mut items = items.iter().enumerate();
    items.try_for_each(|(i, item)| {
        let index = Some(i);
        check(item, Checked { object, index })
    })
}

impl Scene {
    /// Checks the ranges of all numbers.
    ///
    /// # Errors
    /// The first number out of range.
    pub fn validate(&self) -> Result<(), RangeError> {
        let zenith = self.background + self.sky;
        let sky = "-background to 1e9 - background";
        self.camera.check(Checked::one("camera"))?;
        Checked::one("background").field("", self.background, LENGTH)?;
        Checked::one("sky").rule("", self.sky, LENGTH.contains(zenith), sky)?;
        Checked::one("haze").field("", self.haze, THOUSAND)?;
        Checked::one("haze_fall").field("", self.haze_fall, THOUSAND)?;
        Checked::one("scatter").field("", self.scatter, SHARE)?;
        Checked::one("exposure").field("", self.exposure, Range(0.0, 11.0, "0 to 11"))?;
        self.film.check(Checked::one("film"))?;
        Checked::one("ambient").field("", self.ambient, LENGTH)?;
        self.ambience.check(Checked::one("ambience"))?;
        each("spheres", &self.spheres, Sphere::check)?;
        each("planes", &self.planes, Plane::check)?;
        self.water.check(Checked::one("water"))?;
        each("blocks", &self.blocks, Block::check)?;
        each("lights", &self.lights, Light::check)?;
        each("softboxes", &self.softboxes, Softbox::check)
    }
}
