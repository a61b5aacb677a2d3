//! How speed depends on the size of a picture and on the number of objects.

use super::row::quartile;
use crate::arguments::{NamedQuality, Size};
use crate::interrupt;
use crate::scenes::SceneName;
use crate::studio::Studio;
use cpu_time::ThreadTime;
use eightfold::scene::{MAX_SPHERES, Scene};
use eightfold::{MAX_HEIGHT, MAX_WIDTH};
use eightfold_window::cpu::Isa;
use serde::Serialize;

/// Frames of each point of a curve.
const ROUNDS: usize = 7;

/// A line of a plot.
#[derive(Clone, Serialize)]
pub struct Curve {
    /// The quality's name.
    pub name: &'static str,
    /// In the order of what they depend on.
    pub points: Vec<(f64, f64)>,
}

/// Draws the curves' frames.
pub struct Curves<'a> {
    pub scene: SceneName,
    pub isa: Isa,
    pub size: Size,
    pub time: f32,
    /// Of one thread.
    pub studio: &'a mut Studio,
    /// Called after each point.
    pub progress: &'a dyn Fn(u64),
}

/// The sizes of a curve: quarter, half, same and double sides, and the largest of this shape.
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

/// Numbers of small spheres.
pub fn objects(quick: bool) -> &'static [usize] {
    if quick {
        &[1, 8, 64, MAX_SPHERES]
    } else {
        &[1, 2, 4, 8, 16, 32, 64, 128, 256, MAX_SPHERES]
    }
}

/// Those whose lines are worth drawing: the two to compare with, and the ladder's ends and middle.
pub fn qualities() -> Vec<NamedQuality> {
    let all: Vec<NamedQuality> = NamedQuality::all().collect();
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
    /// For each quality but the first the speed-up against it, by the number of pixels.
    pub fn by_resolution(&mut self, sizes: &[Size]) -> Vec<Curve> {
        let scene = self.scene.at(self.time);
        let mut curves = empty(&qualities()[1..]);
        for &size in sizes {
            let times = self.times(&[&scene], size);
            let Some((exhaustive, others)) = times.split_first() else {
                break;
            };
            for (curve, times) in curves.iter_mut().zip(others) {
                let speed = quartile(exhaustive) / quartile(times);
                curve.points.push((size.area() as f64, speed));
            }
        }
        curves
    }

    /// For each quality the time of a frame by the number of spheres, as a multiple of the exhaustive frame's with one.
    pub fn by_objects(&mut self, counts: &[usize]) -> Vec<Curve> {
        let one = SceneName::Field(1).at(self.time);
        let mut curves = empty(&qualities());
        for &count in counts {
            let scene = SceneName::Field(count).at(self.time);
            let times = self.times(&[&one, &scene], self.size);
            let Some((unit, rest)) = times.split_first() else {
                break;
            };
            // The other qualities of one sphere come first.
            let rest = &rest[curves.len() - 1..];
            for (curve, times) in curves.iter_mut().zip(rest) {
                let time = quartile(times) / quartile(unit);
                curve.points.push((count as f64, time));
            }
        }
        curves
    }

    /// The seconds of frames of each quality of each scene in turn, [`ROUNDS`] of each; none once it is time to end.
    fn times(&mut self, scenes: &[&Scene], size: Size) -> Vec<Vec<f64>> {
        let qualities = qualities();
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
                let start = ThreadTime::now();
                let level = self.isa.level;
                self.studio
                    .draw(level, scene, quality, size.width, &mut pixels);
                // The first round brings memory and threads to life.
                if round > 0 {
                    times.push(start.elapsed().as_secs_f64());
                }
            }
        }
        (self.progress)(cost(size, scenes.len()));
        times
    }
}

/// The progress that a point of a curve makes, in microseconds, about: half of it is the exhaustive frames'.
pub fn cost(size: Size, scenes: usize) -> u64 {
    (0.02 * (size.area() * scenes * (1 + ROUNDS)) as f64) as u64
}

fn empty(qualities: &[NamedQuality]) -> Vec<Curve> {
    let curves = qualities.iter().map(|quality| Curve {
        name: quality.name,
        points: Vec::new(),
    });
    curves.collect()
}
