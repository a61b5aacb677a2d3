//! A band of the picture: the unit of work that threads share.

use super::area::Area;
use super::fill::Canvas;
use super::rough::RoughRow;
use super::tile::Tile;
use super::worker::Worker;
use super::{TILE_HEIGHT, TILE_WIDTH};
use crate::MAX_HEIGHT;
use crate::observe::{Observer, Stage};
use crate::prepare::{Prepared, rectangle};
use crate::quality::Quality;
use crate::trace::{BATCH, Counts};
use core::ops::Range;
use fearless_simd::Level;

/// Bands of the tallest picture.
pub(crate) const MAX_BANDS: usize = MAX_HEIGHT.div_ceil(FEWEST_ROWS);

/// Rows of the lowest band: of one square whose side is more than half the tallest tile.
const FEWEST_ROWS: usize = TILE_HEIGHT / 2 + 1;

/// Some rows of the picture.
pub struct Band<'a> {
    /// The picture's rows from here.
    pub(crate) top: usize,
    pub(crate) width: usize,
    pub(crate) pixels: &'a mut [u32],
    /// How much work it was to draw it. The frame's counts are those of all its bands.
    pub counts: Counts,
    /// Which of its blocks are rough, row after row.
    pub(crate) rough: &'a mut [RoughRow],
}

impl Band<'_> {
    /// Which rows of the picture it has, counted from the top.
    #[must_use]
    pub fn rows_of_picture(&self) -> Range<usize> {
        self.top..self.top + self.height()
    }

    /// Has it count as drawn by somebody else, of whom nothing is known but the pixels that are in it when edges are antialiased: then
    /// the rows next to the bands that are drawn here have to be there.
    pub fn be_unknown(&mut self) {
        self.rough.fill([u64::MAX; _]);
    }

    /// How many rows it has.
    pub(crate) fn height(&self) -> usize {
        self.pixels.len() / self.width
    }

    /// Rows of a band, as many as whole squares fit into the tallest tile; the last one of a picture may have fewer.
    pub(crate) fn rows(quality: &Quality) -> usize {
        TILE_HEIGHT / quality.square * quality.square
    }

    /// No rows.
    pub(crate) const fn none() -> Self {
        Self {
            top: 0,
            width: 0,
            pixels: &mut [],
            counts: Counts::NONE,
            rough: &mut [],
        }
    }
}

/// Draws a band by an instruction set, a tile after the other; the observer hears of it.
pub(crate) fn render<O: Observer>(
    isa: Level,
    scene: &Prepared,
    quality: &Quality,
    observer: O,
    worker: &mut Worker,
    band: &mut Band<'_>,
) {
    worker.batch.begin(1);
    band.rough.fill([u64::MAX; _]);
    let height = band.height();
    let width = if quality.square == 1 {
        BATCH / TILE_HEIGHT
    } else {
        TILE_WIDTH / quality.square * quality.square
    };
    for left in (0..band.width).step_by(width) {
        let area = Area {
            left,
            top: band.top,
            right: band.width.min(left + width),
            bottom: band.top + height,
            picture: [band.width, scene.height],
            least: quality.least_square(),
        };
        let rect = scene.axes.rect(rectangle(
            area.left,
            area.top,
            area.right.next_multiple_of(quality.square),
            area.bottom.next_multiple_of(quality.square),
        ));
        let mut tile = Tile {
            isa,
            scene,
            quality,
            observer,
            seen: scene.visible_groups(rect),
            area,
            crowding: 0.0,
            rect,
            worker: &mut *worker,
            canvas: Canvas {
                pixels: &mut *band.pixels,
                width: band.width,
                height,
            },
        };
        if quality.square == 1 {
            tile.trace_pixels();
        } else {
            tile.draw();
            if let Some(rows) = tile.rough() {
                for (row, word) in band.rough.iter_mut().zip(rows) {
                    row[left / TILE_WIDTH] = word;
                }
            }
        }
    }
}

impl<O: Observer> Tile<'_, O> {
    /// Traces every pixel of a tile, which is no larger than a batch.
    fn trace_pixels(&mut self) {
        for y in self.area.top..self.area.bottom {
            for x in self.area.left..self.area.right {
                self.worker.batch.points.push(x, y);
            }
        }
        self.trace_batch();
        self.observer.stage(Stage::Results);
        for i in 0..self.worker.batch.points.len() {
            let (x, y) = self.worker.batch.points.position(i);
            let (sample, _) = self.worker.batch.results.sample(i);
            self.put(x, y - self.area.top, sample);
        }
        self.end_batch();
    }
}

const _: () = assert!(TILE_HEIGHT == Quality::MAX_SQUARE);
