use super::Bytes;
use anyhow::{Context, Result, anyhow};
use eightfold_pack::{costs, strip};
use object::{Object, ObjectSegment};
use std::ops::Range;

pub struct Packed {
    /// Addresses, and the offset in the image.
    segments: Vec<(Range<u64>, usize)>,
    /// Prefix sums of packed bytes, and the total.
    before: Vec<f64>,
}

impl Packed {
    pub fn new(linked: &[u8]) -> Result<Self> {
        let image = strip(linked).map_err(|error| anyhow!("{error}"))?;
        let file = object::File::parse(&*image).context("stripped program")?;
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
        Ok(Self { segments: segments.collect(), before })
    }

    pub fn of(&self, addresses: &Range<u64>) -> Bytes {
        let mut bytes = Bytes { parts: 1, ..Bytes::default() };
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

    pub fn all(&self) -> Bytes {
        Bytes {
            parts: 1,
            linked: self.before.len() as u64 - 1,
            packed: self.before.last().copied().unwrap_or_default(),
        }
    }
}
