//! Scenes, times and cameras at the ends of their ranges, and beyond, give a defined picture for bounded work.

use crate::accuracy::assert_as_traced;
use crate::cpu;
use crate::drawn::{draw, draw_by_all};
use crate::error::Difference;
use crate::text::Text;
use crate::threaded_renderer::ThreadedRenderer;
use eightfold::show;
use eightfold_oracle::frame::Frame;
use eightfold_tracer::scene::{Block, Camera, Caption, List, Scene, Shape, Spot, Waves};
use eightfold_tracer::{Counts, Quality};
use glam::{Mat3, Vec3, vec3};

const QUALITIES: [Quality; 3] = [Quality::EXHAUSTIVE, Quality::THESIS, Quality::DEFAULT];

/// The number of rays of all kinds.
fn work(counts: &Counts) -> u64 {
    counts.rays + counts.shadow_rays
}

/// A scene scaled by a factor.
pub fn scaled(scene: &Scene, factor: f32) -> Scene {
    let mut scene = scene.clone();
    scene.haze /= factor;
    scene.camera.eye *= factor;
    scene.camera.look_at *= factor;
    scene.water.length *= factor;
    for sphere in scene.spheres.iter_mut() {
        sphere.centre *= factor;
        sphere.radius *= factor;
    }
    for plane in scene.planes.iter_mut() {
        plane.centre *= factor;
        plane.half_x *= factor;
        plane.half_z *= factor;
    }
    for light in scene.lights.iter_mut() {
        light.position *= factor;
        light.drawn_radius *= factor;
        light.diameter *= factor;
    }
    for block in scene.blocks.iter_mut() {
        block.centre *= factor;
        block.half *= factor;
    }
    scene
}

#[test]
fn a_scene_of_any_scale_gives_the_same_picture() {
    for scene in [show::model_scene(2.0), show::field(60, 2.0), rich()] {
        for quality in [Quality::EXHAUSTIVE, Quality::DEFAULT] {
            for isa in cpu::instruction_sets() {
                let picture = |scene: &Scene| draw(isa, 2, scene, &quality, 320, 240).pixels;
                let plain = picture(&scene);
                for factor in [1e-4, 1e-2, 0.7, 3.0, 1e2, 1e4] {
                    let scene = scaled(&scene, factor);
                    assert_eq!(scene.validate(), Ok(()));
                    let psnr = Difference::between(&plain, &picture(&scene)).psnr;
                    assert!(psnr >= 50.0, "{}, times {factor}: {psnr} dB", isa.name);
                }
            }
        }
    }
}

#[test]
fn scene_of_any_size_is_as_the_oracle_sees_it() {
    // Scaled, so that its lengths stay in their range by both factors.
    let scene = scaled(&rich(), 0.7);
    let oracle = |scene: &Scene| Frame::new(scene, &Quality::EXHAUSTIVE, 64, 48).picture();
    let known = oracle(&scene);
    for factor in [1e-8, 1e8] {
        let scene = scaled(&scene, factor);
        assert_eq!(scene.validate(), Ok(()));
        let by_all = draw_by_all(&scene, &Quality::EXHAUSTIVE, 64, 48);
        let pictures = by_all.into_iter().map(|(_, drawn)| drawn.pixels);
        for picture in pictures.chain([oracle(&scene)]) {
            let psnr = Difference::between(&known, &picture).psnr;
            assert!(psnr > 45.0, "times {factor}: {psnr} dB");
        }
    }
}

#[test]
fn a_camera_inside_on_and_along_a_sphere_sees_what_the_oracle_sees() {
    let mut scene = show::model_scene(0.0);
    let glass = scene.spheres[3].material;
    for material in [glass, scene.spheres[0].material] {
        // In the mirror's position, so that light comes from all directions.
        scene.spheres[1].material = material;
        let (centre, radius) = (scene.spheres[1].centre, scene.spheres[1].radius);
        for (distance, along) in [
            (0.0, false),
            (0.5, false),
            (0.999, false),
            (1.0, false),
            (1.0, true),
            (1.001, true),
            (1.5, false),
        ] {
            // Towards the centre, or along the surface.
            let eye = centre + Vec3::NEG_Z * (radius * distance);
            let ahead = if along { Vec3::X } else { Vec3::Z };
            scene.camera = Camera::new(eye, eye + ahead, 1.2);
            let frame = Frame::new(&scene, &Quality::EXHAUSTIVE, 120, 90);
            for (isa, drawn) in draw_by_all(&scene, &Quality::EXHAUSTIVE, 120, 90) {
                let what = format!("at {distance} radii, along it: {along}, by {}", isa.name);
                assert_as_traced(&drawn, &frame, &what);
            }
        }
    }
}

#[test]
fn any_time_gives_a_picture() {
    for quality in QUALITIES {
        for isa in cpu::instruction_sets() {
            let normal = work(&draw(isa, 1, &show::model_scene(0.0), &quality, 160, 120).counts);
            for time in [
                -0.0,
                -1e-30,
                -3.0,
                1e6,
                -1e6,
                1e30,
                f32::MAX,
                f32::NAN,
                f32::INFINITY,
                f32::NEG_INFINITY,
            ] {
                let drawn = draw(isa, 1, &show::model_scene(time), &quality, 160, 120);
                let rays = work(&drawn.counts);
                assert!(
                    2 * rays <= 5 * normal,
                    "{time} s: {rays} rays, not {normal}"
                );
            }
        }
    }
}

