//! Packs Linux executables. The packed file has
//!
//! | bytes | content |
//! | ---: | --- |
//! | 64 | the ELF header |
//! | 2 x 56 | program headers: this file; a stack that is not executable |
//! | 180 | the stub's first section, which verifies the rest |
//! | 280 | the first stage, which unpacks the second |
//! | 61,000 | the packed program |
//! | 2,700 | the packed second stage |

use super::{Parts, Record};
use crate::elf::{self, Segment};
use crate::{Error, checksum};

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
    let parts = Parts::new(stripped, stub)?;
    let Parts { packed, first, memory, .. } = &parts;
    // The file follows the program, so the heap, which follows both, is at its usual address. A
    // zero byte follows the stage, as an empty name for its file in memory.
    let memory_end = parts.stage_end() + 1;
    let address = memory_end.next_multiple_of(elf::PAGE);
    let first_at = address + HEAD as u64;
    let packed_at = first_at + first.size() as u64;
    let more = [
        ("SUM", address + SUM as u64),
        ("PROGRAM_SIZE", memory.end - memory.start),
        ("MEMORY_SIZE", memory_end - memory.start),
    ];
    let mut names = parts.names(&more, first_at, ["fail", "no_memory"], packed_at);
    let stage = parts.packed_stage(&names)?;
    let size = HEAD + first.size() + packed.len() + stage.len();
    names.insert("FILE_END", address + size as u64);
    let linked = first.link(first_at, &names)?;
    let checked = [&linked[first.first_size()..], packed, &stage].concat();
    let mut file = elf::header(first_at + first.place("_start"), 2);
    let file_itself = Segment {
        kind: elf::LOAD,
        flags: elf::READ | elf::EXECUTE,
        address,
        file_size: size as u64,
        size: size as u64,
        ..Segment::default()
    };
    // Linux reads only this header's flags; the unpacker reads the other fields as the record.
    let stack = Segment {
        kind: elf::STACK,
        flags: elf::READ | elf::WRITE,
        offset: packed_at - address,
        address: checksum(&checked).into(),
        physical_address: parts.lengths[1],
        file_size: packed.len() as u64,
        size: checked.len() as u64,
    };
    file.extend([file_itself, stack].map(Segment::to_bytes).concat());
    file.resize(HEAD, 0);
    file.extend(&linked[..first.first_size()]);
    file.extend(checked);
    Ok(file)
}

pub fn record(file: &[u8]) -> Result<Record, Error> {
    let segments = elf::segments(file)?;
    let is_stack = |segment: &&Segment| segment.kind == elf::STACK;
    let stack = segments.iter().find(is_stack).ok_or("file is not packed")?;
    let checked = file.len().checked_sub(stack.size as usize).ok_or("file is incomplete")?;
    let [start, length, unpacked, sum] =
        [stack.offset, stack.file_size, stack.physical_address, stack.address]
            .map(|field| field as usize);
    Ok([start, length, unpacked, checked, file.len(), sum])
}
