//! Where a frame's time goes, stage by stage, on one thread.

use super::FRAME;
use crate::arguments::Size;
use crate::measure::{Plan, Shot};
use crate::threaded_renderer::whole;
use crate::timing::real_time;
use crate::way::Way;
use eightfold_tracer::observe::{Fill, Observer, Stage};
use eightfold_tracer::scene::Scene;
use eightfold_tracer::{Band, Counts, Job, Memory, Quality, Renderer, Threads, Worker};
use std::sync::atomic::{AtomicU64, AtomicUsize, Ordering::Relaxed};
use std::time::Instant;

/// Times that each frame is drawn; what took least counts, as others at work on the machine only ever add to it.
const REPEATS: usize = 5;

/// The parts that a frame's time is divided into, in the order of the table: the tracer's stages by their numbers, and two more.
const ROWS: [(&str, usize); STAGES] = [
    ("preparing the scene", PREPARING),
    (
        "tracing: primary rays and their light",
        Stage::Primary as usize,
    ),
    (
        "tracing: secondary rays and their light",
        Stage::Tracing as usize,
    ),
    ("taking in what was traced", Stage::Results as usize),
    ("finding points", Stage::Points as usize),
    ("guard", Stage::Guard as usize),
    ("verdict", Stage::Verdict as usize),
    ("filling", Stage::Fill as usize),
    ("splitting", Stage::Split as usize),
    ("antialiasing: finding edges, mixing", Stage::Edges as usize),
    ("antialiasing: tracing", Stage::Middles as usize),
    ("other: tiles, captions", OTHER),
];
const STAGES: usize = 12;
const OTHER: usize = 10;
const PREPARING: usize = 11;

/// Takes the time of each stage of one thread.
struct Clock {
    start: Instant,
    /// The stage at work, and when it began, in nanoseconds.
    stage: AtomicUsize,
    since: AtomicU64,
    /// Nanoseconds of each stage.
    sums: [AtomicU64; STAGES],
    /// How often the clock was asked for each of them.
    calls: [AtomicU64; STAGES],
}

impl Clock {
    fn new() -> Self {
        Self {
            start: Instant::now(),
            stage: AtomicUsize::new(PREPARING),
            since: AtomicU64::new(0),
            sums: [const { AtomicU64::new(0) }; STAGES],
            calls: [const { AtomicU64::new(0) }; STAGES],
        }
    }

    /// Ends the stage at work, and begins another one.
    fn begin(&self, stage: usize) {
        let now = self.start.elapsed().as_nanos() as u64;
        let last = self.stage.load(Relaxed);
        let time = now - self.since.load(Relaxed);
        self.sums[last].store(self.sums[last].load(Relaxed) + time, Relaxed);
        self.calls[last].store(self.calls[last].load(Relaxed) + 1, Relaxed);
        self.stage.store(stage, Relaxed);
        self.since.store(now, Relaxed);
    }

    /// Nanoseconds that a call takes, while nothing else is at work on the processor.
    fn cost() -> f64 {
        const RUNS: usize = 200;
        const CALLS: usize = 500;
        let runs = (0..RUNS).map(|_| {
            let clock = Self::new();
            for _ in 0..CALLS {
                clock.begin(OTHER);
            }
            clock.start.elapsed().as_nanos() as f64 / CALLS as f64
        });
        runs.fold(f64::INFINITY, f64::min)
    }

    /// Milliseconds of each stage, without what asking took; tracing without what its primary rays take.
    fn times(&self, cost: f64) -> [f64; STAGES] {
        let mut times = [0.0; STAGES];
        for (i, time) in times.iter_mut().enumerate() {
            let calls = self.calls[i].load(Relaxed) as f64;
            *time = (self.sums[i].load(Relaxed) as f64 - calls * cost).max(0.0) * 1e-6;
        }
        let primary = times[Stage::Primary as usize];
        let all = &mut times[Stage::Tracing as usize];
        *all = (*all - primary).max(0.0);
        times
    }
}

