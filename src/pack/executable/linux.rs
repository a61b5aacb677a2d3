//! Packs Linux executables. The packed file has
//!
//! | bytes | content |
//! | ---: | --- |
//! | 64 | the ELF header |
//! | 2 x 56 | program headers: this file; a stack that is not executable |
//! | 138 | the stub's first section, which verifies the rest; it also reports truncation behind itself |
//! | 4,200 | the stub |
//! | the rest | the packed program |

use std::collections::HashMap;

use super::{Memory, encode_both};
use crate::{
    DAMAGED, Error, checksum, decode, elf,
    elf::Segment,
    stub::{FIRST, LOADER, Stub},
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
    let Memory { start, end } = Memory::of(&segments)?;
    // Place the file after the program, so that the heap, which follows both, is at its usual address.
    let stub = Stub::read(stub, FIRST)?;
    let size = (HEAD + stub.size() + packed.len()) as u64;
    let address = end.next_multiple_of(elf::PAGE);
    let entry = address + HEAD as u64;
    let packed_at = entry + stub.size() as u64;
    let names = HashMap::from([
        ("SUM", address + SUM as u64),
        ("CHECKED", entry + stub.first_size() as u64),
        ("PACKED", packed_at),
        ("PACKED_END", packed_at + packed.len() as u64),
        ("LENGTH", unpacked.len() as u64),
        ("PROGRAM_LENGTH", stripped.len() as u64),
        ("PROGRAM", start),
        ("PROGRAM_SIZE", end - start),
    ]);
    let linked = stub.link(entry, &names)?;
    let (first, rest) = linked.split_at(stub.first_size());
    let checked = [rest, &packed].concat();
    let mut file = elf::header(entry, 2);
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
        offset: (HEAD + stub.size()) as u64,
        address: checksum(&checked).into(),
        physical_address: unpacked.len() as u64,
        file_size: packed.len() as u64,
        size: checked.len() as u64,
    };
    for segment in [file_itself, stack] {
        file.extend(segment.to_bytes());
    }
    file.resize(HEAD, 0);
    file.extend(first);
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
