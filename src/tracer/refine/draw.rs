//! The first phase of a frame: a band's points are traced, and its squares filled.

use super::Worker;
use super::tile::Tile;
use crate::coverage::rectangle;
use crate::grid::Area;
use crate::observe::Observer;
use crate::picture::{Band, TILE_HEIGHT, TILE_WIDTH};
use crate::plan::Context;
use crate::trace::BATCH;

/// Draws a band, a tile after the other.
pub(crate) fn draw<O: Observer>(
    context: &Context<'_, O>,
    worker: &mut Worker,
    band: &mut Band<'_>,
) {
    let Context { plan, coverage, .. } = context;
    worker.batch.begin();
    band.rough.fill([u64::MAX; _]);
    let bottom = band.top + band.height();
    let square = plan.quality.square;
    let width = if square == 1 {
        BATCH / TILE_HEIGHT
    } else {
        TILE_WIDTH
    };
    for left in (0..band.width).step_by(width) {
        // Place the next tile.
        let area = Area {
            left,
            top: band.top,
            right: band.width.min(left + width),
            bottom,
            picture: plan.size,
        };
        let rect = coverage.axes.rect(rectangle(
            area.left,
            area.top,
            area.right.next_multiple_of(square),
            area.bottom.next_multiple_of(square),
        ));
        let mut tile = Tile {
            context,
            seen: coverage.visible_groups(rect),
            area,
            crowding: 0.0,
            rect,
            worker: &mut *worker,
            band: &mut *band,
        };
        tile.draw();
        // Note where edges may be.
        if let Some(rows) = tile.rough() {
            for (row, word) in band.rough.iter_mut().zip(rows) {
                row[left / TILE_WIDTH] = word;
            }
        }
    }
}
