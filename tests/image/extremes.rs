//! Numbers at the ends of their ranges, and beyond: `render` refuses these, `render_valid` draws
//! them with bounded work. Objects whose size is many times the eye's height above them: the
//! ground, and planets.

use crate::cpu;
use crate::drawn::{Drawn, REFINEMENTS, draw, draw_by_all, isa_of, of_side};
use crate::error::Difference;
use crate::threaded_renderer::MomentRef;
use eightfold::show;
use eightfold_oracle::Oracle;
use eightfold_oracle::frame::Frame as Traced;
use eightfold_scenes::lights::spotlight;
use eightfold_scenes::solids::SHAPES;
use eightfold_scenes::text::Text;
use eightfold_scenes::{Random, cases, scaled};
use eightfold_tracer::presentation::{Caption, Moment};
use eightfold_tracer::scene::{Block, Camera, Light, List, Material, Scene, Shape, Sphere, Waves};
use eightfold_tracer::{Error, Frame, MAX_HEIGHT, MAX_WIDTH, Quality, Renderer, Worker};
use glam::{Mat3, Vec3, vec3};
use std::panic::catch_unwind;

fn rich() -> Scene {
    let mut scene = show::model_scene(1.0);
    let material = scene.spheres[0].material;
    for (shape, x) in SHAPES.into_iter().zip([-3.5, 3.8, 5.0]) {
        let half = vec3(0.4, 0.8, 0.4);
        scene.blocks.push(Block::new(shape, vec3(x, 0.8, -1.0), half, material));
    }
    scene.water = Waves { slope: 0.02, length: 2.0, phase: 0.3 };
    scene.lights[0] = Light { diameter: 0.5, ..spotlight(scene.lights[0], 0.45, 0.795) };
    scene
}

fn written() -> Moment {
    let mut scene = Moment::from(rich());
    scene.presentation.method.points = 0.4;
    let letters = List::of(b"EIGHTFOLD");
    scene.presentation.captions.push(Caption { letters, middle: 0.5, size: 0.2, brightness: 0.8 });
    scene
}

fn rays(drawn: &Drawn) -> u64 {
    drawn.counts.rays + drawn.counts.shadow_rays
}

/// Two bands.
const SMALL: (usize, usize) = (48, 36);

fn usual_rays<'a>(moment: impl Into<MomentRef<'a>>) -> Vec<[u64; 4]> {
    let scene = moment.into();
    let rays = |isa, quality| rays(&draw(isa, 2, scene, &quality, SMALL.0, SMALL.1));
    let isas = cpu::instruction_sets();
    isas.map(|isa| REFINEMENTS.map(|quality| rays(isa, quality))).collect()
}

/// Asserts equal bits on one thread and on two, for at most 2.5 times the usual rays.
#[track_caller]
fn assert_bounded(scene: &Moment, usual: &[[u64; 4]], case: usize, what: &str) {
    let (number, seed) = (case % REFINEMENTS.len(), case / REFINEMENTS.len());
    let isa = isa_of(seed as u64);
    assert!(scene.validate().is_err(), "{what}");
    let quality = REFINEMENTS[number];
    let [one, two] = [1, 2].map(|threads| draw(isa, threads, scene, &quality, SMALL.0, SMALL.1));
    assert!(one.pixels == two.pixels, "{what}");
    // Without a tolerance all squares split, as in the first refinement.
    let number = number * usize::from(!what.starts_with("tolerance"));
    let (rays, usual) = (rays(&one), usual[seed % usual.len()][number]);
    assert!(2 * rays <= 5 * usual, "{what}: {rays} for {usual}");
}

#[test]
fn invalid_number_gives_a_picture_for_bounded_work() {
    let text = Text::of(&written());
    let usual = usual_rays(&written());
    let mut case = 0;
    for i in 0..text.numbers.len() {
        for wrong in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
            let (scene, name) = text.value_with(i, wrong);
            assert_bounded(&scene, &usual, case, &format!("{name} {wrong}"));
            case += 1;
        }
    }
    let field = show::field(100, 1.0);
    let usual = usual_rays(&field);
    for wrong in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY, f32::MAX] {
        for every in [1, 3, 50] {
            let mut scene = Moment::from(field.clone());
            let spheres = scene.scene.spheres.iter_mut().step_by(every);
            spheres.for_each(|sphere| sphere.centre.x = wrong);
            for refinement in 0..REFINEMENTS.len() {
                assert_bounded(&scene, &usual, 4 * case + refinement, "spheres");
            }
            case += 1;
        }
    }
}

