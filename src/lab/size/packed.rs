//! The cost of each byte of the linked program in the packed file.

use super::Bytes;
use anyhow::{Context, Result, anyhow};
use eightfold_pack::{costs, strip};
use object::{Object, ObjectSegment};
use std::ops::Range;

/// The packed image: those parts of the linked program that are loaded.
pub struct Packed {
    /// The addresses of each segment, and the offset of its first byte in the image.
    segments: Vec<(Range<u64>, usize)>,
    /// For each offset in the image, and for its end, the packed bytes before it.
    before: Vec<f64>,
}

impl Packed {
    /// Packs a linked program and records the cost of each byte.
    pub fn new(linked: &[u8]) -> Result<Self> {
        let image = strip(linked).map_err(|error| anyhow!("{error}"))?;
        let file = object::File::parse(&*image).context("what is packed is no program")?;
        let segments = file.segments().map(|segment| {
            let (offset, size) = segment.file_range();
            (segment.address()..segment.address() + size, offset as usize)
        });
        let mut before = vec![0.0];
        let mut sum = 0.0;
        for bits in costs(&image) {
            sum += f64::from(bits) / 8.0;
            before.push(sum);
        }
        Ok(Self {
            segments: segments.collect(),
            before,
        })
    }

    /// Returns the size of the part at these addresses.
    pub fn of(&self, addresses: &Range<u64>) -> Bytes {
        let mut bytes = Bytes {
            parts: 1,
            ..Bytes::default()
        };
        for (segment, offset) in &self.segments {
            let start = addresses.start.max(segment.start);
            let end = addresses.end.min(segment.end);
            if start < end {
                let index = |address: u64| offset + (address - segment.start) as usize;
                bytes.linked += end - start;
                bytes.packed += self.before[index(end)] - self.before[index(start)];
            }
        }
        bytes
    }

    /// Returns the size of the whole image.
    pub fn all(&self) -> Bytes {
        Bytes {
            parts: 1,
            linked: self.before.len() as u64 - 1,
            packed: self.before.last().copied().unwrap_or_default(),
        }
    }
}
