use crate::{lab, stderr};
use eightfold_harness::Size;
use eightfold_lab::truth::{Comparison, Estimate, draw};
use eightfold_oracle::Oracle;
use eightfold_tracer::Quality;
use eightfold_tracer::glam::{DVec3, Mat3, Vec3, vec3};
use eightfold_tracer::scene::{
    Block, Camera, Light, List, Material, Pattern, Plane, Scene, Shape, Sphere, Spot,
};

const WHITE: Material = Material::matt(Vec3::ONE, 1.0);
const COLOUR: Vec3 = vec3(0.9, 0.6, 0.3);

/// Asserts an error of at most five standard errors, and these below `max`.
#[track_caller]
fn assert_near(estimate: Estimate, known: DVec3, max: f64) {
    // Scenes are in f32.
    let allowed = estimate.variance.map(f64::sqrt) * 5.0 + 1e-6;
    let off = (estimate.mean - known).abs();
    assert!(allowed.max_element() < max, "noise: {allowed}");
    assert!(off.cmple(allowed).all(), "{} is not {known}", estimate.mean);
}

fn estimate(scene: &Scene, samples: u32) -> Estimate {
    assert_eq!(scene.validate(), Ok(()));
    draw(scene, Size::new(1, 1), samples, 1)[0]
}

/// The camera sees the origin of a white floor from the side.
fn floor(light: Light) -> Scene {
    Scene {
        camera: Camera::new(vec3(4.0, 0.6, 0.0), Vec3::ZERO, 1e-4),
        planes: List::of(&[Plane::new(Vec3::ZERO, 1e4, 1e4, WHITE)]),
        lights: List::of(&[light]),
        ..Scene::default()
    }
}

fn light(position: Vec3, diameter: f32) -> Light {
    Light { diameter, ..Light::new(position, COLOUR) }
}

#[test]
fn white_furnace_is_uniform() {
    let keeping = |kd, kr, kt| Material { kd, kr, kt, index: 1.5, ..WHITE };
    let sphere = |x: f32, material| Sphere::new(vec3(x, 0.2, 0.3 * x), 0.6, material);
    let block = |z, shape| Block {
        axes: Mat3::from_rotation_y(0.4),
        ..Block::new(shape, vec3(0.7, 0.1, z), Vec3::splat(0.4), keeping(0.6, 0.4, 0.0))
    };
    let scene = Scene {
        camera: Camera::new(vec3(0.0, 1.0, 5.0), Vec3::ZERO, 0.8),
        background: vec3(0.5, 0.25, 1.0),
        spheres: List::of(&[
            sphere(-1.2, WHITE),
            sphere(0.0, keeping(0.0, 0.1, 0.9)),
            sphere(1.2, keeping(0.0, 1.0, 0.0)),
        ]),
        blocks: List::of(&[
            block(1.4, Shape::Box),
            block(-1.4, Shape::Cylinder),
            block(-2.6, Shape::Capsule),
        ]),
        planes: List::of(&[Plane::new(-0.5 * Vec3::Y, 2.0, 2.0, keeping(0.7, 0.3, 0.0))]),
        ..Scene::default()
    };
    for estimate in draw(&scene, Size::new(16, 12), 256, 1) {
        assert_near(estimate, scene.background.as_dvec3(), 0.2);
    }
}

#[test]
fn light_of_any_size_gives_same_irradiance() {
    let position = vec3(1.0, 2.0, 0.5);
    let known = f64::from(position.normalize().y) * COLOUR.as_dvec3();
    for diameter in [0.0, 0.1, 1.0, 3.0] {
        let sphere = light(position, diameter);
        let sun = Light { parallel: true, ..sphere };
        let spot = Light {
            spot: Some(Spot { aim: -position.normalize(), outer_angle: 0.45, inner_angle: 0.2 }),
            ..sphere
        };
        for light in [sphere, sun, spot] {
            assert_near(estimate(&floor(light), 1024), known, 0.06);
        }
    }
}

#[test]
fn surface_reflects_share_of_sky() {
    // From above, the highlight's integral is 2 ks / (exponent + 1).
    let mut scene = floor(light(Vec3::NEG_Y, 0.0));
    scene.camera.eye = vec3(0.0, 4.0, 0.01);
    scene.background = COLOUR;
    scene.planes[0].material =
        Material { ks: 0.8, exponent: 7.0, ..Material::matt(Vec3::ONE, 0.3) };
    assert_near(estimate(&scene, 4096), 0.5 * COLOUR.as_dvec3(), 0.04);
}

