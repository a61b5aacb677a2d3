use super::{lab, stderr};
use eightfold_stage::reader::read_png;

#[test]
fn sheet_has_six_distinct_pictures() {
    let output = lab("figures --size 200x150 --out -");
    assert!(output.status.success(), "{}", stderr(&output));
    let (width, sheet) = read_png(&output.stdout);
    let place = |i: usize| [12 + i % 2 * 212, 12 + i / 2 * (150 + 40 + 12)];
    let picture = |i: usize| {
        let [x, y] = place(i);
        let rows = (y..y + 150).flat_map(|y| &sheet[y * width + x..][..200]);
        rows.copied().collect::<Vec<u32>>()
    };
    let rendered = lab("render --size 200x150 --out -");
    let pictures: Vec<Vec<u32>> = (0..6).map(picture).collect();
    assert!(pictures[1] == read_png(&rendered.stdout).1);
    for (i, picture) in pictures.iter().enumerate() {
        assert!(!pictures[..i].contains(picture), "picture {i}");
    }
}
