//! Draws frames by several techniques against the clock, and compares them with those of the first technique.

use crate::arguments::{NamedQuality, Size};
use crate::error::Difference;
use crate::interrupt;
use crate::progress;
use crate::rivals::{self, Way};
use crate::scenes::SceneName;
use crate::seen::{Seen, look};
use crate::threaded_renderer::ThreadedRenderer;
use cpu_time::ThreadTime;
use eightfold_tracer::scene::Scene;
use eightfold_tracer::{Counts, Level, Quality};
use eightfold_window::cpu::Isa;
use std::time::Instant;

/// A way to draw a frame.
#[derive(Clone, Debug, PartialEq)]
pub struct Technique {
    pub name: String,
    pub quality: Quality,
    pub way: Way,
}

impl Technique {
    /// Returns the technique of a named quality, with antialiasing or without.
    pub fn named(named: NamedQuality, antialias: bool) -> Self {
        Self {
            name: named.name.to_owned(),
            quality: Quality {
                antialias,
                ..named.quality
            },
            way: Way::Drawn,
        }
    }

    /// Returns what people do instead, antialiased where that can be, and the default quality without its guard.
    pub fn rivals(antialias: bool) -> impl Iterator<Item = Self> {
        let exhaustive = Quality {
            antialias,
            ..Quality::EXHAUSTIVE
        };
        let enlarged = (4..10).map(move |tenths| Self {
            name: format!("resolution:0.{tenths}"),
            quality: exhaustive,
            way: Way::Enlarged(f64::from(tenths) / 10.0),
        });
        let others = [
            ("checkerboard", Quality::EXHAUSTIVE, Way::Checkerboard),
            (
                "unguarded",
                Quality {
                    antialias,
                    guarded: false,
                    ..Quality::DEFAULT
                },
                Way::Drawn,
            ),
        ];
        enlarged.chain(others.map(|(name, quality, way)| Self {
            name: name.to_owned(),
            quality,
            way,
        }))
    }

    /// Draws a frame that fills `pixels`.
    pub fn draw(
        &self,
        renderer: &mut ThreadedRenderer,
        level: Level,
        scene: &Scene,
        width: usize,
        pixels: &mut [u32],
    ) -> Counts {
        rivals::draw(
            self.way,
            renderer,
            level,
            scene,
            &self.quality,
            width,
            pixels,
        )
    }
}

/// The plan of a measurement: all shots, in all sizes, by all numbers of threads, by all techniques.
pub struct Plan {
    pub shots: Vec<Shot>,
    pub isa: Isa,
    pub sizes: Vec<Size>,
    pub threads: Vec<usize>,
    /// The first is the reference.
    pub techniques: Vec<Technique>,
}

/// The frames of a scene.
pub struct Shot {
    pub scene: SceneName,
    /// The times of the frames against the clock, in seconds since the scene's start.
    pub times: Vec<f32>,
    /// The times of the frames of each view, at which pictures are compared as a viewer sees them.
    pub views: Vec<Vec<f32>>,
}

/// Seconds per frame of frames in a row, as on most screens.
const FRAME: f32 = 1.0 / 60.0;
/// The frames after the first one of a view.
const FOLLOWING: usize = 10;

impl Shot {
    /// Spreads a number of frames and of views evenly over a scene.
    pub fn new(scene: SceneName, frames: usize, views: usize) -> Self {
        let length = scene.length();
        // The next scene of the show has no part in this one.
        let (last, end) = match scene.start() {
            Some(_) => (length - FRAME, length),
            None => (length, f32::INFINITY),
        };
        // The model scene ends where it begins.
        let first = |view| evenly_spaced(length, view, views + 1);
        let view = |view| {
            let times = (0..=FOLLOWING).map(|frame| first(view) + frame as f32 * FRAME);
            times.take_while(|&time| time < end).collect()
        };
        Self {
            scene,
            times: (0..frames)
                .map(|i| evenly_spaced(last, i, frames))
                .collect(),
            views: (0..views).map(view).collect(),
        }
    }
}

/// Returns time `i` of `count` that are evenly spaced from 0 to a last one, in seconds.
fn evenly_spaced(last: f32, i: usize, count: usize) -> f32 {
    last * i as f32 / (count - 1).max(1) as f32
}

/// The results of a shot, in a size, by a number of threads.
pub struct Setting {
    /// The index of the shot in the plan.
    pub shot: usize,
    pub size: Size,
    pub threads: usize,
    /// One for each technique.
    pub runs: Vec<Run>,
}

/// The results of a technique in a setting.
#[derive(Clone, Default)]
pub struct Run {
    /// The milliseconds of each frame: real time, or the time on a processor if there is one thread, which other programs do not lengthen.
    pub times: Vec<f64>,
    /// The work of all frames together.
    pub counts: Counts,
    /// The difference between each frame and the reference's.
    pub differences: Vec<Difference>,
    pub seen: Seen,
}

