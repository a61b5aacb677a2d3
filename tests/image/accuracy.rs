//! If every pixel is traced, pictures are those of the oracle.

use crate::drawn::{Drawn, draw_by_all};
use crate::error::{Difference, worst_channel};
use eightfold::show::{self, grid};
use eightfold_oracle::frame::Frame;
use eightfold_tracer::Quality;
use eightfold_tracer::scene::{Camera, Light, List, Material, Method, Scene, Sphere};
use glam::{Vec3, vec3};

/// Asserts that a picture is the oracle's: at most 0.02 % of the pixels, or four in a small picture, are wrong by more than 8/255,
/// on silhouettes alone, and the mean error of the others is at most 0.01/255.
#[track_caller]
pub fn assert_as_traced(drawn: &Drawn, frame: &Frame, what: &str) {
    let expected = frame.picture_like(&drawn.pixels);
    let difference = Difference::between(&expected, &drawn.pixels);
    let mean = mean_of_right(&expected, &drawn.pixels);
    assert!(mean <= 0.01, "{what}: {mean}, {difference:?}");
    // Silhouettes, as checked below. In small pictures what glass and mirror balls show of others' may have four.
    let most = (expected.len() / 5000).max(4);
    assert!(difference.over_8 <= most, "{what}: {difference:?}");
    let silhouettes = frame.silhouettes();
    for (i, (&a, &b)) in expected.iter().zip(&drawn.pixels).enumerate() {
        let (x, y) = (i % frame.width, i / frame.width);
        let off = worst_channel(a, b);
        assert!(
            off <= 8 || silhouettes[i],
            "{what}: ({x}, {y}) is off by {off}: {b:06x} for {a:06x}"
        );
    }
}

/// The mean error of the pixels that are off by 8/255 at most: in a small picture a single other one is more than that.
pub fn mean_of_right(expected: &[u32], drawn: &[u32]) -> f64 {
    let pairs = expected.iter().zip(drawn);
    let right = pairs.filter(|&(&a, &b)| worst_channel(a, b) <= 8);
    let (expected, drawn): (Vec<u32>, Vec<u32>) = right.unzip();
    Difference::between(&expected, &drawn).mean
}

fn hold(scene: &Scene, width: usize, height: usize, what: &str) {
    let frame = Frame::new(scene, &Quality::EXHAUSTIVE, width, height);
    for (isa, drawn) in draw_by_all(scene, &Quality::EXHAUSTIVE, width, height) {
        assert_as_traced(&drawn, &frame, &format!("{what} by {}", isa.name));
    }
}

#[test]
fn a_field_of_spheres_is_as_the_oracle_sees_it() {
    for (count, time) in [(4, 0.0), (64, 3.0), (256, 9.0), (320, 1.0)] {
        let what = format!("a field of {count} at {time} s");
        hold(&show::field(count, time), 240, 180, &what);
    }
}

#[test]
fn every_scene_of_the_show_is_as_the_oracle_sees_it() {
    for bar in 0..show::BARS {
        if bar % 3 != 1 {
            continue;
        }
        let time = (bar as f32 + 0.3) * grid::BAR;
        let mut scene = Scene::default();
        show::at(time, &mut scene);
        // The oracle draws no captions and bars, and every pixel of a transition.
        scene.captions.clear();
        scene.copper_bars.clear();
        scene.method = Method::default();
        scene.validate().unwrap();
        // In a smaller picture the share of silhouettes, which rounding may change, would be too large.
        let frame = Frame::new(&scene, &Quality::EXHAUSTIVE, 320, 180);
        for (isa, drawn) in draw_by_all(&scene, &Quality::EXHAUSTIVE, 320, 180) {
            assert_as_traced(&drawn, &frame, &format!("bar {bar} by {}", isa.name));
        }
    }
}

#[test]
fn as_many_rays_are_followed_as_by_the_oracle() {
    let near = |count: u64, expected: u64| count.abs_diff(expected) <= expected / 5000;
    for time in [0.0, 2.5] {
        let scene = show::model_scene(time);
        let frame = Frame::new(&scene, &Quality::EXHAUSTIVE, 320, 240);
        let (rays, shadow_rays) = (frame.total(|p| p.rays), frame.total(|p| p.shadow_rays));
        for (isa, Drawn { counts, .. }) in draw_by_all(&scene, &Quality::EXHAUSTIVE, 320, 240) {
            let what = format!("{} at {time} s: {counts:?}", isa.name);
            assert_eq!(counts.points, 320 * 240, "{what}");
            assert!(near(counts.rays, rays), "{what}, {rays} expected");
            // The library need not cast shadow rays that cannot be blocked.
            assert!(
                counts.shadow_rays <= shadow_rays + shadow_rays / 5000,
                "{what}, {shadow_rays} expected"
            );
        }
    }
}

