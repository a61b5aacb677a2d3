//! Which scenes are within the tracer's limits.

use super::{Camera, Material, Method, Scene, Shape};
use core::fmt;
use glam::Vec3A;

/// The largest coordinate and the largest extent, in scene units: their squares, times a few, stay finite in f32.
pub const MAX_LENGTH: f32 = 1e9;
/// The smallest radius and the smallest extent: their squares stay normal numbers.
pub const MIN_LENGTH: f32 = 1e-9;

/// The first thing about a scene that is out of its range.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Flaw {
    /// What has it: "camera", "sphere" and so on.
    pub object: &'static str,
    /// Its place in its list, 0 where there is but one.
    pub number: usize,
    /// The field.
    pub field: &'static str,
    /// What the field takes.
    pub takes: &'static str,
}

impl fmt::Display for Flaw {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self {
            object,
            number,
            field,
            takes,
        } = self;
        write!(f, "{object} {number}: {field} takes {takes}")
    }
}

impl core::error::Error for Flaw {}

const PLACE: &str = "coordinates from -1e9 to 1e9";
const EXTENT: &str = "a length from 1e-9 to 1e9";
const COLOUR: &str = "numbers from 0 on, such as 1 0.5 0";
const UNIT: &str = "a direction of length 1";
const HAZE: &str = "a number from 0 to 1000";
const SHARE: &str = "a number from 0 to 1";

impl Scene {
    /// Whether every number of the scene is in the range that its documentation says, the first that is not otherwise.
    ///
    /// A scene that is valid gives the picture that [`crate::limits`] promises. One that is not gives some picture, in
    /// bounded time.
    ///
    /// # Errors
    /// What is out of its range.
    pub fn validate(&self) -> Result<(), Flaw> {
        self.camera.validate()?;
        let scene = Part("scene", 0);
        scene.hold("background", COLOUR, is_colour(self.background))?;
        let straight_up = self.background + self.sky;
        scene.hold(
            "sky",
            "no more than the background loses",
            is_colour(straight_up),
        )?;
        scene.hold("haze", HAZE, (0.0..=1e3).contains(&self.haze))?;
        scene.hold(
            "fade",
            "a number from -10 to 1",
            (-10.0..=1.0).contains(&self.fade),
        )?;
        scene.hold("ambient", COLOUR, is_colour(self.ambient))?;
        let Method {
            points,
            squares,
            picture,
        } = self.method;
        let is_method = [points, squares, picture]
            .iter()
            .all(|x| (0.0..=1.0).contains(x));
        scene.hold("method", SHARE, is_method)?;
        for (i, caption) in self.captions.iter().enumerate() {
            let part = Part("caption", i);
            let is_share = |x: f32| (0.0..=1.0).contains(&x);
            part.hold("middle", SHARE, is_share(caption.middle))?;
            part.hold("size", SHARE, is_share(caption.size))?;
            part.hold("brightness", SHARE, is_share(caption.brightness))?;
        }
        for (i, sphere) in self.spheres.iter().enumerate() {
            let part = Part("sphere", i);
            part.hold("centre", PLACE, is_place(sphere.centre))?;
            part.hold("radius", EXTENT, is_extent(sphere.radius))?;
            sphere.material.validate(&part)?;
        }
        for (i, plane) in self.planes.iter().enumerate() {
            let part = Part("plane", i);
            part.hold("centre", PLACE, is_place(plane.centre))?;
            part.hold("half_x", EXTENT, is_extent(plane.half_x))?;
            part.hold("half_z", EXTENT, is_extent(plane.half_z))?;
            plane.material.validate(&part)?;
        }
        for (i, light) in self.lights.iter().enumerate() {
            let part = Part("light", i);
            part.hold("position", PLACE, is_place(light.position))?;
            part.hold("colour", COLOUR, is_colour(light.colour))?;
            let is_radius = light.radius == 0.0 || is_extent(light.radius);
            part.hold("radius", "0, or a length from 1e-9 to 1e9", is_radius)?;
            let is_size = (0.0..=MAX_LENGTH).contains(&light.size);
            part.hold("size", "a length from 0 to 1e9", is_size)?;
            if let Some(spot) = light.spot {
                part.hold("aim", UNIT, is_unit(spot.aim))?;
                let is_cone = spot.dark >= -1.0 && spot.dark < spot.bright && spot.bright <= 1.0;
                part.hold(
                    "spot",
                    "cosines, that of dark below that of bright",
                    is_cone,
                )?;
            }
        }
        for (i, block) in self.blocks.iter().enumerate() {
            let part = Part("block", i);
            part.hold("centre", PLACE, is_place(block.centre))?;
            let is_block = block.half.to_array().into_iter().all(is_extent);
            part.hold("half", EXTENT, is_block)?;
            let is_even = block.shape == Shape::Box || block.half.x == block.half.z;
            part.hold("half", "the same along x and z of a cylinder", is_even)?;
            let [x, y, z] = [0, 1, 2].map(|i| block.axes.col(i));
            let is_square = x.dot(y).abs().max(y.dot(z).abs()).max(z.dot(x).abs()) < 1e-4;
            let are_axes = is_unit(x) && is_unit(y) && is_unit(z) && is_square;
            part.hold("axes", "three of length 1, square to each other", are_axes)?;
            block.material.validate(&part)?;
        }
        Ok(())
    }
}

