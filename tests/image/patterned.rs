//! Patterns in filled squares are as sharp as traced ones, and take few points.

use crate::drawn::{draw, draw_best, draw_by_all, jagged};
use crate::error::Difference;
use eightfold_scenes::{Random, cases, solids};
use eightfold_tracer::Quality;
use eightfold_tracer::scene::{
    Block, Camera, Light, List, Material, Pattern, Plane, Scene, Shape, Sphere,
};
use glam::{Mat3, Vec3, vec3};

/// A floor, a sphere, a box and a cylinder with checkers, stripes and marble that are much finer than squares. `marble` is the
/// steepness of the marble's edges.
fn scene(depth: f32, marble: f32) -> Scene {
    let material = |waves: Vec3, edge: f32, warp: f32| Material {
        colour: vec3(0.9, 0.8, 0.7),
        kd: 0.9,
        pattern: Pattern {
            waves,
            depth,
            edge,
            balance: 0.0,
            warp,
            grain: 1.0,
        },
        ..Material::BLACK
    };
    let block = |x: f32, shape: Shape, material: Material| Block {
        axes: Mat3::from_rotation_y(0.4),
        ..Block::new(shape, vec3(x, 1.0, 0.0), vec3(0.7, 1.0, 0.7), material)
    };
    Scene {
        camera: Camera::new(vec3(0.0, 2.5, -5.0), vec3(0.0, 0.8, 0.0), 0.8),
        background: Vec3::splat(0.2),
        ambient: Vec3::splat(0.2),
        planes: List::of(&[Plane {
            half_x: 5.0,
            half_z: 5.0,
            material: material(vec3(1.5, 0.0, 1.5), 40.0, 0.0),
            ..Plane::default()
        }]),
        spheres: List::of(&[Sphere::new(
            vec3(0.0, 0.6, -1.2),
            0.6,
            material(Vec3::splat(3.0), 20.0, 0.0),
        )]),
        blocks: List::of(&[
            block(-1.2, Shape::Box, material(vec3(0.0, 4.0, 0.0), 20.0, 0.0)),
            block(
                1.2,
                Shape::Cylinder,
                material(vec3(1.0, 2.0, 1.0), marble, 1.0),
            ),
        ]),
        lights: List::of(&[Light::new(vec3(-3.0, 6.0, -4.0), Vec3::ONE)]),
        ..Scene::default()
    }
}

/// Squares are split at edges of objects and shadows, but not at the much longer edges of patterns.
#[test]
fn patterns_are_as_sharp_in_filled_squares_as_traced() {
    let plain = scene(0.0, 2.0);
    // Marble with edges, and without.
    for (marble, least) in [(2.0, 42.5), (1.0, 41.0)] {
        let patterned = scene(0.8, marble);
        for (isa, exhaustive) in draw_by_all(&patterned, &Quality::EXHAUSTIVE, 480, 270) {
            let [even, drawn] = [&plain, &patterned]
                .map(|scene| draw(isa, 2, scene, &jagged(Quality::DEFAULT), 480, 270));
            let psnr = Difference::between(&exhaustive.pixels, &drawn.pixels).psnr;
            let (points, plainly) = (drawn.counts.points, even.counts.points);
            let what = format!(
                "{}: {psnr:.1} dB, {points} points, {plainly} without",
                isa.name
            );
            println!("{what}");
            assert!(psnr > least, "{what}");
            assert!(marble < 2.0 || points < plainly * 7 / 4, "{what}");
        }
    }
}

/// A floor, or a solid over it, with a pattern of any kind and softness, near or far.
fn soft(random: &mut Random) -> Scene {
    let distance = random.power(-0.3, 1.5);
    let waves = [Vec3::X, Vec3::Z, vec3(1.0, 0.0, 1.0), Vec3::Y, Vec3::ONE];
    let pattern = Pattern {
        waves: random.one_of(waves) * random.power(-0.7, 0.7),
        depth: random.between(0.4, 1.0),
        edge: random.power(-0.3, 1.0),
        balance: random.between(-0.9, 0.9),
        warp: random.zero_or(0.3, 1.5),
        grain: random.between(0.3, 2.0),
    };
    let material = Material {
        pattern,
        ..Material::matt(random.colour(), 0.8)
    };
    let eye = vec3(0.0, random.between(0.4, 3.0), -distance);
    let mut scene = Scene {
        camera: Camera::new(
            Mat3::from_rotation_y(random.between(0.0, 6.0)) * eye,
            Vec3::ZERO,
            0.6,
        ),
        background: random.colour(),
        ambient: Vec3::splat(0.3),
        planes: List::of(&[Plane::new(-Vec3::Y, 20.0, 20.0, material)]),
        lights: List::of(&[Light::new(vec3(-3.0, 6.0, -4.0), Vec3::splat(0.7))]),
        ..Scene::default()
    };
    match random.below(3) {
        0 => {}
        1 => scene.spheres.push(Sphere::new(Vec3::ZERO, 0.9, material)),
        _ => scene.blocks.push(solids::block(
            random,
            Vec3::ZERO,
            vec3(0.5, 0.8, 0.5),
            material,
        )),
    }
    scene
}

#[test]
fn soft_patterns_are_right_at_any_distance() {
    let mut worst = f64::INFINITY;
    for mut random in cases(100) {
        let scene = soft(&mut random);
        for antialias in [false, true] {
            let quality = Quality {
                antialias,
                ..Quality::DEFAULT
            };
            let [exact, drawn] = [quality.reference(), quality]
                .map(|quality| draw_best(&scene, &quality, 480, 270).pixels);
            let psnr = Difference::between(&exact, &drawn).psnr;
            let pattern = &scene.planes[0].material.pattern;
            println!("case {}: {psnr:.1} dB, {pattern:?}", random.seed);
            worst = worst.min(psnr);
        }
    }
    assert!(worst >= 42.0, "{worst:.1} dB");
}
