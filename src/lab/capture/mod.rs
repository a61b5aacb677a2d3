//! `lab capture`: writes frames of the show as pictures, a video or a contact sheet, and their sound.

mod exposure;
mod files;
mod film;
mod frame_queue;
mod sheet;
mod video;

use crate::arguments::{self, BadInput, NamedQuality, Part, Size};
use crate::rate::Rate;
use crate::scenes::{self, SceneName};
use crate::{interrupt, output};
use anyhow::{Result, bail};
use clap::{ArgGroup, Args};
use eightfold_tracer::scene::MAX_LENGTH;
use eightfold_window::cpu::{self, Isa};
use exposure::{Exposure, MAX_SAMPLES};
use film::{Film, MAX_SUPERSAMPLE, Samples};
use frame_queue::FrameQueue;
use std::ops::Range;
use std::path::PathBuf;

/// Draws frames of the show: PNG files, a video, or a contact sheet; and makes their sound
///
/// A frame's bytes depend on its number and on the flags that say what is drawn, and not on the machine, the number of
/// threads or the range it is part of. So a long capture can be done in parts, anywhere: see the end of this help.
#[derive(Args)]
#[command(
    group(ArgGroup::new("pictures").args(["png", "video", "sheet"])),
    group(ArgGroup::new("output").required(true).multiple(true).args(["png", "video", "sheet", "audio"])),
    after_long_help = PARTS
)]
pub struct Arguments {
    /// Folder for one PNG file per frame, frame-000000.png and so on; made where it is not there. Frames of this very
    /// capture that are there already, whole, are kept
    #[arg(long, value_name = "FOLDER")]
    png: Option<PathBuf>,
    /// File for a video, .mp4 or .mkv, which ffmpeg makes: H.264, 4:2:0, BT.709, and the soundtrack as AAC; or for a moving
    /// picture without sound, .webp. Width and height have to be even
    #[arg(long, value_name = "FILE", value_parser = video::name)]
    video: Option<PathBuf>,
    /// File for a contact sheet, or - for standard output: a PNG of frames spread evenly over the range, each with its time
    #[arg(long, value_name = "FILE", value_parser = arguments::png_file)]
    sheet: Option<PathBuf>,
    /// File for the sound of the same frames, or - for standard output: WAV, 48 kHz, 32-bit floating point
    #[arg(long, value_name = "FILE")]
    audio: Option<PathBuf>,
    /// Frames on the contact sheet
    #[arg(long, value_name = "N", default_value = "24", value_parser = arguments::frames, conflicts_with_all = ["png", "video"])]
    frames: usize,
    /// The first frame; the scene begins with frame 0
    #[arg(long, value_name = "FRAME", default_value = "0", value_parser = arguments::frame, allow_negative_numbers = true)]
    from: usize,
    /// The frame to end before; beyond the scene's end it means that end [default: the scene's end]
    #[arg(long, value_name = "FRAME", value_parser = arguments::frame, allow_negative_numbers = true)]
    to: Option<usize>,
    /// Part I of N of these frames, such as 1/70: the others are drawn by other processes
    #[arg(long, value_name = "I/N", default_value_t = Part::WHOLE)]
    part: Part,
    /// Frames a second, a whole number or a fraction such as 30000/1001
    #[arg(
        long,
        value_name = "RATE",
        default_value = "60",
        allow_negative_numbers = true
    )]
    fps: Rate,
    /// Width and height of a frame in pixels [default: 1024x768, and 320x240 on a contact sheet]
    #[arg(long, value_name = "WxH")]
    size: Option<Size>,
    #[arg(long, value_name = "NAME", default_value_t = SceneName::Show, help = scenes::takes())]
    scene: SceneName,
    /// How frames are refined: exhaustive, thesis, or one of the ladder, from finest to fastest
    #[arg(long, value_name = "NAME", default_value = "default")]
    quality: NamedQuality,
    /// A pixel is the mean of N by N samples
    #[arg(long, value_name = "N", default_value = "1", value_parser = supersample)]
    supersample: usize,
    #[command(flatten)]
    exposure: ExposureFlags,
    /// Frames drawn at a time
    #[arg(long, value_name = "N", default_value_t = arguments::processors(), value_parser = arguments::threads)]
    threads: usize,
    /// Instruction set; avx2 and avx512 draw the same bits, sse2 others [default: the best of this machine, but not sse2]
    #[arg(long, value_name = "NAME", value_parser = arguments::instruction_set)]
    isa: Option<Isa>,
}

/// How a frame is exposed. Each picture of which a frame is the mean is drawn at another time, from another point of the lens.
#[derive(Args)]
#[command(next_help_heading = "Exposure")]
struct ExposureFlags {
    /// The share of the time between two frames that the shutter is open, 0 to 1: what moves is blurred
    #[arg(long, value_name = "SHARE", value_parser = share, allow_negative_numbers = true)]
    shutter: Option<f32>,
    /// The diameter of the lens in scene units: what is out of focus is blurred
    #[arg(long, value_name = "LENGTH", value_parser = length, allow_negative_numbers = true)]
    aperture: Option<f32>,
    /// The distance in scene units at which things are sharp [default: that of the point that the camera looks at]
    #[arg(long, value_name = "LENGTH", requires = "aperture", value_parser = length, allow_negative_numbers = true)]
    focus: Option<f32>,
    /// Each picture has lamps with a size at other points of it: exact soft shadows, also of blocks
    #[arg(long)]
    sample_lamps: bool,
    /// Pictures of which a frame is the mean, each with samples elsewhere in the pixels [default: 16 with one of the flags above]
    #[arg(long, value_name = "N", conflicts_with = "supersample", value_parser = samples)]
    samples: Option<usize>,
}