impl Camera {
    fn validate(&self) -> Result<(), Flaw> {
        let part = Part("camera", 0);
        part.hold("eye", PLACE, is_place(self.eye))?;
        part.hold("look_at", PLACE, is_place(self.look_at))?;
        let forward = (self.look_at - self.eye).normalize_or_zero();
        let is_ahead = forward != Vec3A::ZERO;
        part.hold("look_at", "a point that is not the eye", is_ahead)?;
        // Within a thousandth of the line of sight, rounding decides where the picture's sides are.
        let across = forward.cross(self.up.normalize_or_zero()).length();
        let takes = "a direction that is not along the line of sight";
        part.hold("up", takes, across > 1e-3)?;
        let is_angle = self.field_of_view > 0.0 && self.field_of_view < core::f32::consts::PI;
        part.hold("field_of_view", "radians between 0 and pi", is_angle)
    }
}

impl Material {
    fn validate(&self, part: &Part) -> Result<(), Flaw> {
        let is_share = |x: f32| (0.0..=1.0).contains(&x);
        part.hold("colour", COLOUR, is_colour(self.colour))?;
        part.hold("kd", SHARE, is_share(self.kd))?;
        part.hold("ks", SHARE, is_share(self.ks))?;
        let is_exponent = (1.0..=1000.0).contains(&self.exponent);
        part.hold("exponent", "a number from 1 to 1000", is_exponent)?;
        part.hold("kr", SHARE, is_share(self.kr))?;
        part.hold("kt", SHARE, is_share(self.kt))?;
        let is_index = self.kt == 0.0 || (0.1..=10.0).contains(&self.index);
        part.hold("index", "a number from 0.1 to 10", is_index)?;
        part.hold(
            "tint",
            SHARE,
            self.tint.to_array().into_iter().all(is_share),
        )?;
        let pattern = &self.pattern;
        part.hold("pattern", SHARE, is_share(pattern.depth))?;
        let is_number = |x: f32| (0.0..=1e3).contains(&x);
        let numbers = [pattern.edge, pattern.warp, pattern.grain];
        let waves = pattern.waves.to_array();
        let all = numbers.into_iter().chain(waves).all(is_number);
        part.hold("pattern", "numbers from 0 to 1000", all)
    }
}

/// A part of a scene, by its kind and its place in its list.
struct Part(&'static str, usize);

impl Part {
    fn hold(&self, field: &'static str, takes: &'static str, holds: bool) -> Result<(), Flaw> {
        let flaw = Flaw {
            object: self.0,
            number: self.1,
            field,
            takes,
        };
        if holds { Ok(()) } else { Err(flaw) }
    }
}

fn is_place(v: Vec3A) -> bool {
    v.to_array().iter().all(|c| c.abs() <= MAX_LENGTH)
}

fn is_unit(v: Vec3A) -> bool {
    (v.length() - 1.0).abs() < 1e-4
}

fn is_extent(length: f32) -> bool {
    (MIN_LENGTH..=MAX_LENGTH).contains(&length)
}

/// Bright lights are above 1; nothing is above what f32 can multiply.
fn is_colour(v: Vec3A) -> bool {
    v.to_array().iter().all(|c| (0.0..=1e9).contains(c))
}
