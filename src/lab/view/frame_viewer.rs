//! Draws the frame to look at, with an overlay, and measures it.

use super::controls::{Controls, MOST_ERROR, MOST_RAYS, Overlay};
use crate::arguments::Size;
use crate::error::Difference;
use crate::overlay::{FrameTrace, draw_error};
use crate::threaded_renderer::ThreadedRenderer;
use eightfold_tracer::Quality;
use eightfold_tracer::scene::Scene;
use eightfold_window::cpu::Isa;
use std::time::{Duration, Instant};

/// The memory and threads to draw with, and the last frame.
pub struct FrameViewer {
    renderer: ThreadedRenderer,
    isa: Isa,
    /// The selection that the picture was drawn for.
    drawn: Option<(Controls, [u64; 2], Size)>,
    pub picture: Vec<u32>,
    /// The exhaustive frame of the same moment.
    exhaustive: Vec<u32>,
    /// Whether `exhaustive` has been drawn for this picture.
    has_exhaustive: bool,
    pub figures: Figures,
}

/// The measurements of the picture.
#[derive(Clone, Copy, Default)]
pub struct Figures {
    /// The time to draw it, without the overlay.
    pub time: Duration,
    /// The number of traced points per pixel.
    pub points: f64,
    /// The PSNR against the exhaustive frame, in dB.
    pub psnr: f64,
}

impl FrameViewer {
    pub fn new(threads: usize, isa: Isa) -> Self {
        Self {
            renderer: ThreadedRenderer::new(threads),
            isa,
            drawn: None,
            picture: Vec::new(),
            exhaustive: Vec::new(),
            has_exhaustive: false,
            figures: Figures::default(),
        }
    }

    /// Draws the frame of a scene that the controls select; `version` is another one for another scene. Returns false if it is the
    /// same as before. With `measure` it measures the error, which takes an exhaustive frame.
    pub fn draw(
        &mut self,
        controls: &Controls,
        version: [u64; 2],
        scene: impl FnOnce() -> Scene,
        size: Size,
        measure: bool,
    ) -> bool {
        let wanted = Some((*controls, version, size));
        if self.drawn == wanted && (self.has_exhaustive || !measure) {
            return false;
        }
        self.drawn = wanted;
        let scene = scene();
        self.picture.resize(size.area(), 0);
        let start = Instant::now();
        let quality = &controls.quality.quality;
        let level = self.isa.level;
        let counts = self
            .renderer
            .draw(level, &scene, quality, size.width, &mut self.picture);
        self.figures.time = start.elapsed();
        self.figures.points = counts.points as f64 / size.area() as f64;
        self.has_exhaustive = measure || controls.overlay == Overlay::Error;
        if self.has_exhaustive {
            self.compare(&scene, &quality.reference(), size);
        }
        self.draw_overlay(&scene, controls, size);
        true
    }

    /// Draws the exhaustive frame and measures the picture's error.
    fn compare(&mut self, scene: &Scene, quality: &Quality, size: Size) {
        let level = self.isa.level;
        self.exhaustive.resize(size.area(), 0);
        self.renderer
            .draw(level, scene, quality, size.width, &mut self.exhaustive);
        self.figures.psnr = Difference::between(&self.picture, &self.exhaustive).psnr;
    }

    /// Draws the overlay.
    fn draw_overlay(&mut self, scene: &Scene, controls: &Controls, size: Size) {
        match controls.overlay {
            Overlay::None => return,
            Overlay::Error => return draw_error(&mut self.picture, &self.exhaustive, MOST_ERROR),
            Overlay::Points | Overlay::Squares | Overlay::Heat => {}
        }
        // Drawn anew, with what tells how, and not shown.
        let trace = FrameTrace::new(size.width, size.height);
        let mut pixels = vec![0; size.area()];
        let (level, quality) = (self.isa.level, &controls.quality.quality);
        self.renderer
            .draw_observed(level, scene, quality, size.width, &mut pixels, &trace);
        match controls.overlay {
            Overlay::Points => trace.draw_points(&mut self.picture),
            Overlay::Squares => trace.draw_squares(&mut self.picture),
            _ => trace.draw_heat(&mut self.picture, MOST_RAYS),
        }
    }
}
