//! Keeps a film that is not finished: a file that the next run goes on from.
//!
//! The first line tells, as JSON, how the picture is made, and how many samples each row has. The sums follow, row by row, as
//! little-endian numbers of 64 bits, and at the end the CRC-32 of all before it.

use super::REPLICATIONS;
use super::film::Film;
use crate::arguments::Size;
use crate::output;
use anyhow::{Context, Result, bail};
use eightfold_tracer::glam::DVec3;
use serde::{Deserialize, Serialize};
use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};

/// The first line of a file.
#[derive(Serialize, Deserialize)]
struct Header {
    /// Describes how the picture is made: equal lines mean equal pictures.
    made: String,
    /// The number of samples of each replication, for each row.
    counts: Vec<usize>,
}

/// The bytes of a pixel.
const PIXEL: usize = REPLICATIONS * 3 * size_of::<f64>();

/// The name of the file beside a picture.
pub fn beside(picture: &Path) -> PathBuf {
    let mut name = picture.as_os_str().to_owned();
    name.push(".unfinished");
    name.into()
}

/// Writes a film.
pub fn save(name: &Path, made: &str, film: &Film) -> Result<()> {
    let header = Header {
        made: made.to_owned(),
        counts: film.rows.iter().map(|row| row.count).collect(),
    };
    let mut bytes = serde_json::to_vec(&header)?;
    bytes.push(b'\n');
    for sums in film.rows.iter().flat_map(|row| &row.pixels) {
        for number in sums.iter().flat_map(|sum| sum.to_array()) {
            bytes.extend(number.to_le_bytes());
        }
    }
    bytes.extend(crc32fast::hash(&bytes).to_le_bytes());
    let write = || {
        let mut file = output::start_for_another(name, ".part")?;
        file.write_all(&bytes)?;
        file.persist(name)?;
        Ok(())
    };
    let written: Result<()> = write();
    written.with_context(|| format!("cannot keep {}", name.display()))
}

/// Reads the film of a picture of the same making with up to `count` samples of each replication; `None` if there is none, or
/// another's.
///
/// # Errors
/// If the file is not as it was written.
pub fn load(name: &Path, made: &str, size: Size, count: usize) -> Result<Option<Film>> {
    let Ok(bytes) = fs::read(name) else {
        return Ok(None);
    };
    let whole = bytes.split_last_chunk();
    let whole = whole.filter(|(bytes, sum)| crc32fast::hash(bytes).to_le_bytes() == **sum);
    let Some((bytes, _)) = whole else {
        bail!("{} is damaged: delete it to begin anew", name.display());
    };
    Ok(film(bytes, made, size, count))
}

/// The film in the bytes of a file that is as it was written.
fn film(bytes: &[u8], made: &str, size: Size, count: usize) -> Option<Film> {
    let end = bytes.iter().position(|&byte| byte == b'\n')?;
    let header: Header = serde_json::from_slice(&bytes[..end]).ok()?;
    let numbers = &bytes[end + 1..];
    let is_whole = header.counts.len() == size.height && numbers.len() == size.area() * PIXEL;
    let has_more = header.counts.iter().any(|&there| there > count);
    if header.made != made || !is_whole || has_more {
        return None;
    }
    let mut film = Film::new(size);
    let mut numbers = numbers
        .as_chunks::<{ size_of::<f64>() }>()
        .0
        .iter()
        .map(|&bytes| f64::from_le_bytes(bytes));
    for (row, count) in film.rows.iter_mut().zip(header.counts) {
        row.count = count;
        for sum in row.pixels.iter_mut().flatten() {
            *sum = DVec3::from_array([numbers.next()?, numbers.next()?, numbers.next()?]);
        }
    }
    Some(film)
}
