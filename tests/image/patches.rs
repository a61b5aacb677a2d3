//! Patches of lost pixels: no drawn pixel nearby is similar.

use crate::cpu::{self, Isa};
use crate::drawn::{draw, draw_best, jagged, of_the_show};
use crate::error::Difference;
use eightfold_harness::patches::{largest, lost, patches};
use eightfold_scenes::artists::{FLOORS, KINDS, LIGHTS, ON_FLOORS};
use eightfold_scenes::{Random, cases, coloured, solids};
use eightfold_tracer::glam::{Vec3, vec3};
use eightfold_tracer::scene::{Block, Camera, Light, Material, Scene, Shape};
use eightfold_tracer::{Preset, Quality};
use std::ops::Range;

const SIZE: [usize; 2] = [1280, 720];
const LARGE: [usize; 2] = [1920, 1080];

/// The maximum patch in pixels, and the minimum PSNR in dB, in the show's frames.
const SHOW: [usize; 2] = [19, 42];

/// The maximum patch before the finale: the sun in the city's waves.
const LARGEST: usize = 50;

/// The maximum patch in rooms of mirrors. The largest has 55; without nested images in the keys it has 441.
const ROOM: [usize; 2] = [60, 42];

/// The maximum patch on a floor between the shadows of bars, by a light without a diameter.
const FLOOR: usize = 8;

/// Returns the PSNR against the exhaustive picture in dB, and the size of the largest patch.
pub fn compared(isa: Isa, scene: &Scene, quality: Quality, size: [usize; 2]) -> (f64, usize) {
    let [exact, drawn] = [quality.reference(), quality]
        .map(|quality| draw(isa, 2, scene, &quality, size[0], size[1]).pixels);
    let patch = largest(&exact, &drawn, size[0]);
    (Difference::between(&exact, &drawn).psnr, patch)
}

/// Returns the size of the largest patch, and the least PSNR in dB.
fn worst(
    scenes: impl Iterator<Item = (String, Scene)>,
    quality: Quality,
    size: [usize; 2],
) -> (usize, f64) {
    scenes.fold((0, f64::INFINITY), |(largest, least), (name, scene)| {
        let (psnr, patch) = compared(cpu::best(), &scene, quality, size);
        println!("{name}, {size:?}: {psnr:.1} dB, a patch of {patch}, {}", quality.antialias);
        (largest.max(patch), least.min(psnr))
    })
}

fn hold(scenes: impl Fn() -> Vec<(String, Scene)>, quality: Quality, [limit, psnr]: [usize; 2]) {
    for quality in [jagged(quality), quality] {
        let (largest, least) = worst(scenes().into_iter(), quality, SIZE);
        assert!(largest <= limit && least >= psnr as f64, "{largest}, {least:.1} dB");
    }
}

fn show(time: f32) -> (String, Scene) {
    (format!("{time} s"), of_the_show(time))
}

fn room(mut random: Random) -> (String, Scene) {
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
        let wall = Block::new(Shape::Box, vec3(x, 2.5, z), half, Material::mirror(0.62));
        scene.blocks.push(wall);
    }
    for i in 0..6 {
        let centre = random.vector(vec3(-4.0, 2.0, -4.0), vec3(4.0, 2.0, 4.0));
        let radius = random.between(0.05, 0.3);
        let colour = random.vector(Vec3::splat(0.3), Vec3::ONE);
        let half = vec3(radius, 2.0, radius);
        let material = Material::matt(colour, 0.9);
        let shape = solids::SHAPES[i % 3];
        scene.blocks.push(Block::new(shape, centre, half, material));
    }
    (format!("room {}", random.seed), scene)
}

#[test]
fn show_worst_frames_have_small_patches() {
    hold(|| [22.1, 54.3, 66.5, 61.7].map(show).to_vec(), Quality::DEFAULT, SHOW);
}

#[test]
#[ignore = "many frames"]
fn long_show_has_small_patches() {
    let tenths = |of: Range<u32>| of.map(|tenth| show(tenth as f32 / 10.0));
    for size in [SIZE, LARGE] {
        for (scenes, limit) in [(0..1040, LARGEST), (1040..1160, SHOW[0])] {
            let (largest, least) = worst(tenths(scenes), Quality::DEFAULT, size);
            assert!(largest <= limit && least >= 46.0, "{largest}, {least:.1} dB");
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
    hold(|| cases(2).map(room).collect(), dim, ROOM);
}

fn shows_floor(scene: &Scene) -> Vec<bool> {
    let mut scene = coloured(scene, 28);
    scene.lights.clear();
    let mut black = scene.clone();
    black.planes[0].material = Material::BLACK;
    let [floor, black] = [&scene, &black]
        .map(|scene| draw_best(scene, &Quality::EXHAUSTIVE, SIZE[0], SIZE[1]).pixels);
    floor.iter().zip(black).map(|(a, b)| *a != b).collect()
}

/// Asserts that bars of every kind leave no patch on a plain floor, at each of `presets`.
fn assert_whole_light(count: u64, presets: &[Preset]) {
    for mut random in cases(count) {
        let kind = KINDS[random.below(ON_FLOORS)];
        for (light, draw) in &LIGHTS[..3] {
            let scene = kind.scene(&mut random, *draw, FLOORS[0].1);
            let is_floor = shows_floor(&scene);
            let exact = draw_best(&scene, &Quality::EXHAUSTIVE, SIZE[0], SIZE[1]).pixels;
            for &preset in presets {
                let quality = jagged(*preset.quality());
                let drawn = draw_best(&scene, &quality, SIZE[0], SIZE[1]).pixels;
                let mut lost = lost(&exact, &drawn, SIZE[0]);
                lost.retain(|&i| is_floor[i]);
                let patches = patches(&lost, SIZE[0]);
                let patch = patches.iter().map(Vec::len).max().unwrap_or(0);
                let (case, kind) = (random.seed, kind.0);
                assert!(
                    patch <= FLOOR,
                    "a patch of {patch}, case {case}: {kind} by a {light}, {preset}"
                );
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
