use crate::bitmap::{Tile, sheet};
use crate::overlay::{draw_heat, draw_points, draw_squares, heat};
use crate::scenes::FrameArguments;
use crate::view_errors::{flip, mean};
use crate::{arguments, output};
use anyhow::{Result, ensure};
use clap::Args;
use eightfold_harness::Size;
use eightfold_harness::error::Difference;
use eightfold_harness::frame_trace::FrameTrace;
use eightfold_harness::threaded_renderer::ThreadedRenderer;
use eightfold_tracer::{Preset, Quality, presentation::Moment};
use eightfold_window::cpu;
use std::path::PathBuf;

/// Draws the points, squares, rays and errors of a frame on one sheet, or a close-up of the guard
#[derive(Args)]
pub struct Arguments {
    #[command(flatten)]
    frame: FrameArguments,
    #[arg(long, value_name = "NAME", default_value = "default", help = arguments::QUALITY)]
    quality: Preset,
    /// Draw the pixels around this one: without antialiasing, exhaustively, without the guard and
    /// with it
    #[arg(long, value_name = "X,Y", value_parser = pixel)]
    at: Option<[usize; 2]>,
    /// PNG file to write, or - for standard output
    #[arg(long, value_name = "FILE", default_value = "target/figures.png", value_parser = arguments::png_file)]
    out: PathBuf,
}

const COLUMNS: usize = 2;

/// The FLIP error shown in white, above the 99th percentile of `fastest`.
const FLIP_SHOWN: f32 = 0.25;

pub fn run(arguments: &Arguments) -> Result<()> {
    arguments.frame.scene.check(arguments.frame.time)?;
    output::check(&arguments.out)?;
    let FrameArguments { scene, time, size } = arguments.frame;
    let sheet = match arguments.at {
        Some(place) => {
            let mut renderer = ThreadedRenderer::new(arguments::processors());
            let (frame, quality) = (scene.without_overlay(time), arguments.quality.quality());
            close_up(&mut renderer, &frame, quality, size, place)
        }
        None => sheet(size, COLUMNS, &figures(arguments)),
    };
    output::write(&arguments.out, &sheet?)
}

fn pixel(argument: &str) -> Result<[usize; 2], String> {
    let numbers =
        argument.split_once(',').and_then(|(x, y)| Some([x.parse().ok()?, y.parse().ok()?]));
    numbers.ok_or_else(|| "must be two whole numbers with a comma, such as 80,60".into())
}

fn figures(arguments: &Arguments) -> Vec<Tile> {
    let FrameArguments { scene, time, size } = arguments.frame;
    let mut renderer = ThreadedRenderer::new(arguments::processors());
    let frame = scene.without_overlay(time);
    let mut draw = |quality: &Quality| renderer.trace(cpu::best().level, &frame, quality, size);
    let quality = arguments.quality.quality();
    let (exhaustive, all) = draw(&quality.reference());
    let (picture, trace) = draw(quality);
    let errors = flip(size.width, &exhaustive, &picture);
    let psnr = Difference::between(&exhaustive, &picture).psnr;

    let tile = |caption: String, mark: &dyn Fn(&mut [u32])| {
        let mut pixels = picture.clone();
        mark(&mut pixels);
        Tile { pixels, caption }
    };
    let area = size.area() as f64;
    let traced = trace.rays().filter(|&rays| rays > 0).count() as f64 / area;
    let rays = |trace: &FrameTrace| trace.rays().map(f64::from).sum::<f64>();
    let (share, per_pixel) = (1e2 * rays(&trace) / rays(&all), rays(&all) / area);
    let count = trace.squares().len();
    let max = all.rays().max().unwrap_or(1);
    let points = format!("Traced points, white\n{:.1} % of all pixels", 1e2 * traced);
    let frame = format!("{scene} at {time} s, {}\n{psnr:.1} dB to exhaustive", arguments.quality);
    let squares = format!("Squares: the smaller, the brighter\n{count} squares");
    let own = format!("Rays per point, white for {max}\n{share:.1} % of exhaustive");
    let every = format!("Exhaustive: rays, white for {max}\n{per_pixel:.1} per pixel");
    let error = format!("FLIP, white for {FLIP_SHOWN}\nmean {:.4}", mean(&errors));
    vec![
        tile(points, &|pixels| draw_points(&trace, pixels)),
        tile(frame, &|_| {}),
        tile(squares, &|pixels| draw_squares(&trace, pixels)),
        tile(own, &|pixels| draw_heat(&trace, pixels, max)),
        tile(every, &|pixels| draw_heat(&all, pixels, max)),
        tile(error, &|pixels| {
            for (pixel, error) in pixels.iter_mut().zip(&errors) {
                *pixel = heat(error / FLIP_SHOWN);
            }
        }),
    ]
}

/// Pixels of the picture.
const CROP: Size = Size { width: 32, height: 20 };
/// The side of an enlarged pixel.
const ZOOM: usize = 12;
/// The side of the mark of a traced point.
const MARK: usize = 4;
const POINT: u32 = 0x00ff_ffff;
const OUTLINE: u32 = 0x00ff_b000;

fn close_up(
    renderer: &mut ThreadedRenderer,
    scene: &Moment,
    quality: &Quality,
    size: Size,
    [x, y]: [usize; 2],
) -> Result<Vec<u8>> {
    let fits = size.width >= CROP.width && size.height >= CROP.height;
    ensure!(fits, "--at needs a --size of {}x{} or more", CROP.width, CROP.height);
    let left = x.saturating_sub(CROP.width / 2).min(size.width - CROP.width);
    let top = y.saturating_sub(CROP.height / 2).min(size.height - CROP.height);
    let [exhaustive, guarded] = [quality.reference(), *quality].map(Quality::jagged);
    let ways = [
        ("Every pixel traced", exhaustive),
        ("Without the guard", Quality { guarded: false, ..guarded }),
        ("With the guard", guarded),
    ];
    let tiles = ways.map(|(caption, quality)| {
        let (pixels, trace) = renderer.trace(cpu::best().level, scene, &quality, size);
        Tile { pixels: enlarged(&trace, &pixels, [left, top]), caption: caption.into() }
    });
    sheet(Size { width: ZOOM * CROP.width, height: ZOOM * CROP.height }, tiles.len(), &tiles)
}

/// Enlarges pixels, with the upper and left edges of squares, and marks at the traced points.
fn enlarged(trace: &FrameTrace, pixels: &[u32], [left, top]: [usize; 2]) -> Vec<u32> {
    let [width, height] = [CROP.width, CROP.height].map(|side| ZOOM * side);
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
