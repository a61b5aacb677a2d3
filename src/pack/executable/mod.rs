//! Packs executables: a stripped ELF file and the stub's loader, with the stub and the headers of
//! [`linux`] or [`windows`].

mod linux;
mod strip;
#[cfg(test)]
mod tests;
mod windows;

pub use strip::strip;

use std::collections::HashMap;

use crate::elf::{self, Segment};
use crate::stub::{FIRST, LOADER, STAGE, Stub};
use crate::{DAMAGED, Error, LONGEST, checksum, decode, encode, small};

#[derive(Clone, Copy, PartialEq, Eq)]
pub enum System {
    Linux,
    Windows,
}

/// The addresses of a program's segments, from a page's beginning to the last byte's end.
struct Memory {
    start: u64,
    end: u64,
}

impl Memory {
    fn of(segments: &[Segment]) -> Result<Memory, Error> {
        let loads = segments.iter().filter(|segment| segment.kind == elf::LOAD);
        let starts = loads.clone().map(|load| load.address);
        let ends = loads.map(|load| load.address.saturating_add(load.size));
        let start = starts.min().ok_or("loaded segment is missing")? / elf::PAGE * elf::PAGE;
        let end = ends.max().unwrap_or_default();
        // The stub's addresses are 32-bit signed integers.
        if end > 1 << 31 {
            return Err(format!("end of program is {end:#x}; must be at most 0x80000000").into());
        }
        Ok(Memory { start, end })
    }

    /// Returns the address of the second stage, behind the program and the first stage's counts.
    fn stage(&self) -> u64 {
        self.end.max(self.start + small::MEMORY).next_multiple_of(elf::PAGE)
    }
}

/// In order: the offset and length of the packed bytes, their length once unpacked, the start and
/// end of the bytes under the checksum, and the checksum. Offsets are in the file.
type Record = [usize; 6];

struct Parts<'a> {
    /// The length of the program, without and with its loader.
    lengths: [u64; 2],
    packed: Vec<u8>,
    first: Stub<'a>,
    second: Stub<'a>,
    memory: Memory,
    stage: u64,
}

impl<'a> Parts<'a> {
    fn new(stripped: &[u8], stub: &'a [u8]) -> Result<Self, Error> {
        let loader = Stub::read(stub, LOADER)?.link_anywhere()?;
        let unpacked = [stripped, &loader].concat();
        let length = unpacked.len();
        if length > LONGEST {
            return Err(format!("program size is {length}; must be at most {LONGEST}").into());
        }
        let packed = encode(&unpacked);
        if decode(&packed, length)? != unpacked {
            return Err("unpacked program differs from the original".into());
        }
        let memory = Memory::of(&elf::segments(stripped)?)?;
        Ok(Self {
            lengths: [stripped, &unpacked].map(|bytes| bytes.len() as u64),
            packed,
            first: Stub::read(stub, FIRST)?,
            second: Stub::read(stub, STAGE)?,
            stage: memory.stage(),
            memory,
        })
    }

    fn stage_end(&self) -> u64 {
        self.stage + self.second.size() as u64
    }

    /// Returns the stub's symbols, with `more`, and the addresses of `functions` of the first
    /// section.
    fn names<'b>(
        &self,
        more: &[(&'b str, u64)],
        first_at: u64,
        functions: [&'b str; 2],
        packed_at: u64,
    ) -> HashMap<&'b str, u64> {
        let packed_end = packed_at + self.packed.len() as u64;
        let names = [
            ("STAGE", self.stage),
            ("STAGE_END", self.stage_end()),
            ("STAGE_LENGTH", self.second.size() as u64),
            ("STAGE_PACKED", packed_end),
            ("PACKED", packed_at),
            ("PACKED_END", packed_end),
            ("PROGRAM_LENGTH", self.lengths[0]),
            ("LENGTH", self.lengths[1]),
            ("PROGRAM", self.memory.start),
        ];
        let functions = functions.map(|name| (name, first_at + self.first.place(name)));
        names.into_iter().chain(functions).chain(more.iter().copied()).collect()
    }

    fn packed_stage(&self, names: &HashMap<&str, u64>) -> Result<Vec<u8>, Error> {
        Ok(small::encode(&self.second.link(self.stage, names)?))
    }
}

/// Packs an executable, with the stub's object file.
///
/// # Errors
/// If the stub cannot load the executable.
pub fn pack_executable(program: &[u8], stub: &[u8], system: &System) -> Result<Vec<u8>, Error> {
    let stripped = strip(program)?;
    match system {
        System::Linux => linux::pack(&stripped, stub),
        System::Windows => windows::pack(&stripped, stub),
    }
}

pub fn packed_size(program: &[u8]) -> Result<usize, Error> {
    Ok(encode(&strip(program)?).len())
}

/// Returns a packed executable's program, as left by [`strip`].
///
/// # Errors
/// If the file is not a packed executable, or damaged.
pub fn unpack_executable(file: &[u8]) -> Result<Vec<u8>, Error> {
    let record = if windows::is_pe(file) { windows::record(file) } else { linux::record(file)? };
    let [start, length, unpacked, checked, end, sum]: Record = record;
    let checked = file.get(checked..end).ok_or("file is incomplete")?;
    if checksum(checked) as usize != sum {
        return Err(DAMAGED.into());
    }
    let packed = file.get(start..start.saturating_add(length)).ok_or(DAMAGED)?;
    let mut unpacked = decode(packed, unpacked)?;
    let ends = elf::segments(&unpacked)?.into_iter().map(|segment| segment.range().end);
    unpacked.truncate(ends.max().unwrap_or_default());
    Ok(unpacked)
}
