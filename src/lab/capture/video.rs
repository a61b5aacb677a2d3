use super::recorder::{Recorder, wav};
use crate::arguments::Exit;
use crate::{interrupt, output};
use anyhow::{Context, Result, ensure};
use eightfold_harness::Size;
use std::fs;
use std::io::{Read, Seek, Write};
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

/// Without `-xerror` ffmpeg reports success if a full disk truncates the end of a file.
const INPUT: &str = "-v error -xerror -nostdin -y -f rawvideo -pixel_format 0rgb";
/// All players support 4:2:0, but guess a missing colour space. Rate factor 16 has no visible loss.
const H264: &str = "-vf scale=out_color_matrix=bt709:out_range=tv -c:v libx264 -crf 16 -pix_fmt yuv420p -colorspace bt709 \
                    -color_primaries bt709 -color_trc bt709 -color_range tv -movflags +faststart";
/// 192 kbit/s has no audible loss.
const AAC: &str = "-map 0:v -map 1:a -c:a aac -b:a 192k";
const WEBP: &str = "-c:v libwebp_anim -quality 70 -loop 0";

pub fn file(name: &str) -> Result<PathBuf, &'static str> {
    let path = PathBuf::from(name);
    let end = path.extension().unwrap_or_default();
    let is_known = ["mp4", "mkv", "webp"].iter().any(|known| end == *known);
    is_known.then_some(path).ok_or("must be a .mp4, .mkv or .webp file")
}

pub fn write(recorder: &mut Recorder<'_>, frames: Range<usize>, name: &Path) -> Result<()> {
    let kind = name.extension().unwrap_or_default();
    let Size { width, height } = recorder.size;
    if kind != "webp" && !(width.is_multiple_of(2) && height.is_multiple_of(2)) {
        let message = format!("--size is {width}x{height}; must be even in .mp4 and .mkv files");
        return Err(Exit::bad_input(message).into());
    }
    let out = output::part(name)?;
    let mut ffmpeg = Command::new("ffmpeg");
    let (size, rate) = (recorder.size.to_string(), recorder.arguments.fps.to_string());
    ffmpeg.args(INPUT.split(' ')).args(["-video_size", &size, "-framerate", &rate, "-i", "-"]);
    let folder = tempfile::tempdir()?;
    if kind == "webp" {
        ffmpeg.args(WEBP.split(' '));
    } else {
        if let Some(sound) = recorder.sound(&frames) {
            let file = folder.path().join("sound.wav");
            fs::write(&file, wav(&sound)).with_context(|| output::cannot("write", &file))?;
            ffmpeg.arg("-i").arg(file).args(AAC.split(' '));
        }
        ffmpeg.args(H264.split_whitespace());
    }
    let mut errors = tempfile::tempfile()?;
    let mut ffmpeg = ffmpeg
        .arg(out.path())
        .stdin(Stdio::piped())
        .stderr(errors.try_clone()?)
        .spawn()
        .context("ffmpeg cannot be started (apt-get install ffmpeg)")?;
    let mut pipe = ffmpeg.stdin.take().expect("a pipe");
    let sent = recorder.draw_each(frames, |_, pixels| {
        let bytes = pixels.iter().flat_map(|pixel| pixel.to_be_bytes());
        Ok(pipe.write_all(&bytes.collect::<Vec<_>>())?)
    });
    drop(pipe);
    if interrupt::is_stopped() {
        let _ = ffmpeg.kill();
    }
    let status = ffmpeg.wait().context("ffmpeg's exit code is unknown")?;
    interrupt::check("the video is missing")?;
    let mut text = String::new();
    errors.rewind()?;
    errors.read_to_string(&mut text)?;
    let is_empty = fs::metadata(out.path()).is_ok_and(|file| file.len() == 0);
    let cause = cause(&text).replace(&out.path().display().to_string(), "the file");
    let error = format!("{}: ffmpeg cannot write: {cause}", name.display());
    ensure!(status.success(), error);
    sent.context("ffmpeg ended early")?;
    ensure!(!is_empty, error);
    output::persist(out, name)
}

/// Returns ffmpeg's first line, the cause of the rest, without the address of its part.
fn cause(text: &str) -> &str {
    let line = text.lines().find(|line| !line.trim().is_empty());
    let line = line.unwrap_or("cause is unknown");
    match line.split_once("] ") {
        Some((part, rest)) if part.starts_with('[') => rest,
        _ => line,
    }
}
