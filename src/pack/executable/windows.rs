//! Packs Windows executables, which are linked for Linux but call no function of Linux. The packed file has
//!
//! | bytes | content |
//! | ---: | --- |
//! | 512 | the headers; their last 20 bytes are for [`unpack`] |
//! | | the section `.text`, for reading and executing: |
//! | 80 | addresses of the stub's functions, filled in by Windows |
//! | 172 | the stub's first section, which verifies the rest |
//! | 3,800 | the stub |
//! | 200 | the functions' names |
//! | the rest | the packed program |
//!
//! A section `.bss` reserves the program's memory at a fixed address, so it needs no relocations. No memory is ever writable and
//! executable.

use std::collections::HashMap;

use object::pe::{IMAGE_DIRECTORY_ENTRY_IAT, IMAGE_DIRECTORY_ENTRY_IMPORT};

use super::{Memory, encode_both};
use crate::{
    DAMAGED, Error, checksum, decode,
    elf::{self, PAGE, number},
    pe::{BASE_ALIGNMENT, CODE, Executable, Imports, MEMORY, Section},
    stub::{FIRST, LOADER, Stub},
};

/// The stub's functions, in the order of `System` in `src/pack/stub/windows/system.rs`. The program receives the first two.
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

const fn addresses_size(functions: usize) -> u64 {
    (functions as u64 + 1) * 8
}

/// The first section's address in the image, and its offset in the file.
const START: u64 = PAGE;
const HEAD: usize = 512;

/// The 32-bit fields at the end of the headers: the packed bytes' offset and length, the unpacked length, the checked bytes'
/// offset, the checksum.
const RECORD: usize = 5;
const SUM: usize = HEAD - 4;

pub fn is_pe(file: &[u8]) -> bool {
    file.starts_with(b"MZ")
}

impl Memory {
    fn base(&self, size: u64) -> Result<u64, Error> {
        let base = self.start.checked_sub(size.next_multiple_of(BASE_ALIGNMENT));
        let base = base.filter(|&base| base != 0 && base % BASE_ALIGNMENT == 0);
        base.ok_or_else(|| {
            let start = self.start;
            format!("program start is {start:#x}; must be a multiple of 0x10000, above {size:#x}")
                .into()
        })
    }
}

pub fn pack(stripped: &[u8], stub: &[u8]) -> Result<Vec<u8>, Error> {
    let loader = Stub::read(stub, LOADER)?.link_anywhere()?;
    let unpacked = [stripped, &loader].concat();
    let packed = encode_both(&unpacked)?;
    let stub = Stub::read(stub, FIRST)?;
    let entry = START + addresses_size(FUNCTIONS.len());
    let names_at = entry + stub.size().next_multiple_of(4) as u64;
    let imports = Imports::new(LIBRARY, &FUNCTIONS, START, names_at);
    let packed_at = names_at + imports.names.len() as u64;
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
    let mut bytes = imports.addresses;
    bytes.extend(stub.link(base + entry, &names)?);
    bytes.resize((names_at - START) as usize, 0);
    bytes.extend(&imports.names);
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
            Section { name: ".text", flags: CODE, address: START, bytes },
            Section {
                name: ".bss",
                flags: MEMORY,
                address: end.next_multiple_of(PAGE),
                bytes: Vec::new(),
            },
        ],
        directories: vec![
            (IMAGE_DIRECTORY_ENTRY_IAT, START..entry),
            (IMAGE_DIRECTORY_ENTRY_IMPORT, names_at..names_at + Imports::DIRECTORY),
        ],
    }
    .to_bytes(&record.map(|number| (number as u32).to_le_bytes()).concat())
}

pub fn unpack(file: &[u8]) -> Result<Vec<u8>, Error> {
    let field = |i: usize| number(file, HEAD - 4 * (RECORD - i), 4) as usize;
    let [start, length, unpacked, checked, sum] = [0, 1, 2, 3, 4].map(field);
    let end = start.saturating_add(length);
    let bytes = file.get(checked..end).ok_or("file is incomplete")?;
    if checksum(bytes) as usize != sum {
        return Err(DAMAGED.into());
    }
    decode(file.get(start..end).ok_or(DAMAGED)?, unpacked)
}
