//! Adaptive squares follow their rules: pictures equal those of the oracle's squares, and are close to exhaustive ones.

use crate::accuracy::mean_of_right;
use crate::cpu;
use crate::drawn::{draw, draw_best, draw_by_all, jagged};
use crate::error::Difference;
use crate::generator::config;
use crate::generator::crowded::crowded;
use crate::generator::seeded::Random;
use crate::threaded_renderer::ThreadedRenderer;
use eightfold::show;
use eightfold_oracle::squares::{Splits, Squares, TILE};
use eightfold_tracer::observe::{Fill, Observer, Split};
use eightfold_tracer::scene::{Camera, Scene, Spot};
use eightfold_tracer::{Counts, Quality};
use glam::{Vec3, vec3};
use std::sync::Mutex;

/// Asserts that pictures by all instruction sets are those of the oracle's squares: the number of points differs by at most 0.2 %, or
/// 24, and few pixels by more than 8/255, about points on silhouettes alone, where rounding decides what a ray hits.
#[track_caller]
pub fn assert_as_refined(
    scene: &Scene,
    quality: &Quality,
    [width, height]: [usize; 2],
    what: &str,
) {
    let drawn: Vec<_> = cpu::instruction_sets()
        .map(|isa| {
            let mut pixels = vec![0; width * height];
            let splits = SplitSquares::default();
            let counts = ThreadedRenderer::new(1).draw_observed(
                isa.level,
                scene,
                quality,
                width,
                &mut pixels,
                &splits,
            );
            let splits = splits.0.into_inner().unwrap();
            (isa.name, counts.points, pixels, splits)
        })
        .collect();
    let mut known: Option<Squares<'_>> = None;
    for (isa, points, pixels, splits) in &drawn {
        let squares = known
            .take_if(|squares| squares.follows(splits))
            .unwrap_or_else(|| Squares::new(scene, quality, splits, width, height));
        let expected = squares.points() as u64;
        assert!(
            points.abs_diff(expected) <= (expected / 500).max(24),
            "{what} by {isa}: {points} points for {expected}"
        );
        let picture = squares.picture_like(pixels);
        let difference = Difference::between(&picture, pixels);
        let mean = mean_of_right(&picture, pixels);
        assert!(mean <= 0.02, "{what} by {isa}: {mean}, {difference:?}");
        let most = (pixels.len() / 5000).max(24);
        assert!(difference.over_8 <= most, "{what} by {isa}: {difference:?}");
        known = Some(squares);
    }
}

/// The squares of a frame that were not filled.
#[derive(Default)]
struct SplitSquares(Mutex<Splits>);

impl Observer for &SplitSquares {
    fn point(self, _: usize, _: usize, _: Counts) {}

    fn square(self, _: usize, _: usize, _: usize, _: usize, _: Fill) {}

    fn split(self, x: usize, y: usize, side: usize, _: Split) {
        self.0.lock().unwrap().insert([x, y, side]);
    }
}

/// The quality without the guard and without antialiasing, which the oracle's squares do not have.
pub fn bare(quality: Quality) -> Quality {
    Quality {
        guarded: false,
        ..jagged(quality)
    }
}