#[test]
fn silhouettes_are_the_lesser_part_of_a_picture() {
    // Otherwise it would mean little that large errors lie on silhouettes alone.
    let frame = Frame::new(&show::model_scene(0.0), &Quality::EXHAUSTIVE, 1024, 768);
    let on = frame.silhouettes().iter().filter(|&&on| on).count();
    assert!(on < 1024 * 768 / 8, "{on} pixels");
}

/// Concentric glass shells around the eye: every ray hits one, and is both reflected and transmitted.
fn shells(count: usize) -> Scene {
    let glass = Material {
        colour: Vec3::splat(0.9),
        kd: 0.2,
        ks: 0.5,
        exponent: 50.0,
        kr: 0.5,
        kt: 0.5,
        index: 1.01,
        ..Material::BLACK
    };
    let shell = |i| Sphere::new(Vec3::ZERO, 2.0 + 0.5 * i as f32, glass);
    let shells: Vec<Sphere> = (0..count).map(shell).collect();
    Scene {
        camera: Camera::new(vec3(0.1, 0.2, 0.3), Vec3::X, 1.0),
        background: Vec3::splat(0.4),
        ambient: Vec3::splat(0.3),
        spheres: shells.iter().copied().collect(),
        ..Scene::default()
    }
}

#[test]
fn no_ray_is_lost_where_every_ray_goes_on_in_two() {
    let scene = shells(Quality::MAX_DEPTH as usize + 1);
    for depth in 0..=Quality::MAX_DEPTH {
        let quality = Quality {
            depth,
            least_contribution: 0.0,
            ..Quality::EXHAUSTIVE
        };
        let frame = Frame::new(&scene, &quality, 75, 50);
        for (isa, drawn) in draw_by_all(&scene, &quality, 75, 50) {
            let what = format!("depth {depth} by {}", isa.name);
            let tree = (2 << depth) - 1;
            assert_eq!(drawn.counts.rays, drawn.counts.points * tree, "{what}");
            assert_as_traced(&drawn, &frame, &what);
        }
    }
}

#[test]
fn no_ray_is_lost_where_some_end_and_others_go_on_in_two() {
    // Rays that hit the black sphere in front of the eye end there, so that packets of secondary rays are not full.
    let mut scene = shells(Quality::MAX_DEPTH as usize + 1);
    scene.lights = List::of(&[Light {
        drawn_radius: 0.15,
        ..Light::new(vec3(0.6, 0.2, 0.3), Vec3::ZERO)
    }]);
    let quality = Quality {
        depth: Quality::MAX_DEPTH,
        least_contribution: 0.0,
        ..Quality::EXHAUSTIVE
    };
    let frame = Frame::new(&scene, &quality, 150, 100);
    let expected = frame.total(|point| point.rays);
    for (isa, drawn) in draw_by_all(&scene, &quality, 150, 100) {
        let rays = drawn.counts.rays;
        let lost = expected.abs_diff(rays);
        assert!(
            lost <= expected / 5000,
            "{}: {rays} for {expected}",
            isa.name
        );
        assert_as_traced(&drawn, &frame, isa.name);
    }
}

#[test]
fn a_lamp_lights_the_sphere_around_it_from_within_alone() {
    let mut scene = shells(1);
    scene.planes = show::model_scene(0.0).planes.iter().copied().collect();
    for (lamp, eye) in [
        (vec3(0.5, 0.7, 0.1), vec3(0.1, 0.2, 0.3)),
        (vec3(0.5, 0.7, 0.1), vec3(1.0, 3.0, 7.0)),
        (vec3(3.5, 3.7, 0.1), vec3(0.1, 0.2, 0.3)),
    ] {
        scene.camera.eye = eye;
        scene.camera.look_at = Vec3::ZERO;
        scene.lights = List::of(&[Light {
            drawn_radius: 0.1,
            ..Light::new(lamp, Vec3::ONE)
        }]);
        hold(
            &scene,
            120,
            90,
            &format!("a lamp at {lamp} seen from {eye}"),
        );
    }
}
