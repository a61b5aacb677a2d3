//! Packs Linux executables. The packed file has
//!
//! | bytes | content |
//! | ---: | --- |
//! | 64 | the ELF header |
//! | 2 x 56 | program headers: this file; a stack that is not executable |
//! | 180 | the stub's first section, which verifies the rest; it also reports truncation behind itself |
//! | 280 | the first stage, which unpacks the second |
//! | 61,000 | the packed program |
//! | 2,700 | the packed second stage |

use std::collections::HashMap;

use super::{Memory, encode_both};
use crate::{
    DAMAGED, Error, checksum, decode, elf,
    elf::Segment,
    small,
    stub::{FIRST, LOADER, STAGE, Stub},
};

/// The size of the headers, with padding to align the stub's constants.
const HEAD: usize = (elf::HEADER_SIZE + 2 * Segment::SIZE).next_multiple_of(16);

/// The file offset of the checksum: the second program header's address field.
const SUM: usize = elf::HEADER_SIZE + Segment::SIZE + 16;

pub fn pack(stripped: &[u8], stub: &[u8]) -> Result<Vec<u8>, Error> {
    let segments = elf::segments(stripped)?;
    for kind in [elf::INTERPRETER, elf::PROGRAM_HEADERS] {
        if !segments.iter().any(|segment| segment.kind == kind) {
            return Err("dynamic linker is missing from the program".into());
        }
    }
    let loader = Stub::read(stub, LOADER)?.link_anywhere()?;
    let unpacked = [stripped, &loader].concat();
    let packed = encode_both(&unpacked)?;
    let memory = Memory::of(&segments)?;
    let Memory { start, end } = memory;
    let [first, second] = [FIRST, STAGE].map(|section| Stub::read(stub, section));
    let (first, second) = (first?, second?);
    let stage = memory.stage();
    let stage_end = stage + second.size() as u64;
    // Place the file after the program, so that the heap, which follows both, is at its usual address.
    // A zero byte follows the stage, as an empty name for its file in memory.
    let memory_end = stage_end + 1;
    let address = memory_end.next_multiple_of(elf::PAGE);
    let first_at = address + HEAD as u64;
    let packed_at = first_at + first.size() as u64;
    let packed_end = packed_at + packed.len() as u64;
    let mut names = HashMap::from([
        ("SUM", address + SUM as u64),
        ("STAGE", stage),
        ("STAGE_END", stage_end),
        ("STAGE_LENGTH", second.size() as u64),
        ("STAGE_PACKED", packed_end),
        ("PACKED", packed_at),
        ("PACKED_END", packed_end),
        ("LENGTH", unpacked.len() as u64),
        ("PROGRAM_LENGTH", stripped.len() as u64),
        ("PROGRAM", start),
        ("PROGRAM_SIZE", end - start),
        ("MEMORY_SIZE", memory_end - start),
    ]);
    for name in ["fail", "no_memory"] {
        names.insert(name, first_at + first.place(name));
    }
    let second = small::encode(&second.link(stage, &names)?);
    let size = packed_end + second.len() as u64 - address;
    names.insert("FILE_END", address + size);
    let linked = first.link(first_at, &names)?;
    let checked = [&linked[first.first_size()..], &packed, &second].concat();
    let mut file = elf::header(first_at + first.place("_start"), 2);
    let file_itself = Segment {
        kind: elf::LOAD,
        flags: elf::READ | elf::EXECUTE,
        address,
        file_size: size,
        size,
        ..Segment::default()
    };
    // Linux reads only this header's flags. The rest are the packed bytes' offset and length, the length that the checksum covers,
    // the checksum, and the unpacked length.
    let stack = Segment {
        kind: elf::STACK,
        flags: elf::READ | elf::WRITE,
        offset: packed_at - address,
        address: checksum(&checked).into(),
        physical_address: unpacked.len() as u64,
        file_size: packed.len() as u64,
        size: checked.len() as u64,
    };
    for segment in [file_itself, stack] {
        file.extend(segment.to_bytes());
    }
    file.resize(HEAD, 0);
    file.extend(&linked[..first.first_size()]);
    file.extend(checked);
    Ok(file)
}

pub fn unpack(file: &[u8]) -> Result<Vec<u8>, Error> {
    let segments = elf::segments(file)?;
    let is_stack = |segment: &&Segment| segment.kind == elf::STACK;
    let stack = segments.iter().find(is_stack).ok_or("file is not packed")?;
    let packed = file.get(stack.range()).ok_or("file is incomplete")?;
    let start = file.len().checked_sub(stack.size as usize);
    let checked = file.get(start.ok_or("file is incomplete")?..);
    if checked.is_none_or(|checked| u64::from(checksum(checked)) != stack.address) {
        return Err(DAMAGED.into());
    }
    decode(packed, stack.physical_address as usize)
}
