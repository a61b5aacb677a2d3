//! Draws frames against the clock, and compares them with those that they are held to.

use crate::arguments::{Size, processors};
use crate::error::Difference;
use crate::interrupt;
use crate::missed::Visible;
use crate::progress;
use crate::scenes::SceneName;
use crate::threaded_renderer::ThreadedRenderer;
use crate::timing::{percentile, real_time, thread_time};
use crate::views::{Seen, Viewer};
use crate::way::Way;
use eightfold_tracer::Counts;
use eightfold_window::cpu::Isa;
use eightfold_window::pool::Pool;
use indicatif::ProgressBar;
use rayon::prelude::*;

/// The plan of a measurement.
pub struct Plan {
    pub shots: Vec<Shot>,
    pub isa: Isa,
    pub sizes: Vec<Size>,
    /// Numbers of threads.
    pub threads: Vec<usize>,
    /// The first is what the others are held to.
    pub ways: Vec<Way>,
    /// Whether a frame's time is that of its one thread on a processor, which other programs do not lengthen.
    pub is_on_processor: bool,
    /// Whether views are compared with 64 samples a pixel.
    pub has_samples: bool,
    /// Whether objects are counted that a frame misses.
    pub has_missed: bool,
}

/// The frames of a scene.
pub struct Shot {
    pub scene: SceneName,
    /// When they are, in seconds since the scene's start.
    pub times: Vec<f32>,
    /// The times of the frames of each view at which FLIP and pops are measured, see [`crate::views`].
    pub views: Vec<Vec<f32>>,
}

/// Ways whose pictures are held at the same time.
const GROUP: usize = 8;

/// The pictures of a size.
struct Canvas {
    /// That which the others are held to.
    reference: Vec<u32>,
    /// Those of a group of ways.
    pictures: Vec<Vec<u32>>,
    /// The picture that is filled.
    filled: Vec<u32>,
}

/// A shot in a size on a number of threads.
pub struct Setting {
    /// The index of the shot in the plan.
    pub shot: usize,
    pub size: Size,
    pub threads: usize,
    /// The index of its canvas, and that of its renderer.
    at: [usize; 2],
    /// One for each way.
    pub runs: Vec<Run>,
    /// Milliseconds to fill each frame with one colour.
    pub floor: Vec<f64>,
}

/// A way in a setting.
#[derive(Clone, Default)]
pub struct Run {
    /// Milliseconds of each frame.
    pub times: Vec<f64>,
    /// Of all frames together.
    pub counts: Counts,
    /// Of each frame to what it is held to.
    pub differences: Vec<Difference>,
    /// The number of missed objects in all frames together.
    pub missed: usize,
    /// Of the views.
    pub seen: Seen,
}

/// The colour that frames are filled with to see how fast that is.
const COLOUR: u32 = 0x0012_3456;
/// Rows that a thread fills in one go, as many as the intro's bands have.
const STRIP: usize = 16;

impl Plan {
    /// How often [`Plan::measure`] tells of its progress.
    fn steps(&self) -> usize {
        let frames: usize = self.shots.iter().map(|shot| shot.times.len()).sum();
        let views: usize = self.shots.iter().map(|shot| shot.views.len()).sum();
        self.sizes.len() * (self.threads.len() * (self.shots.len() + frames) + views)
    }

    /// Draws all frames in all ways in all settings, with a progress bar, which is drawn while no time is taken.
    ///
    /// All settings take turns frame by frame, and the ways of a setting, so that a machine whose speed drifts
    /// hits them alike. After Ctrl-C the rest of the frames is left out; the first of each is always drawn.
    pub fn measure(&self) -> Vec<Setting> {
        let bar = progress::bar(self.steps());
        let threads = self.threads.iter();
        let mut renderers: Vec<_> = threads.map(|&count| ThreadedRenderer::new(count)).collect();
        let canvases = self.sizes.iter();
        let mut canvases: Vec<_> = canvases.map(|&size| self.canvas(size)).collect();
        let mut settings = self.settings();
        let mut draw = |setting: &mut Setting, time: f32| {
            let [canvas, renderer] = setting.at;
            setting.draw(self, &mut renderers[renderer], &mut canvases[canvas], time);
            bar.inc(1);
        };
        for setting in &mut settings {
            // Frames that warm up memory and threads, and do not count.
            draw(setting, self.shots[setting.shot].times[0]);
            setting.floor.clear();
            setting.runs.fill(Run::default());
        }
        let longest = self.shots.iter().map(|shot| shot.times.len()).max();
        for frame in 0..longest.unwrap_or(0) {
            if frame > 0 && interrupt::is_stopped() {
                break;
            }
            for setting in &mut settings {
                if let Some(&time) = self.shots[setting.shot].times.get(frame) {
                    draw(setting, time);
                }
            }
        }
        // What is seen of frames is the same on any number of threads.
        let count = self.sizes.len() * self.shots.len();
        let mut renderer = ThreadedRenderer::new(processors());
        for i in 0..count {
            let seen = self.look(&settings[i], &mut renderer, &bar);
            for setting in settings.iter_mut().skip(i).step_by(count) {
                for (run, seen) in setting.runs.iter_mut().zip(&seen) {
                    run.seen = seen.clone();
                }
            }
        }
        bar.finish_and_clear();
        settings
    }

