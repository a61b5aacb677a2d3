use super::controls::{Controls, MAX_ERROR, MAX_RAYS, Overlay};
use super::subject::Subject;
use crate::overlay::{draw_error, draw_heat, draw_points, draw_squares};
use eightfold_harness::Size;
use eightfold_harness::error::Difference;
use eightfold_harness::threaded_renderer::ThreadedRenderer;
use eightfold_tracer::{Frame, Probes, presentation::Moment};
use eightfold_window::cpu::Isa;
use std::time::{Duration, Instant};

pub struct FrameViewer {
    renderer: ThreadedRenderer,
    isa: Isa,
    drawn: Option<(Controls, u64, Size)>,
    probes: Probes,
    number: u32,
    pub picture: Vec<u32>,
    pub figures: Figures,
}

#[derive(Clone, Copy, Default)]
pub struct Figures {
    /// Without the overlay.
    pub time: Duration,
    /// Per pixel.
    pub points: f64,
    /// In dB to the exhaustive frame, and half its 95 % interval, 0 if all pixels were compared.
    pub psnr: Option<(f64, f64)>,
}

impl FrameViewer {
    pub fn new(threads: usize, isa: Isa) -> Self {
        Self {
            renderer: ThreadedRenderer::new(threads),
            isa,
            drawn: None,
            probes: Probes::NONE,
            number: 0,
            picture: Vec::new(),
            figures: Figures::default(),
        }
    }

    /// Returns false if nothing changes. For a paused frame, the first call's PSNR is the probes'
    /// estimate; the next call compares all pixels.
    pub fn draw(&mut self, controls: &Controls, subject: &Subject, size: Size) -> bool {
        let wanted = Some((*controls, subject.version, size));
        let is_drawn = self.drawn == wanted;
        if is_drawn && (self.figures.psnr.is_some() || !controls.is_paused) {
            return false;
        }
        let selection = |controls: &Controls| (controls.quality, controls.is_paused);
        let last = self.drawn.map(|(controls, ..)| selection(&controls));
        if last != Some(selection(controls)) {
            self.probes = Probes::NONE;
        }
        self.drawn = wanted;
        let scene = subject.at(controls.time());
        self.picture.resize(size.area(), 0);
        self.number += 1;
        let count = if controls.is_paused { 0 } else { Frame::PROBES };
        self.renderer.set_probes(count, self.number);
        let start = Instant::now();
        let (level, quality) = (self.isa.level, controls.quality.quality());
        let (renderer, width) = (&mut self.renderer, size.width);
        let counts = renderer.draw(level, &scene, quality, width, &mut self.picture);
        let time = start.elapsed();
        renderer.set_probes(0, 0);
        self.probes += counts.probes;
        let [psnr, margin] = [self.probes.psnr(), self.probes.margin()].map(f64::from);
        self.figures = Figures {
            time,
            points: counts.points as f64 / size.area() as f64,
            psnr: (self.probes.squares > 0).then_some((psnr, margin)),
        };
        if self.probes.pixels > Probes::MAX_RECENT {
            self.probes.halve();
        }
        if is_drawn || controls.overlay == Overlay::Error {
            let mut exhaustive = vec![0; size.area()];
            let quality = quality.reference();
            renderer.draw(level, &scene, &quality, width, &mut exhaustive);
            let psnr = Difference::between(&self.picture, &exhaustive).psnr;
            self.figures.psnr = Some((psnr, 0.0));
            if controls.overlay == Overlay::Error {
                draw_error(&mut self.picture, &exhaustive, MAX_ERROR);
            }
        }
        self.draw_trace(&scene, controls, size);
        true
    }

    fn draw_trace(&mut self, scene: &Moment, controls: &Controls, size: Size) {
        if matches!(controls.overlay, Overlay::None | Overlay::Error) {
            return;
        }
        let quality = controls.quality.quality();
        let (_, trace) = self.renderer.trace(self.isa.level, scene, quality, size);
        match controls.overlay {
            Overlay::Points => draw_points(&trace, &mut self.picture),
            Overlay::Squares => draw_squares(&trace, &mut self.picture),
            _ => draw_heat(&trace, &mut self.picture, MAX_RAYS),
        }
    }
}
