use super::{cells, printed};
use eightfold_tracer::Preset;

fn number(cell: &str) -> f64 {
    let number = cell.split(' ').next().and_then(|text| text.parse().ok());
    number.unwrap_or_else(|| panic!("not a number: {cell}"))
}

/// Allows one unit of the last digit, since both figures are rounded, plus a share.
fn tolerance(cell: &str, share: f64) -> f64 {
    let digits = cell.split(' ').next().and_then(|text| text.split_once('.'));
    let last = 0.1_f64.powi(digits.map_or(0, |(_, digits)| digits.len() as i32));
    1.01 * last + share * number(cell)
}

#[test]
#[ignore = "many frames"]
fn errors_match_documentation_and_increase() {
    const PAGE: &str = include_str!("../../../../docs/accuracy.md");
    let (_, part) = PAGE.split_once("<!-- report ladder -->").expect("a part");
    let documented = cells(part.split("<!--").next().expect("its text"));
    // One view saves time: views are not compared.
    let text = printed("trade --ladder --frames 9 --views 1");
    let measured = cells(&text);
    assert_eq!(documented.len(), 1 + Preset::ALL.len());
    assert_eq!(measured.len(), documented.len());
    assert_eq!(measured[0], documented[0], "titles");
    for (documented, measured) in
        documented.iter().zip(&measured).skip(2).take(Preset::LADDER.len())
    {
        assert_eq!(documented[0], measured[0]);
        // Columns, and the relative difference between instruction sets.
        for (column, share) in [(2, 0.01), (3, 0.0), (4, 0.01), (5, 0.02)] {
            let (documented, measured) = (&documented[column], &measured[column]);
            let off = (number(documented) - number(measured)).abs();
            let is_near = off <= tolerance(documented, share);
            assert!(is_near, "{documented}, {measured}");
        }
    }
    for pair in measured[2..][..Preset::LADDER.len()].windows(2) {
        let [finer, faster] = [&pair[0], &pair[1]];
        for (column, sign) in [(2, -1.0), (3, -1.0), (7, 1.0)] {
            let rise = sign * (number(faster[column]) - number(finer[column]));
            assert!(rise > 0.0, "{finer:?}, {faster:?}");
        }
    }
}
