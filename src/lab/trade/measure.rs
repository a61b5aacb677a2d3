//! Draws the frames of every point: to measure time and error, and what a viewer sees of it.

use super::sweep::Point;
use crate::arguments::Size;
use crate::error::Difference;
use crate::interrupt;
use crate::missed::Visible;
use crate::scenes::SceneName;
use crate::threaded_renderer::ThreadedRenderer;
use crate::timing::{evenly_spaced, thread_time};
use crate::views::{Seen, Subject, Viewer};
use eightfold_tracer::scene::Scene;
use eightfold_tracer::{Counts, Quality};
use eightfold_window::cpu::Isa;

/// The number of points drawn between two exhaustive frames: few enough that the machine's speed hardly drifts in between.
const GROUP: usize = 4;

/// The plan of the measurements for each point.
pub struct Plan {
    pub scene: SceneName,
    pub isa: Isa,
    /// The quality of the reference frames, against which errors are measured: exhaustive, perhaps antialiased.
    pub reference: Quality,
    pub size: Size,
    /// The number of timed frames, at even intervals.
    pub frames: usize,
    /// The time of the first frame, in seconds.
    pub time_from: f32,
    /// The time of the last timed frame, in seconds.
    pub time_to: f32,
    /// The times of the frames of each view at which FLIP and pops are measured, see [`crate::views`].
    pub views: Vec<Vec<f32>>,
    /// Whether views are compared with 64 samples a pixel.
    pub has_samples: bool,
}

/// Draws and compares frames.
pub struct Measurement<'a> {
    pub plan: &'a Plan,
    /// Draws timed frames on one thread. What is measured is the thread's time on a processor, which does not include the time
    /// that other programs take.
    pub timed: ThreadedRenderer,
    /// Draws all other frames, on all threads.
    renderer: ThreadedRenderer,
    threads: usize,
    /// The reference frame.
    exhaustive: Vec<u32>,
    /// The frames of a group of points.
    frames: Vec<Vec<u32>>,
    /// Called with the estimated microseconds of each piece of work.
    progress: &'a dyn Fn(u64),
}

/// Estimated nanoseconds per pixel to draw a frame, for the progress.
const DRAWING: f64 = 3.0;
/// Estimated nanoseconds per pixel to compare two frames.
const COMPARING: f64 = 1.0;
/// Estimated nanoseconds per pixel of a view, most of them to compute FLIP.
const FLIPPING: f64 = 700.0;

impl Plan {
    /// The estimated microseconds to measure a number of points.
    pub fn steps(&self, points: usize) -> u64 {
        self.cost(DRAWING + COMPARING, self.frames * points)
            + self.cost(FLIPPING, self.views.len() * points)
    }

    fn cost(&self, per_pixel: f64, frames: usize) -> u64 {
        (per_pixel * 1e-3 * (self.size.area() * frames) as f64) as u64
    }

    /// The time of frame `i` of `count`, in seconds.
    pub fn time(&self, i: usize, count: usize) -> f32 {
        evenly_spaced(self.time_from, self.time_to, i, count)
    }
}

impl<'a> Measurement<'a> {
    /// Allocates memory and starts threads.
    pub fn new(plan: &'a Plan, threads: usize, progress: &'a dyn Fn(u64)) -> Self {
        Self {
            plan,
            timed: ThreadedRenderer::new(1),
            renderer: ThreadedRenderer::new(threads),
            threads,
            exhaustive: vec![0; plan.size.area()],
            frames: vec![vec![0; plan.size.area()]; GROUP],
            progress,
        }
    }

    /// Measures all points; after Ctrl-C, the rest of the frames is left out.
    pub fn measure(&mut self, points: Vec<Point>) -> Vec<Tally> {
        let mut tallies: Vec<Tally> = points.into_iter().map(Tally::new).collect();
        let plan = self.plan;
        // The first frame warms up threads and memory.
        self.time_exhaustive(&plan.scene.without_overlay(plan.time_from));
        // The first frame is always drawn, so that there is a result for each point.
        for frame in 0..plan.frames {
            if frame > 0 && interrupt::is_stopped() {
                break;
            }
            // Points change places in the groups, so that no point always benefits from its place.
            tallies.rotate_left(1);
            self.measure_time(&mut tallies, plan.time(frame, plan.frames));
        }
        let rotated = plan.frames.min(tallies[0].times.len()) % tallies.len();
        tallies.rotate_right(rotated);
        self.look(&mut tallies);
        tallies
    }