#[test]
fn a_million_seconds_on_the_picture_is_the_one_of_that_time() {
    let time = 1e6;
    let scene = show::model_scene(time);
    assert_eq!(scene.validate(), Ok(()));
    let angle = f64::from(time) * 0.25;
    let eye = scene.camera.eye.as_dvec3();
    assert!((eye.x - 7.5 * angle.sin()).abs() < 1e-4, "{eye}");
    assert!((eye.z + 7.5 * angle.cos()).abs() < 1e-4, "{eye}");
}

/// The model scene with a block of each shape and a large spotlight.
pub fn rich() -> Scene {
    let mut scene = show::model_scene(1.0);
    for (shape, x) in [
        (Shape::Box, -3.5),
        (Shape::Cylinder, 3.8),
        (Shape::Capsule, 5.0),
    ] {
        scene.blocks.push(Block {
            centre: vec3(x, 0.8, -1.0),
            half: vec3(0.4, 0.8, 0.4),
            axes: Mat3::IDENTITY,
            shape,
            material: scene.spheres[0].material,
        });
    }
    scene.water = Waves {
        slope: 0.02,
        length: 2.0,
        phase: 0.3,
    };
    let lamp = &mut scene.lights[0];
    lamp.diameter = 0.5;
    lamp.spot = Some(Spot {
        aim: -lamp.position.normalize(),
        outer_angle: 0.795,
        inner_angle: 0.45,
    });
    scene
}

#[test]
#[ignore = "many frames"]
fn nan_and_infinity_are_refused_and_still_give_a_picture_for_bounded_work() {
    for scene in [show::model_scene(1.0), rich()] {
        assert_numbers_are_checked(scene);
    }
}

/// Asserts that for each number of a scene.
fn assert_numbers_are_checked(mut scene: Scene) {
    scene.method.points = 0.4;
    scene.captions.push(Caption {
        letters: List::of(b"EIGHTFOLD"),
        middle: 0.5,
        size: 0.2,
        brightness: 0.8,
    });
    assert_eq!(scene.validate(), Ok(()));
    let text = Text::of(&scene);
    let mut renderer = ThreadedRenderer::new(1);
    let mut pixels = vec![0; 64 * 48];
    for quality in QUALITIES {
        for isa in cpu::instruction_sets() {
            let all = work(&draw(isa, 1, &scene, &Quality::EXHAUSTIVE, 64, 48).counts);
            let normal = work(&draw(isa, 1, &scene, &quality, 64, 48).counts);
            for i in 0..text.numbers.len() {
                for wrong in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
                    let (scene, name) = text.scene_with(i, wrong);
                    let what = format!("{name} {wrong} by {}", isa.name);
                    assert!(scene.validate().is_err(), "{what}");
                    pixels.fill(u32::MAX);
                    let rays = work(&renderer.draw(isa.level, &scene, &quality, 64, &mut pixels));
                    // Without a tolerance no square is filled.
                    let normal = if name == "tolerance" { all } else { normal };
                    assert!(2 * rays <= 5 * normal, "{what}: {rays} rays, not {normal}");
                    assert!(pixels.iter().all(|pixel| pixel >> 24 == 0), "{what}");
                }
            }
        }
    }
}

#[test]
fn many_spheres_with_invalid_coordinates_give_a_picture() {
    // There are enough spheres for bounds, which such numbers affect, too.
    let normal = show::field(100, 1.0);
    for wrong in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY, f32::MAX] {
        for every in [1, 3, 50] {
            let mut scene = normal.clone();
            for sphere in scene.spheres.iter_mut().step_by(every) {
                sphere.centre.x = wrong;
            }
            assert!(scene.validate().is_err());
            for quality in QUALITIES {
                for isa in cpu::instruction_sets() {
                    let one = draw(isa, 1, &scene, &quality, 64, 48);
                    let most = 5 * work(&draw(isa, 1, &normal, &quality, 64, 48).counts) / 2;
                    assert!(work(&one.counts) <= most, "{wrong}, every {every}");
                    let two = draw(isa, 2, &scene, &quality, 64, 48);
                    assert!(one.pixels == two.pixels, "{wrong}, every {every}");
                }
            }
        }
    }
}

#[test]
fn a_scene_is_refused_by_its_first_number_out_of_range() {
    let refused = |change: fn(&mut Scene)| {
        let mut scene = show::model_scene(0.0);
        change(&mut scene);
        scene.validate().unwrap_err().to_string()
    };
    for (change, message) in [
        (
            (|scene| scene.spheres[2].radius = 0.0) as fn(&mut Scene),
            "spheres[2].radius is 0, must be 1e-9 to 1e9",
        ),
        (
            |scene| scene.lights[1].colour = glam::vec3(1.0, -1.0, 0.5),
            "lights[1].colour is [1, -1, 0.5], must be 0 to 1e9",
        ),
        (
            |scene| {
                scene.camera.eye = glam::vec3(1.0, 2.0, 3.0);
                scene.camera.look_at = scene.camera.eye;
            },
            "camera.look_at is [1, 2, 3], must be a point that is not the eye",
        ),
        (
            |scene| {
                scene.camera.look_at = scene.camera.eye + glam::Vec3::X;
                scene.camera.up = glam::Vec3::X;
            },
            "camera.up is [1, 0, 0], must be off the line of sight",
        ),
        (
            |scene| scene.haze = f32::NAN,
            "haze is NaN, must be 0 to 1000",
        ),
    ] {
        assert_eq!(refused(change), message);
    }
    for time in [0.0, 12.0] {
        assert_eq!(show::field(320, time).validate(), Ok(()));
    }
    assert_eq!(Scene::default().validate(), Ok(()));
}