impl Plan {
    /// Draws all frames.
    ///
    /// Settings and techniques take turns frame by frame: a machine whose speed drifts hits them alike. After Ctrl-C the rest of the
    /// frames and the views are left out; the first frame of each shot is always drawn.
    pub fn measure(&self) -> Vec<Setting> {
        let mut settings = self.settings();
        let mut renderers: Vec<(usize, ThreadedRenderer)> = self
            .threads
            .iter()
            .map(|&count| (count, ThreadedRenderer::new(count)))
            .collect();
        let largest = self.sizes.iter().map(|size| size.area()).max();
        let mut pictures = [(); 2].map(|()| vec![0; largest.unwrap_or(0)]);
        let longest = self.shots.iter().map(|shot| shot.times.len()).max();
        let longest = longest.unwrap_or(0);
        let bar = progress::bar(longest * settings.len());
        for frame in 0..longest {
            for setting in &mut settings {
                bar.inc(1);
                let shot = &self.shots[setting.shot];
                let Some(&time) = shot.times.get(frame) else {
                    continue;
                };
                if frame > 0 && interrupt::is_stopped() {
                    continue;
                }
                let renderer = renderers
                    .iter_mut()
                    .find(|(count, _)| *count == setting.threads);
                let (_, renderer) = renderer.expect("a renderer for each number of threads");
                let scene = self.scene(shot.scene, time);
                let mut draw = || setting.draw(self, renderer, &scene, &mut pictures);
                draw();
                if frame == 0 {
                    // That one warmed memory and threads up.
                    setting.runs.fill(Run::default());
                    setting.draw(self, renderer, &scene, &mut pictures);
                }
            }
        }
        bar.finish_and_clear();
        self.look(&mut settings);
        settings
    }

    /// The scene of a frame. Beside enlarged frames it has no captions, which would be enlarged as well.
    fn scene(&self, name: SceneName, time: f32) -> Scene {
        let mut scene = name.without_overlay(time);
        if self.techniques.iter().any(|it| it.way != Way::Drawn) {
            scene.captions.clear();
            scene.copper_bars.clear();
        }
        scene
    }

    /// Returns all settings, without results.
    fn settings(&self) -> Vec<Setting> {
        let threads = self.threads.iter();
        let sized =
            threads.flat_map(|&threads| self.sizes.iter().map(move |&size| (threads, size)));
        let runs = vec![Run::default(); self.techniques.len()];
        let setting = |((threads, size), shot)| Setting {
            shot,
            size,
            threads,
            runs: runs.clone(),
        };
        let all = sized.flat_map(|sized| (0..self.shots.len()).map(move |shot| (sized, shot)));
        all.map(setting).collect()
    }

    /// Compares the pictures of all views, which are the same by any number of threads.
    fn look(&self, settings: &mut [Setting]) {
        let count = self.sizes.len() * self.shots.len();
        let views: usize = self.shots.iter().map(|shot| shot.views.len()).sum();
        let bar = progress::bar(self.sizes.len() * views);
        for i in 0..count {
            let Setting { shot, size, .. } = settings[i];
            let Shot { scene, views, .. } = &self.shots[shot];
            let mut seen = vec![Seen::default(); self.techniques.len()];
            for view in views {
                let scenes: Vec<Scene> =
                    view.iter().map(|&time| self.scene(*scene, time)).collect();
                look(&self.techniques, self.isa.level, size, &scenes, &mut seen);
                bar.inc(1);
            }
            if interrupt::is_stopped() {
                break;
            }
            for setting in settings.iter_mut().skip(i).step_by(count) {
                for (run, seen) in setting.runs.iter_mut().zip(&seen) {
                    run.seen = seen.clone();
                }
            }
        }
        bar.finish_and_clear();
    }
}

impl Setting {
    /// Draws a frame by each technique.
    fn draw(
        &mut self,
        plan: &Plan,
        renderer: &mut ThreadedRenderer,
        scene: &Scene,
        [reference, picture]: &mut [Vec<u32>; 2],
    ) {
        let (width, area) = (self.size.width, self.size.area());
        let (reference, picture) = (&mut reference[..area], &mut picture[..area]);
        for (i, (run, technique)) in self.runs.iter_mut().zip(&plan.techniques).enumerate() {
            let (real, own) = (Instant::now(), ThreadTime::now());
            run.counts += technique.draw(renderer, plan.isa.level, scene, width, picture);
            let time = if self.threads == 1 {
                own.elapsed()
            } else {
                real.elapsed()
            };
            run.times.push(1e3 * time.as_secs_f64());
            if i == 0 {
                reference.copy_from_slice(picture);
            }
            run.differences
                .push(Difference::between(reference, picture));
        }
    }
}
