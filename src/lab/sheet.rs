use crate::bitmap::{at, bitmap, text};
use anyhow::Result;
use eightfold_harness::{Size, picture};

pub struct Tile {
    pub pixels: Vec<u32>,
    pub caption: String,
}

/// Pixels.
const GAP: usize = 12;
/// Pixels.
const LINE: usize = 18;
const PAPER: u32 = 0x00ff_ffff;

pub fn sheet(size: Size, columns: usize, tiles: &[Tile]) -> Result<Vec<u8>> {
    let lines = tiles.iter().map(|tile| tile.caption.lines().count()).max();
    let below = LINE * lines.unwrap_or(0) + 4;
    let (across, down) = (size.width + GAP, size.height + below + GAP);
    let width = GAP + columns * across;
    let height = GAP + tiles.len().div_ceil(columns) * down;
    let place = |i: usize| [GAP + i % columns * across, GAP + i / columns * down];
    let mut pixels = bitmap([width, height], PAPER, |area| {
        for (i, tile) in tiles.iter().enumerate() {
            let [x, y] = place(i);
            for (line, words) in tile.caption.lines().enumerate() {
                let place = at([x, y + size.height + 6 + line * LINE]);
                area.draw_text(words, &text(13), place)?;
            }
        }
        Ok(())
    })?;
    for (i, tile) in tiles.iter().enumerate() {
        let [x, y] = place(i);
        for (row, line) in tile.pixels.chunks_exact(size.width).enumerate() {
            pixels[(y + row) * width + x..][..size.width].copy_from_slice(line);
        }
    }
    Ok(picture::png(width, &pixels)?)
}
