//! Arguments out of their range are refused, those at its ends are not; lengths at its ends draw what they are.

use crate::cpu;
use crate::drawn::{draw, draw_best};
use crate::error::Difference;
use eightfold::show;
use eightfold_tracer::scene::{Block, Camera, List, Scene, Shape, Sphere};
use eightfold_tracer::{Error, Frame, MAX_HEIGHT, MAX_WIDTH, Memory, Quality, Renderer, Worker};
use glam::{Mat3, Vec3};
use std::panic::catch_unwind;

/// Why a frame with so many pixels is not rendered, if it is not. Then all its pixels are as before.
fn refusal(
    scene: &Scene,
    quality: &Quality,
    (width, height): (usize, usize),
    count: usize,
) -> Option<Error> {
    let mut pixels = vec![1; count];
    let frame = Frame::new(width, height, &mut pixels);
    let mut renderer = Renderer::with_memory(cpu::best().level, Box::new(Memory::new()));
    let result = renderer.render(scene, quality, frame, &mut Worker::new());
    if result.is_err() {
        assert!(pixels.iter().all(|&pixel| pixel == 1), "it is rendered");
    }
    result.err()
}

/// Whether a frame that is said to be valid panics.
fn panics(quality: Quality, (width, height): (usize, usize), count: usize) -> bool {
    let panic = catch_unwind(|| {
        let mut pixels = vec![0; count];
        let frame = Frame::new(width, height, &mut pixels);
        let mut renderer = Renderer::with_memory(cpu::best().level, Box::new(Memory::new()));
        renderer.render_valid(&show::model_scene(0.0), &quality, frame, &mut Worker::new());
    });
    panic.is_err()
}

#[test]
fn sizes_out_of_range_are_refused() {
    for (width, height) in [
        (0, 1),
        (1, 0),
        (MAX_WIDTH + 1, 1),
        (1, MAX_HEIGHT + 1),
        (MAX_HEIGHT, MAX_WIDTH),
        (usize::MAX, usize::MAX),
    ] {
        let size = (width, height);
        let error = refusal(&show::model_scene(0.0), &Quality::THESIS, size, 16);
        assert_eq!(error, Some(Error::Size { width, height }));
        let text = format!("a frame has 1x1 to 3840x2160 pixels, and not {width}x{height}");
        assert_eq!(error.unwrap().to_string(), text);
        assert!(panics(Quality::THESIS, size, 16), "{width}x{height}");
    }
}

#[test]
fn too_few_pixels_are_refused_and_more_than_enough_stay() {
    let scene = show::model_scene(0.0);
    let error = refusal(&scene, &Quality::THESIS, (10, 2), 19).unwrap();
    let text = "a frame of this size takes 20 pixels, and there are 19";
    assert_eq!(error.to_string(), text);
    assert!(panics(Quality::THESIS, (10, 2), 19));

    let mut pixels = [1; 25];
    let frame = Frame::new(10, 2, &mut pixels);
    let mut renderer = Renderer::with_memory(cpu::best().level, Box::new(Memory::new()));
    let result = renderer.render(&scene, &Quality::THESIS, frame, &mut Worker::new());
    assert!(result.is_ok());
    assert!(pixels[..20].iter().all(|&pixel| pixel != 1));
    assert_eq!(pixels[20..], [1; 5]);
}

#[test]
fn a_frame_in_a_larger_picture_has_the_same_bits_and_leaves_the_rest() {
    const STRIDE: usize = 117;
    let mut renderer = Renderer::with_memory(cpu::best().level, Box::new(Memory::new()));
    // One with a pattern, one with captions, one with the method's marks.
    for time in [4.0, 20.0, 100.0] {
        let mut scene = Scene::default();
        show::at(time, &mut scene);
        for quality in Quality::LADDER.iter().chain([&Quality::THESIS]) {
            for (width, height) in [(1, 1), (8, 33), (101, 70), (STRIDE, 64)] {
                let mut alone = vec![0; width * height];
                let frame = Frame::new(width, height, &mut alone);
                let expected = renderer.render(&scene, quality, frame, &mut Worker::new());
                let mut pixels = vec![1 << 24; STRIDE * height];
                let needed = STRIDE * (height - 1) + width;
                let frame = Frame::new(width, height, &mut pixels[..needed]).with_stride(STRIDE);
                let counts = renderer.render(&scene, quality, frame, &mut Worker::new());
                assert_eq!(counts, expected);
                for (y, row) in pixels.chunks(STRIDE).enumerate() {
                    assert_eq!(row[..width], alone[y * width..][..width]);
                    assert!(row[width..].iter().all(|&pixel| pixel == 1 << 24));
                }
            }
        }
    }
}

