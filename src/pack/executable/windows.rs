//! Packs Windows executables, which are linked for Linux but call no function of Linux. The packed file has
//!
//! | bytes | content |
//! | ---: | --- |
//! | 512 | the headers; their last 24 bytes are for [`unpack`] |
//! | | the section `.text`, for reading and executing: |
//! | 80 | addresses of the stub's functions, filled in by Windows |
//! | 220 | the stub's first section, which verifies the rest |
//! | 240 | the first stage, which unpacks the second |
//! | 200 | the functions' names |
//! | 57,000 | the packed program |
//! | 2,600 | the packed second stage |
//!
//! A section `.bss` reserves the memory of the program and of the second stage at a fixed address, so they need no relocations. No
//! memory is ever writable and executable.

use std::collections::HashMap;

use object::pe::{IMAGE_DIRECTORY_ENTRY_IAT, IMAGE_DIRECTORY_ENTRY_IMPORT};

use super::{Memory, encode_both};
use crate::{
    DAMAGED, Error, checksum, decode,
    elf::{self, PAGE, number},
    pe::{BASE_ALIGNMENT, CODE, Executable, Imports, MEMORY, Section},
    small,
    stub::{FIRST, LOADER, STAGE, Stub},
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
/// offset and end, the checksum.
const RECORD: usize = 6;
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
    let [first, second] = [FIRST, STAGE].map(|section| Stub::read(stub, section));
    let (first, second) = (first?, second?);
    let first_at = START + addresses_size(FUNCTIONS.len());
    let names_at = first_at + first.size().next_multiple_of(4) as u64;
    let imports = Imports::new(LIBRARY, &FUNCTIONS, START, names_at);
    let packed_at = names_at + imports.names.len() as u64;
    let packed_end = packed_at + packed.len() as u64;
    let memory = Memory::of(&elf::segments(stripped)?)?;
    // The packed second stage is smaller.
    let base = memory.base(packed_end + second.size() as u64)?;
    let stage = memory.stage();
    let mut names = HashMap::from([
        ("SUM", base + SUM as u64),
        ("STAGE", stage),
        ("STAGE_END", stage + second.size() as u64),
        ("STAGE_LENGTH", second.size() as u64),
        ("STAGE_PACKED", base + packed_end),
        ("PACKED", base + packed_at),
        ("PACKED_END", base + packed_end),
        ("LENGTH", unpacked.len() as u64),
        ("PROGRAM_LENGTH", stripped.len() as u64),
        ("PROGRAM", memory.start),
        ("COUNTS_SIZE", small::MEMORY),
        ("SYSTEM", base + START),
    ]);
    for name in ["fail", "unprotected"] {
        names.insert(name, base + first_at + first.place(name));
    }
    let packed_stage = small::encode(&second.link(stage, &names)?);
    let end = packed_end + packed_stage.len() as u64;
    names.insert("FILE_END", base + end);
    let mut bytes = imports.addresses;
    bytes.extend(first.link(base + first_at, &names)?);
    bytes.resize((names_at - START) as usize, 0);
    bytes.extend(&imports.names);
    bytes.extend(&packed);
    bytes.extend(&packed_stage);
    let checked_at = (first_at - START) as usize + first.first_size();
    let record: [usize; RECORD] = [
        HEAD + (packed_at - START) as usize,
        packed.len(),
        unpacked.len(),
        HEAD + checked_at,
        HEAD + bytes.len(),
        checksum(&bytes[checked_at..]) as usize,
    ];
    Executable {
        base,
        end: (stage + second.size() as u64).next_multiple_of(PAGE) - base,
        entry: first_at + first.place("_start"),
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
            (IMAGE_DIRECTORY_ENTRY_IAT, START..first_at),
            (IMAGE_DIRECTORY_ENTRY_IMPORT, names_at..names_at + Imports::DIRECTORY),
        ],
    }
    .to_bytes(&record.map(|number| (number as u32).to_le_bytes()).concat())
}

pub fn unpack(file: &[u8]) -> Result<Vec<u8>, Error> {
    let field = |i: usize| number(file, HEAD - 4 * (RECORD - i), 4) as usize;
    let [start, length, unpacked, checked, end, sum] = [0, 1, 2, 3, 4, 5].map(field);
    let bytes = file.get(checked..end).ok_or("file is incomplete")?;
    if checksum(bytes) as usize != sum {
        return Err(DAMAGED.into());
    }
    decode(file.get(start..start.saturating_add(length)).ok_or(DAMAGED)?, unpacked)
}
