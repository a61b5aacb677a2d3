use super::picture;
use eightfold_harness::Size;
use eightfold_harness::patches::{lost, patches};
use eightfold_harness::threaded_renderer::drawn;
use eightfold_lab::bitmap::{Tile, sheet};
use eightfold_lab::overlay::{draw_error, heat};
use eightfold_scenes::artists::{KINDS, ON_FLOORS};
use eightfold_tracer::Quality;

#[test]
fn sheet_has_six_distinct_pictures() {
    let (width, sheet) = picture("figures --size 200x150 --out -");
    let tile = |i: usize| {
        let (x, y) = (12 + i % 2 * 212, 12 + i / 2 * (150 + 40 + 12));
        let rows = (y..y + 150).flat_map(|y| &sheet[y * width + x..][..200]);
        rows.copied().collect::<Vec<u32>>()
    };
    let pictures: Vec<Vec<u32>> = (0..6).map(tile).collect();
    assert!(pictures[1] == picture("render --size 200x150 --out -").1);
    for (i, picture) in pictures.iter().enumerate() {
        assert!(!pictures[..i].contains(picture), "picture {i}");
    }
}

#[test]
fn close_up_shows_what_the_guard_finds() {
    let line = "figures --scene ../../docs/guard/ball.ron --size 160x120 --at 84,52 --out -";
    let (width, sheet) = picture(line);
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

const PICTURE: Size = Size::new(640, 360);
const TILE: Size = Size::new(200, 75);

/// Draws the worst of 24 scenes of each kind by `default`: exhaustive to the left of it.
#[test]
#[ignore = "draws docs/unguarded.png"]
fn sheet_of_unguarded_kinds() {
    let tiles = KINDS[ON_FLOORS..].iter().map(|kind| {
        let pairs = (0..24).map(|seed| {
            let pair = [Quality::EXHAUSTIVE, Quality::DEFAULT]
                .map(|quality| drawn(2, &kind.seeded(seed), &quality.jagged(), PICTURE));
            let lost = lost(&pair[0], &pair[1], PICTURE.width);
            let patch = patches(&lost, PICTURE.width).into_iter().max_by_key(Vec::len);
            (pair, patch.unwrap_or_default())
        });
        let (pair, patch) = pairs.max_by_key(|(_, patch)| patch.len()).expect("24 scenes");
        let middle = patch.get(patch.len() / 2);
        let middle = middle.copied().unwrap_or(PICTURE.width * PICTURE.height / 2);
        let half = TILE.width / 2;
        let start = |middle: usize, part: usize, whole: usize| {
            middle.saturating_sub(part / 2).min(whole - part)
        };
        let left = start(middle % PICTURE.width, half, PICTURE.width);
        let top = start(middle / PICTURE.width, TILE.height, PICTURE.height);
        let rows = (top..top + TILE.height).flat_map(|y| {
            pair.each_ref().map(|picture| &picture[y * PICTURE.width + left..][..half])
        });
        Tile {
            pixels: rows.flatten().copied().collect(),
            caption: format!("{}: {} pixels", kind.0, patch.len()),
        }
    });
    let sheet = sheet(TILE, 3, &tiles.collect::<Vec<Tile>>()).expect("a sheet");
    std::fs::write("../../docs/unguarded.png", sheet).expect("a picture");
}
