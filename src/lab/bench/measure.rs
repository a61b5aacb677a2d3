//! Draws frames against the clock.

use crate::arguments::{NamedQuality, Size};
use crate::error::Difference;
use crate::interrupt;
use crate::scenes::SceneName;
use crate::threaded_renderer::ThreadedRenderer;
use crate::timing::real_time;
use crate::views::{Seen, Subject, Viewer};
use eightfold_tracer::Counts;
use eightfold_tracer::scene::Scene;
use eightfold_window::cpu::Isa;
use eightfold_window::pool::Pool;

/// The plan of a measurement.
pub struct Plan {
    pub shots: Vec<Shot>,
    pub isa: Isa,
    pub sizes: Vec<Size>,
    /// Numbers of threads.
    pub threads: Vec<usize>,
    /// The first is what the others are held to.
    pub ways: Vec<Way>,
}

/// How a frame is drawn.
#[derive(Clone, Copy, PartialEq)]
pub struct Way {
    pub quality: NamedQuality,
    /// Whether lamps throw shadows as points do, whatever their size.
    pub hard_shadows: bool,
}

/// The frames of a scene.
pub struct Shot {
    pub scene: SceneName,
    /// When they are, in seconds since the scene's start.
    pub times: Vec<f32>,
    /// The times of the frames of each view at which FLIP and pops are measured, see [`crate::views`].
    pub views: Vec<Vec<f32>>,
}

/// Where a size is drawn by a number of threads.
struct Bench {
    renderer: ThreadedRenderer,
    /// One for each size.
    cases: Vec<BenchCase>,
}

/// A case: frames that are drawn one right after the other.
struct BenchCase {
    canvas: Canvas,
    /// One for each shot.
    settings: Vec<Setting>,
}

/// The last frame.
struct Canvas {
    size: Size,
    /// A picture for each way.
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
    /// One for each way.
    pub runs: Vec<Run>,
    /// Milliseconds to fill each frame with one colour.
    pub floor: Vec<f64>,
}

/// A way in a setting.
pub struct Run {
    pub way: Way,
    /// Milliseconds of each frame.
    pub times: Vec<f64>,
    /// Of all frames together.
    pub counts: Counts,
    /// Of each frame to what it is held to.
    pub differences: Vec<Difference>,
    /// Of the views.
    pub seen: Seen,
}

/// The colour that frames are filled with to see how fast that is.
const COLOUR: u32 = 0x0012_3456;
/// Rows that a thread fills in one go, as many as the intro's bands have.
const STRIP: usize = 16;

impl Plan {
    /// How often [`Plan::measure`] calls back.
    pub fn steps(&self) -> usize {
        let frames: usize = self.shots.iter().map(|shot| shot.times.len()).sum();
        let views: usize = self.shots.iter().map(|shot| shot.views.len()).sum();
        self.sizes.len() * (self.threads.len() * (self.shots.len() + frames) + views)
    }

    /// Draws all frames in all ways in all settings. Calls `step` now and then, while no time is taken.
    ///
    /// All settings take turns frame by frame, and the ways of a setting, so that a machine whose speed drifts
    /// hits them alike. After Ctrl-C the rest of the frames is left out; the first of each is always drawn.
    pub fn measure(&self, mut step: impl FnMut()) -> Vec<Setting> {
        let threads = self.threads.iter();
        let mut benches: Vec<Bench> = threads.map(|&threads| Bench::new(self, threads)).collect();
        for bench in &mut benches {
            bench.each(|renderer, canvas, setting| {
                setting.warm_up(self, renderer, canvas);
                step();
            });
        }
        let longest = self.shots.iter().map(|shot| shot.times.len()).max();
        for frame in 0..longest.unwrap_or(0) {
            if frame > 0 && interrupt::is_stopped() {
                break;
            }
            for bench in &mut benches {
                bench.each(|renderer, canvas, setting| {
                    if let Some(&time) = self.shots[setting.shot].times.get(frame) {
                        setting.draw(self, renderer, canvas, time);
                        step();
                    }
                });
            }
        }
        // The frames are the same on any number of threads.
        let last = benches.last_mut().expect("there is a number of threads");
        last.each(|renderer, canvas, setting| {
            let mut viewer = Viewer::new(renderer, self.isa, canvas.size, true);
            for view in &self.shots[setting.shot].views {
                if interrupt::is_stopped() {
                    return;
                }
                setting.look(self, &mut viewer, view);
                step();
            }
        });
        let seen: Vec<Vec<Seen>> = last.settings().map(Setting::seen).collect();
        let mut settings = Vec::new();
        for bench in benches {
            let cases = bench.cases.into_iter().flat_map(|case| case.settings);
            for (mut setting, seen) in cases.zip(&seen) {
                for (run, seen) in setting.runs.iter_mut().zip(seen) {
                    run.seen = seen.clone();
                }
                settings.push(setting);
            }
        }
        settings
    }
}

impl Way {
    /// Its name in tables.
    pub fn name(&self) -> String {
        let shadows = if self.hard_shadows { ", hard" } else { "" };
        format!("{}{shadows}", self.quality)
    }

    /// The scene of a time.
    pub fn scene(&self, scene: SceneName, time: f32) -> Scene {
        let mut scene = scene.without_overlay(time);
        if self.hard_shadows {
            for light in scene.lights.iter_mut() {
                light.size = 0.0;
            }
        }
        scene
    }

    /// The scene of a time, if it takes no part in the time of a frame: what a scene file says is put together before, as no
    /// program does that in each frame.
    fn made_before(&self, scene: SceneName, time: f32) -> Option<Scene> {
        matches!(scene, SceneName::File(_)).then(|| self.scene(scene, time))
    }

