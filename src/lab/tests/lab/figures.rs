//! `lab figures` writes a picture for each figure, and a sheet of all.

use super::lab;
use eightfold_stage::reader::read_png;
use std::collections::BTreeSet;
use std::fs;

const PICTURES: [&str; 6] = [
    "points",
    "picture",
    "squares",
    "rays",
    "rays-exhaustive",
    "error",
];

#[test]
fn every_figure_is_written_and_the_sheet_shows_them_all() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("made/here");
    let output = lab(&format!("figures --size 200x150 --out {}", out.display()));
    assert!(output.status.success() && output.stdout.is_empty());
    let read = |name: &str| read_png(&fs::read(out.join(format!("{name}.png"))).unwrap());
    let (sheet_width, sheet) = read("sheet");
    let sheet: Vec<&[u32]> = sheet.chunks_exact(sheet_width).collect();
    let mut pictures = BTreeSet::new();
    for name in PICTURES {
        let (width, pixels) = read(name);
        assert_eq!((width, pixels.len()), (200, 200 * 150), "{name}");
        let first = &pixels[75 * width..76 * width];
        let is_shown = sheet
            .iter()
            .any(|row| row.windows(width).any(|part| part == first));
        assert!(is_shown, "{name} is not on the sheet");
        pictures.insert(pixels);
    }
    assert_eq!(pictures.len(), PICTURES.len(), "two figures are the same");
    assert_eq!(fs::read_dir(&out).unwrap().count(), PICTURES.len() + 1);
}
