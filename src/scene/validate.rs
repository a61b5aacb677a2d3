//! Which scenes are within the tracer's limits.

use super::{Block, Camera, Caption, Light, Material, Pattern, Plane, Scene, Shape, Sphere, Waves};
use crate::flaw::{Checked, Flaw};
use glam::Vec3A;

/// The largest coordinate and the largest extent, in scene units: their squares, times a few, stay finite in f32.
pub const MAX_LENGTH: f32 = 1e9;
/// The smallest radius and the smallest extent: their squares stay normal numbers.
pub const MIN_LENGTH: f32 = 1e-9;

const POINT: &str = "coordinates from -1e9 to 1e9";
const EXTENT: &str = "a length from 1e-9 to 1e9";
const EXTENTS: &str = "lengths from 1e-9 to 1e9";
const COLOUR: &str = "channels from 0 to 1e9";
const UNIT: &str = "a direction of length 1";
const HAZE: &str = "0 to 1000";
const FADE: &str = "-10 to 1";
const SHARE: &str = "0 to 1";
const SHARES: &str = "channels from 0 to 1";

impl Scene {
    /// Whether every number of the scene is in the range that its documentation says.
    ///
    /// A scene that is valid gives the picture that [`crate::limits`] promises. One that is not gives some picture, in
    /// bounded time.
    ///
    /// # Errors
    /// The first number that is out of its range, by the name that it has in a program.
    pub fn validate(&self) -> Result<(), Flaw> {
        self.camera.validate()?;
        self.validate_air()?;
        self.validate_method()?;
        self.water.validate()?;
        each("captions", &self.captions, Caption::validate)?;
        each("spheres", &self.spheres, Sphere::validate)?;
        each("planes", &self.planes, Plane::validate)?;
        each("lights", &self.lights, Light::validate)?;
        each("blocks", &self.blocks, Block::validate)
    }

    fn validate_air(&self) -> Result<(), Flaw> {
        let field = |name, found: Vec3A, takes, is_in_range| {
            Checked::one(name).field("", found, takes, is_in_range)
        };
        let (background, ambient) = (self.background, self.ambient);
        field("background", background, COLOUR, is_colour(background))?;
        let is_sky = is_colour(background + self.sky);
        let takes = "what leaves the background's channels at 0 to 1e9 when it is added";
        field("sky", self.sky, takes, is_sky)?;
        field("ambient", ambient, COLOUR, is_colour(ambient))?;
        let is_haze = (0.0..=1e3).contains(&self.haze);
        Checked::one("haze").field("", self.haze, HAZE, is_haze)?;
        let is_fade = (-10.0..=1.0).contains(&self.fade);
        Checked::one("fade").field("", self.fade, FADE, is_fade)?;
        let film = Checked::one("film");
        film.share("shoulder", self.film.shoulder)?;
        film.share("vignette", self.film.vignette)?;
        film.share("dither", self.film.dither)?;
        film.share("tolerance", self.film.tolerance)
    }

    fn validate_method(&self) -> Result<(), Flaw> {
        let (checked, method) = (Checked::one("method"), self.method);
        checked.share("points", method.points)?;
        checked.share("squares", method.squares)?;
        checked.share("picture", method.picture)?;
        let is_side = (0.0..=32.0).contains(&method.coarse);
        checked.field("coarse", method.coarse, "0 to 32", is_side)?;
        checked.share("front", method.front)
    }
}

/// Validates each item of one of a scene's lists.
fn each<T>(
    list: &'static str,
    items: &[T],
    validate: impl Fn(&T, Checked) -> Result<(), Flaw>,
) -> Result<(), Flaw> {
    let mut items = items.iter().enumerate();
    items.try_for_each(|(i, item)| validate(item, Checked::item(list, i)))
}

impl Camera {
    fn validate(&self) -> Result<(), Flaw> {
        let camera = Checked::one("camera");
        camera.point("eye", self.eye)?;
        camera.point("look_at", self.look_at)?;
        let forward = (self.look_at - self.eye).normalize_or_zero();
        let takes = "a point that is not the eye";
        camera.field("look_at", self.look_at, takes, forward != Vec3A::ZERO)?;
        // Within a thousandth of the line of sight, rounding decides where the picture's sides are.
        let across = forward.cross(self.up.normalize_or_zero()).length();
        let takes = "a direction that is not along the line of sight";
        camera.field("up", self.up, takes, across > 1e-3)?;
        let angle = self.field_of_view;
        let is_angle = angle > 0.0 && angle < core::f32::consts::PI;
        camera.field("field_of_view", angle, "radians between 0 and pi", is_angle)
    }
}

impl Caption {
    fn validate(&self, caption: Checked) -> Result<(), Flaw> {
        caption.share("middle", self.middle)?;
        caption.share("size", self.size)?;
        caption.share("brightness", self.brightness)
    }
}

impl Sphere {
    fn validate(&self, sphere: Checked) -> Result<(), Flaw> {
        sphere.point("centre", self.centre)?;
        sphere.extent("radius", self.radius)?;
        self.material.validate(sphere)
    }
}

impl Plane {
    fn validate(&self, plane: Checked) -> Result<(), Flaw> {
        plane.point("centre", self.centre)?;
        plane.extent("half_x", self.half_x)?;
        plane.extent("half_z", self.half_z)?;
        self.material.validate(plane)
    }
}

