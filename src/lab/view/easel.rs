//! Where a frame is drawn to be looked at: the picture, what it was made of, how right it is.

use super::controls::{Controls, Look, MOST_ERROR, MOST_RAYS};
use crate::arguments::Size;
use crate::error::Difference;
use crate::overlay::{FrameTrace, draw_error};
use crate::scenes::SceneName;
use crate::studio::Studio;
use eightfold::Quality;
use eightfold::scene::Scene;
use eightfold_window::cpu::Isa;
use std::time::{Duration, Instant};

/// Memory and threads for frames, and the last of them.
pub struct Easel {
    studio: Studio,
    isa: Isa,
    scene: SceneName,
    /// Frames a second of the show.
    rate: f64,
    /// What the picture is of.
    drawn: Option<(Controls, Size)>,
    pub picture: Vec<u32>,
    /// The same moment with every pixel traced, and whether it is there.
    exhaustive: Vec<u32>,
    has_exhaustive: bool,
    trace: FrameTrace,
    trace_size: Size,
    scratch: Vec<u32>,
    pub sight: Sight,
}

/// What is known of the picture.
#[derive(Clone, Copy, Default)]
pub struct Sight {
    /// To draw it, without overlays.
    pub time: Duration,
    /// Points traced for each pixel.
    pub points: f64,
    /// Against the exhaustive picture, in dB.
    pub psnr: f64,
}

impl Easel {
    pub fn new(threads: usize, isa: Isa, scene: SceneName, rate: f64) -> Self {
        Self {
            studio: Studio::new(threads),
            isa,
            scene,
            rate,
            drawn: None,
            picture: Vec::new(),
            exhaustive: Vec::new(),
            has_exhaustive: false,
            trace: FrameTrace::new(0, 0),
            trace_size: Size {
                width: 0,
                height: 0,
            },
            scratch: Vec::new(),
            sight: Sight::default(),
        }
    }

    /// Draws what the controls ask for; false if that is what is there already. With `measure`, says how right it is,
    /// which takes an exhaustive picture.
    pub fn draw(&mut self, controls: &Controls, size: Size, measure: bool) -> bool {
        if self.drawn == Some((*controls, size)) && (self.has_exhaustive || !measure) {
            return false;
        }
        self.drawn = Some((*controls, size));
        let scene = self.scene.at((controls.frame / self.rate) as f32);
        self.picture.resize(size.area(), 0);
        let start = Instant::now();
        let quality = &controls.quality.quality;
        let level = self.isa.level;
        let counts = self
            .studio
            .draw(level, &scene, quality, size.width, &mut self.picture);
        self.sight.time = start.elapsed();
        self.sight.points = counts.points as f64 / size.area() as f64;
        self.has_exhaustive = measure || controls.look == Look::Error;
        if self.has_exhaustive {
            self.compare(&scene, size);
        }
        self.lay_over(&scene, controls, size);
        true
    }

    /// Draws the exhaustive picture, and compares the other one to it.
    fn compare(&mut self, scene: &Scene, size: Size) {
        let (level, quality) = (self.isa.level, &Quality::EXHAUSTIVE);
        self.exhaustive.resize(size.area(), 0);
        self.studio
            .draw(level, scene, quality, size.width, &mut self.exhaustive);
        self.sight.psnr = Difference::between(&self.picture, &self.exhaustive).psnr;
    }

    /// Draws what is to be seen of the frame over it.
    fn lay_over(&mut self, scene: &Scene, controls: &Controls, size: Size) {
        match controls.look {
            Look::Picture => return,
            Look::Error => return draw_error(&mut self.picture, &self.exhaustive, MOST_ERROR),
            Look::Points | Look::Squares | Look::Heat => {}
        }
        if self.trace_size == size {
            self.trace.clear();
        } else {
            self.trace = FrameTrace::new(size.width, size.height);
            self.trace_size = size;
        }
        self.scratch.resize(size.area(), 0);
        let (level, quality) = (self.isa.level, &controls.quality.quality);
        self.studio
            .draw_observed(level, scene, quality, &self.trace, &mut self.scratch);
        match controls.look {
            Look::Points => self.trace.draw_points(&mut self.picture),
            Look::Squares => self.trace.draw_squares(&mut self.picture),
            _ => self.trace.draw_heat(&mut self.picture, MOST_RAYS),
        }
    }
}
