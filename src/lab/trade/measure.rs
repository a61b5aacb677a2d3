//! Draws every point's frames: against the clock, for flicker, and for FLIP.

use super::sweep::Point;
use super::tally::Tally;
use crate::arguments::Size;
use crate::error::Difference;
use crate::flip::Flip;
use crate::interrupt;
use crate::missed::Visible;
use crate::scenes::SceneName;
use crate::studio::Studio;
use cpu_time::ThreadTime;
use eightfold::scene::Scene;
use eightfold::{Counts, Quality};
use eightfold_window::cpu::Isa;

/// Points drawn one right after the other between two exhaustive frames: the machine's speed drifts little meanwhile.
const GROUP: usize = 4;

/// Frames a second of those that flicker is looked for in.
const FLICKER_FPS: f64 = 60.0;

/// What is measured of each point.
pub struct Plan {
    pub scene: SceneName,
    pub isa: Isa,
    /// The exhaustive quality, as its frames are those that errors are held to.
    pub reference: Quality,
    pub size: Size,
    /// Frames against the clock, at times spread evenly.
    pub frames: usize,
    pub time_from: f32,
    pub time_to: f32,
    /// Frames in a row that flicker is looked for in, from the first time on.
    pub flicker_frames: usize,
    /// Frames that FLIP looks at, at times spread evenly.
    pub flip_frames: usize,
}

/// Where frames are drawn and compared, and the exhaustive frame that the others are held to.
pub struct Bench<'a> {
    pub plan: &'a Plan,
    /// Of one thread, whose time on a processor is what is measured: unlike the clock's it does not hold what others at
    /// work on the machine take.
    pub timed: Studio,
    /// Of all threads, for frames that no time is taken of.
    studio: Studio,
    threads: usize,
    exhaustive: Vec<u32>,
    /// The frames of a group.
    frames: Vec<Vec<u32>>,
    /// Called with the microseconds that something took on this machine, about.
    progress: &'a dyn Fn(u64),
}

/// What work takes about, in nanoseconds a pixel: the progress is counted in it.
const DRAWING: f64 = 3.0;
const COMPARING: f64 = 1.0;
const FLIPPING: f64 = 700.0;

impl Plan {
    /// The progress that measuring so many points makes.
    pub fn steps(&self, points: usize) -> u64 {
        let frames = self.frames * points;
        let flicker = self.flicker_frames * points;
        let flips = self.flip_frames * points;
        self.cost(DRAWING + COMPARING, frames + flicker) + self.cost(FLIPPING, flips)
    }

    fn cost(&self, per_pixel: f64, frames: usize) -> u64 {
        (per_pixel * 1e-3 * (self.size.area() * frames) as f64) as u64
    }

    /// When frame `i` of `count` is, in seconds.
    pub fn time(&self, i: usize, count: usize) -> f32 {
        let share = i as f64 / (count - 1).max(1) as f64;
        (f64::from(self.time_from) * (1.0 - share) + f64::from(self.time_to) * share) as f32
    }
}

impl<'a> Bench<'a> {
    pub fn new(plan: &'a Plan, threads: usize, progress: &'a dyn Fn(u64)) -> Self {
        Self {
            plan,
            timed: Studio::new(1),
            studio: Studio::new(threads),
            threads,
            exhaustive: vec![0; plan.size.area()],
            frames: vec![vec![0; plan.size.area()]; GROUP],
            progress,
        }
    }

    /// Measures all points, or as much of each as there was time for.
    pub fn measure(&mut self, points: Vec<Point>) -> Vec<Tally> {
        let mut tallies: Vec<Tally> = points.into_iter().map(Tally::new).collect();
        let plan = self.plan;
        // One frame that does not count: threads and memory come to life.
        self.time_exhaustive(&plan.scene.without_overlay(plan.time_from));
        // The first frame is drawn in any case, so that there is something to tell of each point.
        for frame in 0..plan.frames {
            if frame > 0 && interrupt::is_stopped() {
                break;
            }
            // Each time another one comes first, so that none has its place in a group to thank.
            tallies.rotate_left(1);
            self.against_the_clock(&mut tallies, plan.time(frame, plan.frames));
        }
        let turned = plan.frames.min(tallies[0].times.len()) % tallies.len();
        tallies.rotate_right(turned);
        for frame in 0..plan.flicker_frames {
            let time = f64::from(plan.time_from) + frame as f64 / FLICKER_FPS;
            self.for_flicker(&mut tallies, time as f32);
        }
        for frame in 0..plan.flip_frames {
            self.for_flip(&mut tallies, plan.time(frame, plan.flip_frames));
        }
        tallies
    }