    /// Draws a timed frame of each point, in groups between exhaustive frames, and measures its error.
    fn measure_time(&mut self, tallies: &mut [Tally], time: f32) {
        let Size { width, height } = self.plan.size;
        let scene = self.plan.scene.without_overlay(time);
        let visible = Visible::new(&scene, width, height);
        let mut before = self.time_exhaustive(&scene);
        for group in tallies.chunks_mut(GROUP) {
            let drawn = self.time_group(&scene, group);
            let after = self.time_exhaustive(&scene);
            for (tally, (counts, time)) in group.iter_mut().zip(drawn) {
                tally.counts += counts;
                tally.times.push(time);
                tally.exhaustive_times.push(before.min(after));
            }
            before = after;
            self.compare(group, |tally, exhaustive, pixels| {
                let difference = Difference::between(exhaustive, pixels);
                tally.differences.push(difference);
                tally.missed += visible.missed(exhaustive, pixels);
            });
            (self.progress)(self.plan.cost(DRAWING + COMPARING, group.len()));
        }
    }

    /// Has all views of all points looked at.
    fn look(&mut self, tallies: &mut [Tally]) {
        let plan = self.plan;
        let scene = |time| plan.scene.without_overlay(time);
        let mut subjects: Vec<Subject<'_>> = tallies
            .iter_mut()
            .map(|tally| Subject {
                quality: &tally.point.quality,
                scene: &scene,
                seen: &mut tally.seen,
            })
            .collect();
        let mut viewer = Viewer::new(&mut self.renderer, plan.isa, plan.size, plan.has_samples);
        for view in &plan.views {
            viewer.look(view, &mut subjects, |points| {
                (self.progress)(plan.cost(FLIPPING, points));
            });
        }
    }

    /// Draws the reference frame. Returns the seconds that an exhaustive frame without antialiasing takes one thread.
    fn time_exhaustive(&mut self, scene: &Scene) -> f64 {
        let (level, width) = (self.plan.isa.level, self.plan.size.width);
        let pixels = &mut self.exhaustive;
        let draw = || {
            self.timed
                .draw(level, scene, &Quality::EXHAUSTIVE, width, pixels)
        };
        let (_, time) = thread_time(draw);
        if self.plan.reference != Quality::EXHAUSTIVE {
            self.draw_exhaustive(scene);
        }
        time
    }

    /// Draws a frame of each point of a group. Returns the work and the seconds that each took one thread.
    fn time_group(&mut self, scene: &Scene, group: &[Tally]) -> Vec<(Counts, f64)> {
        let (level, width) = (self.plan.isa.level, self.plan.size.width);
        let each = group.iter().zip(&mut self.frames);
        each.map(|(tally, pixels)| {
            let quality = &tally.point.quality;
            thread_time(|| self.timed.draw(level, scene, quality, width, pixels))
        })
        .collect()
    }

    /// Draws the reference frame.
    fn draw_exhaustive(&mut self, scene: &Scene) {
        let (level, width) = (self.plan.isa.level, self.plan.size.width);
        let pixels = &mut self.exhaustive;
        self.renderer
            .draw(level, scene, &self.plan.reference, width, pixels);
    }

    /// Calls a function for each point of a group, with the reference frame and the point's own, on all threads.
    fn compare(&mut self, group: &mut [Tally], job: impl Fn(&mut Tally, &[u32], &[u32]) + Sync) {
        let mut workers = vec![(); self.threads];
        let mut each: Vec<_> = group.iter_mut().zip(&self.frames).collect();
        self.renderer
            .threads
            .pool
            .run(&mut workers, &mut each, &|_, (tally, pixels)| {
                job(tally, &self.exhaustive, pixels);
            });
    }
}

/// What is recorded of a point while it is measured.
pub struct Tally {
    pub point: Point,
    /// The seconds that each frame took.
    pub times: Vec<f64>,
    /// The seconds of the faster one of the exhaustive frames before and after each frame.
    pub exhaustive_times: Vec<f64>,
    /// The work for all frames together.
    pub counts: Counts,
    /// The error of each frame.
    pub differences: Vec<Difference>,
    /// The number of missed objects in all frames together.
    pub missed: usize,
    /// Of the views.
    pub seen: Seen,
}

impl Tally {
    /// Empty records.
    pub fn new(point: Point) -> Self {
        Self {
            point,
            times: Vec::new(),
            exhaustive_times: Vec::new(),
            counts: Counts::NONE,
            differences: Vec::new(),
            missed: 0,
            seen: Seen::default(),
        }
    }
}
