use crate::flip::{self, flip};
use crate::overlay::{draw_heat, draw_points, draw_squares, heat};
use crate::scenes::FrameArguments;
use crate::sheet::{Tile, sheet};
use crate::{arguments, close_up, output};
use anyhow::Result;
use clap::Args;
use eightfold_harness::error::Difference;
use eightfold_harness::frame_trace::FrameTrace;
use eightfold_harness::threaded_renderer::ThreadedRenderer;
use eightfold_tracer::{Preset, Quality};
use eightfold_window::cpu;
use std::path::PathBuf;

/// Draws the points, squares, rays and errors of a frame on one sheet, or a close-up of the guard
#[derive(Args)]
pub struct Arguments {
    #[command(flatten)]
    frame: FrameArguments,
    #[arg(long, value_name = "NAME", default_value = "default", help = arguments::QUALITY)]
    quality: Preset,
    /// Draw the pixels around this one: without antialiasing, exhaustively, without the guard and with it
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
            close_up::draw(&mut renderer, &frame, quality, size, place)
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
    let width = size.width;
    let mut renderer = ThreadedRenderer::new(arguments::processors());
    let frame = scene.without_overlay(time);
    let mut draw = |quality: &Quality| {
        let (level, mut pixels) = (cpu::best().level, vec![0; size.area()]);
        let trace = renderer.trace(level, &frame, quality, width, &mut pixels);
        (pixels, trace)
    };
    let quality = arguments.quality.quality();
    let (exhaustive, all) = draw(&quality.reference());
    let (picture, trace) = draw(quality);
    let errors = flip(width, &exhaustive, &picture);
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
    let most = all.rays().max().unwrap_or(1);
    let points = format!("Traced points, white\n{:.1} % of all pixels", 1e2 * traced);
    let frame = format!("{scene} at {time} s, {}\n{psnr:.1} dB to exhaustive", arguments.quality);
    let squares = format!("Squares: the smaller, the brighter\n{count} squares");
    let own = format!("Rays per point, white for {most}\n{share:.1} % of exhaustive");
    let every = format!("Exhaustive: rays, white for {most}\n{per_pixel:.1} per pixel");
    let error = format!("FLIP, white for {FLIP_SHOWN}\nmean {:.4}", flip::mean(&errors));
    vec![
        tile(points, &|pixels| draw_points(&trace, pixels)),
        tile(frame, &|_| {}),
        tile(squares, &|pixels| draw_squares(&trace, pixels)),
        tile(own, &|pixels| draw_heat(&trace, pixels, most)),
        tile(every, &|pixels| draw_heat(&all, pixels, most)),
        tile(error, &|pixels| {
            for (pixel, error) in pixels.iter_mut().zip(&errors) {
                *pixel = heat(error / FLIP_SHOWN);
            }
        }),
    ]
}
