//! Packs Windows executables, which are linked for Linux but call no function of Linux. The packed
//! file has
//!
//! | bytes | content |
//! | ---: | --- |
//! | 512 | the headers; their last 24 bytes are a [`Record`] |
//! | | the section `.text`, for reading and executing: |
//! | 80 | addresses of the stub's functions, filled in by Windows |
//! | 220 | the stub's first section, which verifies the rest |
//! | 240 | the first stage, which unpacks the second |
//! | 200 | the functions' names |
//! | 57,000 | the packed program |
//! | 2,600 | the packed second stage |
//!
//! A section `.bss` reserves the program's and the second stage's fixed addresses.

use object::pe::{IMAGE_DIRECTORY_ENTRY_IAT, IMAGE_DIRECTORY_ENTRY_IMPORT};

use super::{Memory, Parts, Record};
use crate::elf::{PAGE, number};
use crate::pe::{BASE_ALIGNMENT, Executable, Imports, START};
use crate::{Error, checksum, small};

/// The stub's functions, in the order of `System` in `src/pack/stub/windows/system.rs`. The program
/// receives the first two.
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

/// The first section's offset in the file.
const HEAD: usize = 512;

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
    let parts = Parts::new(stripped, stub)?;
    let Parts { packed, first, second, memory, .. } = &parts;
    let first_at = START + addresses_size(FUNCTIONS.len());
    let names_at = first_at + first.size().next_multiple_of(4) as u64;
    let imports = Imports::new(LIBRARY, &FUNCTIONS, START, names_at);
    let packed_at = names_at + imports.names.len() as u64;
    // The packed second stage is smaller.
    let base = memory.base(packed_at + (packed.len() + second.size()) as u64)?;
    let more =
        [("SUM", base + SUM as u64), ("COUNTS_SIZE", small::MEMORY), ("SYSTEM", base + START)];
    let functions = ["fail", "unprotected"];
    let mut names = parts.names(&more, base + first_at, functions, base + packed_at);
    let stage = parts.packed_stage(&names)?;
    let end = packed_at + (packed.len() + stage.len()) as u64;
    names.insert("FILE_END", base + end);
    let mut bytes = imports.addresses;
    bytes.extend(first.link(base + first_at, &names)?);
    bytes.resize((names_at - START) as usize, 0);
    bytes.extend([&imports.names, packed, &stage].map(Vec::as_slice).concat());
    let checked_at = (first_at - START) as usize + first.first_size();
    let record: Record = [
        HEAD + (packed_at - START) as usize,
        packed.len(),
        parts.lengths[1] as usize,
        HEAD + checked_at,
        HEAD + bytes.len(),
        checksum(&bytes[checked_at..]) as usize,
    ];
    Executable {
        base,
        end: parts.stage_end().next_multiple_of(PAGE) - base,
        entry: first_at + first.place("_start"),
        text: bytes,
        directories: [
            (IMAGE_DIRECTORY_ENTRY_IAT, START..first_at),
            (IMAGE_DIRECTORY_ENTRY_IMPORT, names_at..names_at + Imports::DIRECTORY),
        ],
    }
    .to_bytes(&record.map(|number| (number as u32).to_le_bytes()).concat())
}

pub fn record(file: &[u8]) -> Record {
    [6, 5, 4, 3, 2, 1].map(|i| number(file, HEAD - 4 * i, 4) as usize)
}
