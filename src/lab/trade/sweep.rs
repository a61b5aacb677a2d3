//! Varies each field of `Quality` by itself, then combinations.

use crate::technique::{Sampling, Technique};
use eightfold_tracer::Preset;
use eightfold_tracer::Quality;

const BASES: [(&str, Quality); 2] = [("default", Quality::DEFAULT), ("thesis", Quality::THESIS)];
const SQUARES: [usize; 5] = [2, 4, 8, 16, 32];
const TOLERANCES: [f32; 12] = [1.0, 2.0, 3.0, 4.0, 5.0, 7.0, 9.0, 12.0, 18.0, 26.0, 40.0, 64.0];
const DIFFERING: [f32; 4] = [4.0, 9.0, 18.0, 64.0];
const SIDES: [f32; 4] = [0.0, 3.0, 5.0, 16.0];
/// Depths of objects and of lights' states.
const KEYS: [(u32, u32); 6] = [(0, 0), (1, 0), (1, 1), (2, 2), (5, 1), (5, 5)];
const HIGHLIGHTS: [f32; 4] = [1.0 / 1024.0, 1.0 / 64.0, 0.25, f32::INFINITY];
const UNGUARDED: [f32; 3] = [0.05, 0.1, 0.2];
const EDGES: [u8; 5] = [4, 8, 12, 16, 40];
const CONTRIBUTIONS: [f32; 6] = [0.0, 0.003, 0.02, 0.05, 0.1, 0.2];
const FOLLOWED: [(u32, f32); 5] = [(5, 0.01), (5, 0.02), (4, 0.02), (3, 0.05), (2, 0.1)];

pub fn techniques(antialias: bool) -> Vec<Technique> {
    let named = Preset::ALL.map(|preset| Technique::named(preset, antialias));
    let mut all = named.to_vec();
    let mut add = |name: &str, quality: Quality| {
        let technique = Technique::new(name, quality, antialias, Sampling::Full);
        if all.iter().all(|known| known.quality != technique.quality) {
            all.push(technique);
        }
    };
    for (base, quality) in BASES {
        let mut vary = |field: &str, change: &dyn Fn(&mut Quality)| {
            let mut quality = quality;
            change(&mut quality);
            add(&format!("{base}, {field}"), quality);
        };
        for square in SQUARES {
            vary(&format!("square {square}"), &|it| it.square = square);
        }
        for to in TOLERANCES {
            vary(&format!("tolerance {to}"), &|it| set_tolerance(it, to));
        }
        for to in DIFFERING {
            let field = format!("differing {to}");
            vary(&field, &|it| it.tolerance_differing = to);
        }
        for to in SIDES {
            vary(&format!("side {to}"), &|it| it.tolerance_side = to);
        }
        vary("unguarded", &|it| it.guarded = false);
        for to in UNGUARDED {
            vary(&format!("unguarded weight {to}"), &|it| it.unguarded_weight = to);
        }
        for keys in KEYS {
            vary(&format!("keys {}/{}", keys.0, keys.1), &|it| {
                (it.key_depth, it.state_depth) = keys;
            });
        }
        for to in HIGHLIGHTS {
            vary(&format!("highlight {to:.3}"), &|it| it.highlight = to);
        }
        for edge in EDGES {
            vary(&format!("edge {edge}"), &|it| it.edge = edge);
        }
        for depth in 0..=Quality::MAX_DEPTH {
            vary(&format!("depth {depth}"), &|it| it.depth = depth);
        }
        for least in CONTRIBUTIONS {
            let field = format!("contribution {least}");
            vary(&field, &|it| it.least_contribution = least);
        }
    }
    for tolerance in TOLERANCES {
        for (depth, least_contribution) in FOLLOWED {
            let mut quality = Quality { depth, least_contribution, ..Quality::DEFAULT };
            set_tolerance(&mut quality, tolerance);
            let name =
                format!("tolerance {tolerance}, depth {depth}, contribution {least_contribution}");
            add(&name, quality);
        }
    }
    all
}

fn set_tolerance(quality: &mut Quality, tolerance: f32) {
    (quality.tolerance_agreeing, quality.tolerance_side) = (tolerance, tolerance);
}
