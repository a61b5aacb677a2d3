//! Writes frames and their sound as a video, by ffmpeg.

use super::film::Film;
use crate::interrupt::{self, Stopped};
use crate::{output, wav};
use anyhow::{Context, Result, ensure};
use std::fs;
use std::io::{Read, Seek, Write};
use std::ops::Range;
use std::path::Path;
use std::process::{Command, Stdio};

/// H.264 in 4:2:0, which all players support, labelled with its colour space, which players would otherwise guess. No loss is visible
/// at a rate factor of 16.
const H264: &str = "-vf scale=out_color_matrix=bt709:out_range=tv -c:v libx264 -crf 16 -pix_fmt yuv420p -colorspace bt709 \
                    -color_primaries bt709 -color_trc bt709 -color_range tv -movflags +faststart";
/// AAC. No loss is audible at 192 kbit/s.
const AAC: &str = "-map 0:v -map 1:a -c:a aac -b:a 192k";
/// An animated picture that repeats.
const WEBP: &str = "-c:v libwebp_anim -quality 70 -loop 0";

/// Pipes frames to ffmpeg, and gives the file its name once it is complete.
pub fn write(film: &mut Film, frames: Range<usize>, name: &Path) -> Result<()> {
    let kind = name.extension().unwrap_or_default();
    let out = output::part(name)?;
    let mut ffmpeg = Command::new("ffmpeg");
    let (size, rate) = (film.size.to_string(), film.fps.to_string());
    ffmpeg
        .args([
            "-v",
            "error",
            "-nostdin",
            "-y",
            "-f",
            "rawvideo",
            "-pixel_format",
            "0rgb",
        ])
        .args(["-video_size", &size, "-framerate", &rate, "-i", "-"]);
    // The folder has to exist until ffmpeg has read it.
    let folder = tempfile::tempdir()?;
    if kind == "webp" {
        ffmpeg.args(WEBP.split(' '));
    } else {
        if let Some(sound) = film.sound(&frames) {
            let file = folder.path().join("sound.wav");
            fs::write(&file, wav::wav(&sound)).context("cannot write the sound")?;
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
        .context("--video needs ffmpeg (apt-get install ffmpeg)")?;
    let mut pipe = ffmpeg.stdin.take().expect("a pipe");
    let sent = film.draw_each(frames, |_, pixels| {
        let bytes: Vec<u8> = pixels
            .iter()
            .flat_map(|pixel| pixel.to_be_bytes())
            .collect();
        Ok(pipe.write_all(&bytes)?)
    });
    drop(pipe);
    if interrupt::is_stopped() {
        let _ = ffmpeg.kill();
    }
    let status = ffmpeg.wait().context("ffmpeg is lost")?;
    ensure!(
        !interrupt::is_stopped(),
        Stopped("no video is written".to_owned())
    );
    // ffmpeg reports success even if a full disk cuts off the end of the file.
    let mut text = String::new();
    errors.rewind()?;
    errors.read_to_string(&mut text)?;
    let last = text.lines().last().unwrap_or("it does not say why");
    let what = format!("ffmpeg cannot write {}: {last}", name.display());
    ensure!(status.success() && text.is_empty(), what);
    sent.context("ffmpeg ended early")?;
    output::persist(out, name)
}
