//! Makes a packed executable of an ordinary one.
//!
//! The packed content is an ELF file itself, without all that nobody reads who starts it, and the stub's loader, which loads it. Around
//! that are the stub and the headers of the system that it is for: [`linux`] or [`windows`].

mod linux;
mod strip;
#[cfg(test)]
mod tests;
mod version;
mod windows;

pub use strip::strip;
pub use version::Version;

use crate::{
    Error, LONGEST, decode,
    elf::{self, Segment},
    encode,
};

/// A system that executables are made for.
pub enum System {
    /// Linux on x86-64.
    Linux,
    /// Windows on x86-64, with what it shows of the program.
    Windows(Version),
}

/// Where in memory a program's segments go: from the beginning of a page to the last byte's end.
struct Memory {
    start: u64,
    end: u64,
}

impl Memory {
    /// Finds it, if the program is one that can be loaded.
    fn of(segments: &[Segment]) -> Result<Memory, Error> {
        let loads = segments.iter().filter(|segment| segment.kind == elf::LOAD);
        let starts = loads.clone().map(|load| load.address);
        let ends = loads.map(|load| load.address.saturating_add(load.size));
        let start = starts.min().ok_or("nothing of it is loaded")? / elf::PAGE * elf::PAGE;
        let end = ends.max().unwrap_or_default();
        // The stub's addresses have four bytes, with a sign.
        if end > 1 << 31 {
            return Err("it is not linked to addresses below 2 GB".into());
        }
        Ok(Memory { start, end })
    }
}

/// A packed executable of an ordinary one and the stub's object file.
///
/// # Errors
/// If it is no executable that the stub can load.
pub fn pack_executable(program: &[u8], stub: &[u8], system: &System) -> Result<Vec<u8>, Error> {
    let stripped = strip(program)?;
    match system {
        System::Linux => linux::pack(&stripped, stub),
        System::Windows(version) => windows::pack(&stripped, stub, version),
    }
}

/// How many bytes a program takes packed, without its stub.
pub fn packed_size(program: &[u8]) -> Result<usize, Error> {
    Ok(encode(&strip(program)?).len())
}

/// The program that is in a packed executable, as [`strip`] leaves it.
///
/// # Errors
/// If it is none, or not whole.
pub fn unpack_executable(file: &[u8]) -> Result<Vec<u8>, Error> {
    let mut unpacked = if windows::is_one(file) {
        windows::unpack(file)?
    } else {
        linux::unpack(file)?
    };
    // The rest is the loader.
    let ends = elf::segments(&unpacked)?
        .into_iter()
        .map(|segment| segment.range().end);
    unpacked.truncate(ends.max().unwrap_or_default());
    Ok(unpacked)
}

/// Packs a program with its loader behind it, and makes sure that both can be unpacked.
fn encode_both(unpacked: &[u8]) -> Result<Vec<u8>, Error> {
    if unpacked.len() > LONGEST {
        return Err(format!("{} bytes are too many", unpacked.len()).into());
    }
    let packed = encode(unpacked);
    if decode(&packed, unpacked.len())? != unpacked {
        return Err("what is unpacked is not what was packed".into());
    }
    Ok(packed)
}
