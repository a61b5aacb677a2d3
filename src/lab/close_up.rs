use crate::sheet::{Tile, sheet};
use anyhow::{Result, ensure};
use eightfold_harness::Size;
use eightfold_harness::frame_trace::FrameTrace;
use eightfold_harness::threaded_renderer::ThreadedRenderer;
use eightfold_tracer::Quality;
use eightfold_tracer::scene::Moment;
use eightfold_window::cpu;

/// Pixels of the picture.
const SHOWN: Size = Size { width: 32, height: 20 };
/// The side of an enlarged pixel.
const ZOOM: usize = 12;
/// The side of the mark of a traced point.
const MARK: usize = 4;
const POINT: u32 = 0x00ff_ffff;
const OUTLINE: u32 = 0x00ff_b000;

/// Draws the pixels around one exhaustively, without the guard and with it, on a sheet.
pub fn draw(
    renderer: &mut ThreadedRenderer,
    scene: &Moment,
    quality: &Quality,
    size: Size,
    [x, y]: [usize; 2],
) -> Result<Vec<u8>> {
    let fits = size.width >= SHOWN.width && size.height >= SHOWN.height;
    ensure!(fits, "--at needs a --size of {}x{} or more", SHOWN.width, SHOWN.height);
    let left = x.saturating_sub(SHOWN.width / 2).min(size.width - SHOWN.width);
    let top = y.saturating_sub(SHOWN.height / 2).min(size.height - SHOWN.height);
    let exhaustive = Quality { antialias: false, ..quality.reference() };
    let guarded = Quality { antialias: false, ..*quality };
    let ways = [
        ("Every pixel traced", exhaustive),
        ("Without the guard", Quality { guarded: false, ..guarded }),
        ("With the guard", guarded),
    ];
    let tiles = ways.map(|(caption, quality)| {
        let mut pixels = vec![0; size.area()];
        let trace = renderer.trace(cpu::best().level, scene, &quality, size.width, &mut pixels);
        Tile { pixels: enlarged(&trace, &pixels, [left, top]), caption: caption.into() }
    });
    sheet(Size { width: ZOOM * SHOWN.width, height: ZOOM * SHOWN.height }, tiles.len(), &tiles)
}

/// Enlarges pixels, with outlines of the squares and marks at the traced points.
fn enlarged(trace: &FrameTrace, pixels: &[u32], [left, top]: [usize; 2]) -> Vec<u32> {
    let width = ZOOM * SHOWN.width;
    let all = (0..ZOOM * SHOWN.height).flat_map(|y| (0..width).map(move |x| [x, y]));
    let at = |[x, y]: [usize; 2]| (top + y / ZOOM) * trace.width + left + x / ZOOM;
    let mut large: Vec<u32> = all.clone().map(|place| pixels[at(place)]).collect();
    for square in trace.squares().filter(|square| square.side > 1) {
        let columns = ZOOM * square.x..ZOOM * (square.x + square.w);
        let rows = ZOOM * square.y..ZOOM * (square.y + square.h);
        for (pixel, [x, y]) in large.iter_mut().zip(all.clone()) {
            let [x, y] = [x + ZOOM * left, y + ZOOM * top];
            let is_inside = columns.contains(&x) && rows.contains(&y);
            if is_inside && (x == columns.start || y == rows.start) {
                *pixel = OUTLINE;
            }
        }
    }
    let rays: Vec<u32> = trace.rays().collect();
    let is_marked = |i: usize| (i % ZOOM).abs_diff(ZOOM / 2) < MARK / 2;
    for (pixel, [x, y]) in large.iter_mut().zip(all) {
        if rays[at([x, y])] > 0 && is_marked(x) && is_marked(y) {
            *pixel = POINT;
        }
    }
    large
}
