//! Keeps a film as a file: one that is not finished, for the next run to go on from, or a part of a picture, to be merged with the
//! others.
//!
//! The first line tells, as JSON, how the picture is made, and how many samples each row has. The sums of each pixel follow, row by
//! row, as little-endian numbers of 64 bits, and at the end the CRC-32 of all before it.

use super::REPLICATIONS;
use super::estimate::Pixel;
use super::film::{Film, Row};
use crate::arguments::Part;
use crate::output;
use anyhow::{Context, Result, bail, ensure};
use eightfold_tracer::glam::DVec3;
use serde::{Deserialize, Serialize};
use std::fs;
use std::path::{Path, PathBuf};

/// The first line of a file.
#[derive(Serialize, Deserialize)]
struct Header {
    /// Describes how the picture is made: equal lines mean equal pictures.
    made: String,
    width: usize,
    /// The number of samples of each replication, for each row; nothing for rows of other parts.
    counts: Vec<Option<usize>>,
}

/// The name of the file beside a picture that has a part of it, or all of it as long as that is not finished.
pub fn beside(picture: &Path, part: Option<Part>) -> PathBuf {
    let mut name = picture.as_os_str().to_owned();
    name.push(match part {
        Some(Part { number, count }) => format!(".part-{number}-of-{count}"),
        None => ".unfinished".to_owned(),
    });
    name.into()
}

/// Writes a film.
pub fn save(name: &Path, made: &str, film: &Film) -> Result<()> {
    let count = |row: &Row| (!row.pixels.is_empty()).then_some(row.count);
    let header = Header {
        made: made.to_owned(),
        width: film.width,
        counts: film.rows.iter().map(count).collect(),
    };
    let mut bytes = serde_json::to_vec(&header)?;
    bytes.push(b'\n');
    for pixel in film.rows.iter().flat_map(|row| &row.pixels) {
        let sums = pixel.sums.iter().chain([&pixel.blur]);
        for number in sums.flat_map(|sum| sum.to_array()) {
            bytes.extend(number.to_le_bytes());
        }
    }
    bytes.extend(crc32fast::hash(&bytes).to_le_bytes());
    let written = output::write(name, &bytes);
    written.with_context(|| format!("cannot keep {}", name.display()))
}

/// Reads the film of a picture of the same making, with the rows of `empty` and up to `count` samples of each replication; `None` if
/// there is none, or another's.
///
/// # Errors
/// If the file is not as it was written.
pub fn load(name: &Path, made: &str, empty: &Film, count: usize) -> Result<Option<Film>> {
    if !name.exists() {
        return Ok(None);
    }
    let fits = |(there, film): &(String, Film)| {
        let mut rows = film.rows.iter().zip(&empty.rows);
        there == made
            && rows.all(|(row, empty)| row.pixels.len() == empty.pixels.len() && row.count <= count)
    };
    Ok(read(name)?.filter(fits).map(|(_, film)| film))
}

/// Puts together the films of all parts of a picture.
///
/// # Errors
/// If they are of different pictures, not finished, or not all.
pub fn merge(names: &[PathBuf]) -> Result<Film> {
    let mut merged: Option<(String, Film)> = None;
    for name in names {
        let part = read(name)?.context("another version has written this");
        let added = part.and_then(|part| add(&mut merged, part));
        added.with_context(|| name.display().to_string())?;
    }
    let (_, film) = merged.context("nothing is to be merged")?;
    let missing = film.rows.len() - film.own_rows().count();
    let all = film.rows.len();
    ensure!(missing == 0, "{missing} of {all} rows are in no part");
    Ok(film)
}

/// Adds a part to those that are merged.
fn add(merged: &mut Option<(String, Film)>, (made, film): (String, Film)) -> Result<()> {
    let count = film.count();
    let is_even = film.own_rows().all(|row| row.count == count);
    ensure!(is_even, "this part is not finished");
    let Some((first, whole)) = merged else {
        *merged = Some((made, film));
        return Ok(());
    };
    ensure!(made == *first, "this is a part of another picture");
    let [here, before] = [count, whole.count()].map(|count| count * REPLICATIONS);
    ensure!(
        here == before,
        "{here} samples a pixel, where others have {before}"
    );
    for (there, row) in whole.rows.iter_mut().zip(film.rows) {
        if !row.pixels.is_empty() {
            ensure!(there.pixels.is_empty(), "another part has the same rows");
            *there = row;
        }
    }
    Ok(())
}

/// How the picture of a file is made, and its film; `None` if another version wrote it.
///
/// # Errors
/// If the file is not as it was written.
fn read(name: &Path) -> Result<Option<(String, Film)>> {
    let bytes = fs::read(name).with_context(|| format!("cannot read {}", name.display()))?;
    let whole = bytes.split_last_chunk();
    let whole = whole.filter(|(bytes, sum)| crc32fast::hash(bytes).to_le_bytes() == **sum);
    let Some((bytes, _)) = whole else {
        bail!("{} is damaged: delete it to begin anew", name.display());
    };
    Ok(film(bytes))
}

/// The same for the bytes of a file that is as it was written.
fn film(bytes: &[u8]) -> Option<(String, Film)> {
    let end = bytes.iter().position(|&byte| byte == b'\n')?;
    let header: Header = serde_json::from_slice(&bytes[..end]).ok()?;
    let mut numbers = bytes[end + 1..]
        .as_chunks::<{ size_of::<f64>() }>()
        .0
        .iter()
        .map(|&bytes| f64::from_le_bytes(bytes));
    let mut pixel = || {
        let mut pixel = Pixel::default();
        for sum in pixel.sums.iter_mut().chain([&mut pixel.blur]) {
            *sum = DVec3::from_array([numbers.next()?, numbers.next()?, numbers.next()?]);
        }
        Some(pixel)
    };
    let mut row = |count: Option<usize>| {
        let width = count.map_or(0, |_| header.width);
        Some(Row {
            count: count.unwrap_or(0),
            pixels: (0..width).map(|_| pixel()).collect::<Option<_>>()?,
        })
    };
    let rows: Option<Vec<Row>> = header.counts.into_iter().map(&mut row).collect();
    let (width, rows) = (header.width, rows?);
    Some((header.made, Film { width, rows }))
}
