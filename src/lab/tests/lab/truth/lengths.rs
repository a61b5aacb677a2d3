//! Scenes of any size, and lamps within a sphere: the same by the path tracer, the oracle and the library.

use super::{WHITE, assert_near, drawn, seen};
use eightfold_lab::arguments::Size;
use eightfold_lab::error::Difference;
use eightfold_lab::threaded_renderer;
use eightfold_lab::truth::effects::Effects;
use eightfold_lab::truth::estimate::Estimate;
use eightfold_oracle::Oracle;
use eightfold_oracle::frame::Frame;
use eightfold_tracer::Quality;
use eightfold_tracer::glam::{DVec3, Mat3A, Vec3A, vec3a};
use eightfold_tracer::scene::{Block, Camera, Light, List, Material, Plane, Scene, Shape, Sphere};

const SIZE: Size = Size::new(64, 48);

/// A scene with all shapes, a mirror, glass and two lamps, of which all lengths are multiplied by a factor.
fn scene(factor: f32) -> Scene {
    let at = |x: f32, y: f32, z: f32| factor * vec3a(x, y, z);
    let matt = Material {
        colour: vec3a(0.8, 0.5, 0.3),
        kd: 0.8,
        ks: 0.2,
        exponent: 20.0,
        ..Material::BLACK
    };
    let mirror = Material { kr: 0.6, ..matt };
    let glass = Material {
        kd: 0.1,
        kr: 0.1,
        kt: 0.8,
        index: 1.4,
        ..matt
    };
    let sphere = |centre: Vec3A, material| Sphere::new(centre, 0.7 * factor, material);
    let block = |centre: Vec3A, shape| Block {
        axes: Mat3A::from_rotation_y(0.5),
        ..Block::new(shape, centre, at(0.4, 0.6, 0.4), matt)
    };
    let lamp = |position: Vec3A| Light::new(position, Vec3A::splat(0.5));
    Scene {
        camera: Camera::new(at(0.3, 1.6, 5.0), at(0.0, 0.6, 0.0), 0.8),
        background: vec3a(0.1, 0.2, 0.3),
        ambient: Vec3A::splat(0.1),
        spheres: List::of(&[
            sphere(at(-1.1, 0.7, 0.2), mirror),
            sphere(at(0.4, 0.7, 0.9), glass),
        ]),
        planes: List::of(&[Plane::new(
            Vec3A::ZERO,
            3.0 * factor,
            3.0 * factor,
            Material { kr: 0.2, ..matt },
        )]),
        blocks: List::of(&[
            block(at(1.6, 0.6, -0.6), Shape::Box),
            block(at(0.2, 0.6, -1.2), Shape::Cylinder),
            block(at(-1.6, 0.9, -1.4), Shape::Capsule),
        ]),
        lights: List::of(&[lamp(at(-3.0, 4.0, 2.0)), lamp(at(2.0, 5.0, 3.0))]),
        ..Scene::default()
    }
}

#[test]
#[ignore = "many paths of light"]
fn a_scene_of_any_size_gives_one_picture_by_paths_by_the_oracle_and_by_the_library() {
    let by_paths = |factor, effects| -> Vec<u32> {
        let estimates = drawn(&scene(factor), SIZE, effects, 8);
        estimates.iter().map(Estimate::pixel).collect()
    };
    let by_oracle = |factor| {
        let frame = Frame::new(
            &scene(factor),
            &Quality::EXHAUSTIVE,
            SIZE.width,
            SIZE.height,
        );
        frame.picture()
    };
    let by_library =
        |factor| threaded_renderer::drawn(1, &scene(factor), &Quality::EXHAUSTIVE, SIZE);
    let (model, truth, oracle) = (
        by_paths(1.0, Effects::NONE),
        by_paths(1.0, Effects::TRUTH),
        by_oracle(1.0),
    );
    let differ = |a: &[u32], b: &[u32]| Difference::between(a, b).psnr;
    // The noise of mirrors and glass, of which one way is chosen by chance.
    assert!(differ(&model, &oracle) > 30.0);
    for factor in [1e-8, 1.0, 1e8] {
        for (what, psnr) in [
            ("model", differ(&model, &by_paths(factor, Effects::NONE))),
            ("truth", differ(&truth, &by_paths(factor, Effects::TRUTH))),
            ("oracle", differ(&oracle, &by_oracle(factor))),
            ("library", differ(&oracle, &by_library(factor))),
        ] {
            assert!(psnr > 45.0, "{what}, times {factor}: {psnr} dB");
        }
    }
}

#[test]
fn a_dome_is_lit_from_within_by_lamps_of_any_size_that_it_contains() {
    // The lamp is above the middle, and the camera looks along a line to the side of the dome.
    let radius = 20.0;
    for size in [0.0, 0.5, 10.0] {
        let lamp = Light {
            diameter: size,
            ..Light::new(vec3a(0.0, 6.0, 0.0), vec3a(0.9, 0.6, 0.3))
        };
        let scene = Scene {
            camera: Camera::new(Vec3A::ZERO, Vec3A::NEG_Z, 0.001),
            spheres: List::of(&[Sphere::new(Vec3A::ZERO, radius, WHITE)]),
            // Nobody sees it, and it is in nobody's way.
            blocks: List::of(&[Block::new(
                Shape::Box,
                vec3a(60.0, 0.0, 0.0),
                vec3a(3.0, 5.0, 2.0),
                WHITE,
            )]),
            lights: List::of(&[lamp]),
            ..Scene::default()
        };
        // The cosine at the point (0, 0, -radius) that is seen.
        let cosine = radius / radius.hypot(lamp.position.y);
        let known = f64::from(cosine) * lamp.colour.as_dvec3();
        let without = Effects {
            indirect: false,
            ..Effects::TRUTH
        };
        assert_near(seen(&scene, without, 1024), known, 0.01);
        assert_near(seen(&scene, Effects::NONE, 8), known, 1e-9);
        let traced = Oracle::new(&scene, &Quality::EXHAUSTIVE, 1, 1).trace(0, 0);
        assert!((traced.colour - known).abs().max_element() < 1e-6, "{size}");
    }
}

#[test]
fn a_lamp_that_a_dome_does_not_contain_does_not_light_it_from_within() {
    let scene = Scene {
        camera: Camera::new(Vec3A::ZERO, Vec3A::NEG_Z, 0.001),
        spheres: List::of(&[Sphere::new(Vec3A::ZERO, 20.0, WHITE)]),
        lights: List::of(&[Light {
            diameter: 1.0,
            ..Light::new(vec3a(0.0, 30.0, 0.0), Vec3A::ONE)
        }]),
        ..Scene::default()
    };
    let traced = Oracle::new(&scene, &Quality::EXHAUSTIVE, 1, 1).trace(0, 0);
    assert_eq!(traced.colour, DVec3::ZERO);
}
