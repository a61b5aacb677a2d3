//! The film: the picture for each frame number.

use super::exposure::Exposure;
use crate::arguments::{NamedQuality, Size};
use crate::interrupt::{self, Stopped};
use crate::picture::Mean;
use crate::rate::Rate;
use crate::scenes::SceneName;
use crate::threaded_renderer::ThreadedRenderer;
use crate::wav;
use anyhow::{Result, bail};
use eightfold::sound::RATE;
use eightfold_tracer::glam::{Vec2, vec2};
use eightfold_tracer::scene::Scene;
use eightfold_window::cpu::Isa;
use std::ops::Range;

/// Everything that determines a frame's pixels, except its number.
pub struct Film {
    pub scene: SceneName,
    pub rate: Rate,
    pub size: Size,
    pub quality: NamedQuality,
    pub samples: Samples,
    pub isa: Isa,
}

/// The pictures of which a frame is the mean.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Samples {
    /// A sample at the centre of each of N by N parts of a pixel, 1 to [`MAX_SUPERSAMPLE`].
    Grid(usize),
    /// Samples over pixel, time, lens and lamps.
    Spread(Exposure),
}

/// The most samples per pixel along each axis: 256 samples give every step of an edge in 8 bits.
pub const MAX_SUPERSAMPLE: usize = 16;

/// The working memory for a picture.
pub struct Canvas {
    renderer: ThreadedRenderer,
    pixels: Vec<u32>,
}

impl Film {
    /// The time of a frame in seconds.
    pub fn time(&self, frame: usize) -> f32 {
        self.rate.time(frame)
    }

    /// The number of frames of the scene.
    pub fn length(&self) -> usize {
        self.rate.frames(self.scene.length())
    }

    /// The sound of a range of frames as a WAV file; `None` if the scene has none.
    ///
    /// # Errors
    /// If the command has to end meanwhile.
    pub fn sound(&self, frames: &Range<usize>) -> Result<Option<Vec<u8>>> {
        let Some(samples) = self.samples(frames) else {
            return Ok(None);
        };
        let record = wav::record(samples);
        if interrupt::is_stopped() {
            bail!(Stopped("no sound is written".to_owned()));
        }
        Ok(Some(wav::wav(&record)))
    }

    /// The range of the soundtrack, in samples, that belongs to a range of frames; `None` if the scene has no sound.
    fn samples(&self, frames: &Range<usize>) -> Option<Range<u32>> {
        let start = (self.scene.start()? * RATE as f32) as u32;
        let position = |frame: usize| {
            let frames = frame as u64 * u64::from(self.rate.den);
            let samples = (frames * u64::from(RATE)).div_ceil(u64::from(self.rate.num));
            start + samples as u32
        };
        Some(position(frames.start)..position(frames.end))
    }

    /// A line that describes a frame: equal lines mean equal pictures.
    ///
    /// AVX2 and AVX-512 draw the same bits. Other instruction sets lack fused multiply-add.
    pub fn describe(&self, frame: usize) -> String {
        let lanes = match self.isa.name {
            "avx512" | "avx2" => "fused",
            other => other,
        };
        let samples = match self.samples {
            Samples::Grid(n) => format!("{n}x{n} samples"),
            Samples::Spread(exposure) => format!("{exposure:?}"),
        };
        format!(
            "eightfold {}: scene {} ({:08x}), frame {frame} at {} fps, {}, {:?}, {samples}, {lanes}",
            env!("CARGO_PKG_VERSION"),
            self.scene,
            self.contents(frame),
            self.rate,
            self.size,
            self.quality.quality,
        )
    }

    /// The checksum of all that the scenes of a frame have in them: several while the shutter is open.
    fn contents(&self, frame: usize) -> u32 {
        let moments = match self.samples {
            Samples::Spread(exposure) if exposure.shutter > 0.0 => exposure.samples,
            _ => 1,
        };
        let still = self.scene.at(self.time(frame));
        let mut hash = crc32fast::Hasher::new();
        for index in 0..moments {
            let (scene, _) = self.picture(frame, index, &still);
            hash.update(format!("{scene:?}").as_bytes());
        }
        hash.finalize()
    }

    /// Draws a frame as `0x00RRGGBB` pixels, row by row: the mean of its pictures as they would be shown.
    ///
    /// The shown colours are linear in the light up to the brightest that can be, so that this is what a camera would gather whose
    /// film clips at every moment; a lamp brighter than white does not outshine what is beside it for the rest of the time.
    pub fn draw<'a>(&self, frame: usize, canvas: &'a mut Canvas) -> &'a [u32] {
        let scene = self.scene.at(self.time(frame));
        let Canvas { renderer, pixels } = canvas;
        pixels.resize(self.size.area(), 0);
        let count = self.pictures();
        let mut mean = Mean::default();
        for index in 0..count {
            let (scene, offset) = self.picture(frame, index, &scene);
            renderer.set_offset(offset.x, offset.y);
            let (quality, width) = (&self.quality.quality, self.size.width);
            renderer.draw(self.isa.level, &scene, quality, width, pixels);
            if count > 1 {
                mean.add(pixels);
            }
        }
        if count > 1 {
            mean.write(pixels);
        }
        pixels
    }

    /// The number of pictures of which a frame is the mean.
    fn pictures(&self) -> usize {
        match self.samples {
            Samples::Grid(n) => n * n,
            Samples::Spread(exposure) => exposure.samples,
        }
    }

    /// The scene of one picture of a frame, which has the scene `still` at its time, and how far its samples are off the pixels'
    /// centres.
    fn picture(&self, frame: usize, index: usize, still: &Scene) -> (Scene, Vec2) {
        match self.samples {
            Samples::Grid(n) => {
                let offset = |part: usize| (part as f32 + 0.5) / n as f32 - 0.5;
                (*still, vec2(offset(index % n), offset(index / n)))
            }
            Samples::Spread(exposure) => {
                let shot = exposure.shot(index);
                let mut scene = if exposure.shutter > 0.0 {
                    let delay = f64::from(shot.delay) / self.rate.hertz();
                    self.scene.at(self.time(frame) + delay as f32)
                } else {
                    *still
                };
                let offset = exposure.aim(&shot, &mut scene, self.size.height);
                (scene, offset)
            }
        }
    }
}

impl Canvas {
    /// Working memory for one thread.
    pub(super) fn new() -> Self {
        Self {
            renderer: ThreadedRenderer::new(1),
            pixels: Vec::new(),
        }
    }
}
