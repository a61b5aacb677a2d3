//! `cargo lab capture`: writes frames and sound as files.

mod recorder;
mod video;

use crate::arguments::{self, Exit, within};
use crate::bitmap::{Tile, sheet};
use crate::scenes::{self, SceneName};
use crate::{interrupt, output};
use anyhow::{Context, Result, ensure};
use clap::{ArgGroup, Args};
use eightfold_harness::{Size, picture};
use eightfold_tracer::Preset;
use eightfold_tracer::scene::MAX_LENGTH;
use recorder::Recorder;
pub use recorder::{record, wav};
use std::fs;
use std::ops::{Range, RangeInclusive};
use std::path::{Path, PathBuf};

/// Draws frames as PNG files, a video or a contact sheet, and writes the show's sound
#[derive(Args)]
#[command(
    group(ArgGroup::new("pictures").args(["png", "video", "sheet"])),
    group(ArgGroup::new("output").required(true).multiple(true).args(["png", "video", "sheet", "audio"]))
)]
pub struct Arguments {
    /// Folder for frame-000000.png, frame-000001.png and so on
    #[arg(long, value_name = "FOLDER")]
    png: Option<PathBuf>,
    /// Animation (.webp) or video with the show's sound (.mp4, .mkv), by ffmpeg
    #[arg(long, value_name = "FILE", value_parser = video::file)]
    video: Option<PathBuf>,
    /// PNG contact sheet of evenly spaced frames with their times, or - for standard output
    #[arg(long, value_name = "FILE", value_parser = arguments::png_file)]
    sheet: Option<PathBuf>,
    /// WAV file of the sound, 48 kHz, 32-bit floating point, or - for standard output
    #[arg(long, value_name = "FILE")]
    audio: Option<PathBuf>,
    /// Frames on the contact sheet
    #[arg(long, value_name = "N", default_value = "24", value_parser = within(arguments::FRAMES), conflicts_with_all = ["png", "video"])]
    frames: usize,
    /// First frame
    #[arg(long, value_name = "FRAME", default_value = "0", value_parser = within(FRAME))]
    from: usize,
    /// End of the frame range, exclusive [default: the scene's end]
    #[arg(long, value_name = "FRAME", value_parser = within(arguments::FRAMES))]
    to: Option<usize>,
    /// Frames per second
    #[arg(long, value_name = "N", default_value = "60", value_parser = within(1..=1000_u32))]
    fps: u32,
    /// Width and height of a frame in pixels [default: 1024x768, or 320x240 on a contact sheet]
    #[arg(long, value_name = "WxH")]
    size: Option<Size>,
    #[arg(long, value_name = "NAME", default_value_t = SceneName::Show, help = scenes::names())]
    scene: SceneName,
    #[arg(long, value_name = "NAME", default_value = "default", help = arguments::QUALITY)]
    quality: Preset,
    /// NxN samples a pixel [default: 1; 4 with --shutter or --aperture]
    #[arg(long, value_name = "N", value_parser = within(1..=MAX_SUPERSAMPLE))]
    supersample: Option<usize>,
    /// Motion blur: the fraction of a frame's time with an open shutter, 0 to 1
    #[arg(long, value_name = "FRACTION", default_value = "0", value_parser = within(0.0..=1.0_f32))]
    shutter: f32,
    /// Depth of field: the diameter of the lens in scene units; the camera's target is in focus
    #[arg(long, value_name = "LENGTH", default_value = "0", value_parser = within(0.0..=MAX_LENGTH))]
    aperture: f32,
}

const FRAME: RangeInclusive<usize> = 0..=*arguments::FRAMES.end();
/// 16x16 samples, for the 256 levels of a channel.
const MAX_SUPERSAMPLE: usize = 16;

pub fn run(arguments: &Arguments) -> Result<()> {
    let frames = range(arguments)?;
    let mut recorder = Recorder::new(arguments);
    interrupt::listen();
    if let Some(name) = &arguments.audio {
        let sound = recorder.sound(&frames);
        let scene = arguments.scene;
        let message = format!("--scene is {scene}; with --audio, must be show or show:NAME");
        let sound = sound.ok_or_else(|| Exit::bad_input(message))?;
        output::write(name, &wav(&sound))?;
    }
    if let Some(folder) = &arguments.png {
        write_files(&mut recorder, frames, folder)
    } else if let Some(name) = &arguments.video {
        video::write(&mut recorder, frames, name)
    } else if let Some(name) = &arguments.sheet {
        write_sheet(&mut recorder, &frames, name)
    } else {
        Ok(())
    }
}

fn range(arguments: &Arguments) -> Result<Range<usize>> {
    let length = (arguments.scene.length() * arguments.fps as f32).ceil() as usize;
    let (from, to) = (arguments.from, arguments.to.unwrap_or(length).min(length));
    let range = format!("--from is {from}; must be below {to}, the end");
    ensure!(from < to, Exit::bad_input(range));
    Ok(from..to)
}

fn write_files(recorder: &mut Recorder<'_>, frames: Range<usize>, folder: &Path) -> Result<()> {
    fs::create_dir_all(folder).with_context(|| output::cannot("make", folder))?;
    let width = recorder.size.width;
    recorder.draw_each(frames, |frame, pixels| {
        // Padded: names of 1,000,000 frames sort in order.
        let path = folder.join(format!("frame-{frame:06}.png"));
        output::write(&path, &picture::png(width, pixels)?)
    })
}

/// Shows the middle frame of each of equal parts.
fn write_sheet(recorder: &mut Recorder<'_>, range: &Range<usize>, name: &Path) -> Result<()> {
    output::check(name)?;
    let Arguments { fps, frames, .. } = *recorder.arguments;
    let middle = |i| range.start + (2 * i + 1) * range.len() / (2 * frames);
    let mut tiles = Vec::new();
    recorder.draw_each((0..frames).map(middle), |frame, pixels| {
        tiles.push(Tile {
            pixels: pixels.to_vec(),
            caption: format!("{:.2} s", frame as f64 / f64::from(fps)),
        });
        Ok(())
    })?;
    output::write(name, &sheet(recorder.size, columns(frames), &tiles)?)
}

/// Returns the column count, from ceil(sqrt(`count`)) to twice that, with the fewest empty places.
fn columns(count: usize) -> usize {
    let min = (count as f64).sqrt().ceil() as usize;
    let empty = |&columns: &usize| count.next_multiple_of(columns) - count;
    (min..=2 * min).min_by_key(empty).unwrap_or(1)
}
