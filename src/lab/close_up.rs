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

/// Enlarges pixels, with the upper and left edges of squares, and marks at the traced points.
fn enlarged(trace: &FrameTrace, pixels: &[u32], [left, top]: [usize; 2]) -> Vec<u32> {
    let [width, height] = [SHOWN.width, SHOWN.height].map(|side| ZOOM * side);
    let mut large = vec![0; width * height];
    let mut fill = |[x, y]: [usize; 2], [w, h]: [usize; 2], colour: u32| {
        let clipped = |from: usize, length: usize, start: usize, end: usize| {
            let at = |place: usize| place.saturating_sub(ZOOM * start).min(end);
            at(from)..at(from + length)
        };
        for y in clipped(y, h, top, height) {
            large[y * width..][clipped(x, w, left, width)].fill(colour);
        }
    };
    let place = |i: usize| [ZOOM * (i % trace.width), ZOOM * (i / trace.width)];
    for (i, &pixel) in pixels.iter().enumerate() {
        fill(place(i), [ZOOM; 2], pixel);
    }
    for square in trace.squares().into_iter().filter(|square| square.side > 1) {
        let corner = [ZOOM * square.x, ZOOM * square.y];
        fill(corner, [ZOOM * square.w, 1], OUTLINE);
        fill(corner, [1, ZOOM * square.h], OUTLINE);
    }
    for (i, _) in trace.rays().enumerate().filter(|&(_, rays)| rays > 0) {
        fill(place(i).map(|corner| corner + (ZOOM - MARK) / 2), [MARK; 2], POINT);
    }
    large
}
