//! Takes away of an executable what nobody reads who starts it.

use std::ops::Range;

use crate::{
    Error,
    elf::{self, Section, Segment, number},
    panics,
};

/// The kind of entry of the dynamic section with flags, and the flag of a program whose functions are all found when it starts.
const FLAGS: u64 = 30;
const BIND_NOW: u64 = 8;

/// Keeps what is read of an executable to start it: its headers and segments, without what only unwinding reads, or a report of a
/// panic. That is not needed where a panic ends the process.
///
/// # Errors
/// If it is no executable at fixed addresses.
pub fn strip(program: &[u8]) -> Result<Vec<u8>, Error> {
    if elf::kind(program)? != elf::EXECUTABLE {
        return Err("it is not linked to fixed addresses".into());
    }
    // Look for what only unwinding reads, and for the segments.
    let file = object::File::parse(program)?;
    let range = |name| Some(Section::find(&file, name)?.range);
    let names = [".eh_frame", ".eh_frame_hdr", ".gcc_except_table"];
    let unwinding: Vec<_> = names.into_iter().filter_map(range).collect();
    let mut segments = elf::segments(program)?;
    let lookups = [".plt", ".got.plt"].map(range);
    let is_bound_at_start = range(".dynamic").is_some_and(|entries| {
        let entries = program[entries].chunks_exact(16);
        let mut fields = entries.map(|entry| [number(entry, 0, 8), number(entry, 8, 8)]);
        fields.any(|[tag, value]| tag == FLAGS && value & BIND_NOW != 0)
    });
    // Leave out the reports of panics, and blank the sections for unwinding.
    let mut program = program.to_vec();
    panics::blank_locations(&mut program)?;
    if let [Some(calls), Some(slots)] = lookups
        && is_bound_at_start
    {
        blank_lookups(&mut program, calls, slots);
    }
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

/// Blanks what finds a function of a library when it is first called. Entries of 16 bytes jump to an address in a slot, which at first
/// is that of the rest of the entry: this pushes a number, and jumps to the first entry.
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
