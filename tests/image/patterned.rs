//! Patterns in filled squares are as sharp as traced ones, and take few points.

use crate::drawn::{draw, draw_best, draw_by_all, jagged};
use crate::error::Difference;
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

#[test]
fn patterns_are_as_sharp_in_filled_squares_as_traced() {
    let (patterned, plain) = (scene(0.8, 2.0), scene(0.0, 2.0));
    for (isa, exhaustive) in draw_by_all(&patterned, &Quality::EXHAUSTIVE, 480, 270) {
        let even = draw(isa, 1, &plain, &jagged(Quality::DEFAULT), 480, 270);
        let drawn = draw(isa, 2, &patterned, &jagged(Quality::DEFAULT), 480, 270);
        let difference = Difference::between(&exhaustive.pixels, &drawn.pixels);
        let (points, plainly) = (drawn.counts.points, even.counts.points);
        println!(
            "{}: {difference:?}, {points} points, {plainly} without",
            isa.name
        );
        assert!(difference.psnr > 42.5, "{}: {difference:?}", isa.name);
        // Squares are split at edges of objects and shadows, but not at the much longer edges of patterns.
        assert!(
            points < plainly * 7 / 4,
            "{}: {points}, {plainly}",
            isa.name
        );
    }
}

#[test]
fn patterns_without_edges_are_filled_as_light_is() {
    // Patterns without edges.
    let soft = scene(0.8, 1.0);
    for (isa, exhaustive) in draw_by_all(&soft, &Quality::EXHAUSTIVE, 480, 270) {
        let drawn = draw(isa, 2, &soft, &jagged(Quality::DEFAULT), 480, 270);
        let difference = Difference::between(&exhaustive.pixels, &drawn.pixels);
        println!("{}: {difference:?}", isa.name);
        assert!(difference.psnr > 41.0, "{}: {difference:?}", isa.name);
    }
}

#[test]
fn balance_is_how_much_is_light_near_and_far() {
    let floor = |balance: f32, height: f32| Scene {
        camera: Camera {
            up: Vec3::Z,
            ..Camera::new(vec3(0.01, height, 0.0), vec3(0.01, 0.0, 0.0), 0.8)
        },
        ambient: Vec3::ONE,
        planes: List::of(&[Plane {
            half_x: 1e4,
            half_z: 1e4,
            material: Material {
                colour: Vec3::ONE,
                pattern: Pattern {
                    waves: vec3(2.0, 0.0, 0.0),
                    depth: 1.0,
                    edge: 100.0,
                    balance,
                    ..Pattern::NONE
                },
                ..Material::BLACK
            },
            ..Plane::default()
        }]),
        ..Scene::default()
    };
    for balance in [-1.0, -0.5, 0.0, 0.8, 1.0] {
        // From near, 20 whole stripes are seen, each sharp; from far away a pixel shows several.
        for height in [11.83, 3000.0] {
            let scene = floor(balance, height);
            let drawn = draw_best(&scene, &Quality::EXHAUSTIVE, 400, 400);
            let sum: u32 = drawn.pixels.iter().map(|pixel| pixel & 0xff).sum();
            let mean = sum as f32 / (255.0 * 400.0 * 400.0);
            let expected = 0.5 + 0.5 * balance;
            assert!(
                (mean - expected).abs() < 0.03,
                "{balance}, {height}: {mean}"
            );
        }
    }
}
