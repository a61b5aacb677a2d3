//! Draws frames against the clock.

use super::row::Row;
use crate::arguments::{NamedQuality, SceneName, Size};
use crate::error::Difference;
use crate::flicker::Flicker;
use crate::isa::Isa;
use crate::studio::Studio;
use eightfold::Counts;
use eightfold_window::pool::Pool;
use std::time::Instant;

/// What to measure.
pub struct Plan {
    pub scene: SceneName,
    pub isa: Isa,
    pub sizes: Vec<Size>,
    /// Numbers of threads.
    pub threads: Vec<usize>,
    /// The first is what the others are held to.
    pub qualities: Vec<NamedQuality>,
    pub frames: usize,
    /// Times of the first and of the last frame in seconds.
    pub time_from: f32,
    pub time_to: f32,
    /// Frames in a row, 60 a second, that flicker is looked for in, from the first time on.
    pub flicker_frames: usize,
}

/// A size on a number of threads: what is drawn one right after the other.
pub struct Setting {
    pub size: Size,
    pub threads: usize,
    /// One for each quality.
    pub runs: Vec<Run>,
    /// Milliseconds to fill each frame with one colour.
    pub floor: Vec<f64>,
    /// The picture that is filled.
    filled: Vec<u32>,
}

/// A quality in a setting.
pub struct Run {
    pub quality: NamedQuality,
    /// Milliseconds of each frame.
    pub times: Vec<f64>,
    /// Of all frames together.
    pub counts: Counts,
    /// Of each frame to what it is held to.
    pub differences: Vec<Difference>,
    /// Of the frames that flicker is looked for in.
    pub flicker: Flicker,
    /// The last frame.
    pixels: Vec<u32>,
}

/// Frames a second of those that flicker is looked for in: what a screen shows.
const FLICKER_FPS: f64 = 60.0;
/// What frames are filled with to see how fast that is.
const COLOUR: u32 = 0x0012_3456;
/// Rows that a thread fills in one go, as many as the intro's bands have.
const STRIP: usize = 16;

impl Plan {
    /// How often [`Plan::measure`] calls back.
    pub fn steps(&self) -> usize {
        let settings = (1 + self.frames) * self.sizes.len() * self.threads.len();
        settings + self.flicker_frames * self.sizes.len()
    }

    /// Draws all frames of all qualities in all settings. Calls `step` now and then, while no time is taken.
    ///
    /// All settings take turns frame by frame, and the qualities of a setting, so that a machine whose speed drifts
    /// hits them alike.
    pub fn measure(&self, mut step: impl FnMut()) -> Vec<Row> {
        let threads = self.threads.iter();
        let mut benches: Vec<(Studio, Vec<Setting>)> = threads
            .map(|&threads| {
                let settings = self.sizes.iter();
                let settings = settings.map(|&size| Setting::new(self, size, threads));
                (Studio::new(threads), settings.collect())
            })
            .collect();
        for (studio, settings) in &mut benches {
            for setting in settings {
                setting.warm_up(self, studio);
                step();
            }
        }
        for frame in 0..self.frames {
            for (studio, settings) in &mut benches {
                for setting in settings {
                    setting.draw(self, studio, self.time(frame));
                    step();
                }
            }
        }
        // The frames are the same on any number of threads.
        let (studio, last) = benches.last_mut().expect("there is a number of threads");
        for setting in last.iter_mut() {
            for frame in 0..self.flicker_frames {
                let time = f64::from(self.time_from) + frame as f64 / FLICKER_FPS;
                setting.look_for_flicker(self, studio, time as f32);
                step();
            }
        }
        let flickers = || benches.last().into_iter().flat_map(|(_, last)| last);
        let settings = benches
            .iter()
            .flat_map(|(_, settings)| settings.iter().zip(flickers()));
        settings
            .flat_map(|(setting, flicker)| Row::of(self, setting, flicker))
            .collect()
    }

    /// When a frame is, in seconds.
    fn time(&self, frame: usize) -> f32 {
        let last = (self.frames - 1).max(1);
        let share = frame as f64 / last as f64;
        (f64::from(self.time_from) * (1.0 - share) + f64::from(self.time_to) * share) as f32
    }
}

impl Setting {
    fn new(plan: &Plan, size: Size, threads: usize) -> Self {
        let runs = plan.qualities.iter().map(|&quality| Run {
            quality,
            times: Vec::new(),
            counts: Counts::NONE,
            differences: Vec::new(),
            flicker: Flicker::default(),
            pixels: vec![0; size.area()],
        });
        Self {
            size,
            threads,
            runs: runs.collect(),
            floor: Vec::new(),
            filled: vec![0; size.area()],
        }
    }

    /// Draws a frame of each quality that does not count.
    fn warm_up(&mut self, plan: &Plan, studio: &mut Studio) {
        self.draw(plan, studio, plan.time(0));
        self.floor.clear();
        for run in &mut self.runs {
            run.times.clear();
            run.counts = Counts::NONE;
            run.differences.clear();
        }
    }

    /// Draws a frame of each quality and fills one, then compares.
    fn draw(&mut self, plan: &Plan, studio: &mut Studio, time: f32) {
        for run in &mut self.runs {
            let start = Instant::now();
            let counts = studio.draw(
                plan.isa.level,
                &plan.scene.at(time),
                &run.quality.quality,
                self.size.width,
                &mut run.pixels,
            );
            run.times.push(milliseconds(start));
            run.counts += counts;
        }
        let start = Instant::now();
        fill(&mut studio.pool, self.size.width, &mut self.filled);
        self.floor.push(milliseconds(start));

        // Not before all are drawn, so that threads and caches stay with what is timed.
        let (reference, others) = self.runs.split_first_mut().expect("there is a reference");
        reference.differences.push(Difference {
            psnr: f64::INFINITY,
            ..Difference::default()
        });
        for run in others {
            let difference = Difference::between(&reference.pixels, &run.pixels);
            run.differences.push(difference);
        }
    }

    /// Draws a frame of each quality and compares it to the one before.
    fn look_for_flicker(&mut self, plan: &Plan, studio: &mut Studio, time: f32) {
        let scene = plan.scene.at(time);
        for run in &mut self.runs {
            let (level, width) = (plan.isa.level, self.size.width);
            studio.draw(level, &scene, &run.quality.quality, width, &mut run.pixels);
        }
        let (reference, others) = self.runs.split_first_mut().expect("there is a reference");
        for run in others {
            run.flicker
                .next(self.size.width, &reference.pixels, &run.pixels);
        }
    }
}

/// Fills a frame with one colour: no way to draw it on these threads is faster.
fn fill(pool: &mut Pool, width: usize, pixels: &mut [u32]) {
    let mut strips: Vec<&mut [u32]> = pixels.chunks_mut(STRIP * width).collect();
    let mut threads = vec![(); pool.threads()];
    pool.run(&mut threads, &mut strips, &|_, strip| strip.fill(COLOUR));
}

fn milliseconds(start: Instant) -> f64 {
    start.elapsed().as_secs_f64() * 1e3
}