#[test]
fn ball_hides_share_of_light() {
    // Ball and light are concentric discs, with areas as the squared sines.
    let mut scene = floor(light(vec3(0.0, 6.0, 0.0), 2.0));
    let sphere = Sphere::new(vec3(0.0, 3.0, 0.0), 0.3, Material::BLACK);
    scene.spheres.push(sphere);
    let hidden = (0.3_f64 / 3.0).powi(2) / (1.0_f64 / 6.0).powi(2);
    assert_near(estimate(&scene, 4096), (1.0 - hidden) * COLOUR.as_dvec3(), 0.04);
}

#[test]
fn mirrors_add_images_of_light() {
    // Walls at x = -2 and 2 show images at x = 4 i + 0.5 for even i, and 4 i - 0.5 for odd i, by
    // |i| bounces.
    let mut scene = floor(light(vec3(0.5, 2.0, 0.0), 2.8));
    let wall = |x: f32| {
        let half = vec3(0.01, 40.0, 40.0);
        Block::new(Shape::Box, vec3(x, 0.0, 0.0), half, Material::mirror(0.5))
    };
    scene.blocks = List::of(&[wall(-2.01), wall(2.01)]);
    scene.camera.eye = vec3(1.0, 0.6, 0.0);
    let image = |i: i32| {
        let x = 4.0 * f64::from(i) + if i % 2 == 0 { 0.5 } else { -0.5 };
        0.5_f64.powi(i.abs()) * 2.0 / f64::hypot(2.0, x)
    };
    let cosines: f64 = (-40..=40).map(image).sum();
    assert_near(estimate(&scene, 40_000), cosines * COLOUR.as_dvec3(), 0.15);
}

#[test]
fn lone_ball_matches_oracle() {
    let material = Material {
        ks: 0.7,
        exponent: 9.0,
        anisotropy: 0.4,
        metallic: 0.5,
        pattern: Pattern { depth: 0.8, waves: Vec3::splat(2.0), ..Pattern::default() },
        ..Material::matt(COLOUR, 0.6)
    };
    let mut scene = floor(light(vec3(4.0, 4.0, 1.0), 0.0));
    scene.planes.clear();
    scene.haze = 0.1;
    scene.spheres.push(Sphere::new(Vec3::ZERO, 1.0, material));
    let traced = Oracle::new(&scene, &Quality::EXHAUSTIVE, 1, 1).trace(0, 0);
    assert!(traced.colour.min_element() > 0.04, "{}", traced.colour);
    let estimate = estimate(&scene, 16);
    let off = (estimate.mean - traced.colour).abs().max_element();
    assert!(off < 1e-3, "{estimate:?}");
}

#[test]
fn error_is_within_standard_error() {
    let mut scene = floor(light(vec3(0.0, 6.0, 0.0), 2.0));
    scene.lights[0].colour *= 0.5;
    scene.camera = Camera::new(vec3(0.0, 2.0, 9.0), Vec3::ZERO, 0.6);
    let sphere = Sphere::new(vec3(0.0, 1.5, 0.0), 1.0, WHITE);
    scene.spheres.push(sphere);
    let size = Size::new(24, 18);
    let grey = vec![0x0080_8080; size.area()];
    let compare = |samples, seed| Comparison::new(&grey, &draw(&scene, size, samples, seed));
    let fine = compare(1024, 0);
    let ratio = compare(16, 0).noise / fine.noise;
    assert!((7.0..9.0).contains(&ratio), "{ratio}");
    for seed in 1..=10 {
        let coarse = compare(16, seed);
        let square = coarse.error.powi(2) - coarse.noise.powi(2);
        let off = square.sqrt() - fine.error;
        assert!(off.abs() < 0.2 * coarse.noise, "{coarse:?}, {fine:?}");
    }
}

#[test]
fn picture_is_reproducible() {
    let truth = || lab("truth --size 24x18 --samples 4 --out -");
    let first = truth();
    let stderr = stderr(&first);
    let comparison = "`default` against 4 paths a pixel: RMS error ";
    assert!(stderr.contains(comparison), "{stderr}");
    assert!(first.status.success() && first.stdout == truth().stdout);
}
