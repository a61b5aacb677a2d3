//! The points to measure: each dial by itself, then combinations of those that save time.

use crate::arguments::{NamedQuality, distinct};
use crate::way::Way;
use eightfold_tracer::Quality;

/// Sides of squares.
const SQUARES: [usize; 6] = [1, 2, 4, 8, 16, 32];
/// Tolerances around the default of 7.
const TOLERANCES: [f32; 11] = [1.0, 2.0, 3.0, 4.0, 5.5, 9.0, 14.0, 18.0, 26.0, 40.0, 64.0];
/// Tolerances for agreeing and for differing keys.
const KEYED: [(f32, f32); 8] = [
    (f32::INFINITY, 4.0),
    (f32::INFINITY, 9.0),
    (f32::INFINITY, 18.0),
    (64.0, 9.0),
    (32.0, 0.0),
    (32.0, 9.0),
    (18.0, 0.0),
    (18.0, 4.0),
];
/// Depths of objects and of lights' states in keys.
const COMPARED: [(u32, u32); 9] = [
    (0, 0),
    (1, 0),
    (1, 1),
    (2, 0),
    (2, 2),
    (3, 3),
    (5, 0),
    (5, 1),
    (5, 5),
];
/// The strengths from which a highlight is a state; infinity for never.
const HIGHLIGHTS: [f32; 6] = [
    1.0 / 1024.0,
    1.0 / 256.0,
    1.0 / 64.0,
    1.0 / 16.0,
    0.25,
    f32::INFINITY,
];
/// The smallest weights of rays that are followed.
const CONTRIBUTIONS: [f32; 9] = [0.0, 0.003, 0.01, 0.015, 0.02, 0.04, 0.06, 0.1, 0.2];

/// The named qualities, the exhaustive one first.
pub fn named() -> Vec<Quality> {
    NamedQuality::all().map(|named| named.quality).collect()
}

/// All qualities, the exhaustive one first. With `quick` there are fewer combinations.
pub fn qualities(quick: bool) -> Vec<Quality> {
    let all = [named(), single_dials(), together(quick)];
    distinct(all.into_iter().flatten())
}

/// Variations of single dials of the default quality, and of those that concern keys of the rules of 2008.
fn single_dials() -> Vec<Quality> {
    let (played, thesis) = (Quality::DEFAULT, Quality::THESIS);
    let mut dials = Vec::new();
    let mut turn = |mut quality, change: &dyn Fn(&mut Quality)| {
        change(&mut quality);
        dials.push(quality);
    };
    for square in SQUARES {
        turn(played, &|it| it.square = square);
        turn(thesis, &|it| it.square = square);
    }
    for quality in [played, thesis] {
        turn(quality, &|it| it.guarded = false);
    }
    for depths in COMPARED {
        turn(thesis, &|it| (it.key_depth, it.state_depth) = depths);
    }
    for highlight in HIGHLIGHTS {
        turn(thesis, &|it| it.highlight = highlight);
    }
    for tolerances in KEYED {
        turn(thesis, &|it| {
            (it.tolerance_agreeing, it.tolerance_differing) = tolerances;
        });
    }
    for tolerance in TOLERANCES {
        let quality = within(8, tolerance, &played);
        turn(quality, &|_| {});
        turn(quality, &|it| it.tolerance_differing = tolerance);
    }
    for tolerance in [0.0, 3.0, 5.0, 10.0, 16.0] {
        turn(played, &|it| it.tolerance_side = tolerance);
    }
    for depth in 0..=Quality::MAX_DEPTH {
        turn(played, &|it| it.depth = depth);
    }
    for least in CONTRIBUTIONS {
        turn(played, &|it| it.least_contribution = least);
    }
    dials
}

/// Combinations of square, tolerance, depth and least contribution.
fn together(quick: bool) -> Vec<Quality> {
    let tolerances: &[f32] = if quick {
        &[3.0, 18.0, 40.0]
    } else {
        &[
            2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0, 10.0, 12.0, 16.0, 18.0, 22.0, 28.0, 40.0,
        ]
    };
    let followed = [
        (5, 0.01),
        (5, 0.015),
        (5, 0.02),
        (4, 0.02),
        (4, 0.04),
        (3, 0.05),
        (2, 0.1),
    ];
    let mut qualities = Vec::new();
    for square in [8, 16] {
        // Nearly all of the front is squares of 8.
        let every = if square == 8 { 1 } else { 3 };
        for &tolerance in tolerances.iter().step_by(every) {
            for (depth, least_contribution) in followed {
                let quality = Quality {
                    depth,
                    least_contribution,
                    ..Quality::DEFAULT
                };
                qualities.push(within(square, tolerance, &quality));
            }
        }
    }
    qualities
}

/// The same quality with other squares and another tolerance, also for midpoints of sides.
fn within(square: usize, tolerance: f32, quality: &Quality) -> Quality {
    Quality {
        square,
        tolerance_agreeing: tolerance,
        tolerance_side: tolerance,
        ..*quality
    }
}

/// The way of a quality, by its name, or by its dials if it has none; with antialiasing, or without.
pub fn way(quality: Quality, antialias: bool) -> Way {
    let known = NamedQuality::all().find(|known| known.quality == quality);
    let quality = Quality {
        antialias,
        ..quality
    };
    let name = known.map_or_else(|| dials(&quality), |known| known.name.to_owned());
    Way::new(&name, quality)
}

/// Whether keys are compared.
pub fn has_keys(quality: &Quality) -> bool {
    quality.square > 1 && quality.tolerance_agreeing != quality.tolerance_differing
}

/// A quality's dials in words. What has its usual value is left out, as the help of `lab trade` explains.
pub fn dials(quality: &Quality) -> String {
    let mut words = vec![format!("square {}", quality.square)];
    let number = |tolerance: f32| {
        if tolerance.is_finite() {
            tolerance.to_string()
        } else {
            "\u{221e}".to_owned()
        }
    };
    let keys = |quality: &Quality| (quality.key_depth, quality.state_depth, quality.key_weight);
    if has_keys(quality) && keys(quality) != keys(&Quality::DEFAULT) {
        let (objects, states, weight) = keys(quality);
        words.push(format!("compared {objects}/{states}/{weight}"));
    }
    if quality.square > 1 {
        words.push(format!("tolerance {}", number(quality.tolerance_agreeing)));
        if quality.tolerance_differing != 0.0 {
            words.push(format!("differing {}", number(quality.tolerance_differing)));
        }
        if quality.tolerance_side != quality.tolerance_agreeing {
            words.push(format!("side {}", number(quality.tolerance_side)));
        }
    }
    if has_keys(quality) && quality.highlight.is_finite() {
        words.push(format!("highlight {:.3}", quality.highlight));
    }
    if !quality.guarded {
        words.push("unguarded".to_owned());
    }
    if quality.depth != Quality::EXHAUSTIVE.depth {
        words.push(format!("depth {}", quality.depth));
    }
    if quality.least_contribution != Quality::EXHAUSTIVE.least_contribution {
        words.push(format!("contribution {}", quality.least_contribution));
    }
    if quality.antialias {
        words.push("antialiased".to_owned());
    }
    words.join(", ")
}
