//! Measures how speed depends on the size of the picture and on the number of objects.

use crate::arguments::{NamedQuality, Size};
use crate::interrupt;
use crate::scenes::SceneName;
use crate::threaded_renderer::ThreadedRenderer;
use crate::timing::{percentile, thread_time};
use eightfold_tracer::scene::{MAX_SPHERES, Scene};
use eightfold_tracer::{MAX_HEIGHT, MAX_WIDTH};
use eightfold_window::cpu::Isa;
use serde::Serialize;

/// The number of frames measured for each point of a curve.
const ROUNDS: usize = 7;

/// A curve of a plot.
#[derive(Clone, Serialize)]
pub struct Curve {
    /// The quality's name.
    pub name: &'static str,
    /// The points, sorted by x.
    pub points: Vec<(f64, f64)>,
}

/// Measures the curves.
pub struct Curves<'a> {
    pub scene: SceneName,
    pub isa: Isa,
    pub size: Size,
    pub time: f32,
    /// The qualities with a curve, the exhaustive one first.
    pub qualities: Vec<NamedQuality>,
    /// A renderer with one thread.
    pub renderer: &'a mut ThreadedRenderer,
    /// Called after each point with the estimated microseconds that it took.
    pub progress: &'a dyn Fn(u64),
}

/// The sizes of a curve: those with a quarter, half, one and two times the sides, and the largest of the same aspect ratio.
pub fn sizes(size: Size, quick: bool) -> Vec<Size> {
    let Size { width, height } = size;
    let scaled = |by: f64| Size {
        width: ((width as f64 * by) as usize).max(1),
        height: ((height as f64 * by) as usize).max(1),
    };
    let most = (MAX_WIDTH as f64 / width as f64).min(MAX_HEIGHT as f64 / height as f64);
    let mut scales: Vec<f64> = [0.25, 0.5, 1.0, 2.0]
        .into_iter()
        .filter(|&by| by < most)
        .collect();
    if !quick || scales.is_empty() {
        scales.push(most);
    }
    scales.into_iter().map(scaled).collect()
}

/// The numbers of small spheres of a curve.
pub fn objects(quick: bool) -> &'static [usize] {
    if quick {
        &[1, 8, 64, MAX_SPHERES]
    } else {
        &[1, 2, 4, 8, 16, 32, 64, 128, 256, MAX_SPHERES]
    }
}

/// The qualities with a curve: the two that serve for comparison, and the ends and the middle of the ladder. All are antialiased,
/// or none is.
pub fn qualities(antialias: bool) -> Vec<NamedQuality> {
    let all: Vec<NamedQuality> = NamedQuality::all()
        .map(|quality| quality.antialiased(antialias))
        .collect();
    let (compared, ladder) = all.split_at(2);
    let default = ladder.iter().find(|rung| rung.name == "default");
    let ends = [ladder.first(), default, ladder.last()];
    compared
        .iter()
        .chain(ends.into_iter().flatten())
        .copied()
        .collect()
}

impl Curves<'_> {
    /// For each quality but the first, the speed-up relative to the first by the number of pixels.
    pub fn by_resolution(&mut self, sizes: &[Size]) -> Vec<Curve> {
        let scene = self.scene.at(self.time);
        let mut curves = empty(&self.qualities[1..]);
        for &size in sizes {
            let times = self.times(&[&scene], size);
            let Some((exhaustive, others)) = times.split_first() else {
                break;
            };
            for (curve, times) in curves.iter_mut().zip(others) {
                let speed = percentile(exhaustive, 25) / percentile(times, 25);
                curve.points.push((size.area() as f64, speed));
            }
        }
        curves
    }

    /// For each quality, the time of a frame by the number of spheres, as a multiple of that of an exhaustive frame with one
    /// sphere.
    pub fn by_objects(&mut self, counts: &[usize]) -> Vec<Curve> {
        let one = SceneName::Field(1).at(self.time);
        let mut curves = empty(&self.qualities);
        for &count in counts {
            let scene = SceneName::Field(count).at(self.time);
            let times = self.times(&[&one, &scene], self.size);
            let Some((unit, rest)) = times.split_first() else {
                break;
            };
            // The times of the other qualities for one sphere are skipped.
            let rest = &rest[curves.len() - 1..];
            for (curve, times) in curves.iter_mut().zip(rest) {
                let time = percentile(times, 25) / percentile(unit, 25);
                curve.points.push((count as f64, time));
            }
        }
        curves
    }

    /// The times, in seconds, of [`ROUNDS`] frames of each quality of each scene; nothing after Ctrl-C. Scenes and qualities take
    /// turns.
    fn times(&mut self, scenes: &[&Scene], size: Size) -> Vec<Vec<f64>> {
        let qualities = &self.qualities;
        let mut pixels = vec![0; size.area()];
        let mut times = vec![Vec::new(); scenes.len() * qualities.len()];
        for round in 0..=ROUNDS {
            if interrupt::is_stopped() {
                return Vec::new();
            }
            let pairs = scenes.iter().flat_map(|scene| {
                let qualities = qualities.iter();
                qualities.map(move |quality| (scene, &quality.quality))
            });
            for ((scene, quality), times) in pairs.zip(&mut times) {
                let level = self.isa.level;
                let draw = || {
                    self.renderer
                        .draw(level, scene, quality, size.width, &mut pixels)
                };
                let (_, time) = thread_time(draw);
                // The first round warms up memory and threads.
                if round > 0 {
                    times.push(time);
                }
            }
        }
        (self.progress)(cost(size, scenes.len()));
        times
    }
}

/// The estimated microseconds that a point of a curve takes; half of them are for exhaustive frames.
pub fn cost(size: Size, scenes: usize) -> u64 {
    (0.02 * (size.area() * scenes * (1 + ROUNDS)) as f64) as u64
}

/// A curve without points for each quality.
fn empty(qualities: &[NamedQuality]) -> Vec<Curve> {
    let curves = qualities.iter().map(|quality| Curve {
        name: quality.name,
        points: Vec::new(),
    });
    curves.collect()
}
