//! The documented errors of the ladder of named qualities are those that are measured.

use super::lab;
use eightfold::Quality;

#[test]
fn the_default_quality_is_the_rung_of_that_name() {
    let rung = Quality::DEFAULT_RUNG;
    assert_eq!(Quality::NAMES[rung], "default");
    assert_eq!(Quality::LADDER[rung], Quality::DEFAULT);
}

/// The cells of a Markdown table, without the titles and the rule under them.
fn cells(lines: impl Iterator<Item = &'static str>) -> Vec<Vec<String>> {
    let lines = lines.skip_while(|line| !line.starts_with("| --- "));
    lines
        .skip(1)
        .take_while(|line| line.starts_with('|'))
        .map(|line| {
            let cells = line.trim_matches('|').split('|');
            cells.map(|cell| cell.trim().to_owned()).collect()
        })
        .collect()
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
fn the_errors_are_as_documented() {
    const SOURCE: &str = include_str!("../../../../src/quality.rs");
    let docs = SOURCE
        .lines()
        .filter_map(|line| line.trim_start().strip_prefix("/// "));
    let documented = cells(docs.skip_while(|line| !line.starts_with("| name | dials |")));
    let output = lab(&["trade", "--ladder"]);
    assert!(output.status.success());
    let text: &'static str = String::from_utf8(output.stdout).expect("text").leak();
    // The two qualities that serve for comparison come first.
    let measured = cells(text.lines()).split_off(2);
    assert_eq!(documented.len(), Quality::LADDER.len());
    assert_eq!(measured.len(), documented.len());
    for (documented, measured) in documented.iter().zip(&measured) {
        assert_eq!(documented[..2], measured[..2], "name and dials");
        // The columns of the documentation and of the lab, and the allowed relative difference.
        for (ours, theirs, share) in [
            (3, 3, 0.01),
            (4, 4, 0.0),
            (5, 7, 0.02),
            (6, 9, 0.1),
            (7, 10, 0.01),
        ] {
            let (documented, measured) = (&documented[ours], &measured[theirs]);
            let off = (number(documented) - number(measured)).abs();
            assert!(
                off <= tolerance(documented, share),
                "{documented} is documented, {measured} is measured"
            );
        }
    }
}
