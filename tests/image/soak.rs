//! Any scene of any size, by any quality and any instruction set, is drawn with the same bits on any number of threads, for
//! bounded work.
//!
//! `tests/run --soak` draws random cases for `SOAK_SECONDS` (600, ten minutes) and prints their number; otherwise a fixed number
//! is drawn. The cases are the same in each run. `SOAK_SEED` selects other cases, `SOAK_FIRST` the case to begin with.

use crate::cpu;
use crate::error::Difference;
use crate::generator::seeded::{Random, corrupt, quality, scene};
use crate::refinement::most_points;
use crate::threaded_renderer::ThreadedRenderer;
use eightfold::show;
use eightfold_oracle::squares::largest;
use eightfold_tracer::scene::Method;
use eightfold_tracer::{Counts, Quality};
use std::env;
use std::time::{Duration, Instant};

/// The number of cases without `SOAK_SECONDS`.
const CASES: u64 = 150;
/// The time between two lines about the progress of a long run.
const PROGRESS: Duration = Duration::from_secs(5);
/// The largest mean error of the default quality, in steps of 1/255, for pictures of 5,000 pixels and more: small spheres take up
/// a large part of these.
const MAX_MEAN_ERROR: f64 = 8.0;
/// The largest width and height.
const MAX_SIZE: (usize, usize) = (160, 120);

/// The renderers of a run.
struct Renderers {
    one: ThreadedRenderer,
    two: ThreadedRenderer,
    exhaustive: ThreadedRenderer,
}

/// Draws a case and asserts everything that holds for all cases. Returns the error of the default quality if the case serves to
/// measure it.
fn hold(renderers: &mut Renderers, seed: u64, case: u64) -> Option<Difference> {
    let mut what = format!("case {case} of seed {seed}");
    let mut random = Random(seed ^ case.wrapping_mul(0xd134_2543_de82_ef95));
    let time = random.between(-100.0, 100.0) * 10_f32.powi(random.below(5) as i32);
    let mut scene = match random.below(8) {
        0 => show::model_scene(time),
        1 => show::field(random.below(321), time),
        _ => scene(&mut random),
    };
    let is_valid = scene.validate().is_ok();
    assert!(is_valid, "{what}: {:?}", scene.validate());
    let is_corrupt = random.below(4) == 0;
    if is_corrupt {
        what += &format!(", invalid {}", corrupt(&mut scene, &mut random));
    }
    let quality = quality(&mut random);
    let (width, height) = match random.below(8) {
        0 => (1, 1 + random.below(300)),
        1 => (1 + random.below(300), 1),
        _ => (1 + random.below(MAX_SIZE.0), 1 + random.below(MAX_SIZE.1)),
    };
    let sets: Vec<_> = cpu::instruction_sets().collect();
    let level = sets[random.below(sets.len())].level;

    let mut pixels = vec![u32::MAX; width * height];
    let mut others = pixels.clone();
    let counts = renderers
        .one
        .draw(level, &scene, &quality, width, &mut pixels);
    let again = renderers
        .two
        .draw(level, &scene, &quality, width, &mut others);
    let is_drawn = pixels.iter().all(|pixel| pixel >> 24 == 0);
    assert!(is_drawn, "{what}: a pixel was left out");
    assert!(pixels == others, "{what}: another picture by two threads");
    let bare = |mut counts: Counts| {
        counts.lanes = 0;
        counts
    };
    assert_eq!(bare(counts), bare(again), "{what}");

    let square = largest(&scene, &quality);
    // Antialiasing takes a point to the right of a pixel and one below; where two parts of a picture meet, both take it.
    let middles = if quality.antialias {
        3 * width * height
    } else {
        0
    };
    let most = (most_points(square, width, height) + middles) as u64;
    assert!(counts.points <= most, "{what}: {counts:?}");
    let tree = (2 << quality.depth) - 1;
    assert!(counts.rays <= counts.points * tree, "{what}: {counts:?}");
    let lights = scene.lights.len() as u64;
    assert!(
        counts.shadow_rays <= counts.rays * lights,
        "{what}: {counts:?}"
    );

    // The corners of the largest squares are always traced, but antialiasing looks at their neighbours, and marks cover them.
    let is_changed = quality.antialias || scene.method != Method::PLAIN;
    let every = Quality {
        square: 1,
        ..quality
    };
    renderers
        .exhaustive
        .draw(level, &scene, &every, width, &mut others);
    for y in (0..height).step_by(square) {
        for x in (0..width).step_by(square) {
            let i = y * width + x;
            let is_same = is_changed || pixels[i] == others[i];
            assert!(is_same, "{what}: ({x}, {y})");
        }
    }
    // Patterns finer than squares have larger errors.
    let is_plain = !is_corrupt && scene.haze == 0.0;
    let is_measured = quality == Quality::DEFAULT && is_plain && pixels.len() > 5000;
    is_measured.then(|| Difference::between(&others, &pixels))
}

#[test]
fn any_case_is_drawn_by_the_same_bits_for_bounded_work() {
    let number = |name| {
        env::var(name)
            .ok()
            .and_then(|text| text.parse::<u64>().ok())
    };
    let seed = number("SOAK_SEED").unwrap_or(2008);
    let limit = number("SOAK_SECONDS").map(Duration::from_secs);
    let start = Instant::now();
    let mut renderers = Renderers {
        one: ThreadedRenderer::new(1),
        two: ThreadedRenderer::new(2),
        exhaustive: ThreadedRenderer::new(1),
    };
    let first = number("SOAK_FIRST").unwrap_or(0);
    let (mut cases, mut measured, mut worst) = (0, 0, 0.0_f64);
    let mut told = Duration::ZERO;
    while limit.map_or(cases < CASES, |limit| start.elapsed() < limit) {
        let since = start.elapsed();
        if let Some(limit) = limit
            && since - told >= PROGRESS
        {
            told = since;
            eprintln!(
                "{} s of {}: {cases} cases held",
                since.as_secs(),
                limit.as_secs()
            );
        }
        if let Some(difference) = hold(&mut renderers, seed, first + cases) {
            measured += 1;
            worst = worst.max(difference.mean);
        }
        cases += 1;
    }
    assert!(
        worst <= MAX_MEAN_ERROR,
        "the default quality is off by {worst} of 255"
    );
    println!(
        "{cases} cases held; the default quality, measured in {measured}, was off by {worst:.2} of 255 at worst"
    );
}
