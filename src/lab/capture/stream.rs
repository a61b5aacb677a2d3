//! Writes frames as a Y4M stream.

use super::film::{Canvas, Film};
use super::frame_queue::FrameQueue;
use super::y4m;
use crate::output::Sink;
use crate::progress;
use anyhow::Result;
use std::fs::{self, File};
use std::io::{self, Read, Seek, SeekFrom};
use std::ops::Range;
use std::path::Path;

/// Writes a stream to a file, or to standard output if the name is `-`. A file that already holds the stream is kept.
pub fn write(queue: &FrameQueue<'_>, frames: Range<usize>, name: &Path) -> Result<()> {
    if is_there(queue.film, &frames, name).unwrap_or(false) {
        eprintln!("{}: kept, since it is complete", name.display());
        return Ok(());
    }
    let mut sink = Sink::open(name)?;
    send(queue, frames, |bytes| sink.write(bytes))?;
    sink.finish()
}

/// Passes a stream to a function, piece by piece.
pub fn send(
    queue: &FrameQueue<'_>,
    frames: Range<usize>,
    mut write: impl FnMut(&[u8]) -> Result<()> + Send,
) -> Result<()> {
    let film = queue.film;
    let bar = progress::bar(frames.len());
    write(&y4m::header(film.size, film.rate))?;
    let frames: Vec<usize> = frames.collect();
    let done = queue.draw(
        &frames,
        |frame, pixels| Ok(y4m::frame(film.made(frame), pixels)),
        |bytes| {
            write(&bytes)?;
            bar.inc(1);
            Ok(())
        },
    );
    bar.finish_and_clear();
    done
}

/// Whether a file holds exactly this stream. The header, the length, how each frame was made, and the first and the last frame are
/// compared. A file under its final name is complete, so the pictures between are there, too.
fn is_there(film: &Film, frames: &Range<usize>, name: &Path) -> io::Result<bool> {
    let header = y4m::header(film.size, film.rate);
    let bytes = y4m::frame_bytes(film.size);
    let there = fs::metadata(name)?;
    let length = header.len() + bytes * frames.len();
    if !there.is_file() || there.len() != length as u64 {
        return Ok(false);
    }
    let mut file = File::open(name)?;
    let mut holds = |start: usize, wanted: &[u8]| {
        let mut found = vec![0; wanted.len()];
        file.seek(SeekFrom::Start(start as u64))?;
        file.read_exact(&mut found)?;
        io::Result::Ok(found == wanted)
    };
    if !holds(0, &header)? {
        return Ok(false);
    }
    for (i, number) in frames.clone().enumerate() {
        if !holds(header.len() + i * bytes, &y4m::mark(film.made(number)))? {
            return Ok(false);
        }
    }
    let mut canvas = Canvas::new();
    let mut frame = |number| y4m::frame(film.made(number), film.draw(number, &mut canvas));
    Ok(
        holds(header.len(), &frame(frames.start))?
            && holds(length - bytes, &frame(frames.end - 1))?,
    )
}
