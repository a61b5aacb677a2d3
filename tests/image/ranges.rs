//! Arguments out of their range are refused, those at its ends are not; lengths at its ends draw what they are.

use crate::cpu;
use crate::drawn::draw;
use crate::error::Difference;
use crate::studio::Studio;
use eightfold::scene::{Block, Camera, List, Scene, Shape, Sphere};
use eightfold::{MAX_HEIGHT, MAX_WIDTH, Quality, show};
use glam::{Mat3A, Vec3A};
use std::panic::catch_unwind;

fn refused(quality: Quality, width: usize, height: usize) -> bool {
    catch_unwind(|| draw(cpu::best(), 1, &show::scene(0.0), &quality, width, height)).is_err()
}

#[test]
fn sizes_out_of_range_are_refused() {
    for (width, height) in [
        (1, 0),
        (MAX_WIDTH + 1, 1),
        (1, MAX_HEIGHT + 1),
        (MAX_HEIGHT, MAX_WIDTH),
    ] {
        assert!(refused(Quality::THESIS, width, height), "{width}x{height}");
    }
}

#[test]
fn pixels_that_do_not_fill_the_picture_are_refused() {
    let half_a_row = catch_unwind(|| {
        let mut pixels = vec![0; 15];
        let level = cpu::best().level;
        Studio::new(1).draw(level, &show::scene(0.0), &Quality::THESIS, 10, &mut pixels);
    });
    assert!(half_a_row.is_err());
}

#[test]
fn qualities_out_of_range_are_refused() {
    for square in [0, Quality::MAX_SQUARE + 1, usize::MAX] {
        let quality = Quality {
            square,
            ..Quality::THESIS
        };
        assert!(refused(quality, 64, 48), "squares of {square}");
    }
    for depth in [Quality::MAX_DEPTH + 1, u32::MAX] {
        let quality = Quality {
            depth,
            ..Quality::THESIS
        };
        assert!(refused(quality, 64, 48), "depth {depth}");
    }
}

#[test]
fn comparing_deeper_than_rays_go_compares_all() {
    let scene = show::scene(0.0);
    let compare = |depth| {
        let quality = Quality {
            key_depth: depth,
            state_depth: depth,
            ..Quality::THESIS
        };
        draw(cpu::best(), 1, &scene, &quality, 200, 150).pixels
    };
    let all = compare(Quality::MAX_DEPTH);
    for depth in [8, 30, 31, 32, 40, u32::MAX] {
        assert!(compare(depth) == all, "depth {depth}");
    }
}

#[test]
fn an_empty_scene_is_its_background() {
    let scene = Scene {
        background: glam::vec3a(1.0, 0.5, 0.0),
        ..Scene::default()
    };
    for isa in cpu::instruction_sets() {
        for quality in [Quality::EXHAUSTIVE, Quality::THESIS] {
            let drawn = draw(isa, 2, &scene, &quality, 70, 50);
            assert!(drawn.pixels.iter().all(|&pixel| pixel == 0x00ff_8000));
            assert_eq!(drawn.counts.rays, drawn.counts.points);
        }
    }
}

/// A camera at the distance `r` from the origin, with lights for objects of that size.
fn of_length(r: f32) -> Scene {
    let mut scene = show::scene(0.0);
    scene.spheres = List::default();
    scene.planes = List::default();
    scene.camera = Camera::default();
    scene.camera.eye = Vec3A::Z * r;
    scene.camera.look_at = Vec3A::ZERO;
    for light in scene.lights.iter_mut() {
        light.position *= 0.125 * r;
        light.radius = 0.0;
    }
    scene
}

#[test]
fn ends_of_the_ranges_of_lengths_draw_what_they_are() {
    let material = show::scene(0.0).spheres[0].material;
    // Over the whole range of lengths.
    let sphere = |r: f32| {
        let mut scene = of_length(r);
        scene.spheres.push(Sphere {
            centre: Vec3A::NEG_Z * r,
            radius: r,
            material,
        });
        scene
    };
    let block = |r: f32, shape: Shape| {
        let mut scene = of_length(r);
        scene.blocks.push(Block {
            centre: Vec3A::NEG_Z * r,
            half: Vec3A::splat(r),
            axes: Mat3A::from_rotation_x(0.5),
            shape,
            material,
        });
        scene
    };
    let scenes: [&dyn Fn(f32) -> Scene; 3] = [&sphere, &|r| block(r, Shape::Box), &|r| {
        block(r, Shape::Cylinder)
    }];
    for scene in scenes {
        for isa in cpu::instruction_sets() {
            let picture = |r| draw(isa, 1, &scene(r), &Quality::EXHAUSTIVE, 96, 72).pixels;
            let one = picture(1.0);
            let nothing = draw(isa, 1, &of_length(1.0), &Quality::EXHAUSTIVE, 96, 72).pixels;
            let seen = Difference::between(&nothing, &one).psnr;
            assert!(seen < 30.0, "{}: nothing is seen", isa.name);
            for r in [2e-9, 1e-8, 1e-4, 1e6, 1e8, 1e9] {
                assert_eq!(scene(r).validate(), Ok(()), "{r}");
                let psnr = Difference::between(&one, &picture(r)).psnr;
                assert!(psnr >= 50.0, "{}, length {r}: {psnr} dB", isa.name);
            }
        }
    }
}
