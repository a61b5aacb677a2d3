//! The settings to measure: each dial by itself, then combinations of dials that save time.

use crate::arguments::NamedQuality;
use crate::measure::Technique;
use crate::rivals::Way;
use eightfold_tracer::Quality;

/// The names of two qualities whose dials are turned, and values of the dials.
const BASES: [(&str, Quality); 2] = [("default", Quality::DEFAULT), ("thesis", Quality::THESIS)];
const SQUARES: [usize; 5] = [2, 4, 8, 16, 32];
const TOLERANCES: [f32; 12] = [
    1.0, 2.0, 3.0, 4.0, 5.0, 7.0, 9.0, 12.0, 18.0, 26.0, 40.0, 64.0,
];
const DIFFERING: [f32; 4] = [4.0, 9.0, 18.0, 64.0];
const SIDES: [f32; 4] = [0.0, 3.0, 5.0, 16.0];
/// Depths of objects and of lights' states.
const KEYS: [(u32, u32); 6] = [(0, 0), (1, 0), (1, 1), (2, 2), (5, 1), (5, 5)];
const HIGHLIGHTS: [f32; 4] = [1.0 / 1024.0, 1.0 / 64.0, 0.25, f32::INFINITY];
const CONTRIBUTIONS: [f32; 6] = [0.0, 0.003, 0.02, 0.05, 0.1, 0.2];
/// Depths and least contributions that go together.
const FOLLOWED: [(u32, f32); 5] = [(5, 0.01), (5, 0.02), (4, 0.02), (3, 0.05), (2, 0.1)];

/// Returns all settings, each once: the named ones, the exhaustive one first, then the others.
pub fn techniques() -> Vec<Technique> {
    let named = NamedQuality::all();
    let mut all: Vec<Technique> = named.map(|named| Technique::named(named, false)).collect();
    let mut add = |name: String, mut quality: Quality| {
        quality.antialias = false;
        if all.iter().all(|technique| technique.quality != quality) {
            all.push(Technique {
                name,
                quality,
                way: Way::Drawn,
            });
        }
    };
    for (base, quality) in BASES {
        let mut turn = |dial: String, change: &dyn Fn(&mut Quality)| {
            let mut quality = quality;
            change(&mut quality);
            add(format!("{base}, {dial}"), quality);
        };
        for square in SQUARES {
            turn(format!("square {square}"), &|it| it.square = square);
        }
        for tolerance in TOLERANCES {
            turn(format!("tolerance {tolerance}"), &|it| {
                set_tolerance(it, tolerance)
            });
        }
        for tolerance in DIFFERING {
            let dial = format!("differing {tolerance}");
            turn(dial, &|it| it.tolerance_differing = tolerance);
        }
        for tolerance in SIDES {
            turn(format!("side {tolerance}"), &|it| {
                it.tolerance_side = tolerance
            });
        }
        turn("unguarded".to_owned(), &|it| it.guarded = false);
        for (objects, states) in KEYS {
            let dial = format!("keys {objects}/{states}");
            turn(dial, &|it| {
                (it.key_depth, it.state_depth) = (objects, states)
            });
        }
        for highlight in HIGHLIGHTS {
            turn(format!("highlight {highlight:.3}"), &|it| {
                it.highlight = highlight
            });
        }
        for depth in 0..=Quality::MAX_DEPTH {
            turn(format!("depth {depth}"), &|it| it.depth = depth);
        }
        for least in CONTRIBUTIONS {
            turn(format!("contribution {least}"), &|it| {
                it.least_contribution = least
            });
        }
    }
    for tolerance in TOLERANCES {
        for (depth, least_contribution) in FOLLOWED {
            let mut quality = Quality {
                depth,
                least_contribution,
                ..Quality::DEFAULT
            };
            set_tolerance(&mut quality, tolerance);
            add(
                format!("tolerance {tolerance}, depth {depth}, contribution {least_contribution}"),
                quality,
            );
        }
    }
    all
}

/// Sets the tolerance of squares, and of midpoints of sides.
fn set_tolerance(quality: &mut Quality, tolerance: f32) {
    (quality.tolerance_agreeing, quality.tolerance_side) = (tolerance, tolerance);
}