impl Light {
    fn validate(&self, light: Checked) -> Result<(), Flaw> {
        light.point("position", self.position)?;
        light.field("colour", self.colour, COLOUR, is_colour(self.colour))?;
        let (radius, size) = (self.radius, self.size);
        let takes = "0, or a length from 1e-9 to 1e9";
        light.field("radius", radius, takes, radius == 0.0 || is_extent(radius))?;
        let is_size = (0.0..=MAX_LENGTH).contains(&size);
        light.field("size", size, "a length from 0 to 1e9", is_size)?;
        let is_glow = (0.0..=MAX_LENGTH).contains(&self.glow);
        light.field("glow", self.glow, "a length from 0 to 1e9", is_glow)?;
        let Some(spot) = self.spot else {
            return Ok(());
        };
        light.field("spot.aim", spot.aim, UNIT, is_unit(spot.aim))?;
        let (dark, bright) = (spot.dark, spot.bright);
        let is_bright = (-1.0..=1.0).contains(&bright);
        light.field("spot.bright", bright, "a cosine, -1 to 1", is_bright)?;
        let takes = "a cosine of at least -1 that is below the one of bright";
        light.field("spot.dark", dark, takes, dark >= -1.0 && dark < bright)
    }
}

impl Block {
    fn validate(&self, block: Checked) -> Result<(), Flaw> {
        block.point("centre", self.centre)?;
        let half = self.half;
        let is_block = half.to_array().into_iter().all(is_extent);
        block.field("half", half, EXTENTS, is_block)?;
        let takes = "the same along x and z of a cylinder";
        block.field(
            "half",
            half,
            takes,
            self.shape == Shape::Box || half.x == half.z,
        )?;
        let [x, y, z] = [0, 1, 2].map(|i| self.axes.col(i));
        for (name, axis, next) in [
            ("axes.x_axis", x, y),
            ("axes.y_axis", y, z),
            ("axes.z_axis", z, x),
        ] {
            block.field(name, axis, UNIT, is_unit(axis))?;
            let takes = "a direction square to the other axes";
            block.field(name, axis, takes, axis.dot(next).abs() < 1e-4)?;
        }
        self.material.validate(block)
    }
}

impl Material {
    fn validate(&self, object: Checked) -> Result<(), Flaw> {
        let colour = self.colour;
        object.field("material.colour", colour, COLOUR, is_colour(colour))?;
        object.share("material.kd", self.kd)?;
        object.share("material.ks", self.ks)?;
        let is_exponent = (1.0..=1000.0).contains(&self.exponent);
        object.field("material.exponent", self.exponent, "1 to 1000", is_exponent)?;
        object.share("material.metallic", self.metallic)?;
        object.share("material.anisotropy", self.anisotropy)?;
        object.share("material.kr", self.kr)?;
        object.share("material.fresnel", self.fresnel)?;
        object.share("material.kt", self.kt)?;
        let is_index = self.kt == 0.0 || (0.1..=10.0).contains(&self.index);
        let takes = "0.1 to 10 where kt is above 0";
        object.field("material.index", self.index, takes, is_index)?;
        let is_tint = self.tint.to_array().into_iter().all(is_share);
        object.field("material.tint", self.tint, SHARES, is_tint)?;
        self.pattern.validate(object)
    }
}

impl Waves {
    fn validate(&self) -> Result<(), Flaw> {
        let water = Checked::one("water");
        let is_slope = (0.0..=0.1).contains(&self.slope);
        water.field("slope", self.slope, "0 to 0.1", is_slope)?;
        let is_length = is_extent(self.length) || self.are_calm() && self.length == 0.0;
        water.field("length", self.length, EXTENT, is_length)?;
        let is_phase = self.phase.abs() <= 1e6;
        water.field("phase", self.phase, "-1e6 to 1e6", is_phase)
    }
}

impl Pattern {
    fn validate(&self, object: Checked) -> Result<(), Flaw> {
        let is_number = |x: f32| (0.0..=1e3).contains(&x);
        let number = |name, x| object.field(name, x, "0 to 1000", is_number(x));
        let are_waves = self.waves.to_array().into_iter().all(is_number);
        let takes = "numbers from 0 to 1000";
        object.field("material.pattern.waves", self.waves, takes, are_waves)?;
        object.share("material.pattern.depth", self.depth)?;
        number("material.pattern.edge", self.edge)?;
        let is_balance = (-1.0..=1.0).contains(&self.balance);
        object.field(
            "material.pattern.balance",
            self.balance,
            "-1 to 1",
            is_balance,
        )?;
        number("material.pattern.warp", self.warp)?;
        number("material.pattern.grain", self.grain)
    }
}

/// What several kinds of objects have.
impl Checked {
    fn point(self, field: &'static str, v: Vec3A) -> Result<(), Flaw> {
        let is_point = v.to_array().iter().all(|c| c.abs() <= MAX_LENGTH);
        self.field(field, v, POINT, is_point)
    }

    fn extent(self, field: &'static str, length: f32) -> Result<(), Flaw> {
        self.field(field, length, EXTENT, is_extent(length))
    }

    fn share(self, field: &'static str, share: f32) -> Result<(), Flaw> {
        self.field(field, share, SHARE, is_share(share))
    }
}

fn is_unit(v: Vec3A) -> bool {
    (v.length() - 1.0).abs() < 1e-4
}

fn is_extent(length: f32) -> bool {
    (MIN_LENGTH..=MAX_LENGTH).contains(&length)
}

fn is_share(share: f32) -> bool {
    (0.0..=1.0).contains(&share)
}

/// Bright lights are above 1; nothing is above what f32 can multiply.
fn is_colour(v: Vec3A) -> bool {
    v.to_array().iter().all(|c| (0.0..=1e9).contains(c))
}
