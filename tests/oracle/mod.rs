//! The tracer's scalar twin: one ray at a time, in f64, by plain recursion.
//!
//! It draws a `Scene` by the rules of the model scene and shares no code with the tracer: what both agree on is right
//! unless both understood the rules wrongly.

pub mod frame;
mod intersect;
mod light;
mod pattern;
mod shade;
pub mod squares;

use eightfold::Quality;
use eightfold::scene::Scene;
use glam::DVec3;

/// Traces points of one picture of a scene.
pub struct Oracle<'a> {
    scene: &'a Scene,
    quality: &'a Quality,
    width: usize,
    height: usize,
    /// Pixel (x, y) looks along `corner + x dx + y dy`.
    corner: DVec3,
    dx: DVec3,
    dy: DVec3,
    /// The side of a pixel at distance 1.
    pixel: f64,
}

/// What came of a point.
#[derive(Clone, Copy, Debug, Default)]
pub struct Traced {
    /// Linear RGB, not clamped.
    pub colour: DVec3,
    /// Stands for the whole ray tree: the object each ray hit, and whether each light shone there.
    pub tree: u64,
    /// Stands for what the quality compares: objects and lights' states (dark, lit, with a highlight), each to its
    /// depth.
    pub key: u64,
    /// Primary and secondary rays.
    pub rays: u64,
    /// Rays towards lights.
    pub shadow_rays: u64,
}

/// An object of the scene, by kind and place in its list.
#[derive(Clone, Copy, Debug, Hash, PartialEq, Eq)]
enum Object {
    Sphere(usize),
    Plane(usize),
    Block(usize),
    Light(usize),
    Background,
}

#[derive(Clone, Copy)]
struct Ray {
    o: DVec3,
    /// Of length 1.
    d: DVec3,
}

impl<'a> Oracle<'a> {
    /// For pictures of so many pixels. Of the quality, the depths, the highlight and the least contribution count.
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

    /// Traces the point at pixel (x, y), which may lie outside the picture.
    pub fn trace(&self, x: isize, y: isize) -> Traced {
        let d = self.corner + self.dx * x as f64 + self.dy * y as f64;
        let ray = Ray {
            o: self.scene.camera.eye.as_dvec3(),
            d: d.normalize(),
        };
        let mut traced = Traced::default();
        let weight = 1.0 - self.scene.fade;
        traced.colour = f64::from(weight) * self.follow(ray, weight, 1, &mut traced);
        traced
    }
}

impl Traced {
    /// The colour as a pixel, `0x00RRGGBB`.
    pub fn pixel(&self) -> u32 {
        let byte = |c: f64| (c.clamp(0.0, 1.0) * 255.0).round() as u32;
        byte(self.colour.x) << 16 | byte(self.colour.y) << 8 | byte(self.colour.z)
    }
}
