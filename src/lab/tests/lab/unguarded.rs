use eightfold_harness::Size;
use eightfold_harness::patches::{lost, patches};
use eightfold_harness::threaded_renderer::drawn;
use eightfold_lab::bitmap::{Tile, sheet};
use eightfold_scenes::artists::{KINDS, ON_FLOORS};
use eightfold_tracer::Quality;

const PICTURE: Size = Size::new(640, 360);
const TILE: Size = Size::new(200, 75);

/// Draws the worst of 24 scenes of each kind by `default`: exhaustive to the left of it.
#[test]
#[ignore = "draws docs/unguarded.png"]
fn sheet_of_unguarded_kinds() {
    let tiles = KINDS[ON_FLOORS..].iter().map(|kind| {
        let pairs = (0..24).map(|seed| {
            let pair = [Quality::EXHAUSTIVE, Quality::DEFAULT].map(|quality| {
                let quality = Quality { antialias: false, ..quality };
                drawn(2, &kind.seeded(seed), &quality, PICTURE)
            });
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
