//! The ladder of named qualities.

use super::lab;
use eightfold::Quality;

#[test]
fn what_the_intro_plays_by_is_a_rung_and_so_called() {
    let rung = Quality::NAMES.iter().position(|&name| name == "default");
    let rung = rung.expect("a rung of that name");
    assert_eq!(Quality::LADDER[rung], Quality::DEFAULT);
}

/// The cells of a Markdown table's lines, without the titles and the rule under them.
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

/// The number that a cell begins with.
fn number(cell: &str) -> f64 {
    let number = cell.split(' ').next().and_then(|text| text.parse().ok());
    number.unwrap_or_else(|| panic!("no number: {cell}"))
}

/// What a figure may be off: half of its last digit, as it is told in the documentation, and the share by which
/// instruction sets may differ.
fn tolerance(cell: &str, share: f64) -> f64 {
    let digits = cell.split(' ').next().and_then(|text| text.split_once('.'));
    let last = 0.1_f64.powi(digits.map_or(0, |(_, digits)| digits.len() as i32));
    // One for the table that is measured, which is rounded too.
    1.01 * last + share * number(cell)
}

#[test]
fn the_errors_are_as_documented() {
    const SOURCE: &str = include_str!("../../../../src/quality.rs");
    let docs = SOURCE
        .lines()
        .filter_map(|line| line.trim_start().strip_prefix("/// "));
    let told = cells(docs.skip_while(|line| !line.starts_with("| name | dials |")));
    let output = lab(&["trade", "--ladder"]);
    assert!(output.status.success());
    let text: &'static str = String::from_utf8(output.stdout).expect("text").leak();
    // The two that are compared with come first.
    let measured = cells(text.lines()).split_off(2);
    assert_eq!(told.len(), Quality::LADDER.len());
    assert_eq!(measured.len(), told.len());
    for (told, measured) in told.iter().zip(&measured) {
        assert_eq!(told[..2], measured[..2], "name and dials");
        // Columns of the documentation and of the lab, and how far they may be apart.
        for (ours, theirs, share) in [
            (3, 3, 0.01),
            (4, 4, 0.0),
            (5, 7, 0.02),
            (6, 9, 0.1),
            (7, 10, 0.01),
        ] {
            let (told, measured) = (&told[ours], &measured[theirs]);
            let off = (number(told) - number(measured)).abs();
            assert!(
                off <= tolerance(told, share),
                "{told} is told, {measured} is measured"
            );
        }
    }
}