    /// Draws a scene `width` pixels wide.
    fn draw(
        &self,
        scene: &Scene,
        isa: Isa,
        renderer: &mut ThreadedRenderer,
        width: usize,
        picture: &mut [u32],
    ) -> Counts {
        renderer.draw(isa.level, scene, &self.quality.quality, width, picture)
    }
}

impl Bench {
    fn new(plan: &Plan, threads: usize) -> Self {
        let case = |&size: &Size| BenchCase {
            canvas: Canvas {
                size,
                pictures: vec![vec![0; size.area()]; plan.ways.len()],
                filled: vec![0; size.area()],
            },
            settings: (0..plan.shots.len())
                .map(|shot| Setting::new(plan, shot, size, threads))
                .collect(),
        };
        Self {
            renderer: ThreadedRenderer::new(threads),
            cases: plan.sizes.iter().map(case).collect(),
        }
    }

    fn settings(&self) -> impl Iterator<Item = &Setting> {
        self.cases.iter().flat_map(|case| &case.settings)
    }

    /// Does something in each setting.
    fn each(&mut self, mut work: impl FnMut(&mut ThreadedRenderer, &mut Canvas, &mut Setting)) {
        for BenchCase { canvas, settings } in &mut self.cases {
            for setting in settings {
                work(&mut self.renderer, canvas, setting);
            }
        }
    }
}

impl Setting {
    fn new(plan: &Plan, shot: usize, size: Size, threads: usize) -> Self {
        let runs = plan.ways.iter().map(|&way| Run {
            way,
            times: Vec::new(),
            counts: Counts::NONE,
            differences: Vec::new(),
            seen: Seen::default(),
        });
        Self {
            shot,
            size,
            threads,
            runs: runs.collect(),
            floor: Vec::new(),
        }
    }

    /// Returns what was seen of each way.
    fn seen(&self) -> Vec<Seen> {
        self.runs.iter().map(|run| run.seen.clone()).collect()
    }

    /// Draws a frame in each way that does not count.
    fn warm_up(&mut self, plan: &Plan, renderer: &mut ThreadedRenderer, canvas: &mut Canvas) {
        self.draw(plan, renderer, canvas, plan.shots[self.shot].times[0]);
        self.floor.clear();
        for run in &mut self.runs {
            run.times.clear();
            run.counts = Counts::NONE;
            run.differences.clear();
        }
    }

    /// Draws a frame in each way and fills one, then compares.
    fn draw(
        &mut self,
        plan: &Plan,
        renderer: &mut ThreadedRenderer,
        canvas: &mut Canvas,
        time: f32,
    ) {
        let (scene, width) = (plan.shots[self.shot].scene, canvas.size.width);
        let mut runs: Vec<_> = self.runs.iter_mut().zip(&mut canvas.pictures).collect();
        // Each other frame the other way round: what is drawn after every pixel of the same scene finds caches full of it.
        if self.floor.len() % 2 == 1 {
            runs.reverse();
        }
        for (run, picture) in runs {
            let made = run.way.made_before(scene, time);
            let draw = || {
                let scene = made.unwrap_or_else(|| run.way.scene(scene, time));
                run.way.draw(&scene, plan.isa, renderer, width, picture)
            };
            let (counts, seconds) = real_time(draw);
            run.times.push(1e3 * seconds);
            run.counts += counts;
        }
        let fill = || fill(&mut renderer.threads.pool, width, &mut canvas.filled);
        let ((), seconds) = real_time(fill);
        self.floor.push(1e3 * seconds);

        // Not before all are drawn, so that threads and caches stay with what is timed.
        let (reference, others) = self.runs.split_first_mut().expect("there is a reference");
        reference.differences.push(Difference {
            psnr: f64::INFINITY,
            ..Difference::default()
        });
        for (run, picture) in others.iter_mut().zip(&canvas.pictures[1..]) {
            let difference = Difference::between(&canvas.pictures[0], picture);
            run.differences.push(difference);
        }
    }

    /// Has a view of all ways looked at.
    fn look(&mut self, plan: &Plan, viewer: &mut Viewer<'_>, view: &[f32]) {
        let scene = plan.shots[self.shot].scene;
        let scenes: Vec<_> = plan
            .ways
            .iter()
            .map(|way| move |time| way.scene(scene, time))
            .collect();
        let runs = self.runs.iter_mut().zip(&scenes);
        let mut subjects: Vec<Subject<'_>> = runs
            .map(|(run, scene)| Subject {
                quality: &run.way.quality.quality,
                scene,
                seen: &mut run.seen,
            })
            .collect();
        viewer.look(view, &mut subjects, |_| {});
    }
}

/// Fills a frame with one colour: no way to draw it on these threads is faster.
fn fill(pool: &mut Pool, width: usize, pixels: &mut [u32]) {
    let mut strips: Vec<&mut [u32]> = pixels.chunks_mut(STRIP * width).collect();
    let mut threads = vec![(); pool.threads()];
    pool.run(&mut threads, &mut strips, &|_, strip| strip.fill(COLOUR));
}

#[cfg(test)]
mod tests {
    use super::*;
    use eightfold_scene_file::SceneFile;

    #[test]
    fn a_frame_of_a_scene_file_is_timed_without_reading_what_the_file_says() {
        let way = Way {
            quality: NamedQuality::THESIS,
            hard_shadows: false,
        };
        let file = SceneFile::parse("room.ron", "Scene()").expect("a scene");
        let file = SceneName::File(Box::leak(Box::new(file)));
        assert!(way.made_before(file, 0.0).is_some());
        assert!(way.made_before(SceneName::Model, 0.0).is_none());
    }
}
