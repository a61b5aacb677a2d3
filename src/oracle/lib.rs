//! The crate of the oracle, a reference tracer for the library's pictures: scalar and recursive, in
//! f64, with textbook formulas. It shares only the scene description with the library.

mod ambient;
pub mod frame;
pub mod geometry;
mod grooves;
pub mod light;
mod pattern;
mod shade;
mod waves;

pub use shade::Hit;

use eightfold_tracer::Quality;
use eightfold_tracer::scene::{Material, Scene};
use geometry::{Met, PicturePlane, Ray, Shape};
use glam::DVec3;

pub struct Oracle<'a> {
    scene: &'a Scene,
    quality: &'a Quality,
    width: usize,
    height: usize,
    plane: PicturePlane,
    bodies: Vec<Body>,
}

struct Body {
    object: Object,
    shape: Shape,
}

#[derive(Clone, Copy, Debug, Default)]
pub struct Traced {
    /// RGB after the film, not clamped.
    pub colour: DVec3,
    /// A hash of the ray tree: the object that each ray hits, and the lights visible there.
    pub tree: u64,
    /// A hash of objects, and of light states (dark, lit, highlight), each up to the quality's
    /// depth.
    pub key: u64,
    pub rays: u64,
    pub shadow_rays: u64,
}

#[derive(Clone, Copy, Hash)]
enum Object {
    Sphere(usize),
    Plane(usize),
    Block(usize),
    Light(usize),
    Background,
}

impl Object {
    fn material(self, scene: &Scene) -> Option<&Material> {
        match self {
            Self::Sphere(i) => Some(&scene.spheres[i].material),
            Self::Plane(i) => Some(&scene.planes[i].material),
            Self::Block(i) => Some(&scene.blocks[i].material),
            Self::Light(_) | Self::Background => None,
        }
    }
}

impl<'a> Oracle<'a> {
    pub fn new(scene: &'a Scene, quality: &'a Quality, width: usize, height: usize) -> Self {
        Self {
            scene,
            quality,
            width,
            height,
            plane: PicturePlane::new(&scene.camera, width, height),
            bodies: bodies(scene),
        }
    }

    pub fn ray(&self, x: f64, y: f64) -> Ray {
        self.plane.ray(x, y)
    }

    fn nearest(&self, ray: Ray, has_lights: bool) -> Option<(&Body, Met)> {
        let bodies = if has_lights { &self.bodies } else { self.solids() };
        bodies.iter().fold(None, |nearest: Option<(&Body, Met)>, body| {
            let limit = nearest.map_or(f64::INFINITY, |(_, met)| met.t);
            body.shape.meet(ray, limit).map(|met| (body, met)).or(nearest)
        })
    }

    fn solids(&self) -> &[Body] {
        let Scene { spheres, planes, blocks, .. } = self.scene;
        &self.bodies[..spheres.len() + planes.len() + blocks.len()]
    }

    pub fn is_free(&self, ray: Ray, distance: f64) -> bool {
        self.solids().iter().all(|body| body.shape.meet(ray, distance).is_none())
    }

    pub fn trace(&self, x: isize, y: isize) -> Traced {
        let ray = self.ray(x as f64, y as f64);
        let mut traced = Traced::default();
        let weight = self.scene.exposure;
        let light = f64::from(weight) * self.follow(ray, weight, 1, &mut traced);
        traced.colour = self.exposed(light, x, y);
        traced
    }

    fn exposed(&self, light: DVec3, x: isize, y: isize) -> DVec3 {
        let from_middle =
            |at: isize, size: usize| (2.0 * at as f64 + 1.0 - size as f64) / self.height as f64;
        let (across, down) = (from_middle(x, self.width), from_middle(y, self.height));
        let film = &self.scene.film;
        let vignette = f64::from(film.vignette) * (across * across + down * down);
        let light = light / (1.0 + vignette);
        let curve = |c: f64| (c * (2.51 * c + 0.03) / (c * (2.43 * c + 0.59) + 0.14)).sqrt();
        if film.filmic { light.map(curve) } else { light }
    }
}

/// Lights are last.
fn bodies(scene: &Scene) -> Vec<Body> {
    let shapes = scene.spheres.iter().map(Shape::from).enumerate();
    let spheres = shapes.map(|(i, shape)| Body { object: Object::Sphere(i), shape });
    let shapes = scene.planes.iter().map(Shape::from).enumerate();
    let planes = shapes.map(|(i, shape)| Body { object: Object::Plane(i), shape });
    let shapes = scene.blocks.iter().map(Shape::from).enumerate();
    let blocks = shapes.map(|(i, shape)| Body { object: Object::Block(i), shape });
    let lights = scene.lights.iter().enumerate();
    let drawn = lights.filter(|(_, light)| light.drawn_radius > 0.0 && !light.parallel);
    let lights = drawn.map(|(i, light)| {
        let (centre, radius) = (light.position.as_dvec3(), light.drawn_radius.into());
        Body { object: Object::Light(i), shape: Shape::Sphere { centre, radius } }
    });
    spheres.chain(planes).chain(blocks).chain(lights).collect()
}

/// The ranks of 4x4 pixels: dithering rounds up the highest rank first.
const ORDER: [[u8; 4]; 4] = [[0, 8, 2, 10], [12, 4, 14, 6], [3, 11, 1, 9], [15, 7, 13, 5]];

/// The distance between numbers, in output steps, below which rounding can change their order.
///
/// A ray tree's sum is off by up to 1/100 of a step, a square's corner by 1/128, a filled square's
/// last pixel by 8/256.
const TIE: f64 = 1.0 / 16.0;

/// Returns the pixel (x, y) of a colour. Where a channel is half-way between two steps, both are
/// right; the nearer to `drawn` is returned.
pub fn pixel_like(drawn: u32, colour: DVec3, dither: f32, x: usize, y: usize) -> u32 {
    let channels = [16, 8, 0].into_iter().zip(steps(colour, dither, x, y));
    channels.fold(0, |pixel, (shift, step)| {
        let [min, max] = [step - TIE, step + TIE].map(|step| step.clamp(0.0, 255.0).floor() as u32);
        pixel | (drawn >> shift & 0xff).clamp(min, max) << shift
    })
}

fn steps(colour: DVec3, dither: f32, x: usize, y: usize) -> [f64; 3] {
    let share = (f64::from(ORDER[y % 4][x % 4]) + 0.5) / 16.0;
    let threshold = 0.5 + f64::from(dither) * (share - 0.5);
    (colour.clamp(DVec3::ZERO, DVec3::ONE) * 255.0 + threshold).to_array()
}
