//! A second ray tracer, with which the tests compare the library's pictures and the lab finds out what a pixel shows.
//!
//! It traces one ray at a time, recursively and in f64, by textbook formulas. It shares no code with the library, so where both
//! agree they are right, unless both misunderstood the same rule. The lab's path tracer uses its geometry and its shading.

pub mod frame;
pub mod geometry;
mod grooves;
pub mod light;
mod pattern;
mod shade;
pub mod squares;
mod waves;

pub use shade::Hit;

use eightfold_tracer::Quality;
use eightfold_tracer::scene::{Material, Scene};
use geometry::{Met, PicturePlane, Ray, Shape};
use glam::DVec3;

/// Traces points of one picture of a scene. Points are given in pixels of the picture.
pub struct Oracle<'a> {
    scene: &'a Scene,
    quality: &'a Quality,
    width: usize,
    height: usize,
    plane: PicturePlane,
    bodies: Vec<Body>,
}

/// An object that rays meet.
struct Body {
    object: Object,
    shape: Shape,
}

impl Body {
    /// Whether it shows a light.
    fn is_light(&self) -> bool {
        matches!(self.object, Object::Light(_))
    }
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

impl Object {
    /// The material of an object of a scene; lights and the background have none.
    pub fn material(self, scene: &Scene) -> Option<&Material> {
        match self {
            Self::Sphere(i) => Some(&scene.spheres[i].material),
            Self::Plane(i) => Some(&scene.planes[i].material),
            Self::Block(i) => Some(&scene.blocks[i].material),
            Self::Light(_) | Self::Background => None,
        }
    }
}

impl<'a> Oracle<'a> {
    /// An oracle for a picture of a given size in pixels. Of the quality it uses the depths, the highlight and the least
    /// contribution.
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

    /// The object that the centre of pixel (x, y) shows, which may lie outside the picture.
    pub fn object_at(&self, x: isize, y: isize) -> Object {
        let nearest = self.nearest(self.ray(x as f64, y as f64), true);
        nearest.map_or(Object::Background, |(body, _)| body.object)
    }

    /// The ray through a point of the picture, in pixels. A pixel's coordinates are those of its centre.
    pub fn ray(&self, x: f64, y: f64) -> Ray {
        self.plane.ray(x, y)
    }

    /// The nearest object along a ray, and where the ray meets it. `has_lights` is whether the spheres that show lights count.
    fn nearest(&self, ray: Ray, has_lights: bool) -> Option<(&Body, Met)> {
        let mut nearest: Option<(&Body, Met)> = None;
        for body in &self.bodies {
            if !has_lights && body.is_light() {
                continue;
            }
            let limit = nearest.map_or(f64::INFINITY, |(_, met)| met.t);
            if let Some(met) = body.shape.meet(ray, limit) {
                nearest = Some((body, met));
            }
        }
        nearest
    }

    /// Whether no surface blocks a ray up to a distance.
    pub fn is_free(&self, ray: Ray, distance: f64) -> bool {
        let mut bodies = self.bodies.iter().filter(|body| !body.is_light());
        bodies.all(|body| body.shape.meet(ray, distance).is_none())
    }

    /// Traces the point at the centre of pixel (x, y), which may lie outside the picture.
    pub fn trace(&self, x: isize, y: isize) -> Traced {
        let ray = self.ray(x as f64, y as f64);
        let mut traced = Traced::default();
        let weight = self.scene.exposure;
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

/// All objects of a scene, those spheres too that show lights.
fn bodies(scene: &Scene) -> Vec<Body> {
    let spheres = scene.spheres.iter().map(Shape::from).enumerate();
    let planes = scene.planes.iter().map(Shape::from).enumerate();
    let blocks = scene.blocks.iter().map(Shape::from).enumerate();
    let lights = scene.lights.iter().enumerate();
    let drawn = lights.filter(|(_, light)| light.drawn_radius > 0.0 && !light.parallel);
    let shown = drawn.map(|(i, light)| {
        let shape = Shape::Sphere {
            centre: light.position.as_dvec3(),
            radius: light.drawn_radius.into(),
        };
        (Object::Light(i), shape)
    });
    let all = spheres
        .map(|(i, shape)| (Object::Sphere(i), shape))
        .chain(planes.map(|(i, shape)| (Object::Plane(i), shape)))
        .chain(blocks.map(|(i, shape)| (Object::Block(i), shape)))
        .chain(shown);
    all.map(|(object, shape)| Body { object, shape }).collect()
}

/// In which order the pixels of a square of 4x4 are rounded up as a colour gets brighter, by the film's dither: the last one first.
const ORDER: [[u8; 4]; 4] = [[0, 8, 2, 10], [12, 4, 14, 6], [3, 11, 1, 9], [15, 7, 13, 5]];

/// How near to each other, in output steps, numbers are whose order rounding may change.
///
/// The sum of a tree's nodes may be off by 1/100 of a step, a corner of a square is cut off to 1/128, and the last pixel of a filled
/// square is off by 8/256 at most.
const TIE: f64 = 1.0 / 16.0;

/// A colour as the pixel (x, y), `0x00RRGGBB`, with a film's dither.
pub fn pixel(colour: DVec3, dither: f32, x: usize, y: usize) -> u32 {
    let [red, green, blue] = steps(colour, dither, x, y).map(|step| step.floor() as u32);
    red << 16 | green << 8 | blue
}

/// A colour as the pixel (x, y) that is nearest to the one drawn: where a channel is as good as half-way between two steps, both
/// are right, and a picture may be full of it.
pub fn pixel_like(drawn: u32, colour: DVec3, dither: f32, x: usize, y: usize) -> u32 {
    let steps = steps(colour, dither, x, y);
    let channels = [16, 8, 0].into_iter().zip(steps);
    channels.fold(0, |pixel, (shift, step)| {
        let [least, most] = bytes(step);
        pixel | (drawn >> shift & 0xff).clamp(least, most) << shift
    })
}

/// The channels of a colour at the pixel (x, y) in output steps, of which the fraction is cut off.
fn steps(colour: DVec3, dither: f32, x: usize, y: usize) -> [f64; 3] {
    let share = (f64::from(ORDER[y % 4][x % 4]) + 0.5) / 16.0;
    let threshold = 0.5 + f64::from(dither) * (share - 0.5);
    (colour.clamp(DVec3::ZERO, DVec3::ONE) * 255.0 + threshold).to_array()
}

/// The least and the greatest byte that rounding may make of a channel.
fn bytes(step: f64) -> [u32; 2] {
    [step - TIE, step + TIE].map(|step| step.clamp(0.0, 255.0).floor() as u32)
}
