//! Packs executables: a stripped ELF file and the stub's loader, with the stub and the headers of [`linux`] or [`windows`].

mod linux;
mod strip;
#[cfg(test)]
mod tests;
mod windows;

pub use strip::strip;

use crate::{
    Error, LONGEST, decode,
    elf::{self, Segment},
    encode, small,
};

#[derive(Clone, Copy, PartialEq, Eq)]
pub enum System {
    Linux,
    Windows,
}

/// The addresses of a program's segments, from the beginning of a page to the last byte's end.
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

    /// Returns the address of the second stage, behind the program and the first stage's counts at its start.
    fn stage(&self) -> u64 {
        self.end.max(self.start + small::MEMORY).next_multiple_of(elf::PAGE)
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
    let mut unpacked =
        if windows::is_pe(file) { windows::unpack(file)? } else { linux::unpack(file)? };
    let ends = elf::segments(&unpacked)?.into_iter().map(|segment| segment.range().end);
    unpacked.truncate(ends.max().unwrap_or_default());
    Ok(unpacked)
}

fn encode_both(unpacked: &[u8]) -> Result<Vec<u8>, Error> {
    if unpacked.len() > LONGEST {
        return Err(format!("program size is {}; must be at most {LONGEST}", unpacked.len()).into());
    }
    let packed = encode(unpacked);
    if decode(&packed, unpacked.len())? != unpacked {
        return Err("unpacked program differs from the original".into());
    }
    Ok(packed)
}
