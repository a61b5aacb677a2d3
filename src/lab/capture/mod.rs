//! `lab capture`: draws frames as PNG files, a video or a contact sheet, and writes their sound.

mod film;
mod video;

use crate::arguments::{self, BadInput, NamedQuality, Size};
use crate::scenes::{self, SceneName};
use crate::sheet::{Tile, sheet};
use crate::{interrupt, output, picture, wav};
use anyhow::{Context, Result, ensure};
use clap::{ArgGroup, Args};
use eightfold_tracer::scene::MAX_LENGTH;
use film::Film;
use std::fs;
use std::ops::Range;
use std::path::{Path, PathBuf};

/// Draws frames of the show as PNG files, a video or a contact sheet, and writes their sound
///
/// The bytes of a frame depend on its number and the flags, and neither on the number of threads nor on the range; AVX2 and AVX-512
/// draw the same. Several machines can therefore draw ranges of a long capture.
#[derive(Args)]
#[command(
    group(ArgGroup::new("pictures").args(["png", "video", "sheet"])),
    group(ArgGroup::new("output").required(true).multiple(true).args(["png", "video", "sheet", "audio"]))
)]
pub struct Arguments {
    /// Folder for one PNG file per frame: frame-000000.png and so on
    #[arg(long, value_name = "FOLDER")]
    png: Option<PathBuf>,
    /// File for a video with sound, by ffmpeg: .mp4 or .mkv; or for an animated picture: .webp
    #[arg(long, value_name = "FILE")]
    video: Option<PathBuf>,
    /// File for a contact sheet, or - for standard output: a PNG file of frames at even intervals, with their times
    #[arg(long, value_name = "FILE", value_parser = arguments::png_file)]
    sheet: Option<PathBuf>,
    /// File for the sound of the same frames, or - for standard output: WAV, 48 kHz, 32-bit floating point
    #[arg(long, value_name = "FILE")]
    audio: Option<PathBuf>,
    /// Frames on the contact sheet
    #[arg(long, value_name = "N", default_value = "24", value_parser = arguments::frames, conflicts_with_all = ["png", "video"])]
    frames: usize,
    /// The first frame; the scene begins with frame 0
    #[arg(long, value_name = "FRAME", default_value = "0", value_parser = arguments::frame)]
    from: usize,
    /// The frame after the last [default: the scene's end]
    #[arg(long, value_name = "FRAME", value_parser = arguments::frame)]
    to: Option<usize>,
    /// Frames per second
    #[arg(long, value_name = "N", default_value_t = 60, value_parser = clap::value_parser!(u32).range(1..=1000))]
    fps: u32,
    /// Width and height of a frame in pixels [default: 1024x768, and 320x240 on a contact sheet]
    #[arg(long, value_name = "WxH")]
    size: Option<Size>,
    #[arg(long, value_name = "NAME", default_value_t = SceneName::Show, help = scenes::takes())]
    scene: SceneName,
    /// How frames are refined: exhaustive, thesis, or one of the ladder, from finest to fastest
    #[arg(long, value_name = "NAME", default_value = "default")]
    quality: NamedQuality,
    /// A frame is the mean of N by N pictures, with samples in other places of the pixels [default: 1; 4 with a flag below]
    #[arg(long, value_name = "N", value_parser = supersample)]
    supersample: Option<usize>,
    /// The share of the time between two frames that the shutter is open, 0 to 1: the pictures of a frame show different times
    #[arg(long, value_name = "SHARE", default_value = "0", value_parser = share)]
    shutter: f32,
    /// The diameter of the lens in scene units: the pictures of a frame are seen from different points of it. The point that the
    /// camera looks at is in focus
    #[arg(long, value_name = "LENGTH", default_value = "0", value_parser = length)]
    aperture: f32,
}

/// Runs the command.
pub fn run(arguments: &Arguments) -> Result<()> {
    let frames = range(arguments)?;
    let mut film = Film::new(arguments);
    interrupt::listen();
    if let Some(name) = &arguments.audio {
        let sound = film.sound(&frames);
        let scene = arguments.scene;
        let sound = sound.ok_or_else(|| BadInput(format!("--audio: {scene} has no sound")))?;
        output::write(name, &wav::wav(&sound))?;
    }
    if let Some(folder) = &arguments.png {
        write_files(&mut film, frames, folder)
    } else if let Some(name) = &arguments.video {
        video::write(&mut film, frames, name)
    } else if let Some(name) = &arguments.sheet {
        write_sheet(&mut film, &frames, arguments.frames, name)
    } else {
        Ok(())
    }
}

/// Returns the range of frames to draw, which is not empty. It ends with the scene.
fn range(arguments: &Arguments) -> Result<Range<usize>> {
    let length = (arguments.scene.length() * arguments.fps as f32).ceil() as usize;
    let (from, to) = (arguments.from, arguments.to.unwrap_or(length).min(length));
    let what =
        format!("--from {from} --to {to} is an empty range; the scene has frames 0 to {length}");
    ensure!(from < to, BadInput(what));
    Ok(from..to)
}

/// Writes one PNG file per frame. Numbers have six digits: sorting by name sorts by number.
fn write_files(film: &mut Film, frames: Range<usize>, folder: &Path) -> Result<()> {
    fs::create_dir_all(folder).with_context(|| format!("cannot make {}", folder.display()))?;
    let width = film.size.width;
    film.draw_each(frames, |frame, pixels| {
        let path = folder.join(format!("frame-{frame:06}.png"));
        output::write(&path, &picture::png(width, pixels)?)
    })
}

/// Writes a sheet of `count` frames, each from the middle of an equal part of the range.
fn write_sheet(film: &mut Film, range: &Range<usize>, count: usize, name: &Path) -> Result<()> {
    output::check(name)?;
    let frames = (0..count).map(|i| range.start + (2 * i + 1) * range.len() / (2 * count));
    let (fps, mut tiles) = (film.fps, Vec::new());
    film.draw_each(frames, |frame, pixels| {
        tiles.push(Tile {
            pixels: pixels.to_vec(),
            caption: format!("{:.2} s", frame as f64 / f64::from(fps)),
        });
        Ok(())
    })?;
    output::write(name, &sheet(film.size, columns(count), &tiles)?)
}

/// Returns the number of columns for `count` tiles: from as many columns as rows to twice that, with the fewest empty places.
fn columns(count: usize) -> usize {
    let least = (count as f64).sqrt().ceil() as usize;
    let empty = |&columns: &usize| count.next_multiple_of(columns) - count;
    (least..=2 * least).min_by_key(empty).unwrap_or(1)
}

/// Parses the number of pictures per frame along each axis: 256 in all show every step of an edge in 8 bits.
fn supersample(text: &str) -> Result<usize, String> {
    arguments::number(text, 16)
}

/// Parses a share.
fn share(text: &str) -> Result<f32, String> {
    let is_share = |share: &f32| (0.0..=1.0).contains(share);
    arguments::parsed(text, is_share, "a share from 0 to 1, such as 0.5")
}

/// Parses a length.
fn length(text: &str) -> Result<f32, String> {
    let is_length = |length: &f32| (0.0..=MAX_LENGTH).contains(length);
    arguments::parsed(text, is_length, "a length in scene units, from 0")
}