/// Scenes with few and many edges, and with so many that nearly every square has one.
fn scenes() -> [(&'static str, Scene); 3] {
    [
        ("model", show::model_scene(0.0)),
        ("some spheres", show::field(40, 2.0)),
        ("many spheres", show::field(320, 5.0)),
    ]
}

#[test]
fn the_rules_of_2008_trace_an_eighth_of_the_points_at_44_db() {
    let scene = show::model_scene(0.0);
    for (isa, exhaustive) in draw_by_all(&scene, &Quality::EXHAUSTIVE, 1024, 768) {
        let thesis = draw(isa, 2, &scene, &Quality::THESIS, 1024, 768);
        let psnr = Difference::between(&exhaustive.pixels, &thesis.pixels).psnr;
        assert!(psnr >= 44.0, "{}: {psnr} dB", isa.name);
        let share = thesis.counts.points as f64 / (1024.0 * 768.0);
        assert!((0.09..=0.14).contains(&share), "{}: {share}", isa.name);
    }
}

#[test]
fn what_the_intro_plays_is_within_45_db_in_every_frame() {
    for second in 0..=10 {
        let scene = show::model_scene(second as f32);
        for quality in [Quality::DEFAULT, jagged(Quality::DEFAULT)] {
            let [exhaustive, played] = [quality.reference(), quality]
                .map(|quality| draw_best(&scene, &quality, 1024, 768).pixels);
            let psnr = Difference::between(&exhaustive, &played).psnr;
            assert!(psnr >= 45.0, "{psnr} dB at {second} s by {quality:?}");
        }
    }
}

#[test]
#[ignore = "many frames"]
fn squares_are_filled_and_split_by_the_rules() {
    for quality in [Quality::THESIS, Quality::DEFAULT].map(bare) {
        for (name, scene) in scenes() {
            assert_as_refined(&scene, &quality, [300, 200], name);
        }
    }
}

#[test]
fn what_corners_compare_follows_the_quality() {
    let scene = show::model_scene(4.0);
    for (key_depth, state_depth, tolerance_agreeing, tolerance_differing) in [
        (0, 0, f32::INFINITY, 0.0),
        (1, 1, f32::INFINITY, 5.0),
        (5, 5, f32::INFINITY, 0.0),
        (7, 0, 30.0, 3.0),
        (5, 1, 2.0, 20.0),
        (0, 0, 9.0, 9.0),
        (0, 0, 4.0, 4.0),
    ] {
        let quality = Quality {
            key_depth,
            state_depth,
            tolerance_agreeing,
            tolerance_differing,
            tolerance_side: 6.0,
            highlight: 0.1,
            ..bare(Quality::THESIS)
        };
        assert_as_refined(&scene, &quality, [400, 300], &format!("{quality:?}"));
    }
}

#[test]
fn squares_of_every_side_follow_the_rules() {
    let scene = show::model_scene(1.0);
    for square in [1, 2, 4, 8, 16, 32] {
        for rules in [Quality::THESIS, Quality::DEFAULT] {
            let quality = Quality {
                square,
                ..bare(rules)
            };
            assert_as_refined(&scene, &quality, [203, 149], &format!("{quality:?}"));
        }
    }
}

#[test]
fn a_point_has_the_same_bits_whatever_is_traced_beside_it() {
    for (name, scene) in scenes() {
        for isa in cpu::instruction_sets() {
            let exhaustive = draw(isa, 2, &scene, &Quality::EXHAUSTIVE, 331, 217);
            for square in [2, 4, 8, 16, 32] {
                let quality = Quality {
                    square,
                    ..Quality::THESIS
                };
                let refined = draw(isa, 2, &scene, &quality, 331, 217);
                for y in (0..217).step_by(square) {
                    for x in (0..331).step_by(square) {
                        assert_eq!(
                            refined.pixels[y * 331 + x],
                            exhaustive.pixels[y * 331 + x],
                            "{name}, squares of {square} by {}: ({x}, {y})",
                            isa.name
                        );
                    }
                }
            }
        }
    }
}

/// The most points of a picture by squares of a side: those on the border between two tiles are traced by both.
pub fn most_points(square: usize, width: usize, height: usize) -> usize {
    let corners = |side: usize, tile: usize| -> usize {
        let parts = (0..side).step_by(tile);
        parts
            .map(|start| (side - start).min(tile).next_multiple_of(square) + 1)
            .sum()
    };
    if square == 1 {
        width * height
    } else {
        corners(width, TILE[0]) * corners(height, TILE[1])
    }
}

#[test]
fn no_point_is_traced_twice_even_where_every_square_splits() {
    // Many spheres from above, and tolerances of 0: hardly any square is filled.
    let mut scene = show::field(320, 0.0);
    scene.camera = Camera::new(vec3(0.0, 14.0, 0.1), Vec3::ZERO, 0.13);
    let (width, height) = (700, 70);
    for square in [1, 2, 4, 8, 16, 32] {
        let quality = Quality {
            square,
            tolerance_agreeing: 0.0,
            tolerance_differing: 0.0,
            ..Quality::THESIS
        };
        let drawn = draw_best(&scene, &quality, width, height);
        let most = most_points(square, width, height);
        let points = drawn.counts.points as usize;
        assert!(
            points <= most,
            "squares of {square}: {points} of {most} points"
        );
        assert!(
            points >= width * height / 2,
            "the scene does not make every square split: {points} points"
        );
    }
}

/// The PSNR of the default quality against the same with every pixel traced.
fn psnr(scene: &Scene, [width, height]: [usize; 2]) -> f64 {
    let quality = Quality::DEFAULT;
    let [exhaustive, played] = [quality.reference(), quality]
        .map(|quality| draw_best(scene, &quality, width, height).pixels);
    Difference::between(&exhaustive, &played).psnr
}

#[test]
fn crowded_pictures_have_42_db() {
    for (count, time) in [
        (100, 13.0),
        (256, 9.0),
        (300, 20.0),
        (320, 0.0),
        (320, 41.6),
    ] {
        let psnr = psnr(&show::field(count, time), [1024, 768]);
        assert!(psnr >= 42.0, "{psnr} dB of {count} spheres at {time} s");
    }
}

/// Asserts that pictures of scenes have 42 dB.
fn assert_42_db(scenes: impl Iterator<Item = Scene>) {
    let mut all: Vec<f64> = scenes.map(|scene| psnr(&scene, [640, 480])).collect();
    all.sort_by(f64::total_cmp);
    println!("{all:.1?}");
    assert!(all[0] >= 42.0, "{} dB", all[0]);
}

/// Scenes by their numbers of spheres and blocks, and their shares of glass and mirrors.
///
/// Measured: 43.1 dB and more. Of 48 scenes of 134 solids and more six are below 42 dB by squares of 8, and by squares of 4 sixteen
/// without keys that tell points of such mirrors apart.
#[test]
#[ignore = "many scenes by chance"]
fn crowds_of_mirrors_and_glass_have_42_db() {
    let counts = [[16, 32], [0, 64], [20, 64], [70, 64], [130, 64], [320, 64]];
    let shares = [[0.2, 0.2], [0.5, 0.2], [0.0, 0.6], [0.4, 0.4]];
    let kinds = counts
        .iter()
        .flat_map(|&count| shares.map(|shares| (count, shares)));
    let scene = |(seed, (count, shares))| crowded(&mut Random(seed), count, shares);
    assert_42_db((0..).zip(kinds).map(scene));
}

/// Scenes under points, suns, balls and spotlights; `PROPTEST_CASES` is how many of each number of blocks.
///
/// Measured: 44.2 dB and more. Where shadows of blocks and by other lamps than points are not looked for, 28 of these 120 scenes are below
/// 42 dB, the worst 34.4 dB. Of 200 scenes of each number of blocks two are below, 41.0 dB, for a slit of light on a block's face.
#[test]
#[ignore = "many scenes by chance"]
fn crowds_without_mirrors_have_42_db() {
    let cases = u64::from(config(24).cases);
    let kinds = [4, 12, 24, 46, 64]
        .into_iter()
        .flat_map(|blocks| (0..cases).map(move |seed| (blocks, seed)));
    assert_42_db(kinds.map(|(blocks, seed)| {
        let mut scene = crowded(&mut Random(seed), [20, blocks], [0.0; 2]);
        for light in scene.lights.iter_mut() {
            let spot = Spot {
                aim: -light.position.normalize(),
                outer_angle: 0.795,
                inner_angle: 0.6435,
            };
            match seed % 4 {
                0 => {}
                1 => light.parallel = true,
                2 => light.diameter = 0.5,
                _ => light.spot = Some(spot),
            }
        }
        scene
    }));
}