    /// Draws a frame of each point, in groups between exhaustive frames, and compares.
    fn against_the_clock(&mut self, tallies: &mut [Tally], time: f32) {
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

    fn for_flicker(&mut self, tallies: &mut [Tally], time: f32) {
        if interrupt::is_stopped() {
            return;
        }
        let scene = self.plan.scene.without_overlay(time);
        self.draw_exhaustive(&scene);
        let width = self.plan.size.width;
        for group in tallies.chunks_mut(GROUP) {
            self.draw_group(&scene, group);
            self.compare(group, |tally, exhaustive, pixels| {
                tally.flicker.next(width, exhaustive, pixels);
            });
            (self.progress)(self.plan.cost(DRAWING + COMPARING, group.len()));
        }
    }

    fn for_flip(&mut self, tallies: &mut [Tally], time: f32) {
        let scene = self.plan.scene.without_overlay(time);
        self.draw_exhaustive(&scene);
        let width = self.plan.size.width;
        for group in tallies.chunks_mut(GROUP) {
            if interrupt::is_stopped() {
                return;
            }
            self.draw_group(&scene, group);
            self.compare(group, |tally, exhaustive, pixels| {
                let flip = Flip::between(width, exhaustive, pixels);
                tally.flips.push((flip.mean(), flip.p99()));
            });
            (self.progress)(self.plan.cost(FLIPPING, group.len()));
        }
    }

    /// Draws the exhaustive frame, and says how many seconds it takes one thread without more samples at edges.
    fn time_exhaustive(&mut self, scene: &Scene) -> f64 {
        let (level, width) = (self.plan.isa.level, self.plan.size.width);
        let pixels = &mut self.exhaustive;
        let start = ThreadTime::now();
        self.timed
            .draw(level, scene, &Quality::EXHAUSTIVE, width, pixels);
        let time = start.elapsed().as_secs_f64();
        if self.plan.reference != Quality::EXHAUSTIVE {
            self.draw_exhaustive(scene);
        }
        time
    }

    /// Draws a frame of each point of a group, and says how much work each was and how many seconds it took one thread.
    fn time_group(&mut self, scene: &Scene, group: &[Tally]) -> Vec<(Counts, f64)> {
        let (level, width) = (self.plan.isa.level, self.plan.size.width);
        let each = group.iter().zip(&mut self.frames);
        each.map(|(tally, pixels)| {
            let start = ThreadTime::now();
            let quality = &tally.point.quality;
            let counts = self.timed.draw(level, scene, quality, width, pixels);
            (counts, start.elapsed().as_secs_f64())
        })
        .collect()
    }

    /// Draws the exhaustive frame.
    fn draw_exhaustive(&mut self, scene: &Scene) {
        let (level, width) = (self.plan.isa.level, self.plan.size.width);
        let pixels = &mut self.exhaustive;
        self.studio
            .draw(level, scene, &self.plan.reference, width, pixels);
    }

    /// Draws a frame of each point of a group.
    fn draw_group(&mut self, scene: &Scene, group: &[Tally]) {
        let (level, width) = (self.plan.isa.level, self.plan.size.width);
        for (tally, pixels) in group.iter().zip(&mut self.frames) {
            let quality = &tally.point.quality;
            self.studio.draw(level, scene, quality, width, pixels);
        }
    }

    /// Does something with each point of a group, the exhaustive frame and its own, on as many threads as draw.
    fn compare(&mut self, group: &mut [Tally], job: impl Fn(&mut Tally, &[u32], &[u32]) + Sync) {
        let mut workers = vec![(); self.threads];
        let mut each: Vec<_> = group.iter_mut().zip(&self.frames).collect();
        self.studio
            .pool
            .run(&mut workers, &mut each, &|_, (tally, pixels)| {
                job(tally, &self.exhaustive, pixels);
            });
    }
}
