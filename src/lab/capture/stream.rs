//! Frames as one Y4M stream.

use super::crew::Crew;
use super::film::{Canvas, Film};
use super::y4m;
use crate::output::Sink;
use crate::progress;
use anyhow::Result;
use std::fs::{self, File};
use std::io::{self, Read, Seek, SeekFrom};
use std::ops::Range;
use std::path::Path;

/// Writes a stream to a file, or to standard output where the name is `-`; leaves a file that holds it already.
pub fn write(crew: &Crew<'_>, frames: Range<usize>, name: &Path) -> Result<()> {
    if is_there(crew.film, &frames, name).unwrap_or(false) {
        eprintln!("{}: kept, it is whole", name.display());
        return Ok(());
    }
    let mut sink = Sink::open(name)?;
    send(crew, frames, |bytes| sink.write(bytes))?;
    sink.finish()
}

/// Hands over a stream, piece by piece.
pub fn send(
    crew: &Crew<'_>,
    frames: Range<usize>,
    mut write: impl FnMut(&[u8]) -> Result<()> + Send,
) -> Result<()> {
    let film = crew.film;
    let bar = progress::bar(frames.len());
    write(&y4m::header(film.size, film.rate))?;
    let frames: Vec<usize> = frames.collect();
    let done = crew.draw(
        &frames,
        |_, pixels| Ok(y4m::frame(pixels)),
        |bytes| {
            write(&bytes)?;
            bar.inc(1);
            Ok(())
        },
    );
    bar.finish_and_clear();
    done
}

/// Whether a file holds just this stream: its header, its length, and its first and last frame, which are drawn to be
/// compared. A file under its final name has been written to its end, so those between are there too.
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
    let mut canvas = Canvas::new();
    let mut frame = |number| y4m::frame(film.draw(number, &mut canvas));
    Ok(holds(0, &header)?
        && holds(header.len(), &frame(frames.start))?
        && holds(length - bytes, &frame(frames.end - 1))?)
}
