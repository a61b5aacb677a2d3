use crate::{cells, printed};
use eightfold_harness::cargo::Build;
use eightfold_stage::intro;
use std::path::PathBuf;

fn number(cell: &str) -> u64 {
    cell.trim_matches('*').parse().expect("a number")
}

fn sum(rows: &[Vec<&str>], column: usize) -> u64 {
    rows.iter().map(|row| number(row[column])).sum()
}

#[test]
#[ignore = "the intro for Windows is compiled"]
fn sections_of_windows_intro_add_up() {
    let text = printed("size --windows --functions 1");
    let build = Build::windows().expect("cargo builds the intro");
    assert_sections(&tables(&text)[0], build.program("eightfold").expect("the intro"));
}

/// Returns the rows of each table, without its title.
fn tables(text: &str) -> Vec<Vec<Vec<&str>>> {
    text.split("\n\n").map(|table| cells(table).split_off(1)).collect()
}

fn assert_sections(sections: &[Vec<&str>], intro: PathBuf) -> [u64; 2] {
    let file = std::fs::metadata(intro).expect("the intro").len();
    let (whole, parts) = sections.split_last().expect("a line for the file");
    assert_eq!(number(whole[2]), file);
    assert!(sum(parts, 2).abs_diff(file) <= parts.len() as u64, "{sections:?}");
    let code = parts.iter().find(|row| row[0] == ".text").expect("code");
    [1, 2].map(|column| number(code[column]))
}

#[test]
fn tables_add_up_to_file() {
    let text = printed("size --functions 12");
    let [sections, crates, functions] = &tables(&text)[..] else { panic!("{text}") };
    let [bytes, packed] = assert_sections(sections, intro());
    assert!(packed < bytes / 2, "{text}");
    // Padding has no symbol; constants have.
    let named = sum(crates, 2);
    assert!(named > bytes * 9 / 10, "{named} of {bytes}");
    for name in ["eightfold", "eightfold_tracer", "eightfold_window"] {
        assert!(crates.iter().any(|row| row[0] == name), "{name}: {text}");
    }
    let (rest, functions) = functions.split_last().expect("a line for the rest");
    assert_eq!(functions.len(), 12);
    let sizes: Vec<u64> = functions.iter().map(|row| number(row[4])).collect();
    assert!(sizes.is_sorted_by(|a, b| a >= b), "{sizes:?}");
    assert_eq!(sum(functions, 3) + number(rest[3]), named);
    let is_traced = |row: &Vec<&str>| row[1] == "eightfold_tracer";
    assert!(functions.iter().any(is_traced), "{text}");
}
