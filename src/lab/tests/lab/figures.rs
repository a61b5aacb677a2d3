use super::{lab, stderr};
use eightfold_lab::overlay::{draw_error, heat};
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

#[test]
fn close_up_shows_what_the_guard_finds() {
    let output = lab("figures --scene ../../docs/guard/ball.ron --size 160x120 --at 84,52 --out -");
    assert!(output.status.success(), "{}", stderr(&output));
    let (width, sheet) = read_png(&output.stdout);
    let is_red = |&pixel: &u32| pixel >> 16 > 100 && pixel & 0xff < 60 && pixel >> 8 & 0xff < 60;
    let red = [0, 1, 2].map(|tile| {
        let left = 12 + tile * (384 + 12);
        let rows = (12..12 + 240).flat_map(|y| &sheet[y * width + left..][..384]);
        rows.filter(|&pixel| is_red(pixel)).count() / 144
    });
    assert!(red[0] > 5 && red[1] == 0 && red[2] > 5, "{red:?}");
}

#[test]
fn error_is_drawn_from_black_to_white() {
    let exhaustive = [0x0010_2030, 0x0010_2030, 0x0010_2030];
    let mut pixels = [0x0010_2030, 0x0010_2130, 0x00ff_2030];
    draw_error(&mut pixels, &exhaustive, 32);
    assert_eq!(pixels, [0.0, 1.0 / 32.0, 1.0].map(heat));
}
