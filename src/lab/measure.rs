use crate::arguments::{self, within};
use crate::interrupt;
use crate::progress::Progress;
use crate::scenes::{self, SceneName};
pub use crate::technique::{Sampling, Technique};
use crate::view_errors::{ViewErrors, add_errors};
use clap::Args;
use cpu_time::ThreadTime;
use eightfold_harness::Size;
use eightfold_harness::error::Difference;
use eightfold_harness::threaded_renderer::ThreadedRenderer;
use eightfold_tracer::{Counts, presentation::Moment};
use eightfold_window::cpu::Isa;
use std::time::Instant;

#[derive(Args, Clone, Copy)]
pub struct ShotArguments {
    #[arg(long, value_name = "NAME", default_value_t = SceneName::Model, help = scenes::names())]
    pub scene: SceneName,
    /// Evenly spaced views for FLIP and dB to 64 samples; pops are counted in the next ten frames,
    /// 60 per second
    #[arg(long, value_name = "N", default_value = "9", value_parser = within(arguments::FRAMES))]
    pub views: usize,
    /// Instruction set [default: the best of this machine]
    #[arg(long, value_name = "NAME", value_parser = arguments::instruction_set)]
    pub isa: Option<Isa>,
}

pub struct Measurement {
    pub shots: Vec<Shot>,
    pub isa: Isa,
    pub sizes: Vec<Size>,
    pub threads: Vec<usize>,
    /// The first is the reference.
    pub techniques: Vec<Technique>,
}

pub struct Shot {
    pub scene: SceneName,
    /// Seconds from the scene's start; each shot has the same number.
    pub times: Vec<f32>,
    pub views: Vec<Vec<f32>>,
}

/// Seconds per frame on most screens.
const FRAME: f32 = 1.0 / 60.0;
const FOLLOWING: usize = 10;

impl Shot {
    pub fn new(scene: SceneName, frames: usize, views: usize) -> Self {
        let length = scene.length();
        // A scene of the show ends before the next one begins.
        let (last, end) = match scene.start() {
            Some(_) => (length - FRAME, length),
            None => (length, f32::INFINITY),
        };
        // The end of the model scene equals its start: it has no view.
        let first = |view| evenly_spaced(length, view, views + 1);
        let view = |view| {
            let times = (0..=FOLLOWING).map(|frame| first(view) + frame as f32 * FRAME);
            times.take_while(|&time| time < end).collect()
        };
        let time = |i| evenly_spaced(last, i, frames);
        Self {
            scene,
            times: (0..frames).map(time).collect(),
            views: (0..views).map(view).collect(),
        }
    }
}

fn evenly_spaced(last: f32, i: usize, count: usize) -> f32 {
    last * i as f32 / (count - 1).max(1) as f32
}

pub struct Setting {
    pub shot: usize,
    pub size: Size,
    pub threads: usize,
    pub runs: Vec<Run>,
}

#[derive(Clone, Default)]
pub struct Run {
    /// Milliseconds per frame: processor time if there is one thread, else real time.
    pub times: Vec<f64>,
    pub counts: Counts,
    pub differences: Vec<Difference>,
    pub view_errors: ViewErrors,
}

impl Measurement {
    /// Settings and techniques take turns, so a drift of the machine's speed affects all. After
    /// Ctrl-C only the first frame of each shot is drawn.
    pub fn run(&self) -> Vec<Setting> {
        let mut settings = self.settings();
        let renderers = self.threads.iter().map(|&count| ThreadedRenderer::new(count));
        let mut renderers: Vec<ThreadedRenderer> = renderers.collect();
        let largest = self.sizes.iter().map(|size| size.area()).max();
        let mut pictures = [(); 2].map(|()| vec![0; largest.unwrap_or(0)]);
        let frames = self.shots[0].times.len();
        let bar = Progress::new(frames * settings.len());
        for frame in 0..frames {
            for (i, setting) in settings.iter_mut().enumerate() {
                bar.inc(1);
                if frame > 0 && interrupt::is_stopped() {
                    continue;
                }
                let shot = &self.shots[setting.shot];
                let renderer = &mut renderers[i / (self.sizes.len() * self.shots.len())];
                let scene = self.scene(shot.scene, shot.times[frame]);
                setting.draw(self, renderer, &scene, &mut pictures);
                if frame == 0 {
                    // The first frame warmed up memory and threads.
                    setting.runs.fill(Run::default());
                    setting.draw(self, renderer, &scene, &mut pictures);
                }
            }
        }
        self.compare_views(&mut settings);
        settings
    }

    /// Omits captions, which enlarged frames would enlarge.
    fn scene(&self, name: SceneName, time: f32) -> Moment {
        let mut scene = name.without_overlay(time);
        if self.techniques.iter().any(|it| it.sampling != Sampling::Full) {
            scene.presentation.captions.clear();
        }
        scene
    }

    fn settings(&self) -> Vec<Setting> {
        let mut settings = Vec::new();
        for &threads in &self.threads {
            for &size in &self.sizes {
                settings.extend((0..self.shots.len()).map(|shot| Setting {
                    shot,
                    size,
                    threads,
                    runs: vec![Run::default(); self.techniques.len()],
                }));
            }
        }
        settings
    }

    /// Compares views once per size: threads do not change pictures.
    fn compare_views(&self, settings: &mut [Setting]) {
        let count = self.sizes.len() * self.shots.len();
        let views: usize = self.shots.iter().map(|shot| shot.views.len()).sum();
        let bar = Progress::new(self.sizes.len() * views);
        for i in 0..count {
            let Setting { shot, size, .. } = settings[i];
            let Shot { scene, views, .. } = &self.shots[shot];
            let mut errors = vec![ViewErrors::default(); self.techniques.len()];
            for view in views {
                let scenes = view.iter().map(|&time| self.scene(*scene, time));
                let scenes: Vec<Moment> = scenes.collect();
                add_errors(&self.techniques, self.isa.level, size, &scenes, &mut errors);
                bar.inc(1);
            }
            for setting in settings.iter_mut().skip(i).step_by(count) {
                for (run, errors) in setting.runs.iter_mut().zip(&errors) {
                    run.view_errors = errors.clone();
                }
            }
        }
    }
}

impl Setting {
    fn draw(
        &mut self,
        measurement: &Measurement,
        renderer: &mut ThreadedRenderer,
        scene: &Moment,
        pictures: &mut [Vec<u32>; 2],
    ) {
        let (level, width) = (measurement.isa.level, self.size.width);
        let [reference, picture] = pictures.each_mut().map(|it| &mut it[..self.size.area()]);
        let runs = self.runs.iter_mut().zip(&measurement.techniques);
        let mut edge = 0;
        for (i, (run, technique)) in runs.enumerate() {
            let (real, own) = (Instant::now(), ThreadTime::now());
            run.counts += technique.draw(renderer, level, scene, width, picture);
            let time = match self.threads {
                1 => own.elapsed(),
                _ => real.elapsed(),
            };
            run.times.push(1e3 * time.as_secs_f64());
            if i == 0 {
                reference.copy_from_slice(picture);
            } else if technique.quality.edge != edge {
                let own = technique.reference();
                own.draw(renderer, level, scene, width, reference);
            }
            edge = technique.quality.edge;
            let difference = Difference::between(reference, picture);
            run.differences.push(difference);
        }
    }
}
