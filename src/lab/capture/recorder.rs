use super::Arguments;
use crate::arguments::processors;
use crate::interrupt;
use crate::progress::Progress;
use anyhow::Result;
use eightfold::sound::{RATE, Synthesizer};
use eightfold_harness::Size;
use eightfold_harness::picture::Mean;
use eightfold_harness::threaded_renderer::ThreadedRenderer;
use eightfold_tracer::glam::{Vec2, vec2};
use eightfold_tracer::scene::Camera;
use eightfold_window::cpu;
use std::f32::consts::TAU;
use std::ops::Range;

const BLURRED: usize = 4;

pub struct Recorder<'a> {
    pub arguments: &'a Arguments,
    pub size: Size,
    /// Samples per pixel along each axis.
    supersample: usize,
    renderer: ThreadedRenderer,
    pixels: Vec<u32>,
}

impl<'a> Recorder<'a> {
    pub fn new(arguments: &'a Arguments) -> Self {
        let default = match arguments.sheet {
            Some(_) => Size::new(320, 240),
            None => Size::new(1024, 768),
        };
        let size = arguments.size.unwrap_or(default);
        let is_blurred = arguments.shutter > 0.0 || arguments.aperture > 0.0;
        let default = if is_blurred { BLURRED } else { 1 };
        Self {
            arguments,
            size,
            supersample: arguments.supersample.unwrap_or(default),
            renderer: ThreadedRenderer::new(processors()),
            pixels: vec![0; size.area()],
        }
    }

    /// Draws frames in order until Ctrl-C or an error of `take`.
    pub fn draw_each(
        &mut self,
        frames: impl ExactSizeIterator<Item = usize>,
        mut take: impl FnMut(usize, &[u32]) -> Result<()>,
    ) -> Result<()> {
        let bar = Progress::new(frames.len());
        for frame in frames {
            let pixels = self.draw(frame);
            interrupt::check("the frames are incomplete")?;
            take(frame, pixels)?;
            bar.inc(1);
        }
        Ok(())
    }

    fn draw(&mut self, frame: usize) -> &[u32] {
        let (arguments, n) = (self.arguments, self.supersample);
        let mut mean = Mean::default();
        for i in 0..n * n {
            // A low-discrepancy sequence, independent of the pixel (Roberts, "The unreasonable
            // effectiveness of quasirandom sequences", 2018).
            let spread = |step: f32| (0.5 + i as f32 * step).fract();
            let delay = arguments.shutter * spread(0.618_034);
            let time = (frame as f64 + f64::from(delay)) / f64::from(arguments.fps);
            let mut moment = arguments.scene.at(time as f32);
            let lens = spread(0.754_877_7).sqrt() * Vec2::from_angle(TAU * spread(0.569_840_3));
            let shift = self.move_camera(&mut moment.scene.camera, 0.5 * arguments.aperture * lens);
            let place = |part: usize| (part as f32 + 0.5) / n as f32 - 0.5;
            let offset = shift + vec2(place(i % n), place(i / n));
            self.renderer.set_offset(offset.x, offset.y);
            let (level, width) = (cpu::best().level, self.size.width);
            let quality = arguments.quality.quality();
            self.renderer.draw(level, &moment, quality, width, &mut self.pixels);
            mean.add(&self.pixels);
        }
        mean.write(&mut self.pixels);
        &self.pixels
    }

    /// Moves the camera on its lens. Returns the offset in pixels that keeps the focus in place.
    fn move_camera(&self, camera: &mut Camera, lens: Vec2) -> Vec2 {
        let sight = camera.look_at - camera.eye;
        let forward = sight.normalize();
        let right = forward.cross(camera.up).normalize();
        let by = lens.x * right + lens.y * right.cross(forward);
        camera.eye += by;
        camera.look_at += by;
        let pixel = camera.pixel(self.size.width, self.size.height);
        // Rows count down; the lens' second axis is up.
        vec2(-lens.x, lens.y) / (sight.length() * pixel)
    }

    /// Returns `None` outside the show.
    pub fn sound(&self, frames: &Range<usize>) -> Option<Vec<[f32; 2]>> {
        let start = (self.arguments.scene.start()? * RATE as f32) as u32;
        let fps = u64::from(self.arguments.fps);
        let samples = |frame: usize| (frame as u64 * u64::from(RATE)).div_ceil(fps);
        let position = |frame| start + samples(frame) as u32;
        Some(record(position(frames.start)..position(frames.end)))
    }
}

/// Bytes per stereo sample.
const FRAME: u32 = 8;

pub fn record(range: Range<u32>) -> Vec<[f32; 2]> {
    let mut synthesizer = Box::<Synthesizer>::default();
    let mut samples = vec![[0.0; 2]; range.len()];
    synthesizer.seek(range.start);
    synthesizer.play(&mut samples);
    samples
}

/// 48 kHz, 32-bit floating point.
pub fn wav(samples: &[[f32; 2]]) -> Vec<u8> {
    let size = samples.len() as u32 * FRAME;
    // Format 3 is floating point.
    let (format, channels) = (3, 2);
    let header = [
        u32::from_le_bytes(*b"RIFF"),
        36 + size,
        u32::from_le_bytes(*b"WAVE"),
        u32::from_le_bytes(*b"fmt "),
        16,
        format | channels << 16,
        RATE,
        RATE * FRAME,
        FRAME | (8 * FRAME / channels) << 16,
        u32::from_le_bytes(*b"data"),
        size,
    ];
    let header = header.into_iter().flat_map(u32::to_le_bytes);
    let samples = samples.iter().flatten();
    header.chain(samples.flat_map(|sample| sample.to_le_bytes())).collect()
}
