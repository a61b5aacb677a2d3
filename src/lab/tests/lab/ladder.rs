//! The documented errors of the ladder of named qualities are those that are measured.

use super::{cells, printed};
use eightfold_tracer::Quality;

#[test]
fn the_default_quality_is_the_preset_of_that_name() {
    let preset = Quality::DEFAULT_PRESET;
    assert_eq!(Quality::NAMES[preset], "default");
    assert_eq!(Quality::LADDER[preset], Quality::DEFAULT);
}

/// The number with which a cell begins.
fn number(cell: &str) -> f64 {
    let number = cell.split(' ').next().and_then(|text| text.parse().ok());
    number.unwrap_or_else(|| panic!("no number: {cell}"))
}

/// The allowed difference between a documented and a measured figure: one unit of the last documented digit, and the share by
/// which instruction sets may differ.
fn tolerance(cell: &str, share: f64) -> f64 {
    let digits = cell.split(' ').next().and_then(|text| text.split_once('.'));
    let last = 0.1_f64.powi(digits.map_or(0, |(_, digits)| digits.len() as i32));
    // A little more than one unit, since both figures are rounded.
    1.01 * last + share * number(cell)
}

#[test]
#[ignore = "many frames"]
fn the_errors_are_as_documented_and_rise_from_preset_to_preset() {
    const PAGE: &str = include_str!("../../../../docs/accuracy.md");
    let (_, part) = PAGE
        .split_once("<!-- lab report ladder -->")
        .expect("a part");
    let documented = cells(part.split("<!--").next().expect("its text"));
    // What is seen is that of fewer views here, which takes less time; `seen.rs` tests how it is measured.
    let text = printed("trade --ladder --views 1");
    let measured = cells(&text);
    // The two qualities that serve for comparison come first.
    assert_eq!(documented.len(), 1 + 2 + Quality::LADDER.len());
    assert_eq!(measured.len(), documented.len());
    assert_eq!(measured[0], documented[0], "titles");
    for (documented, measured) in documented.iter().zip(&measured).skip(3) {
        assert_eq!(documented[0], measured[0]);
        // Columns, and the relative difference that instruction sets may make.
        for (column, share) in [(2, 0.01), (4, 0.0), (5, 0.01), (6, 0.02)] {
            let (documented, measured) = (&documented[column], &measured[column]);
            let off = (number(documented) - number(measured)).abs();
            assert!(
                off <= tolerance(documented, share),
                "{documented} is documented, {measured} is measured"
            );
        }
    }
    // Every preset traces less than the one above it, and differs more.
    for pair in measured[3..].windows(2) {
        let [finer, faster] = [&pair[0], &pair[1]];
        // Points traced, then PSNR and FLIP.
        for (column, sign) in [(2, -1.0), (4, -1.0), (8, 1.0)] {
            let rise = sign * (number(faster[column]) - number(finer[column]));
            assert!(rise > 0.0, "{finer:?}, {faster:?}");
        }
    }
}
