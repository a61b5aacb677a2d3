//! Makes a packed executable of an ordinary one.
//!
//! The packed content is an ELF file itself, without all that neither Linux nor the dynamic linker reads, and the stub's loader, which
//! loads it like any other. The packed file has
//!
//! | bytes | what |
//! | ---: | --- |
//! | 64 | the ELF header |
//! | 2 x 56 | program headers: this file; a stack that is not executable |
//! | 138 | the stub's beginning, which checks all that follows: a file that was cut to no less than this says so |
//! | 4,200 | the stub |
//! | the rest | what was packed |

use std::collections::HashMap;

use crate::{
    Damaged, Error, LONGEST, checksum, decode, elf,
    elf::Segment,
    encode, panics,
    stub::{FIRST, LOADER, Stub},
};

/// Bytes before the stub: the headers, and so many that its constants are aligned.
const HEAD: usize = (elf::HEADER_SIZE + 2 * Segment::SIZE).next_multiple_of(16);

/// Where in the file the checksum is: where the second program header has an address.
const SUM: usize = elf::HEADER_SIZE + Segment::SIZE + 16;

/// A packed executable of an ordinary one and the stub's object file.
///
/// # Errors
/// If it is no executable that the stub can load.
pub fn pack_executable(program: &[u8], stub: &[u8]) -> Result<Vec<u8>, Error> {
    // Put the loader behind the stripped program.
    let stripped = strip(program)?;
    let loader = Stub::read(stub, LOADER)?.link_anywhere()?;
    let unpacked = [&*stripped, &loader].concat();
    if unpacked.len() > LONGEST {
        return Err(format!("{} bytes are too many", unpacked.len()).into());
    }
    // Pack both, and make sure that they can be unpacked.
    let packed = encode(&unpacked);
    if decode(&packed, unpacked.len()).as_ref() != Ok(&unpacked) {
        return Err("what is unpacked is not what was packed".into());
    }
    // Find the memory that the program takes.
    let loads = elf::segments(&stripped)?;
    let loads = loads.iter().filter(|segment| segment.kind == elf::LOAD);
    let start = loads
        .clone()
        .map(|load| load.address)
        .min()
        .unwrap_or_default()
        / elf::PAGE
        * elf::PAGE;
    let end = loads
        .map(|load| load.address + load.size)
        .max()
        .unwrap_or_default();

    // The file lies right behind the program, so that the heap, which begins behind both, is where it always is.
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
    // Link the stub to its address, and compute what it checks.
    let linked = stub.link(entry, &names)?;
    let (first, rest) = linked.split_at(stub.first_size());
    let checked = [rest, &packed].concat();
    // Write the header, the two segments, the stub and the packed bytes.
    let mut file = elf::header(entry, 2);
    let file_itself = Segment {
        kind: elf::LOAD,
        flags: elf::READ | elf::EXECUTE,
        address,
        file_size: size,
        size,
        ..Segment::default()
    };
    // Of this one, Linux reads only the flags. The rest says where in the file the packed bytes are, how many bytes at its end are
    // checked, what their checksum is, and how many bytes were packed.
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

/// The program that is in a packed executable.
///
/// # Errors
/// If it is none, or not whole.
pub fn unpack_executable(file: &[u8]) -> Result<Vec<u8>, Error> {
    let segments = elf::segments(file)?;
    let is_stack = |segment: &&Segment| segment.kind == elf::STACK;
    let stack = segments.iter().find(is_stack).ok_or("it is not packed")?;
    let packed = file.get(stack.range()).ok_or("it is not whole")?;
    let start = file.len().checked_sub(stack.size as usize);
    let checked = file.get(start.ok_or("it is not whole")?..);
    if checked.is_none_or(|checked| u64::from(checksum(checked)) != stack.address) {
        return Err(Damaged.into());
    }
    let mut unpacked = decode(packed, stack.physical_address as usize)?;
    // The rest is the loader.
    let ends = elf::segments(&unpacked)?
        .into_iter()
        .map(|segment| segment.range().end);
    unpacked.truncate(ends.max().unwrap_or_default());
    Ok(unpacked)
}

/// Keeps what Linux and the dynamic linker read of an executable: its headers and segments, without what only unwinding reads, or a
/// report of a panic. That is not needed where a panic ends the process.
///
/// # Errors
/// If it is no executable at fixed addresses that a dynamic linker starts.
pub fn strip(program: &[u8]) -> Result<Vec<u8>, Error> {
    if elf::kind(program)? != elf::EXECUTABLE {
        return Err("it is not linked to fixed addresses".into());
    }
    // Look for what only unwinding reads, and for what has to be there.
    let unwinding = elf::sections(
        program,
        &[".eh_frame", ".eh_frame_hdr", ".gcc_except_table"],
    )?;
    let mut segments = elf::segments(program)?;
    for kind in [elf::INTERPRETER, elf::PROGRAM_HEADERS] {
        if !segments.iter().any(|segment| segment.kind == kind) {
            return Err("no dynamic linker starts it".into());
        }
    }
    // Leave out the reports of panics, and blank the sections for unwinding.
    let mut program = program.to_vec();
    panics::simplify(&mut program)?;
    for section in &unwinding {
        let bytes = program.get_mut(section.clone());
        bytes.ok_or("a section is not in it")?.fill(0);
    }
    // Copy the segments that are loaded, one behind the other.
    let mut stripped = Vec::new();
    let before = segments.clone();
    for load in segments
        .iter_mut()
        .filter(|segment| segment.kind == elf::LOAD)
    {
        let mut range = load.range();
        // At the end of a segment it is left out; elsewhere it is zeros now, which take next to nothing.
        while let Some(last) = unwinding.iter().find(|section| {
            (range.start + 1..range.end).contains(&section.start)
                && section.end.next_multiple_of(16) >= range.end
        }) {
            range.end = last.start;
        }
        if load.size == load.file_size {
            load.size = range.len() as u64;
        }
        load.file_size = range.len() as u64;
        // The same place in a page, so that it can be mapped, too.
        let lead = (load.address - stripped.len() as u64) % elf::PAGE;
        stripped.resize(stripped.len() + lead as usize, 0);
        load.offset = stripped.len() as u64;
        stripped.extend(program.get(range).ok_or("a segment is not in it")?);
    }
    // Have the other segments point to where their bytes are now.
    let loads: Vec<_> = segments
        .iter()
        .filter(|segment| segment.kind == elf::LOAD)
        .copied()
        .collect();
    for (segment, before) in segments.iter_mut().zip(&before) {
        if [elf::UNWINDING, elf::NOTE].contains(&segment.kind) {
            *segment = Segment::default();
        } else if segment.kind != elf::LOAD {
            let load = loads
                .iter()
                .find(|load| (load.address..load.address + load.size).contains(&before.address));
            segment.offset = load.map_or(0, |load| load.offset + (segment.address - load.address));
        }
    }
    elf::set_segments(&mut stripped, &segments)?;
    Ok(stripped)
}
