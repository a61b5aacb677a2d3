use super::recorder::Recorder;
use crate::interrupt;
use crate::{output, wav};
use anyhow::{Context, Result, ensure};
use std::fs;
use std::io::{Read, Seek, Write};
use std::ops::Range;
use std::path::Path;
use std::process::{Command, Stdio};

const INPUT: &str = "-v error -nostdin -y -f rawvideo -pixel_format 0rgb";
/// All players support 4:2:0; without a colour space they would guess one. Rate factor 16 has no visible loss.
const H264: &str = "-vf scale=out_color_matrix=bt709:out_range=tv -c:v libx264 -crf 16 -pix_fmt yuv420p -colorspace bt709 \
                    -color_primaries bt709 -color_trc bt709 -color_range tv -movflags +faststart";
/// 192 kbit/s has no audible loss.
const AAC: &str = "-map 0:v -map 1:a -c:a aac -b:a 192k";
const WEBP: &str = "-c:v libwebp_anim -quality 70 -loop 0";

pub fn write(recorder: &mut Recorder<'_>, frames: Range<usize>, name: &Path) -> Result<()> {
    let kind = name.extension().unwrap_or_default();
    let out = output::part(name)?;
    let mut ffmpeg = Command::new("ffmpeg");
    let (size, rate) = (
        recorder.size.to_string(),
        recorder.arguments.fps.to_string(),
    );
    ffmpeg
        .args(INPUT.split(' '))
        .args(["-video_size", &size, "-framerate", &rate, "-i", "-"]);
    let folder = tempfile::tempdir()?;
    if kind == "webp" {
        ffmpeg.args(WEBP.split(' '));
    } else {
        if let Some(sound) = recorder.sound(&frames) {
            let file = folder.path().join("sound.wav");
            fs::write(&file, wav::wav(&sound)).with_context(|| output::cannot("write", &file))?;
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
    // ffmpeg reports success even if a full disk truncates the file.
    let mut text = String::new();
    errors.rewind()?;
    errors.read_to_string(&mut text)?;
    let last = text.lines().last().unwrap_or("unknown error");
    let error = format!("{}: ffmpeg cannot write: {last}", name.display());
    ensure!(status.success() && text.is_empty(), error);
    sent.context("ffmpeg ended early")?;
    output::persist(out, name)
}