fn refusal(
    scene: &Scene,
    quality: &Quality,
    [width, height, stride, count]: [usize; 4],
) -> Option<Error> {
    let mut pixels = vec![1; count];
    let frame = Frame::new(width, height, &mut pixels).with_stride(stride);
    let mut renderer = Renderer::new(cpu::best().level);
    let result = renderer.render(scene, quality, frame, &mut Worker::new());
    assert!(result.is_ok() || pixels.iter().all(|&pixel| pixel == 1));
    result.err()
}

fn panics(quality: Quality, [width, height, count]: [usize; 3]) -> bool {
    let panic = catch_unwind(|| {
        let mut pixels = vec![0; count];
        let frame = Frame::new(width, height, &mut pixels);
        let mut renderer = Renderer::new(cpu::best().level);
        renderer.render_valid(&show::model_scene(0.0), &quality, frame, &mut Worker::new());
    });
    panic.is_err()
}

#[test]
fn frame_out_of_range_is_refused_by_its_numbers() {
    let scene = show::model_scene(0.0);
    let thesis = Quality::THESIS;
    let largest = [(MAX_HEIGHT, MAX_WIDTH), (usize::MAX, usize::MAX)];
    let sizes = [(0, 1), (1, 0), (MAX_WIDTH + 1, 1), (1, MAX_HEIGHT + 1)].into_iter();
    for (width, height) in sizes.chain(largest) {
        let error = refusal(&scene, &thesis, [width, height, width, 16]).expect("a wrong size");
        assert_eq!(error, Error::Size { width, height });
        assert!(error.to_string().contains(&format!("{width}x{height}")));
        assert!(panics(thesis, [width, height, 16]), "{width}x{height}");
    }
    assert!(panics(thesis, [10, 2, 19]));
    for (stride, count, numbers) in [
        (10, 19, ["20", "19"]),
        (11, 20, ["21", "20"]),
        (9, 20, ["10", "9"]),
        (usize::MAX, 20, ["18446744073709551615", "20"]),
    ] {
        let error = refusal(&scene, &thesis, [10, 2, stride, count]).expect("wrong pixels");
        let text = error.to_string();
        assert!(numbers.iter().all(|number| text.contains(number)), "{text}");
    }
    assert_eq!(refusal(&scene, &thesis, [10, 2, 10, 20]), None);
}

#[test]
fn scene_or_quality_out_of_range_is_refused() {
    let scene = show::model_scene(0.0);
    for (change, text) in [
        (
            (|scene| scene.spheres[2].material.kd = -0.5) as fn(&mut Scene),
            "spheres[2].material.kd is -0.5; must be 0 to 1",
        ),
        (
            |scene| scene.camera.up = scene.camera.look_at - scene.camera.eye,
            "camera.up is [0, -1.2999998, 7.4999995]; must be more than 0.001 radians off the line of sight",
        ),
        (|scene| scene.water.slope = 0.1, "water.length is 0; must be 1e-9 to 1e9"),
    ] {
        let mut scene = scene.clone();
        change(&mut scene);
        let error = refusal(&scene, &Quality::DEFAULT, [8, 6, 8, 48]).expect(text);
        assert_eq!(error.to_string(), text);
        let source = core::error::Error::source(&error).expect("the number's range");
        assert_eq!(source.to_string(), text);
    }
    let thesis = Quality::THESIS;
    let squares = [0, 3, 12, 64, usize::MAX].map(|side| ("square", of_side(side, thesis)));
    let depths = [8, u32::MAX].map(|depth| ("depth", Quality { depth, ..thesis }));
    let tolerance = ("tolerance_side", Quality { tolerance_side: f32::NAN, ..thesis });
    for (name, quality) in squares.into_iter().chain(depths).chain([tolerance]) {
        let error = refusal(&scene, &quality, [8, 6, 8, 48]).expect(name);
        assert!(error.to_string().starts_with(&format!("quality.{name} is ")), "{error}");
        let is_drawn = name == "tolerance_side";
        assert_eq!(panics(quality, [8, 6, 48]), !is_drawn, "{quality:?}");
    }
}

