//! `cargo lab truth`: a path tracer.

mod light;
mod path;

use crate::arguments::{self, processors, within};
use crate::output;
use crate::progress::Progress;
use crate::scenes::FrameArguments;
use anyhow::Result;
use clap::Args;
use eightfold_harness::threaded_renderer::drawn;
use eightfold_harness::{Size, picture};
use eightfold_tracer::Quality;
use eightfold_tracer::glam::{DVec3, dvec2, dvec3};
use eightfold_tracer::scene::{Film, Scene};
use fastrand::Rng;
use path::PathTracer;
use rayon::prelude::*;
use std::path::PathBuf;

const MAX_SAMPLES: u32 = 1 << 20;

/// Path-traces a scene, with indirect light and caustics of area lights
///
/// Prints the RMS error and PSNR of quality `default`, and the path tracer's noise.
#[derive(Args)]
pub struct Arguments {
    #[command(flatten)]
    frame: FrameArguments,
    /// Paths per pixel; quadruple them to halve the noise
    #[arg(long, value_name = "N", default_value = "64", value_parser = within(2..=MAX_SAMPLES))]
    samples: u32,
    /// PNG file to write, or - for standard output
    #[arg(long, value_name = "FILE", value_parser = arguments::png_file)]
    out: PathBuf,
}

pub fn run(arguments: &Arguments) -> Result<()> {
    let FrameArguments { scene, time, size } = arguments.frame;
    let samples = arguments.samples;
    scene.check(time)?;
    let scene = transported(scene.at(time).scene);
    output::check(&arguments.out)?;
    let truth = draw(&scene, size, samples, 0);
    let pixels: Vec<u32> = truth.iter().map(Estimate::pixel).collect();
    output::write(&arguments.out, &picture::png(size.width, &pixels)?)?;
    let real_time = drawn(processors(), &scene, &Quality::DEFAULT, size);
    let Comparison { error, noise } = Comparison::new(&real_time, &truth);
    let psnr = 20.0 * (255.0 / error).log10();
    eprintln!(
        "`default` against {samples} paths a pixel: \
         RMS error {error:.2} of 255, PSNR {psnr:.1} dB, path tracer noise {noise:.2}"
    );
    Ok(())
}

/// Removes effects other than light transport.
fn transported(mut scene: Scene) -> Scene {
    scene.film = Film::PLAIN;
    for light in scene.lights.iter_mut() {
        light.glow = 0.0;
    }
    scene
}

#[derive(Clone, Copy, Debug)]
pub struct Estimate {
    pub mean: DVec3,
    /// The squared standard error of `mean`.
    pub variance: DVec3,
}

impl Estimate {
    /// Averages two or more independent paths (Welford, 1962).
    fn of(paths: impl Iterator<Item = DVec3>) -> Self {
        let (mut count, mut mean, mut squares) = (0.0, DVec3::ZERO, DVec3::ZERO);
        for radiance in paths {
            count += 1.0;
            let off = radiance - mean;
            mean += off / count;
            squares += off * (radiance - mean);
        }
        Self { mean, variance: squares / (count - 1.0) / count }
    }

    fn pixel(&self) -> u32 {
        let levels = self.mean.clamp(DVec3::ZERO, DVec3::ONE) * 255.0;
        let [r, g, b] = levels.to_array().map(|channel| channel.round() as u32);
        r << 16 | g << 8 | b
    }
}

/// The result is the same for any number of threads.
pub fn draw(scene: &Scene, size: Size, samples: u32, seed: u32) -> Vec<Estimate> {
    let tracer = PathTracer::new(scene, size);
    let bar = Progress::new(size.height);
    let pixel = |x: usize, y: usize| {
        let number = u64::from(seed) << 32 | (y * size.width + x) as u64;
        // Hashed, so that pixels' sequences start far apart.
        let mut random = Rng::with_seed(Rng::with_seed(number).u64(..));
        Estimate::of((0..samples).map(|_| {
            let u = dvec2(random.f64(), random.f64()) - 0.5;
            tracer.follow(x as f64 + u.x, y as f64 + u.y, &mut random)
        }))
    };
    let row = |y: usize| {
        let row: Vec<Estimate> = (0..size.width).map(|x| pixel(x, y)).collect();
        bar.inc(1);
        row
    };
    let rows: Vec<_> = (0..size.height).into_par_iter().map(row).collect();
    rows.concat()
}

/// Errors in units of 1/255.
#[derive(Clone, Copy, Debug)]
pub struct Comparison {
    /// The RMS difference, noise included.
    pub error: f64,
    pub noise: f64,
}

impl Comparison {
    pub fn new(pixels: &[u32], truth: &[Estimate]) -> Self {
        let (mut squares, mut variance) = (0.0, 0.0);
        for (pixel, estimate) in pixels.iter().zip(truth) {
            let [_, r, g, b] = pixel.to_be_bytes().map(f64::from);
            let off = dvec3(r, g, b) - 255.0 * estimate.mean.min(DVec3::ONE);
            squares += off.length_squared();
            // Cap the variance at 1. Clipping hides noise where the mean exceeds 1 by 5 standard
            // errors.
            let lower = estimate.mean - 5.0 * estimate.variance.map(f64::sqrt);
            let noise = estimate.variance.min(DVec3::ONE);
            variance += DVec3::select(lower.cmplt(DVec3::ONE), noise, DVec3::ZERO).element_sum();
        }
        let count = 3.0 * truth.len() as f64;
        Self { error: (squares / count).sqrt(), noise: 255.0 * (variance / count).sqrt() }
    }
}