/// The pictures of a frame if it is exposed and their number is not given.
const USUAL_SAMPLES: usize = 16;

impl ExposureFlags {
    /// The pictures of a frame, if any of the flags is there.
    fn exposure(&self, supersample: usize) -> Option<Exposure> {
        let spreads = self.shutter.is_some() || self.aperture.is_some() || self.sample_lamps;
        let usual = if supersample > 1 {
            supersample * supersample
        } else {
            USUAL_SAMPLES
        };
        let samples = self.samples.or(spreads.then_some(usual))?;
        Some(Exposure {
            samples,
            shutter: self.shutter.unwrap_or(0.0),
            aperture: self.aperture.unwrap_or(0.0),
            focus: self.focus,
            samples_lamps: self.sample_lamps,
        })
    }
}

/// The part of `--help` about sharing the work.
const PARTS: &str = "\
Parts of a capture, by Slurm on machines that share a folder; docs/lab.md has a line for those that ssh reaches:

    sbatch --array=1-16 --wrap 'target/release/lab capture --png frames --part $SLURM_ARRAY_TASK_ID/16'

Started again, it draws what is missing.

What is made of frames, by ffmpeg:
    ffmpeg -framerate 60 -i frames/frame-%06d.png -vf scale=out_color_matrix=bt709 -pix_fmt yuv420p show.mp4";

/// Runs the command.
pub fn run(arguments: &Arguments) -> Result<()> {
    interrupt::listen();
    let film = film(arguments)?;
    let frames = range(arguments, &film)?;
    if let Some(name) = &arguments.audio
        && let Some(sound) = film.sound(&frames)?
    {
        output::write(name, &sound)?;
    }
    let queue = FrameQueue {
        film: &film,
        threads: arguments.threads,
    };
    if let Some(folder) = &arguments.png {
        files::write(&queue, frames, folder)
    } else if let Some(name) = &arguments.video {
        video::write(&queue, frames, name)
    } else if let Some(name) = &arguments.sheet {
        sheet::write(&queue, frames, arguments.frames, name)
    } else {
        // Only the sound was asked for.
        Ok(())
    }
}

fn film(arguments: &Arguments) -> Result<Film> {
    let usual = if arguments.sheet.is_some() {
        Size::new(320, 240)
    } else {
        Size::new(1024, 768)
    };
    let size = arguments.size.unwrap_or(usual);
    if arguments.video.is_some() && !(size.width | size.height).is_multiple_of(2) {
        bail!(BadInput(format!(
            "--size {size} takes an even width and height for --video"
        )));
    }
    if arguments.audio.is_some() && arguments.scene.start().is_none() {
        let scene = arguments.scene;
        bail!(BadInput(format!(
            "--audio takes --scene show or one of its scenes: nothing is played to {scene}"
        )));
    }
    let outputs = [&arguments.sheet, &arguments.audio];
    if outputs.map(|name| name.as_ref().is_some_and(|name| name == "-")) == [true, true] {
        bail!(BadInput(
            "--audio - takes standard output for itself".into(),
        ));
    }
    Ok(Film {
        scene: arguments.scene,
        rate: arguments.fps,
        size,
        quality: arguments.quality,
        samples: arguments
            .exposure
            .exposure(arguments.supersample)
            .map_or(Samples::Grid(arguments.supersample), Samples::Spread),
        isa: arguments.isa.map_or_else(usual_isa, Ok)?,
    })
}

/// The default instruction set: the best one, if it draws the same bits as those of other machines.
fn usual_isa() -> Result<Isa> {
    let best = cpu::best();
    if best.name == "sse2" {
        bail!(BadInput(
            "--isa takes sse2 on this machine: it has no AVX2, and draws frames that differ in a few last bits".into(),
        ));
    }
    Ok(best)
}

/// The range of frames to draw, which is not empty: all that are asked for, or a part of them.
fn range(arguments: &Arguments, film: &Film) -> Result<Range<usize>> {
    let length = film.length();
    let (from, to) = (arguments.from, arguments.to.unwrap_or(length).min(length));
    if from >= length {
        bail!(BadInput(format!(
            "--from {from} takes a frame of {}: at {} fps, 0 to {}",
            film.scene,
            film.rate,
            length - 1
        )));
    }
    if from >= to {
        bail!(BadInput(format!(
            "--to {to} takes a frame behind --from {from}"
        )));
    }
    arguments.part.check(to - from, "frames")?;
    Ok(arguments.part.range(&(from..to)))
}

/// Parses the number of samples per pixel along each axis.
fn supersample(text: &str) -> Result<usize, String> {
    arguments::number(text, MAX_SUPERSAMPLE)
}

/// Parses a number of pictures.
fn samples(text: &str) -> Result<usize, String> {
    arguments::number(text, MAX_SAMPLES)
}

/// Parses a share.
fn share(text: &str) -> Result<f32, String> {
    let is_share = |share: &f32| (0.0..=1.0).contains(share);
    arguments::parsed(text, is_share, "a share from 0 to 1, such as 0.5")
}

/// Parses a length above 0.
fn length(text: &str) -> Result<f32, String> {
    let is_length = |&length: &f32| length > 0.0 && length <= MAX_LENGTH;
    arguments::parsed(text, is_length, "a length in scene units, above 0")
}