/// Returns the model scene's lights, nearer, and a solid of its first material ahead, by its
/// number.
fn alone(number: usize) -> Scene {
    let Scene { mut lights, spheres, .. } = show::model_scene(0.0);
    let material = spheres[0].material;
    for light in lights.iter_mut() {
        *light = Light { position: 0.125 * light.position, drawn_radius: 0.0, ..*light };
    }
    let mut scene = Scene { lights, ..Scene::default() };
    match SHAPES.get(number) {
        Some(&shape) => scene.blocks.push(Block {
            axes: Mat3::from_rotation_x(0.5),
            ..Block::new(shape, Vec3::NEG_Z, Vec3::ONE, material)
        }),
        None => scene.spheres.push(Sphere::new(Vec3::NEG_Z, 1.0, material)),
    }
    scene
}

#[test]
fn scene_of_any_scale_is_the_same_picture() {
    let ends = (0..4).map(alone);
    let ends = ends.map(|scene| (scene, [2e-9, 1e-8, 1e-4, 1e6, 1e8, 1e9]));
    let far = (scaled(&rich(), 0.7), [1e-8, 1e-4, 0.1, 3.0, 1e4, 1e8]);
    let whole = [show::model_scene(2.0), show::field(60, 2.0)];
    let whole = whole.map(|scene| (scene, [1e-4, 1e-2, 0.7, 3.0, 1e2, 1e4]));
    for (scene, factors) in ends.chain(whole).chain([far]) {
        for isa in cpu::instruction_sets() {
            for quality in [Quality::EXHAUSTIVE, Quality::DEFAULT] {
                let picture = |scene: &Scene| draw(isa, 2, scene, &quality, 160, 120).pixels;
                let plain = picture(&scene);
                for factor in factors {
                    let scene = scaled(&scene, factor);
                    assert_eq!(scene.validate(), Ok(()), "times {factor}");
                    let psnr = Difference::between(&plain, &picture(&scene)).psnr;
                    assert!(psnr >= 50.0, "{}, times {factor}: {psnr} dB", isa.name);
                }
            }
        }
    }
}

/// Scene units from the origin, and the least PSNR in dB against the oracle;
/// [`eightfold_tracer::limits`] has both.
#[test]
fn scene_far_from_the_origin_is_as_exact_as_stated() {
    let limits = [0.0, 1e2, 1e3, 1e4, 1e5].into_iter();
    for (distance, min_psnr) in limits.zip([80.0, 55.0, 50.0, 41.0, 31.0]) {
        let by = distance / 3.0 * vec3(2.0, 1.0, -2.0);
        for time in [0.0, 2.5] {
            let mut scene = show::model_scene(time);
            scene.camera.eye += by;
            scene.camera.look_at += by;
            scene.spheres.iter_mut().for_each(|it| it.centre += by);
            scene.planes.iter_mut().for_each(|it| it.centre += by);
            scene.lights.iter_mut().for_each(|it| it.position += by);
            assert_near(&scene, [320, 240], min_psnr, &format!("{distance} away at {time} s"));
        }
    }
}

fn above(radius: f32, height: f32, light: f32) -> Scene {
    let ground = Material::matt(Vec3::splat(0.5), 0.9);
    let mirror = Material::mirror(0.8);
    let ball = Material::matt(vec3(0.9, 0.3, 0.2), 0.8);
    let eye = height * vec3(0.0, 1.0, 4.0);
    Scene {
        camera: Camera::new(eye, 0.5 * height * Vec3::Y, 0.8),
        background: Vec3::ONE,
        ambient: Vec3::splat(0.2),
        spheres: List::of(&[
            Sphere::new(-radius * Vec3::Y, radius, ground),
            Sphere::new(height * vec3(-0.6, 0.7, 0.0), 0.5 * height, mirror),
            Sphere::new(height * vec3(0.6, 0.7, 0.0), 0.5 * height, ball),
        ]),
        lights: List::of(&[Light::new(light * vec3(0.5, 1.0, 0.3), Vec3::splat(0.5))]),
        ..Scene::default()
    }
}

#[track_caller]
fn assert_near(scene: &Scene, [width, height]: [usize; 2], min_psnr: f64, what: &str) {
    assert_eq!(scene.validate(), Ok(()));
    let frame = Traced::new(scene, &Quality::EXHAUSTIVE, width, height);
    for (isa, drawn) in draw_by_all(scene, &Quality::EXHAUSTIVE, width, height) {
        let psnr = Difference::between(&frame.picture_like(&drawn.pixels), &drawn.pixels).psnr;
        assert!(psnr >= min_psnr, "{}, {what}: {psnr} dB", isa.name);
    }
}