impl Observer for &Clock {
    const LISTENS: bool = false;
    const TIMES: bool = true;

    fn point(self, _: usize, _: usize, _: Counts) {}

    fn square(self, _: usize, _: usize, _: usize, _: usize, _: Fill) {}

    fn stage(self, at: Stage) {
        self.begin(at as usize);
    }
}

/// Draws the frames of all shots by one thread, and tells where their time goes: a table for each way in each size.
pub fn tables(plan: &Plan, mut step: impl FnMut()) -> String {
    let mut stand = Stand {
        renderer: Renderer::with_memory(plan.isa.level, Box::new(Memory::new())),
        worker: Box::new(Worker::new()),
    };
    let cost = Clock::cost();
    let mut text = String::new();
    for shot in &plan.shots {
        for &size in &plan.sizes {
            for way in &plan.ways {
                text += &table(plan, shot, size, way, &mut stand, cost);
                step();
            }
        }
    }
    text
}

fn table(plan: &Plan, shot: &Shot, size: Size, way: &Way, stand: &mut Stand, cost: f64) -> String {
    let (width, quality) = (size.width, &way.quality);
    let mut picture = vec![0; size.area()];
    let frames = shot.times.len() as f64;
    let (mut total, mut stages) = (0.0, [0.0; STAGES]);
    for &time in &shot.times {
        let scene = way.scene(shot.scene, time);
        let before = way.scene(shot.scene, (time - FRAME).max(0.0));
        let (mut whole, mut least) = (f64::INFINITY, [f64::INFINITY; STAGES]);
        for _ in 0..REPEATS {
            // Which bands are taken first depends on the frame before.
            stand.draw(&before, quality, width, &mut picture, (), None);
            let draw = || stand.draw(&scene, quality, width, &mut picture, (), None);
            whole = whole.min(1e3 * real_time(draw).1);
            let clock = Clock::new();
            stand.draw(&scene, quality, width, &mut picture, &clock, Some(&clock));
            clock.begin(OTHER);
            for (least, time) in least.iter_mut().zip(clock.times(cost)) {
                *least = least.min(time);
            }
        }
        total += whole / frames;
        for (sum, time) in stages.iter_mut().zip(least) {
            *sum += time / frames;
        }
    }
    let sum: f64 = stages.iter().sum();
    let mut text = format!(
        "{} scene, {}x{}, {}, {}, 1 thread: {total:.3} ms a frame\n\n| stage | ms | share |\n| --- | ---: | ---: |\n",
        shot.scene, size.width, size.height, way.name, plan.isa.name
    );
    for (name, stage) in ROWS {
        let ms = stages[stage];
        text += &format!("| {name} | {ms:.3} | {:.1} % |\n", 100.0 * ms / sum);
    }
    text + "\n"
}

/// Where frames are drawn, by the caller's thread.
struct Stand {
    renderer: Renderer<Box<Memory>>,
    worker: Box<Worker>,
}

impl Stand {
    /// Draws a frame, band by band, while an observer looks on, and a clock hears of the work between bands.
    fn draw(
        &mut self,
        scene: &Scene,
        quality: &Quality,
        width: usize,
        pixels: &mut [u32],
        observer: impl Observer,
        clock: Option<&Clock>,
    ) {
        let mut thread = OneThread {
            worker: &mut self.worker,
            clock,
        };
        let frame = whole(width, pixels);
        let counts = self
            .renderer
            .render_observed(scene, quality, frame, &mut thread, observer);
        counts.expect("a valid scene");
    }
}

/// The caller's thread, whose work between bands is told.
struct OneThread<'a> {
    worker: &'a mut Worker,
    clock: Option<&'a Clock>,
}

impl Threads for OneThread<'_> {
    fn run(&mut self, bands: &mut [Band<'_>], job: Job<'_>) {
        let clock = self.clock;
        let other = || clock.inspect(|clock| clock.begin(OTHER));
        for band in bands {
            other();
            job(self.worker, band);
        }
        other();
    }
}
