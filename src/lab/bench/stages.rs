//! Where a frame's time goes, stage by stage, and how many threads can share it.

use super::FRAME;
use super::measure::{Plan, Shot, Way};
use crate::arguments::Size;
use crate::threaded_renderer::whole;
use crate::timing::real_time;
use eightfold_tracer::observe::{Fill, Observer, Stage};
use eightfold_tracer::scene::Scene;
use eightfold_tracer::{Band, Counts, Job, Memory, Quality, Renderer, Threads, Worker};
use std::sync::atomic::{AtomicU64, AtomicUsize, Ordering::Relaxed};
use std::time::Instant;

/// Times that each frame is drawn; what took least counts, as others at work on the machine only ever add to it.
const REPEATS: usize = 5;
/// Numbers of threads that the frame's pieces are dealt to.
const THREADS: [usize; 3] = [4, 16, 64];

/// The parts that a frame's time is divided into, in the order of the table.
const ROWS: [(&str, usize); STAGES] = [
    ("preparing the scene", PREPARING),
    (
        "tracing: primary rays and their light",
        stage(Stage::Primary),
    ),
    (
        "tracing: secondary rays and their light",
        stage(Stage::Tracing),
    ),
    ("taking in what was traced", stage(Stage::Results)),
    ("finding points", stage(Stage::Points)),
    ("guard", stage(Stage::Guard)),
    ("verdict", stage(Stage::Verdict)),
    ("filling", stage(Stage::Fill)),
    ("splitting", stage(Stage::Split)),
    ("antialiasing: finding edges, mixing", stage(Stage::Edges)),
    ("antialiasing: tracing", stage(Stage::Middles)),
    ("other: tiles, captions", OTHER),
];
const STAGES: usize = 12;
const OTHER: usize = 10;
const PREPARING: usize = 11;

/// The number of a stage.
const fn stage(stage: Stage) -> usize {
    match stage {
        Stage::Points => 0,
        Stage::Primary => 1,
        Stage::Tracing => 2,
        Stage::Results => 3,
        Stage::Guard => 4,
        Stage::Verdict => 5,
        Stage::Fill => 6,
        Stage::Split => 7,
        Stage::Edges => 8,
        Stage::Middles => 9,
    }
}

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
        let primary = times[stage(Stage::Primary)];
        let all = &mut times[stage(Stage::Tracing)];
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
        self.begin(stage(at));
    }
}

/// The pieces of work of a frame: milliseconds until the first begins, and those of each piece, in the order in which they are
/// taken.
struct Pieces {
    before: f64,
    /// Those of a phase begin when all of the phase before have ended.
    phases: Vec<Vec<f64>>,
}

impl Pieces {
    fn total(&self) -> f64 {
        self.before + self.phases.iter().flatten().sum::<f64>()
    }