#[test]
fn strides_that_do_not_fit_are_refused() {
    let mut renderer = Renderer::with_memory(cpu::best().level, Box::new(Memory::new()));
    let short =
        |pixels: usize| format!("a frame of this size takes {pixels} pixels, and there are 20");
    let narrow = "a frame 10 pixels wide has a stride of 10 or more, and not 9";
    for (stride, text) in [
        (9, narrow.to_owned()),
        (11, short(21)),
        (usize::MAX, short(usize::MAX)),
    ] {
        let mut pixels = [1; 20];
        let frame = Frame::new(10, 2, &mut pixels).with_stride(stride);
        let scene = show::model_scene(0.0);
        let result = renderer.render(&scene, &Quality::THESIS, frame, &mut Worker::new());
        assert_eq!(result.unwrap_err().to_string(), text);
        assert_eq!(pixels, [1; 20]);
    }
}

#[test]
fn qualities_out_of_range_are_refused() {
    let thesis = Quality::THESIS;
    let squares = [0, 3, 12, 2 * Quality::MAX_SQUARE, usize::MAX];
    let squares = squares.map(|square| Quality { square, ..thesis });
    let depths = [Quality::MAX_DEPTH + 1, u32::MAX];
    let depths = depths.map(|depth| Quality { depth, ..thesis });
    for quality in squares.iter().chain(&depths) {
        let error = refusal(&show::model_scene(0.0), quality, (64, 48), 64 * 48);
        assert!(matches!(error, Some(Error::Flaw(_))), "{quality:?}");
        assert!(panics(*quality, (64, 48), 64 * 48), "{quality:?}");
    }
    let quality = Quality {
        square: 12,
        ..thesis
    };
    let error = quality.validate().unwrap_err();
    let text = "quality.square is 12, must be 1, 2, 4, 8, 16 or 32";
    assert_eq!(error.to_string(), text);
    let quality = Quality {
        tolerance_side: f32::NAN,
        ..thesis
    };
    let error = quality.validate().unwrap_err();
    let text = "quality.tolerance_side is NaN, must be 0 to infinity";
    assert_eq!(error.to_string(), text);
    for quality in Quality::LADDER
        .iter()
        .chain([&thesis, &Quality::EXHAUSTIVE])
    {
        assert_eq!(quality.validate(), Ok(()));
    }
}

#[test]
fn a_scene_out_of_range_is_refused_by_the_name_of_its_number() {
    let mut scene = show::model_scene(0.0);
    scene.spheres[2].material.kd = -0.5;
    let error = refusal(&scene, &Quality::DEFAULT, (64, 48), 64 * 48).unwrap();
    let text = "spheres[2].material.kd is -0.5, must be 0 to 1";
    assert_eq!(error.to_string(), text);
    let mut rough = scene;
    (rough.spheres[2].material.kd, rough.water.slope) = (0.5, 0.2);
    let flaw = rough.validate().unwrap_err().to_string();
    assert_eq!(flaw, "water.slope is 0.2, must be 0 to 0.1");
    rough.water.slope = 0.1;
    let flaw = rough.validate().unwrap_err().to_string();
    assert_eq!(flaw, "water.length is 0, must be 1e-9 to 1e9");
    let source = core::error::Error::source(&error).expect("the flaw");
    assert_eq!(source.to_string(), text);
}

#[test]
fn comparing_deeper_than_rays_go_compares_all() {
    let scene = show::model_scene(0.0);
    let compare = |depth| {
        let quality = Quality {
            key_depth: depth,
            state_depth: depth,
            ..Quality::THESIS
        };
        draw_best(&scene, &quality, 200, 150).pixels
    };
    let all = compare(Quality::MAX_DEPTH);
    for depth in [8, 30, 31, 32, 40, u32::MAX] {
        assert!(compare(depth) == all, "depth {depth}");
    }
}

#[test]
fn an_empty_scene_is_its_background() {
    let scene = Scene {
        background: glam::vec3(1.0, 0.5, 0.0),
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
    let mut scene = show::model_scene(0.0);
    scene.spheres = List::default();
    scene.planes = List::default();
    scene.camera = Camera::default();
    scene.camera.eye = Vec3::Z * r;
    scene.camera.look_at = Vec3::ZERO;
    for light in scene.lights.iter_mut() {
        light.position *= 0.125 * r;
        light.drawn_radius = 0.0;
    }
    scene
}

#[test]
fn ends_of_the_ranges_of_lengths_draw_what_they_are() {
    let material = show::model_scene(0.0).spheres[0].material;
    // Over the whole range of lengths.
    let sphere = |r: f32| {
        let mut scene = of_length(r);
        scene
            .spheres
            .push(Sphere::new(Vec3::NEG_Z * r, r, material));
        scene
    };
    let block = |r: f32, shape: Shape| {
        let mut scene = of_length(r);
        scene.blocks.push(Block {
            axes: Mat3::from_rotation_x(0.5),
            ..Block::new(shape, Vec3::NEG_Z * r, Vec3::splat(r), material)
        });
        scene
    };
    let scenes: [&dyn Fn(f32) -> Scene; 4] = [
        &sphere,
        &|r| block(r, Shape::Box),
        &|r| block(r, Shape::Cylinder),
        &|r| block(r, Shape::Capsule),
    ];
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
