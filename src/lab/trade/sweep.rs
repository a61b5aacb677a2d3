//! Varies fields of `Quality` one by one, then several at once.

use crate::technique::{Sampling, Technique};
use eightfold_tracer::{Preset, Quality};

const BASES: [(&str, Quality); 2] = [("default", Quality::DEFAULT), ("thesis", Quality::THESIS)];
const TOLERANCES: [f32; 12] = [1.0, 2.0, 3.0, 4.0, 5.0, 7.0, 9.0, 12.0, 18.0, 26.0, 40.0, 64.0];
/// Depths of objects and of lights' states.
const KEYS: [(u32, u32); 6] = [(0, 0), (1, 0), (1, 1), (2, 2), (5, 1), (5, 5)];
const FOLLOWED: [(u32, f32); 5] = [(5, 0.01), (5, 0.02), (4, 0.02), (3, 0.05), (2, 0.1)];

type Field = (&'static str, &'static [f32], fn(&mut Quality, f32));
const FIELDS: [Field; 8] = [
    ("square", &[2.0, 4.0, 8.0, 16.0, 32.0], |it, to| it.square = to as usize),
    ("tolerance", &TOLERANCES, set_tolerance),
    ("differing", &[4.0, 9.0, 18.0, 64.0], |it, to| it.tolerance_differing = to),
    ("side", &[0.0, 3.0, 5.0, 16.0], |it, to| it.tolerance_side = to),
    ("unguarded weight", &[0.05, 0.1, 0.2], |it, to| it.unguarded_weight = to),
    ("highlight", &[0.001, 0.016, 0.25, f32::INFINITY], |it, to| it.highlight = to),
    ("depth", &[0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0], |it, to| it.depth = to as u32),
    ("contribution", &[0.0, 0.003, 0.02, 0.05, 0.1, 0.2], |it, to| it.least_contribution = to),
];

pub fn techniques() -> Vec<Technique> {
    let mut all = Preset::ALL.map(|preset| Technique::named(preset, false)).to_vec();
    let mut add = |name: String, quality: Quality| {
        let technique = Technique::new(&name, quality, false, Sampling::Full);
        if all.iter().all(|known| known.quality != technique.quality) {
            all.push(technique);
        }
    };
    for (base, quality) in BASES {
        for (field, values, set) in FIELDS {
            for &to in values {
                let mut varied = quality;
                set(&mut varied, to);
                add(format!("{base}, {field} {to}"), varied);
            }
        }
        add(format!("{base}, unguarded"), Quality { guarded: false, ..quality });
        for (key_depth, state_depth) in KEYS {
            let name = format!("{base}, keys {key_depth}/{state_depth}");
            add(name, Quality { key_depth, state_depth, ..quality });
        }
    }
    for to in TOLERANCES {
        for (depth, least_contribution) in FOLLOWED {
            let mut quality = Quality { depth, least_contribution, ..Quality::DEFAULT };
            set_tolerance(&mut quality, to);
            let name = format!("tolerance {to}, depth {depth}, contribution {least_contribution}");
            add(name, quality);
        }
    }
    all
}

fn set_tolerance(quality: &mut Quality, tolerance: f32) {
    (quality.tolerance_agreeing, quality.tolerance_side) = (tolerance, tolerance);
}