    /// How many times as fast the frame is where so many threads take the pieces in their order, and nothing else holds them
    /// up.
    fn speed_up(&self, threads: usize) -> f64 {
        let longest = |times: &Vec<f64>| {
            let mut ends = vec![0.0_f64; threads];
            for time in times {
                let next = ends.iter_mut().min_by(|a, b| a.total_cmp(b));
                *next.expect("there is a thread") += time;
            }
            ends.into_iter().fold(0.0, f64::max)
        };
        self.total() / (self.before + self.phases.iter().map(longest).sum::<f64>())
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
    let (width, quality) = (size.width, &way.quality.quality);
    let mut picture = vec![0; size.area()];
    let frames = shot.times.len() as f64;
    let (mut total, mut stages, mut speed_ups) = (0.0, [0.0; STAGES], [0.0; THREADS.len()]);
    for &time in &shot.times {
        let scene = way.scene(shot.scene, time);
        let before = way.scene(shot.scene, (time - FRAME).max(0.0));
        let mut pieces: Option<Pieces> = None;
        let mut least = [f64::INFINITY; STAGES];
        for _ in 0..REPEATS {
            // Which pieces are taken first depends on the frame before.
            stand.draw(&before, quality, width, &mut picture, ());
            let drawn = stand.draw(&scene, quality, width, &mut picture, ());
            pieces = Some(match pieces {
                Some(pieces) => pieces.least(drawn),
                None => drawn,
            });
            let clock = Clock::new();
            stand.draw(&scene, quality, width, &mut picture, &clock);
            clock.begin(OTHER);
            for (least, time) in least.iter_mut().zip(clock.times(cost)) {
                *least = least.min(time);
            }
        }
        let pieces = pieces.expect("a frame is drawn");
        total += pieces.total() / frames;
        for (sum, time) in stages.iter_mut().zip(least) {
            *sum += time / frames;
        }
        for (sum, threads) in speed_ups.iter_mut().zip(THREADS) {
            *sum += pieces.speed_up(threads) / frames;
        }
    }
    let sum: f64 = stages.iter().sum();
    let mut text = format!(
        "{} scene, {}x{}, {}, {}, 1 thread: {total:.3} ms a frame\n\n| stage | ms | share |\n| --- | ---: | ---: |\n",
        shot.scene,
        size.width,
        size.height,
        way.name(),
        plan.isa.name
    );
    for (name, stage) in ROWS {
        let ms = stages[stage];
        text += &format!("| {name} | {ms:.3} | {:.1} % |\n", 100.0 * ms / sum);
    }
    let speed_ups = speed_ups.map(|speed_up| format!("{speed_up:.1}"));
    text += &format!(
        "\nAt most {} times as fast by {} threads\n\n",
        speed_ups.join(", "),
        THREADS.map(|threads| threads.to_string()).join(", ")
    );
    text
}

impl Pieces {
    /// The lesser of each two times.
    fn least(mut self, other: Self) -> Self {
        self.before = self.before.min(other.before);
        let times = self.phases.iter_mut().flatten();
        for (time, other) in times.zip(other.phases.into_iter().flatten()) {
            *time = time.min(other);
        }
        self
    }
}

/// Where frames are drawn, by the caller's thread.
struct Stand {
    renderer: Renderer<Box<Memory>>,
    worker: Box<Worker>,
}

impl Stand {
    /// Draws a frame, band by band, while an observer looks on.
    fn draw<O: StageObserver>(
        &mut self,
        scene: &Scene,
        quality: &Quality,
        width: usize,
        pixels: &mut [u32],
        observer: O,
    ) -> Pieces {
        let mut thread = TimedThread {
            worker: &mut self.worker,
            observer,
            start: Instant::now(),
            pieces: Pieces {
                before: 0.0,
                phases: Vec::new(),
            },
        };
        let frame = whole(width, pixels);
        let counts = self
            .renderer
            .render_observed(scene, quality, frame, &mut thread, observer);
        counts.expect("a valid scene");
        thread.pieces
    }
}

/// A thread that takes the time of each band.
struct TimedThread<'a, O> {
    worker: &'a mut Worker,
    observer: O,
    /// When the frame began.
    start: Instant,
    pieces: Pieces,
}

impl<O: StageObserver> Threads for TimedThread<'_, O> {
    fn run(&mut self, bands: &mut [Band<'_>], job: Job<'_>) {
        if self.pieces.phases.is_empty() {
            self.pieces.before = 1e3 * self.start.elapsed().as_secs_f64();
        }
        let times = bands.iter_mut().map(|band| {
            self.observer.other();
            let ((), seconds) = real_time(|| job(self.worker, band));
            1e3 * seconds
        });
        self.pieces.phases.push(times.collect());
        self.observer.other();
    }
}

/// An observer that hears of the work between tiles, too.
trait StageObserver: Observer {
    fn other(self);
}

impl StageObserver for () {
    fn other(self) {}
}

impl StageObserver for &Clock {
    fn other(self) {
        self.begin(OTHER);
    }
}
