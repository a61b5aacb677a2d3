//! `lab size`: what the intro's bytes are.

use crate::{assert_one_line, lab, stage};

/// The cells of the table whose first column has this title, line by line.
fn table<'a>(text: &'a str, title: &str) -> Vec<Vec<&'a str>> {
    let start = format!("| {title} |");
    let lines = text.lines().skip_while(|line| !line.starts_with(&start));
    let rows = lines.skip(2).take_while(|line| line.starts_with('|'));
    rows.map(|line| line.trim_matches('|').split('|').map(str::trim).collect())
        .collect()
}

fn number(cell: &str) -> u64 {
    cell.trim_matches('*').parse().expect("a number")
}

#[test]
fn every_byte_of_the_intro_is_told_of() {
    let output = lab(&["size", "--functions", "12"]);
    let text = String::from_utf8(output.stdout).expect("text");
    assert!(output.status.success(), "{text}");
    let file = std::fs::metadata(stage::intro()).expect("the intro").len();

    let sections = table(&text, "section");
    let (whole, parts) = sections.split_last().expect("a line for the file");
    assert_eq!(number(whole[1]), file);
    let sum: u64 = parts.iter().map(|row| number(row[1])).sum();
    assert_eq!(sum, file);
    let code = parts.iter().find(|row| row[0] == ".text").expect("code");
    let code = number(code[1]);

    let crates = table(&text, "crate");
    let sum: u64 = crates.iter().map(|row| number(row[2])).sum();
    // What aligns functions is no function's.
    assert!(sum <= code && sum > code * 95 / 100, "{sum} of {code}");
    for name in ["eightfold", "eightfold_window"] {
        assert!(crates.iter().any(|row| row[0] == name), "{name}: {text}");
    }

    let functions = table(&text, "function");
    let (rest, functions) = functions.split_last().expect("a line for the rest");
    assert_eq!(functions.len(), 12);
    let bytes: Vec<u64> = functions.iter().map(|row| number(row[3])).collect();
    assert!(bytes.is_sorted_by(|a, b| a >= b), "{bytes:?}");
    assert_eq!(bytes.iter().sum::<u64>() + number(rest[3]), sum);
    // The tracer is most of it.
    assert_eq!(functions[0][1], "eightfold", "{text}");
}

#[test]
fn bad_input_is_named_in_one_line() {
    for number in ["0", "-3", "many"] {
        let output = lab(&["size", "--functions", number]);
        assert_one_line(&output, 2, &["--functions", "from 1"]);
    }
}
