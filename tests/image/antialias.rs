//! Antialiased pictures are closer to supersampled ones, and change at edges alone.

use crate::drawn::draw_best;
use crate::error::{Difference, worst_channel};
use eightfold::show;
use eightfold_oracle::squares::TILE;
use eightfold_scenes::{Kinds, cases};
use eightfold_tracer::Quality;
use eightfold_tracer::glam::{Vec3, vec3};
use eightfold_tracer::scene::{Block, Material, Scene};

/// Samples per side of a pixel in the reference pictures.
const FINE: usize = 8;

const SIZE: (usize, usize) = (200, 150);

/// A picture by the best instruction set, `n` times as large as [`SIZE`].
fn picture(scene: &Scene, quality: &Quality, n: usize) -> Vec<u32> {
    let (width, height) = SIZE;
    draw_best(scene, quality, n * width, n * height).pixels
}

/// A picture whose pixels are the means of 8 by 8 pixels of one that is eight times as large.
fn reference(scene: &Scene) -> Vec<u32> {
    let (width, height) = SIZE;
    let large = picture(scene, &Quality::EXHAUSTIVE, FINE);
    let mean = |i: usize, shift: u32| {
        let (left, top) = (i % width * FINE, i / width * FINE);
        let rows = large.chunks_exact(width * FINE).skip(top).take(FINE);
        let parts = rows.flat_map(|row| &row[left..left + FINE]);
        let sum: u32 = parts.map(|pixel| pixel >> shift & 0xff).sum();
        ((sum + 32) / 64) << shift
    };
    let pixel = |i| [16, 8, 0].map(|shift| mean(i, shift)).iter().sum();
    (0..width * height).map(pixel).collect()
}

/// The quality with antialiasing, or without.
fn with(antialias: bool, quality: Quality) -> Quality {
    Quality {
        antialias,
        ..quality
    }
}

#[test]
fn mixed_edges_are_nearer_to_many_samples() {
    for (name, scene) in [
        ("model", show::model_scene(2.0)),
        ("field", show::field(64, 2.0)),
    ] {
        let reference = reference(&scene);
        let psnr =
            |quality: &Quality| Difference::between(&reference, &picture(&scene, quality, 1)).psnr;
        // With squares the error between edges stays.
        for (quality, least) in [(Quality::EXHAUSTIVE, 4.0), (Quality::DEFAULT, 3.0)] {
            let [jagged, mixed] = [false, true].map(|antialias| psnr(&with(antialias, quality)));
            println!(
                "{name}, squares of {}: {jagged:.1} dB, antialiased {mixed:.1} dB",
                quality.square
            );
            assert!(mixed > jagged + least, "{name}: {jagged} dB, {mixed} dB");
        }
    }
}

/// Tolerances are on both sides of the one beyond which a filled square may have an edge within it.
#[test]
fn point_between_two_pixels_is_traced_where_they_differ() {
    for mut random in cases(120) {
        let scene = Kinds {
            overlays: false,
            ..Kinds::EXTREME
        }
        .scene(&mut random);
        let quality = Quality {
            square: [8, 8, 8, 4, 16, 32][random.below(6)],
            tolerance_agreeing: [7.5, 140.0, 180.0, 250.0, f32::INFINITY][random.below(5)],
            tolerance_differing: [0.0, 30.0, 140.0, 250.0][random.below(4)],
            ..Quality::DEFAULT
        };
        let (width, height) = (1 + random.below(600), 1 + random.below(80));
        let [plain, smooth] = [false, true]
            .map(|antialias| draw_best(&scene, &with(antialias, quality), width, height));
        let is_edge = |i: usize, j: usize| worst_channel(plain.pixels[i], plain.pixels[j]) >= 20;
        let mut is_beside_an_edge = vec![false; width * height];
        // Points between two bands, and between two stretches of 64 columns are traced for each.
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
        let traced = smooth.counts.points - plain.counts.points;
        assert_eq!(traced, points, "case {}: {width}x{height}", random.seed);
    }
}

#[test]
fn edge_between_bands_is_mixed_as_within_one() {
    // A box from side to side, of which more and more is seen. Its upper side cuts the row above the first that it covers, which
    // is then the only one that changes, in the middle of a band as at its ends.
    let (width, height) = (64, 160);
    // Above the middle of the picture, so that its top face is not seen.
    for row in 20..70 {
        let scene = box_up_to(row as f32 + 0.2, height);
        let [plain, smooth] = [false, true].map(|antialias| {
            let quality = with(antialias, Quality::EXHAUSTIVE);
            draw_best(&scene, &quality, width, height).pixels
        });
        let changed = |y: usize| plain[y * width..][..width] != smooth[y * width..][..width];
        let rows: Vec<usize> = (0..height).filter(|&y| changed(y)).collect();
        assert_eq!(rows, [row], "a box from row {row} down");
    }
}

/// A white box, lit evenly, from a height down, given in pixels of a picture that is so many high.
fn box_up_to(row: f32, height: usize) -> Scene {
    let mut scene = Scene {
        ambient: Vec3::ONE,
        ..Scene::default()
    };
    // At distance 1 a pixel is so high; the centre of the picture lies between two rows.
    let pixel = 2.0 * (0.5 * scene.camera.field_of_view).tan() / height as f32;
    let top = (0.5 * height as f32 - 0.5 - row) * pixel;
    scene.blocks.push(Block {
        centre: vec3(0.0, top - 1.0, -0.05),
        half: vec3(1.0, 1.0, 0.05),
        material: Material::matt(Vec3::ONE, 0.0),
        ..Block::default()
    });
    scene
}

#[test]
fn captions_and_the_overlay_are_not_antialiased() {
    let mut scene = Scene::ZEROED;
    let is_white = |pixels: &[u32]| -> Vec<bool> {
        pixels.iter().map(|&pixel| pixel == 0x00ff_ffff).collect()
    };
    // The greetings, over a picture with edges.
    show::at(110.0, &mut scene);
    let mut captions = scene.captions.iter();
    assert!(captions.any(|caption| caption.brightness == 1.0));
    let both = |scene: &Scene| {
        [false, true].map(|antialias| picture(scene, &with(antialias, Quality::DEFAULT), 1))
    };
    let [plain, smooth] = both(&scene);
    assert!(plain != smooth);
    assert!(is_white(&plain) == is_white(&smooth));
    show::at(36.0, &mut scene);
    let [plain, smooth] = both(&scene);
    assert!(plain == smooth);
}
