//! Reads and writes the headers of 64-bit ELF files.

use std::ops::Range;

use object::{Object, ObjectSection};

use crate::Error;

pub const PAGE: u64 = 4096;
pub const HEADER_SIZE: usize = 64;

/// The file type with fixed addresses (`ET_EXEC`).
pub const EXECUTABLE: u16 = 2;

// Segment types.
pub const LOAD: u32 = 1;
pub const INTERPRETER: u32 = 3;
pub const NOTE: u32 = 4;
pub const PROGRAM_HEADERS: u32 = 6;
pub const UNWINDING: u32 = 0x6474_e550;
pub const STACK: u32 = 0x6474_e551;

// Segment permissions.
pub const EXECUTE: u32 = 1;
pub const WRITE: u32 = 2;
pub const READ: u32 = 4;

#[derive(Clone, Copy, Default)]
pub struct Segment {
    pub kind: u32,
    pub flags: u32,
    pub offset: u64,
    pub address: u64,
    /// Unused by Linux.
    pub physical_address: u64,
    pub file_size: u64,
    /// In memory; bytes beyond `file_size` are zero.
    pub size: u64,
}

impl Segment {
    pub const SIZE: usize = 56;

    fn read(bytes: &[u8]) -> Segment {
        let [kind, flags] = [0, 4].map(|place| number(bytes, place, 4) as u32);
        let [offset, address, physical_address, file_size, size] =
            [8, 16, 24, 32, 40].map(|place| number(bytes, place, 8));
        Segment { kind, flags, offset, address, physical_address, file_size, size }
    }

    pub fn to_bytes(self) -> Vec<u8> {
        let Segment { kind, flags, offset, address, physical_address, file_size, size } = self;
        let first = u64::from(kind) | u64::from(flags) << 32;
        let fields = [first, offset, address, physical_address, file_size, size, PAGE];
        fields.map(u64::to_le_bytes).concat()
    }

    pub fn range(&self) -> Range<usize> {
        let start = self.offset as usize;
        start..start.saturating_add(self.file_size as usize)
    }
}

pub fn header(entry: u64, segments: u16) -> Vec<u8> {
    let mut bytes = b"\x7fELF\x02\x01\x01".to_vec();
    bytes.resize(16, 0);
    // 62 is x86-64; then the version, 32 bits.
    bytes.extend([EXECUTABLE, 62, 1, 0].map(u16::to_le_bytes).as_flattened());
    bytes.extend([entry, HEADER_SIZE as u64, 0].map(u64::to_le_bytes).as_flattened());
    // Flags of 32 bits, sizes, and no sections.
    let end = [0, 0, HEADER_SIZE as u16, Segment::SIZE as u16, segments, 0, 0, 0];
    bytes.extend(end.map(u16::to_le_bytes).as_flattened());
    bytes
}

pub fn kind(file: &[u8]) -> Result<u16, Error> {
    if !file.starts_with(b"\x7fELF\x02\x01") || number(file, 18, 2) != 62 {
        return Err("file is in another format; must be x86-64 ELF".into());
    }
    Ok(number(file, 16, 2) as u16)
}

pub fn segments(file: &[u8]) -> Result<Vec<Segment>, Error> {
    kind(file)?;
    let bytes = file.get(segment_range(file)).ok_or("program headers are outside the file")?;
    Ok(bytes.chunks_exact(Segment::SIZE).map(Segment::read).collect())
}

/// Writes the program headers, and removes the section headers.
pub fn set_segments(file: &mut [u8], segments: &[Segment]) -> Result<(), Error> {
    let range = segment_range(file);
    let bytes: Vec<u8> = segments.iter().flat_map(|segment| segment.to_bytes()).collect();
    let place = file.get_mut(range).filter(|place| place.len() == bytes.len());
    place.ok_or("program headers are outside the file")?.copy_from_slice(&bytes);
    file[40..48].fill(0);
    file[58..64].fill(0);
    Ok(())
}

fn segment_range(file: &[u8]) -> Range<usize> {
    let start = number(file, 32, 8) as usize;
    start..start.saturating_add(number(file, 56, 2) as usize * Segment::SIZE)
}

pub struct Section {
    pub address: u64,
    pub range: Range<usize>,
}

impl Section {
    pub fn find(file: &object::File<'_>, name: &str) -> Option<Section> {
        let section = file.section_by_name(name)?;
        let (start, size) = section.file_range()?;
        Some(Section { address: section.address(), range: start as usize..(start + size) as usize })
    }

    /// Returns the file range of `length` bytes from `address` on, if the section contains them.
    pub fn place(&self, address: u64, length: u64) -> Option<Range<usize>> {
        let start = address.checked_sub(self.address)?;
        let end = start.checked_add(length)?;
        let first = self.range.start;
        (end <= self.range.len() as u64).then(|| first + start as usize..first + end as usize)
    }
}

/// Reads a little-endian number of `size` bytes; returns 0 beyond the end.
pub fn number(bytes: &[u8], place: usize, size: usize) -> u64 {
    let bytes = bytes.get(place..place + size).unwrap_or_default();
    bytes.iter().rev().fold(0, |number, &byte| number << 8 | u64::from(byte))
}
