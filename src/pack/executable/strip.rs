use std::ops::Range;

use crate::elf::{self, Section, Segment, number};
use crate::{Error, panics};

/// The dynamic section's flags, and the flag that binds all functions at the start.
const FLAGS: u64 = 30;
const BIND_NOW: u64 = 8;

/// Returns the headers and segments, without unwind tables, panic locations and lazy binding. A
/// panic ends the process.
///
/// # Errors
/// If `program` is not an executable at fixed addresses.
pub fn strip(program: &[u8]) -> Result<Vec<u8>, Error> {
    let kind = elf::kind(program)?;
    if kind != elf::EXECUTABLE {
        return Err(format!("ELF type is {kind}; must be 2 (fixed addresses)").into());
    }
    let mut blanked = program.to_vec();
    let unwinding = blank(program, &mut blanked)?;
    let mut segments = elf::segments(program)?;
    let mut stripped = Vec::new();
    let before = segments.clone();
    let loads = segments.iter_mut().filter(|segment| segment.kind == elf::LOAD);
    let mut loads: Vec<_> = loads.collect();
    // Code last, behind the headers and all data: 100 bytes.
    if let [_, rest @ ..] = &mut loads[..] {
        rest.sort_by_key(|load| load.flags & elf::EXECUTE);
    }
    for load in loads {
        let mut range = load.range();
        // At the end of a segment, leave the blank section out.
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
        // Keep the offset in the page, so that the segment can be mapped.
        let lead = (load.address - stripped.len() as u64) % elf::PAGE;
        stripped.resize(stripped.len() + lead as usize, 0);
        load.offset = stripped.len() as u64;
        stripped.extend(blanked.get(range).ok_or("segment is outside the file")?);
    }
    let loads: Vec<_> =
        segments.iter().filter(|segment| segment.kind == elf::LOAD).copied().collect();
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

/// Blanks unwind tables, panic locations and lazy binding. Returns the ranges of unwind tables.
fn blank(program: &[u8], blanked: &mut [u8]) -> Result<Vec<Range<usize>>, Error> {
    let file = object::File::parse(program)?;
    let range = |name| Some(Section::find(&file, name)?.range);
    let is_bound_at_start = range(".dynamic").is_some_and(|entries| {
        let mut entries = program[entries].chunks_exact(16);
        entries.any(|it| number(it, 0, 8) == FLAGS && number(it, 8, 8) & BIND_NOW != 0)
    });
    panics::blank_locations(blanked)?;
    if let [Some(calls), Some(slots)] = [".plt", ".got.plt"].map(range)
        && is_bound_at_start
    {
        blank_lookups(blanked, calls, slots);
    }
    let names = [".eh_frame", ".eh_frame_hdr", ".gcc_except_table"];
    let unwinding: Vec<_> = names.into_iter().filter_map(range).collect();
    for section in &unwinding {
        let bytes = blanked.get_mut(section.clone());
        bytes.ok_or("section is outside the file")?.fill(0);
    }
    Ok(unwinding)
}

/// Blanks the parts that only lazy binding needs. A function's entry of 16 bytes jumps to the
/// address in its slot; until the function is bound, that is the rest of the entry, which calls the
/// linker. A program bound at the start never runs it.
fn blank_lookups(program: &mut [u8], calls: Range<usize>, slots: Range<usize>) {
    for (i, entry) in program[calls].chunks_exact_mut(16).enumerate() {
        match entry {
            [0xff, 0x35, ..] if i == 0 => entry.fill(0),
            [0xff, 0x25, _, _, _, _, rest @ ..] => rest.fill(0),
            _ => {}
        }
    }
    program[slots].fill(0);
}
