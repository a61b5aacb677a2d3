//! A second ray tracer, with which the tests compare the library's pictures and the lab finds out what a pixel shows.
//!
//! It traces one ray at a time, recursively and in f64, by textbook formulas. It shares no code with the library, so where both
//! agree they are right, unless both misunderstood the same rule.

pub mod frame;
pub mod grooves;
mod intersect;
mod light;
pub mod pattern;
mod shade;
pub mod squares;
pub mod waves;

use eightfold_tracer::Quality;
use eightfold_tracer::scene::Scene;
use glam::DVec3;

/// Traces points of one picture of a scene. Points are given in pixels of the picture.
pub struct Oracle<'a> {
    scene: &'a Scene,
    quality: &'a Quality,
    width: usize,
    height: usize,
    /// The ray through pixel (x, y) has the direction `corner + x dx + y dy`.
    corner: DVec3,
    dx: DVec3,
    dy: DVec3,
    /// The side of a pixel at distance 1, in scene units.
    pixel: f64,
}

/// The result of tracing a point.
#[derive(Clone, Copy, Debug, Default)]
pub struct Traced {
    /// RGB after the film, not clamped.
    pub colour: DVec3,
    /// A hash of the whole ray tree: the object that each ray hit, and which lights were lit there.
    pub tree: u64,
    /// A hash of what the quality compares: objects and lights' states (dark, lit, lit with a highlight), each up to its depth.
    pub key: u64,
    /// The number of primary and secondary rays.
    pub rays: u64,
    /// The number of shadow rays.
    pub shadow_rays: u64,
}

/// An object of the scene, by its kind and its index in its list.
#[derive(Clone, Copy, Debug, Hash, PartialEq, Eq, PartialOrd, Ord)]
pub enum Object {
    /// A sphere.
    Sphere(usize),
    /// A plane.
    Plane(usize),
    /// A box or a cylinder.
    Block(usize),
    /// The sphere that shows a light.
    Light(usize),
    /// The background, which a ray hits that hits nothing else.
    Background,
}

#[derive(Clone, Copy)]
struct Ray {
    /// The origin.
    o: DVec3,
    /// The direction, of length 1.
    d: DVec3,
    /// How far off the origin may be by rounding, in scene units: on surfaces as near as that it starts.
    slack: f64,
}

impl<'a> Oracle<'a> {
    /// An oracle for a picture of a given size in pixels. Of the quality it uses the depths, the highlight and the least
    /// contribution.
    pub fn new(scene: &'a Scene, quality: &'a Quality, width: usize, height: usize) -> Self {
        let camera = &scene.camera;
        let eye = camera.eye.as_dvec3();
        let forward = (camera.look_at.as_dvec3() - eye).normalize();
        let right = forward.cross(camera.up.as_dvec3()).normalize();
        let up = right.cross(forward);
        let pixel = 2.0 * (0.5 * f64::from(camera.field_of_view)).tan() / height as f64;
        let (dx, dy) = (right * pixel, up * -pixel);
        Self {
            scene,
            quality,
            width,
            height,
            corner: forward - dx * (0.5 * width as f64 - 0.5) - dy * (0.5 * height as f64 - 0.5),
            dx,
            dy,
            pixel,
        }
    }

    /// The object that the centre of pixel (x, y) shows, which may lie outside the picture.
    pub fn object_at(&self, x: isize, y: isize) -> Object {
        self.nearest(self.primary_ray(x, y)).0
    }

    /// The ray through the centre of a pixel.
    fn primary_ray(&self, x: isize, y: isize) -> Ray {
        let d = self.corner + self.dx * x as f64 + self.dy * y as f64;
        Ray::from_scene(self.scene.camera.eye.as_dvec3(), d.normalize())
    }

    /// Traces the point at the centre of pixel (x, y), which may lie outside the picture.
    pub fn trace(&self, x: isize, y: isize) -> Traced {
        let ray = self.primary_ray(x, y);
        let mut traced = Traced::default();
        let weight = 1.0 - self.scene.fade;
        let light = f64::from(weight) * self.follow(ray, weight, 1, &mut traced);
        traced.colour = self.exposed(light, x, y);
        traced
    }

    /// Returns what the film makes of the light at a pixel.
    fn exposed(&self, light: DVec3, x: isize, y: isize) -> DVec3 {
        let from_middle =
            |at: isize, size: usize| (2.0 * at as f64 + 1.0 - size as f64) / self.height as f64;
        let (across, down) = (from_middle(x, self.width), from_middle(y, self.height));
        let film = &self.scene.film;
        let vignette = f64::from(film.vignette) * (across * across + down * down);
        let shoulder = f64::from(film.shoulder);
        let roll_off = |c: f64| {
            if c <= shoulder {
                return c;
            }
            let (over, room) = (c - shoulder, 1.0 - shoulder);
            shoulder + over * room / (room + over)
        };
        (light / (1.0 + vignette)).map(roll_off)
    }
}

/// In which order the pixels of a square of 4x4 are rounded up as a colour gets brighter, by the film's dither: the last one first.
const ORDER: [[u8; 4]; 4] = [[0, 8, 2, 10], [12, 4, 14, 6], [3, 11, 1, 9], [15, 7, 13, 5]];

/// A colour as the pixel (x, y), `0x00RRGGBB`, with a film's dither.
pub fn pixel(colour: DVec3, dither: f32, x: usize, y: usize) -> u32 {
    let share = (f64::from(ORDER[y % 4][x % 4]) + 0.5) / 16.0;
    let threshold = 0.5 + f64::from(dither) * (share - 0.5);
    let byte = |c: f64| (c.clamp(0.0, 1.0) * 255.0 + threshold).floor() as u32;
    byte(colour.x) << 16 | byte(colour.y) << 8 | byte(colour.z)
}