    fn canvas(&self, size: Size) -> Canvas {
        let picture = || vec![0; size.area()];
        Canvas {
            reference: picture(),
            pictures: vec![picture(); self.ways.len().min(GROUP)],
            filled: picture(),
        }
    }

    /// All settings, without any frames.
    fn settings(&self) -> Vec<Setting> {
        let mut settings = Vec::new();
        for (renderer, &threads) in self.threads.iter().enumerate() {
            for (canvas, &size) in self.sizes.iter().enumerate() {
                for shot in 0..self.shots.len() {
                    settings.push(Setting {
                        shot,
                        size,
                        threads,
                        at: [canvas, renderer],
                        runs: vec![Run::default(); self.ways.len()],
                        floor: Vec::new(),
                    });
                }
            }
        }
        settings
    }

    /// Returns what is seen of each way at the views of a setting: nothing if Ctrl-C cuts them short.
    fn look(
        &self,
        setting: &Setting,
        renderer: &mut ThreadedRenderer,
        bar: &ProgressBar,
    ) -> Vec<Seen> {
        let shot = &self.shots[setting.shot];
        let mut seen = vec![Seen::default(); self.ways.len()];
        let mut viewer = Viewer::new(renderer, self.isa, setting.size, self.has_samples);
        for view in &shot.views {
            viewer.look(view, shot.scene, &self.ways, &mut seen);
            bar.inc(1);
        }
        if interrupt::is_stopped() {
            seen.fill(Seen::default());
        }
        seen
    }
}

impl Run {
    /// The first quartile of the times, in milliseconds. Other programs lengthen the times of the slower frames, so it is more
    /// stable than the median.
    pub fn quartile(&self) -> f64 {
        percentile(&self.times, 25)
    }
}

impl Setting {
    /// Draws a frame in each way, compares them, and fills one.
    fn draw(
        &mut self,
        plan: &Plan,
        renderer: &mut ThreadedRenderer,
        canvas: &mut Canvas,
        time: f32,
    ) {
        let (scene, Size { width, height }) = (plan.shots[self.shot].scene, self.size);
        let visible = || Visible::new(&scene.without_overlay(time), width, height);
        let visible = plan.has_missed.then(visible);
        let groups = self.runs.chunks_mut(GROUP).zip(plan.ways.chunks(GROUP));
        for (number, (runs, ways)) in groups.enumerate() {
            let mut drawn: Vec<_> = runs
                .iter_mut()
                .zip(ways)
                .zip(&mut canvas.pictures)
                .collect();
            // Each other frame the other way round: what is drawn after every pixel of the same scene finds caches full of it.
            if self.floor.len() % 2 == 1 {
                drawn.reverse();
            }
            for ((run, way), picture) in drawn {
                let made = way.made_before(scene, time);
                let draw = || {
                    let scene = made.unwrap_or_else(|| way.scene(scene, time));
                    renderer.draw(plan.isa.level, &scene, &way.quality, width, picture)
                };
                let (counts, seconds) = if plan.is_on_processor {
                    thread_time(draw)
                } else {
                    real_time(draw)
                };
                run.times.push(1e3 * seconds);
                run.counts += counts;
            }
            // Not before all are drawn, so that threads and caches stay with what is timed.
            if number == 0 {
                canvas.reference.copy_from_slice(&canvas.pictures[0]);
            }
            let reference = &canvas.reference;
            let drawn = runs.par_iter_mut().zip(&canvas.pictures);
            drawn.for_each(|(run, picture)| {
                run.differences
                    .push(Difference::between(reference, picture));
                run.missed += visible
                    .as_ref()
                    .map_or(0, |visible| visible.missed(reference, picture));
            });
        }
        let fill = || fill(&mut renderer.threads.pool, width, &mut canvas.filled);
        let ((), seconds) = real_time(fill);
        self.floor.push(1e3 * seconds);
    }
}

/// Fills a frame with one colour: no way to draw it on these threads is faster.
fn fill(pool: &mut Pool, width: usize, pixels: &mut [u32]) {
    let mut strips: Vec<&mut [u32]> = pixels.chunks_mut(STRIP * width).collect();
    let mut threads = vec![(); pool.threads()];
    pool.run(&mut threads, &mut strips, &|_, strip| strip.fill(COLOUR));
}
