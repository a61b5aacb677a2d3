//! Executables of Windows, made of what is linked as one of Linux and asks nothing of it.
//!
//! What is packed is the same as for Linux: an ELF file, and the stub's loader. The packed file has
//!
//! | bytes | what |
//! | ---: | --- |
//! | 512 | the headers; their last 24 bytes tell [`unpack`] where to find what |
//! | | the section `.text`, for reading and executing: |
//! | 80 | addresses of the functions of Windows that the stub calls, put there by Windows |
//! | 172 | the stub's beginning, which checks all that follows |
//! | 3,800 | the stub |
//! | 640 | the names of these functions, and the version |
//! | the rest | what was packed |
//!
//! A second section, `.bss`, for reading and writing, takes no bytes: it is the memory where the program goes. So that is at a fixed
//! address, which nothing else can have taken, and the program needs no relocations. Once it is unpacked its code is made for
//! reading and executing, its constants for reading: at no time is any memory for both writing and executing.

use std::collections::HashMap;

use object::pe::{
    IMAGE_DIRECTORY_ENTRY_IAT, IMAGE_DIRECTORY_ENTRY_IMPORT, IMAGE_DIRECTORY_ENTRY_RESOURCE,
};

use super::{Memory, Version, encode_both};
use crate::{
    Damaged, Error, checksum, decode,
    elf::{self, PAGE, number},
    pe::{BASE_ALIGNMENT, CODE, Executable, Imports, MEMORY, Section},
    stub::{FIRST, LOADER, Stub},
};

/// The functions that the stub calls, in the order of `System` in `src/pack/stub/windows/system.rs`. The program is given the first two.
pub const FUNCTIONS: [&str; 9] = [
    "LoadLibraryA",
    "GetProcAddress",
    "VirtualAlloc",
    "VirtualProtect",
    "VirtualFree",
    "AttachConsole",
    "GetStdHandle",
    "WriteFile",
    "ExitProcess",
];
const LIBRARY: &str = "kernel32.dll";

/// Bytes of the addresses of so many functions, with a 0 behind them.
const fn addresses_size(functions: usize) -> u64 {
    (functions as u64 + 1) * 8
}

/// Where the first section is in the image, and in the file.
const START: u64 = PAGE;
const HEAD: usize = 512;

/// Numbers of 32 bits that the last bytes of the headers are: where in the file what was packed is, its length, how many bytes were
/// packed, where in the file all begins that is checked, and the checksum.
const RECORD: usize = 5;
const SUM: usize = HEAD - 4;

/// Whether a file is an executable of Windows, by its first bytes.
pub fn is_one(file: &[u8]) -> bool {
    file.starts_with(b"MZ")
}

impl Memory {
    /// Where an image begins that has so many bytes before the program.
    fn base(&self, size: u64) -> Result<u64, Error> {
        let base = self
            .start
            .checked_sub(size.next_multiple_of(BASE_ALIGNMENT));
        let base = base.filter(|&base| base != 0 && base % BASE_ALIGNMENT == 0);
        base.ok_or_else(|| "there is no room for headers before it".into())
    }
}

/// A packed executable of a stripped one and the stub's object file.
pub fn pack(stripped: &[u8], stub: &[u8], version: &Version) -> Result<Vec<u8>, Error> {
    let loader = Stub::read(stub, LOADER)?.link_anywhere()?;
    let unpacked = [stripped, &loader].concat();
    let packed = encode_both(&unpacked)?;
    // Lay out the section with all bytes: it lies right before the program.
    let stub = Stub::read(stub, FIRST)?;
    let entry = START + addresses_size(FUNCTIONS.len());
    let names_at = entry + stub.size().next_multiple_of(4) as u64;
    let imports = Imports::new(LIBRARY, &FUNCTIONS, START, names_at);
    let version_at = names_at + imports.names.len() as u64;
    let version = version.to_resources(version_at as u32);
    let packed_at = version_at + version.len() as u64;
    let end = packed_at + packed.len() as u64;
    let memory = Memory::of(&elf::segments(stripped)?)?;
    let base = memory.base(end)?;
    let names = HashMap::from([
        ("SUM", base + SUM as u64),
        ("CHECKED", base + entry + stub.first_size() as u64),
        ("PACKED", base + packed_at),
        ("PACKED_END", base + end),
        ("LENGTH", unpacked.len() as u64),
        ("PROGRAM_LENGTH", stripped.len() as u64),
        ("SYSTEM", base + START),
    ]);
    // Link the stub to its address, and compute what it checks.
    let mut bytes = imports.addresses;
    bytes.extend(stub.link(base + entry, &names)?);
    bytes.resize((names_at - START) as usize, 0);
    bytes.extend(&imports.names);
    bytes.extend(&version);
    bytes.extend(&packed);
    let checked_at = (entry - START) as usize + stub.first_size();
    let record: [usize; RECORD] = [
        HEAD + (packed_at - START) as usize,
        packed.len(),
        unpacked.len(),
        HEAD + checked_at,
        checksum(&bytes[checked_at..]) as usize,
    ];
    Executable {
        base,
        end: memory.end.next_multiple_of(PAGE) - base,
        entry,
        sections: vec![
            Section {
                name: ".text",
                flags: CODE,
                address: START,
                bytes,
            },
            Section {
                name: ".bss",
                flags: MEMORY,
                address: end.next_multiple_of(PAGE),
                bytes: Vec::new(),
            },
        ],
        directories: vec![
            (IMAGE_DIRECTORY_ENTRY_IAT, START..entry),
            (
                IMAGE_DIRECTORY_ENTRY_IMPORT,
                names_at..names_at + Imports::DIRECTORY,
            ),
            (IMAGE_DIRECTORY_ENTRY_RESOURCE, version_at..packed_at),
        ],
    }
    .to_bytes(&record.map(|number| (number as u32).to_le_bytes()).concat())
}

/// The program that is in a packed executable, with the loader behind it.
pub fn unpack(file: &[u8]) -> Result<Vec<u8>, Error> {
    let field = |i: usize| number(file, HEAD - 4 * (RECORD - i), 4) as usize;
    let [start, length, unpacked, checked, sum] = [0, 1, 2, 3, 4].map(field);
    let end = start.saturating_add(length);
    let bytes = file.get(checked..end).ok_or("it is not whole")?;
    if checksum(bytes) as usize != sum {
        return Err(Damaged.into());
    }
    Ok(decode(file.get(start..end).ok_or(Damaged)?, unpacked)?)
}
