//! Writes frames and their sound as a video, with ffmpeg.

use super::film::Film;
use super::frame_queue::FrameQueue;
use crate::interrupt::{self, Stopped};
use crate::output::{self, Part};
use crate::progress;
use anyhow::{Context, Error, Result, anyhow, bail};
use std::io::{self, Read, Write};
use std::ops::Range;
use std::os::unix::process::CommandExt;
use std::path::{Path, PathBuf};
use std::process::{Child, ChildStderr, ChildStdin, Command, Stdio};
use std::thread;

/// The extensions of containers in which all players support H.264, and of the animated pictures that pages show.
const SUFFIXES: [&str; 3] = [".mp4", ".mkv", WEBP];
const WEBP: &str = ".webp";

/// Parses a file name with one of these extensions.
pub fn name(text: &str) -> Result<PathBuf, String> {
    suffix(text)
        .map(|_| text.into())
        .ok_or_else(|| format!("takes a file name that ends in {}", SUFFIXES.join(", ")))
}

fn suffix(name: &str) -> Option<&'static str> {
    SUFFIXES.into_iter().find(|suffix| name.ends_with(suffix))
}

/// Writes a video.
pub fn write(queue: &FrameQueue<'_>, frames: Range<usize>, name: &Path) -> Result<()> {
    let suffix = suffix(&name.to_string_lossy()).unwrap_or(SUFFIXES[0]);
    let file = output::start_for_another(name, suffix)?;
    let is_animated_picture = suffix == WEBP;
    // The file has to exist until ffmpeg has read it.
    let sound = if is_animated_picture {
        None
    } else {
        sound(queue.film, &frames)?
    };
    let codec: &[&str] = if is_animated_picture {
        &ANIMATED_WEBP
    } else {
        &H264
    };
    let heard = sound.as_ref().map(Part::path);
    let mut ffmpeg = start(queue.film, codec, heard, file.path())?;
    let complaints = ffmpeg.stderr.take().expect("a pipe was asked for");
    let complaints = thread::spawn(move || last_line(complaints));
    let mut pipe = ffmpeg.stdin.take().expect("a pipe was asked for");
    // A signal ends ffmpeg, whatever it is at: so neither writing to it nor waiting for it lasts longer than that.
    let ended = thread::spawn(move || interrupt::wait(&mut ffmpeg));
    let sent = send(queue, frames, &mut pipe);
    drop(pipe);
    let ended = ended.join().expect("waiting does not panic");
    let complaint = complaints.join().unwrap_or_default();
    if interrupt::is_stopped() {
        bail!(Stopped("no video is written".to_owned()));
    }
    // ffmpeg reports success even if a full disk cuts off the end of the file.
    if !ended.context("ffmpeg is lost")?.success() || complaint.is_some() {
        let complaint = complaint.as_deref().unwrap_or("it does not say why");
        let (part, shown) = (file.path().display().to_string(), name.display());
        let complaint = complaint.replace(&part, &shown.to_string());
        bail!("ffmpeg cannot write {shown}: {complaint}");
    }
    sent.with_context(|| format!("ffmpeg ended before {} was complete", name.display()))?;
    output::persist(file, name).with_context(|| format!("cannot write {}", name.display()))
}

/// Draws frames, and writes the bytes of their pixels.
fn send(queue: &FrameQueue<'_>, frames: Range<usize>, pipe: &mut ChildStdin) -> Result<()> {
    let bar = progress::bar(frames.len());
    let frames: Vec<usize> = frames.collect();
    let bytes = |_, pixels: &[u32]| {
        let bytes = pixels.iter().flat_map(|pixel| pixel.to_be_bytes());
        Ok(bytes.collect::<Vec<u8>>())
    };
    let done = queue.draw(&frames, bytes, |bytes| {
        pipe.write_all(&bytes)?;
        bar.inc(1);
        Ok(())
    });
    bar.finish_and_clear();
    done
}

/// A temporary file with the sound of a range of frames.
fn sound(film: &Film, frames: &Range<usize>) -> Result<Option<Part>> {
    let Some(bytes) = film.sound(frames)? else {
        return Ok(None);
    };
    let write = || {
        let mut file = Part::passing(".wav")?;
        file.write_all(&bytes)?;
        io::Result::Ok(file)
    };
    write().map(Some).context("cannot write the sound")
}

/// H.264 in 4:2:0, which all players support, labelled with its colour space, which players would otherwise guess. At a rate factor
/// of 16 no loss is visible.
#[rustfmt::skip]
const H264: [&str; 18] = [
    "-vf", "scale=out_color_matrix=bt709:out_range=tv",
    "-c:v", "libx264", "-crf", "16", "-pix_fmt", "yuv420p",
    "-colorspace", "bt709", "-color_primaries", "bt709", "-color_trc", "bt709", "-color_range", "tv",
    "-movflags", "+faststart",
];

/// An animated picture that repeats. At a quality of 70 out of 100 the loss is hardly visible in motion.
const ANIMATED_WEBP: [&str; 6] = ["-c:v", "libwebp_anim", "-quality", "70", "-loop", "0"];

/// Starts ffmpeg. It reads the bytes of pixels from its standard input, and the sound from a file. At 192 kbit/s of AAC no loss is
/// audible.
fn start(film: &Film, codec: &[&str], sound: Option<&Path>, out: &Path) -> Result<Child> {
    let (size, rate) = (film.size.to_string(), film.rate.to_string());
    let mut ffmpeg = Command::new("ffmpeg");
    ffmpeg
        .args(["-hide_banner", "-loglevel", "error", "-nostdin", "-y"])
        .args(["-f", "rawvideo", "-pixel_format", "0rgb"])
        .args(["-video_size", &size, "-framerate", &rate, "-i", "-"]);
    if let Some(sound) = sound {
        let inputs = ["-map", "0:v", "-map", "1:a"];
        let codec = ["-c:a", "aac", "-b:a", "192k"];
        ffmpeg.arg("-i").arg(sound).args(inputs).args(codec);
    }
    ffmpeg
        .args(codec)
        .arg(out)
        // What a terminal sends on Ctrl-C goes to the lab alone, which ends ffmpeg.
        .process_group(0)
        .stdin(Stdio::piped())
        .stdout(Stdio::null())
        .stderr(Stdio::piped())
        .spawn()
        .map_err(explain)
}

/// The error for a failed start of ffmpeg, with advice.
fn explain(error: io::Error) -> Error {
    if error.kind() == io::ErrorKind::NotFound {
        anyhow!(
            "--video needs ffmpeg, which is not installed: get it by `sudo apt-get install ffmpeg` or from \
             https://ffmpeg.org/download.html, or write files by --png"
        )
    } else {
        Error::new(error).context("cannot start ffmpeg")
    }
}

/// The last line of ffmpeg's messages, if there are any. At its log level these are errors.
fn last_line(mut complaints: ChildStderr) -> Option<String> {
    let mut text = Vec::new();
    let _ = complaints.read_to_end(&mut text);
    let text = String::from_utf8_lossy(&text);
    let last = text.lines().rfind(|line| !line.trim().is_empty());
    last.map(|line| line.trim().to_owned())
}
