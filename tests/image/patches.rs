use crate::cpu::{self, Isa};
use crate::drawn::{draw, draw_best, jagged, show_at};
use crate::error::Difference;
use crate::threaded_renderer::MomentRef;
use eightfold_harness::patches::{largest, largest_of, lost};
use eightfold_scenes::artists::{FLOORS, KINDS, LIGHTS, ON_FLOORS};
use eightfold_scenes::{Random, cases, coloured, solids};
use eightfold_tracer::glam::{Vec3, vec3};
use eightfold_tracer::scene::{Block, Camera, Light, Material, Moment, Presentation, Scene, Shape};
use eightfold_tracer::{Preset, Quality};

const SIZE: [usize; 2] = [1280, 720];
const LARGE: [usize; 2] = [1920, 1080];

/// The maximum patch on a floor between the shadows of bars, by a light without a diameter.
const FLOOR: usize = 8;

/// Returns the PSNR against the exhaustive picture in dB, and the size of the largest patch.
pub fn compared<'a>(
    isa: Isa,
    moment: impl Into<MomentRef<'a>>,
    quality: Quality,
    size: [usize; 2],
) -> (f64, usize) {
    let moment = moment.into();
    let [exact, drawn] = [quality.reference(), quality]
        .map(|quality| draw(isa, 2, moment, &quality, size[0], size[1]).pixels);
    let patch = largest(&exact, &drawn, size[0]);
    (Difference::between(&exact, &drawn).psnr, patch)
}

/// Returns a scene of the show, folded, without captions and marked squares.
fn of_the_show(time: f32) -> Moment {
    let Moment { scene, presentation } = show_at(time);
    let presentation = Presentation { sectors: presentation.sectors, ..Presentation::default() };
    Moment { scene, presentation }
}

fn assert_near<'a>(
    what: &str,
    moment: impl Into<MomentRef<'a>>,
    quality: Quality,
    size: [usize; 2],
    (limit, min_psnr): (usize, f64),
) {
    let (psnr, patch) = compared(cpu::best(), moment, quality, size);
    let what = format!("{what}, {size:?}: {psnr:.1} dB, a patch of {patch}, {}", quality.antialias);
    println!("{what}");
    assert!(patch <= limit && psnr >= min_psnr, "{what}");
}

fn room(random: &mut Random) -> Scene {
    let eye = random.vector(vec3(-3.5, 1.0, -3.5), vec3(3.5, 3.0, 3.5));
    let mut scene = Scene {
        camera: Camera::new(eye, vec3(0.0, 2.0, 0.0), 1.2),
        ambient: Vec3::splat(0.05),
        haze: 0.05,
        ..Scene::default()
    };
    let light = random.vector(vec3(-2.0, 2.0, -2.0), vec3(2.0, 4.0, 2.0));
    scene.lights.push(Light::new(light, Vec3::ONE));
    for [x, z] in [[-5.0, 0.0], [0.0, -5.0], [5.0, 0.0], [0.0, 5.0_f32]] {
        let half = vec3(5.1 - x.abs(), 2.5, 5.1 - z.abs());
        scene.blocks.push(Block::new(Shape::Box, vec3(x, 2.5, z), half, Material::mirror(0.62)));
    }
    for i in 0..6 {
        let centre = random.vector(vec3(-4.0, 2.0, -4.0), vec3(4.0, 2.0, 4.0));
        let radius = random.between(0.05, 0.3);
        let material = Material::matt(random.vector(Vec3::splat(0.3), Vec3::ONE), 0.9);
        let half = vec3(radius, 2.0, radius);
        scene.blocks.push(Block::new(solids::SHAPES[i % 3], centre, half, material));
    }
    scene
}

#[test]
fn show_worst_frames_have_small_patches() {
    for time in [76.8, 54.3, 66.5, 61.7] {
        for quality in [jagged(Quality::DEFAULT), Quality::DEFAULT] {
            assert_near(&format!("{time} s"), &of_the_show(time), quality, SIZE, (19, 42.0));
        }
    }
}

#[test]
#[ignore = "many frames"]
fn long_show_has_small_patches() {
    for size in [SIZE, LARGE] {
        for tenth in 0..1160 {
            let time = tenth as f32 / 10.0;
            let what = format!("{time} s");
            assert_near(&what, &of_the_show(time), Quality::DEFAULT, size, (19, 46.0));
        }
    }
}

#[test]
fn rooms_of_mirrors_have_small_patches() {
    let default = Quality::DEFAULT;
    // The rooms are dim.
    let dim = Quality {
        tolerance_agreeing: 0.5 * default.tolerance_agreeing,
        tolerance_differing: 0.5 * default.tolerance_differing,
        tolerance_side: 0.5 * default.tolerance_side,
        key_weight: 0.25 * default.key_weight,
        ..default
    };
    for mut random in cases(2) {
        let (what, room) = (format!("room {}", random.seed), room(&mut random));
        for quality in [jagged(dim), dim] {
            // The largest patch has 55 pixels, and 441 without nested images in the keys.
            assert_near(&what, &room, quality, SIZE, (60, 42.0));
        }
    }
}

fn shows_floor(scene: &Scene) -> Vec<bool> {
    let mut scene = coloured(scene, 28);
    scene.lights.clear();
    let floor = (255.0 * scene.planes[0].material.colour).to_array().map(|it| it.round() as u8);
    let drawn = draw_best(&scene, &Quality::EXHAUSTIVE, SIZE[0], SIZE[1]).pixels;
    drawn.iter().map(|pixel| pixel.to_be_bytes()[1..] == floor).collect()
}

/// Asserts that bars of every kind leave no patch on a plain floor, at each of `presets`.
fn assert_whole_light(count: u64, presets: &[Preset]) {
    for mut random in cases(count) {
        let kind = KINDS[random.below(ON_FLOORS)];
        for (light, draw) in &LIGHTS[..3] {
            let scene = kind.scene(&mut random, *draw, FLOORS[0].1);
            let is_floor = shows_floor(&scene);
            let drawn = |quality| draw_best(&scene, &jagged(quality), SIZE[0], SIZE[1]).pixels;
            let exact = drawn(Quality::EXHAUSTIVE);
            for &preset in presets {
                let mut lost = lost(&exact, &drawn(*preset.quality()), SIZE[0]);
                lost.retain(|&i| is_floor[i]);
                let (patch, case, kind) = (largest_of(&lost, SIZE[0]), random.seed, kind.0);
                let what = format!("case {case}: {kind} by a {light}, {preset}");
                assert!(patch <= FLOOR, "{what}: a patch of {patch}");
            }
        }
    }
}

#[test]
fn light_between_bars_has_no_patches() {
    assert_whole_light(3, &[Preset::Default]);
}

#[test]
#[ignore = "many frames"]
fn long_light_between_bars_has_no_patches() {
    assert_whole_light(200, &Preset::LADDER[..6]);
}
