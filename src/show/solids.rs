use core::f32::consts::TAU;
use eightfold_tracer::font::strokes;
use eightfold_tracer::maths::{cos, sin};
use eightfold_tracer::scene::{Block, Material, Scene, Shape, Sphere};
use glam::{Mat3, Vec3, vec3};

#[inline(never)]
pub(super) fn add_sphere(centre: Vec3, radius: f32, material: &Material, scene: &mut Scene) {
    scene.spheres.push(Sphere::new(centre, radius, *material));
}

#[inline(never)]
pub(super) fn add_block(
    shape: Shape,
    centre: Vec3,
    half: Vec3,
    axes: Mat3,
    material: &Material,
    scene: &mut Scene,
) {
    scene.blocks.push(Block { centre, half, axes, shape, material: *material });
}

/// Adds stars behind a scene at the origin, seen from z. Few are bright.
pub(super) fn add_stars(scene: &mut Scene) {
    for number in 0..64 {
        let number = number as f32;
        let square = number * number;
        let up = 66.0 * fraction(square * 0.618_034) - 31.0;
        let centre = vec3(124.0 * fraction(square * 0.754_877) - 68.0, up, -85.0);
        let bright = square * square * 6e-8;
        let light =
            Material { colour: Vec3::splat(0.6 + 12.0 * bright), kd: 1.0, ..Material::BLACK };
        add_sphere(centre, 0.08 + 0.1 * bright, &light, scene);
    }
}

/// The sizes of a letter in scene units.
pub(super) struct Size {
    pub step: f32,
    /// Half the width of a stroke.
    pub half_width: f32,
    pub half_depth: f32,
}

/// A stroke's depth relative to the previous one: coincident surfaces would flicker.
const THINNER: f32 = 0.985;

/// Adds a letter of boxes. `axes` are to its right, up, and towards its reader; `foot` is its lower
/// left end.
pub(super) fn add_letter(
    letter: u8,
    foot: Vec3,
    axes: Mat3,
    size: &Size,
    material: &Material,
    scene: &mut Scene,
) {
    let mut half_depth = size.half_depth;
    for (from, to) in strokes(letter) {
        let along = to - from;
        let length = along.length();
        // Slanted strokes meet at 45 degrees; other corners are square.
        let mitre = if along.x * along.y == 0.0 { 1.0 } else { 0.4 };
        let [x, y] = [along.x / length, along.y / length];
        let middle = (from + to) * 0.5;
        let centre = foot + axes * vec3(middle.x, 4.0 - middle.y, 0.0) * size.step;
        let half =
            vec3(0.5 * length * size.step + mitre * size.half_width, size.half_width, half_depth);
        let turned = Mat3::from_cols(vec3(x, -y, 0.0), vec3(y, x, 0.0), Vec3::Z);
        add_block(Shape::Box, centre, half, axes * turned, material, scene);
        half_depth *= THINNER;
    }
}

/// Returns a positive number's fraction, as `f32::fract`, which needs `std`.
pub(super) fn fraction(number: f32) -> f32 {
    number - number as i32 as f32
}

/// Returns the horizontal direction at an angle in turns, from z towards x.
pub(super) fn around(turns: f32) -> Vec3 {
    vec3(sin(TAU * turns), 0.0, cos(TAU * turns))
}