#[test]
fn eye_near_a_huge_sphere_sees_it_as_in_f64() {
    for radius in [1e3, 1e5, 3e6, 1e8] {
        // The points of the sphere have an error of 6e-8 radii.
        for (height, min_psnr) in [(1e-7, 25.0), (5e-7, 35.0), (1e-6, 35.0), (1e-5, 35.0)] {
            for light in [3.0, 10.0] {
                let scene = above(radius, radius * height, light * radius * height);
                assert_near(&scene, [80, 60], min_psnr, &format!("{radius} {height} {light}"));
            }
        }
    }
}

#[test]
fn eye_near_a_huge_block_sees_it_lit() {
    for shape in SHAPES {
        for (size, height) in [(1e3, 2e-3), (1e5, 0.2), (3e6, 3.0), (3e6, 20.0)] {
            let mut scene = above(size, height, 8.0 * height);
            let Sphere { centre, material, .. } = scene.spheres[0];
            scene.spheres.clear();
            scene.blocks.push(Block::new(shape, centre, Vec3::splat(size), material));
            assert_near(&scene, [80, 60], 25.0, &format!("{shape:?} {size} {height}"));
        }
    }
}

#[test]
fn telescope_sees_a_far_sphere_as_in_f64() {
    for distance in [1e1, 1e2, 1e3, 1e4] {
        let mut scene = above(1.0, 1.0, 5.0);
        scene.camera.eye *= distance / scene.camera.eye.length();
        scene.camera.field_of_view = 4.0 / distance;
        assert_near(&scene, [80, 60], 40.0, &format!("from {distance} radii"));
    }
}

/// Returns a white ball. The distances are in radii. A box beyond the ball, and the diameter of a
/// light inside, make no difference.
fn ball(random: &mut Random, [eye_at, light_at]: [f32; 2], has_more: bool) -> Scene {
    let radius = random.power(-4.0, 4.0);
    let centre = random.vector(Vec3::NEG_ONE, Vec3::ONE) * random.power(0.0, 3.0) * radius;
    let mut from = |distance: f32| centre + random.turn() * Vec3::X * (distance * radius);
    let white = Material::matt(Vec3::ONE, 1.0);
    let mut scene = Scene {
        camera: Camera::new(from(eye_at), centre, (2.0 / eye_at).min(1.5)),
        spheres: List::of(&[Sphere::new(centre, radius, white)]),
        lights: List::of(&[Light::new(from(light_at), Vec3::ONE)]),
        ..Scene::default()
    };
    if has_more {
        let half = Vec3::splat(radius);
        scene.blocks.push(Block::new(Shape::Box, from(3.0), half, white));
        scene.lights[0].diameter = 1.9 * (1.0 - light_at).max(0.0) * radius;
    }
    scene
}

/// A light wholly inside a sphere illuminates its inside, others its outside. Rounding makes no
/// point shadow itself.
#[test]
fn sphere_is_lit_on_the_side_of_its_light_only() {
    let mut counts = [0; 2];
    for mut random in cases(2000) {
        let (is_inside, has_more) = random.one_of([(false, false), (true, false), (true, true)]);
        let eye_at = if is_inside { 0.5 } else { random.power(0.1, 3.0) };
        let lights = [random.between(0.1, 0.95), random.power(0.03, 2.0)];
        let light_at = random.one_of(lights);
        let scene = ball(&mut random, [eye_at, light_at], has_more);
        let drawn = draw(isa_of(random.seed), 1, &scene, &Quality::EXHAUSTIVE, 16, 16).pixels;
        let oracle = Oracle::new(&scene, &Quality::EXHAUSTIVE, 16, 16);
        let light = scene.lights[0].position.as_dvec3();
        for (i, pixel) in drawn.into_iter().enumerate() {
            let Some(hit) = oracle.surface(oracle.ray((i % 16) as f64, (i / 16) as f64)) else {
                continue;
            };
            let cosine = hit.n.dot((light - hit.ray.o).normalize());
            let is_lit = cosine > 0.0 && is_inside == (light_at < 1.0);
            // Rounding moves grazing hits, and hides faint light.
            if cosine.abs() >= 0.01 && hit.ray.d.dot(hit.n).abs() >= 0.1 {
                assert_eq!(pixel != 0, is_lit, "case {}: {cosine}, {scene:?}", random.seed);
                counts[usize::from(is_lit)] += 1;
            }
        }
    }
    assert!(counts.into_iter().all(|count| count > 50_000), "{counts:?}");
}
