//! Patches of lost pixels: no drawn pixel nearby is similar.

use crate::drawn::{draw_best, jagged};
use crate::error::{Difference, worst_channel};
use crate::errors::patches;
use eightfold_lab::scenes::SceneName;
use eightfold_scenes::{Random, cases, solids};
use eightfold_tracer::Quality;
use eightfold_tracer::glam::{Vec3, vec3};
use eightfold_tracer::scene::{Block, Camera, Light, Material, Scene, Shape};

const SIZE: [usize; 2] = [1280, 720];

/// The maximum patch in pixels in the show's frames.
const SHOW: usize = 19;

/// Times in each second.
const TIMES: [f32; 4] = [0.1, 0.3, 0.5, 0.7];

/// The maximum patch in rooms of mirrors. The largest has 55; without nested images in the keys it has 441.
const ROOM: usize = 60;

/// Returns the exhaustive pixels that differ by more than 32 of 255 from all drawn pixels within 2 pixels.
fn lost(exact: &[u32], drawn: &[u32], width: usize) -> Vec<usize> {
    let height = exact.len() / width;
    let is_alike =
        |i: usize, x: usize, y: usize| worst_channel(exact[i], drawn[y * width + x]) <= 32;
    let is_lost = |&i: &usize| {
        let (x, y) = (i % width, i / width);
        let mut near = (y.saturating_sub(2)..height.min(y + 3))
            .flat_map(|y| (x.saturating_sub(2)..width.min(x + 3)).map(move |x| (x, y)));
        !is_alike(i, x, y) && !near.any(|(x, y)| is_alike(i, x, y))
    };
    (0..exact.len()).filter(is_lost).collect()
}

/// Returns the largest patch of lost pixels, if any are lost.
pub fn largest(exact: &[u32], drawn: &[u32], width: usize) -> Vec<usize> {
    let patches = patches(&lost(exact, drawn, width), width);
    patches.into_iter().max_by_key(Vec::len).unwrap_or_default()
}

fn hold(scenes: impl Iterator<Item = (String, Scene)>, limit: usize) {
    let (mut largest, mut least) = (0, f64::INFINITY);
    for (name, scene) in scenes {
        for quality in [jagged(Quality::DEFAULT), Quality::DEFAULT] {
            let [exact, drawn] = [quality.reference(), quality]
                .map(|quality| draw_best(&scene, &quality, SIZE[0], SIZE[1]).pixels);
            let psnr = Difference::between(&exact, &drawn).psnr;
            let patch = self::largest(&exact, &drawn, SIZE[0]).len();
            println!(
                "{name}: {psnr:.1} dB, a patch of {patch}, {}",
                quality.antialias
            );
            largest = largest.max(patch);
            least = least.min(psnr);
        }
    }
    assert!(
        largest <= limit && least >= 42.0,
        "{largest}, {least:.1} dB"
    );
}

fn show(time: f32) -> (String, Scene) {
    (format!("{time} s"), SceneName::Show.without_overlay(time))
}

/// Returns a room of four mirrors, with columns of all shapes.
fn room(mut random: Random) -> (String, Scene) {
    let eye = random.vector(vec3(-3.5, 1.0, -3.5), vec3(3.5, 3.0, 3.5));
    let mut scene = Scene {
        camera: Camera::new(eye, vec3(0.0, 2.0, 0.0), 1.2),
        ambient: Vec3::splat(0.05),
        haze: 0.05,
        ..Scene::default()
    };
    scene.film.tolerance = 0.5;
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
    let worst = TIMES.into_iter().zip([22, 54, 66, 61]);
    hold(worst.map(|(part, second)| show(second as f32 + part)), SHOW);
}

#[test]
#[ignore = "many frames"]
fn long_show_has_small_patches() {
    for part in TIMES {
        hold((0..116).map(|second| show(second as f32 + part)), SHOW);
    }
}

#[test]
fn rooms_of_mirrors_have_small_patches() {
    hold(cases(4).map(room), ROOM);
}
