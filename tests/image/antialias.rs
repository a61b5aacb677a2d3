//! Pixels that are mixed from points, and means of dithered pixels.

use crate::drawn::{REFINEMENTS, TILE, draw_best};
use crate::error::worst_channel;
use eightfold_scenes::{Kinds, cases};
use eightfold_tracer::Quality;
use eightfold_tracer::glam::{Mat3, Vec3, vec3};
use eightfold_tracer::scene::{Block, Material, Scene};
use std::f32::consts::TAU;

#[test]
fn points_are_added_between_differing_pixels() {
    for mut random in cases(30) {
        let scene = Kinds::EXTREME.scene(&mut random);
        let quality = Quality {
            square: random.one_of([8, 8, 8, 4, 16, 32]),
            tolerance_agreeing: random.one_of([7.5, 140.0, 180.0, 250.0, f32::INFINITY]),
            tolerance_differing: random.one_of([0.0, 30.0, 140.0, 250.0]),
            edge: random.one_of([1, 8, 20]),
            ..Quality::DEFAULT
        };
        let (width, height) = (1 + random.below(600), 1 + random.below(80));
        let [plain, smooth] = [false, true]
            .map(|antialias| draw_best(&scene, &Quality { antialias, ..quality }, width, height));
        let is_edge = |i: usize, j: usize| {
            worst_channel(plain.pixels[i], plain.pixels[j]) >= u32::from(quality.edge)
        };
        let mut is_beside_an_edge = vec![false; width * height];
        // Midpoints between bands, and between stretches of 64 columns, are traced twice.
        let band = width * TILE[1];
        let points = (0..width * height).map(|i| {
            let right = i % width + 1 < width && is_edge(i, i + 1);
            let below = i + width < width * height && is_edge(i, i + width);
            let beside = [(right, i + 1), (below, i + width)];
            for (_, other) in beside.into_iter().filter(|(is_edge, _)| *is_edge) {
                is_beside_an_edge[i] = true;
                is_beside_an_edge[other] = true;
            }
            let across = if i % width % 64 == 63 { 2 } else { 1 };
            let down = if (i + width) % band < width { 2 } else { 1 };
            across * u64::from(right) + down * u64::from(below)
        });
        let points: u64 = points.sum();
        for (i, &is_beside) in is_beside_an_edge.iter().enumerate() {
            let is_same = plain.pixels[i] == smooth.pixels[i];
            assert!(is_same || is_beside, "case {}: pixel {i}", random.seed);
        }
        // Bisection adds at most two points on each side of the midpoint, three below an edge of
        // 20.
        let max = if quality.edge < 20 { 7 } else { 5 };
        let (traced, seed) = (smooth.counts.points - plain.counts.points, random.seed);
        assert!((points..=max * points).contains(&traced), "case {seed}: {traced} of {points}");
    }
}

/// Bisection finds an edge to an eighth of a pixel along the axis that it crosses. Cutting off a
/// corner adds an error of an eighth.
#[test]
fn share_of_a_cut_pixel_is_known_to_an_eighth() {
    const SIDE: usize = 40;
    let quality = Quality { antialias: true, ..Quality::EXHAUSTIVE };
    let (mut worst, mut squares, mut count) = (0.0_f32, 0.0, 0);
    for step in 0..48 {
        let (angle, distance) = (step as f32 * TAU / 48.0, 3.0 + 0.37 * step as f32 % 5.0);
        let picture = draw_best(&half_plane(angle, distance, SIDE), &quality, SIDE, SIDE).pixels;
        for (i, pixel) in picture.into_iter().enumerate() {
            let [x, y] = [i % SIDE, i / SIDE].map(|at| at as f32 + 0.5 - 0.5 * SIDE as f32);
            let share = covered(angle, distance - (x * angle.sin() - y * angle.cos()));
            let error = (pixel as u8 as f32 / 255.0 - share).abs();
            if error > 0.002 && x.abs().max(y.abs()) < 0.5 * SIDE as f32 - 1.0 {
                worst = worst.max(error);
                squares += error * error;
                count += 1;
            }
        }
    }
    let mean = (squares / count as f32).sqrt();
    println!("of {count} shares the worst is off by {worst:.3}, the root mean square is {mean:.3}");
    assert!(worst <= 0.14 && mean < 0.05, "{worst}, {mean}");
}

fn covered(angle: f32, distance: f32) -> f32 {
    const SLICES: usize = 200;
    let (across, along) = (angle.sin().abs(), angle.cos().abs());
    let (across, along) = (across.max(along), across.min(along));
    let slice = |i| {
        let place = (i as f32 + 0.5) / SLICES as f32 - 0.5;
        (0.5 + (distance - along * place) / across).clamp(0.0, 1.0)
    };
    (0..SLICES).map(slice).sum::<f32>() / SLICES as f32
}

/// Returns a white box whose edge is `distance` pixels from the picture's centre, turned clockwise
/// by an angle.
fn half_plane(angle: f32, distance: f32, height: usize) -> Scene {
    let mut scene = Scene { ambient: Vec3::ONE, ..Scene::default() };
    let pixel = 2.0 * (0.5 * scene.camera.field_of_view).tan() / height as f32;
    let axes = Mat3::from_rotation_z(-angle);
    scene.blocks.push(Block {
        centre: axes * vec3(0.0, distance * pixel - 3.0, 0.0) - 0.05 * Vec3::Z,
        half: vec3(3.0, 3.0, 0.05),
        axes,
        material: Material::matt(Vec3::ONE, 0.0),
        ..Block::default()
    });
    scene
}

#[test]
fn dither_keeps_means_between_two_steps() {
    let (width, height) = (70, 46);
    for quality in REFINEMENTS {
        for sixteenths in 0..=16 {
            let mut scene = Scene {
                background: Vec3::splat((10.0 + sixteenths as f32 / 16.0) / 255.0),
                ..Scene::default()
            };
            scene.film.dither = 1.0;
            let drawn = draw_best(&scene, &quality, width, height);
            let at = |x: usize, y: usize| drawn.pixels[y * width + x] & 0xff;
            // In any 4x4 pixels, the number of brighter ones is the fraction in sixteenths.
            for (left, top) in [(0, 0), (13, 7), (33, 30), (66, 42)] {
                let sum: u32 = (0..16).map(|i| at(left + i % 4, top + i / 4)).sum();
                assert!(sum.abs_diff(160 + sixteenths) <= 1, "{sum}, {sixteenths}");
            }
            assert!((0..width).all(|x| at(x, 0) == at(x % 4, 0)));
        }
    }
}
