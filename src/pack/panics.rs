//! Blanks what a panic would have told: where in the source it was.
//!
//! Such a `Location` is a record of 24 bytes in `.data.rel.ro`: the address and the length of a file's name in `.rodata`, a line and
//! a column. Code that panics passes its address along. Packed, zeros take next to nothing: of 64,172 bytes this saves 992.
//!
//! # Why nobody misses it
//!
//! - Only what tells of a panic reads a record, and the diet has left that out: what is called instead has no arguments. Where the
//!   panic handler is not redirected, as in any other program, all stays as it is.
//! - A record is known by all of its parts: an address in `.rodata`, the length of a name there that ends in `.rs`, and a line and a
//!   column, which count from 1. So a program must not have such records of its own to read; the intro has no names of source files
//!   but these.
//! - A name is a constant of its own, and is blanked only if no other address that could be of one of its bytes is anywhere in the
//!   data, aligned or not, or in the code, at whatever place an instruction may have it. What has the same text stays.

use std::ops::Range;

use object::{Object, ObjectSymbol, SymbolKind};

use crate::{
    Error,
    aborts::{self, Code},
    elf::{Section, number},
};

/// The function that the diet has called in place of those that panic.
pub const ABORT: &str = "eightfold_abort";

/// The end of the panic handler's name, which is mangled.
const HANDLER: &str = "17rust_begin_unwind";

/// Bytes of a `Location`.
const RECORD: usize = 24;

/// The sections that take part.
struct Sections {
    /// `.rodata`, with the names of files.
    names: Section,
    /// `.data.rel.ro`, with the records.
    records: Section,
    code: Section,
    /// All that may have addresses in it as words of 8 bytes.
    data: Vec<Section>,
}

/// Leaves out what panics would tell, and [simplifies](aborts) the ways to them, if they go to [`ABORT`].
///
/// # Errors
/// If it is no ELF file.
pub fn simplify(program: &mut [u8]) -> Result<(), Error> {
    // Find the sections, and where panics go.
    let file = object::File::parse(&*program)?;
    let section = |name| Section::find(&file, name);
    let (Some(names), Some(records), Some(code)) = (
        section(".rodata"),
        section(".data.rel.ro"),
        section(".text"),
    ) else {
        return Ok(());
    };
    let Some(abort) = redirected(&file, program, &code) else {
        return Ok(());
    };
    // Find the beginnings of functions.
    let table = section(".got");
    let functions = file.symbols().filter(|symbol| {
        symbol.is_definition() && symbol.kind() == SymbolKind::Text && symbol.size() != 0
    });
    let functions: Vec<_> = functions.map(|symbol| symbol.address()).collect();
    let data = [".rodata", ".data.rel.ro", ".data", ".got"];
    let sections = Sections {
        names,
        records,
        code,
        data: data.into_iter().filter_map(section).collect(),
    };
    // Simplify the ways to panics, then blank what nothing reads any more.
    aborts::simplify(
        program,
        &Code {
            code: &sections.code,
            table: table.as_ref(),
            functions: &functions,
            abort,
        },
    );
    blank(program, &sections);
    Ok(())
}

/// Where the panic handler is, if all that it does is a jump to [`ABORT`].
fn redirected(file: &object::File<'_>, program: &[u8], code: &Section) -> Option<u64> {
    let address = |is_it: fn(&str) -> bool| {
        let mut symbols = file.symbols();
        symbols
            .find(|symbol| symbol.is_definition() && symbol.name().is_ok_and(is_it))
            .map(|symbol| symbol.address())
    };
    let handler = address(|name| name.ends_with(HANDLER))?;
    let abort = address(|name| name == ABORT)?;
    let jump = &program[code.place(handler, 5)?];
    let target = (handler + 5).wrapping_add_signed(number(jump, 1, 4) as i32 as i64);
    (jump[0] == 0xe9 && target == abort).then_some(handler)
}

fn blank(program: &mut [u8], sections: &Sections) {
    let mut names = Vec::new();
    for place in sections.records.range.clone().step_by(8) {
        if let Some(name) = location(program, place, sections) {
            program[place..place + RECORD].fill(0);
            names.push(name);
        }
    }
    let used = pointed_to(program, sections);
    for name in names {
        let start = name.start - sections.names.range.start;
        if !used[start..start + name.len()].contains(&true) {
            program[name].fill(0);
        }
    }
}

/// Where the name of a location's file is, if there is a location.
fn location(program: &[u8], place: usize, sections: &Sections) -> Option<Range<usize>> {
    if place + RECORD > sections.records.range.end {
        return None;
    }
    let [line, column] = [16, 20].map(|field| number(program, place + field, 4));
    let (address, length) = (number(program, place, 8), number(program, place + 8, 8));
    let name = sections.names.place(address, length)?;
    let text = &program[name.clone()];
    let is_path = text
        .iter()
        .all(|byte| byte.is_ascii_alphanumeric() || b"/._-+<>() ".contains(byte));
    (line != 0 && column != 0 && is_path && text.ends_with(b".rs")).then_some(name)
}

/// For each byte of [`Sections::names`], whether something may point to it: an address, or an offset in an instruction. Where
/// numbers look like some by chance, a name is left that could have been blanked.
fn pointed_to(program: &[u8], sections: &Sections) -> Vec<bool> {
    let names = &sections.names;
    let mut used = vec![false; names.range.len()];
    let mut point = |address| {
        if let Some(place) = names.place(address, 1) {
            used[place.start - names.range.start] = true;
        }
    };
    for section in &sections.data {
        for place in section.range.start..section.range.end.saturating_sub(7) {
            point(number(program, place, 8));
        }
    }
    for (i, place) in sections.code.range.clone().enumerate() {
        let field = number(program, place, 4);
        point(field);
        // An offset is from the end of its instruction, before which may be an immediate value of 1, 2 or 4 bytes.
        for end in [4, 5, 6, 8] {
            let next = sections.code.address + i as u64 + end;
            point(next.wrapping_add_signed(field as i32 as i64));
        }
    }
    used
}

#[cfg(test)]
mod tests {
    use super::{RECORD, Sections, blank};
    use crate::elf::Section;

    const NAMES: &[u8] = b"src/a.rssrc/b.rssrc/c.rsno path.";
    /// Where in memory the file is.
    const BASE: u64 = 0x20_0000;
    const RECORDS: usize = 32;
    const CODE: usize = RECORDS + 5 * RECORD;

    fn section(start: usize, end: usize) -> Section {
        Section {
            address: BASE + start as u64,
            range: start..end,
        }
    }

    fn record(name: u64, length: u64, line: u32, column: u32) -> Vec<u8> {
        let words = [BASE + name, length].map(u64::to_le_bytes);
        let halves = [line, column].map(u32::to_le_bytes);
        [words.as_flattened(), halves.as_flattened()].concat()
    }

    /// Names, records and an instruction that reads the address of `src/c.rs`.
    fn image() -> (Vec<u8>, Sections) {
        let mut image = NAMES.to_vec();
        image.extend(record(0, 8, 12, 5));
        image.extend(record(8, 8, 0, 7));
        image.extend(record(16, 8, 3, 1));
        image.extend(record(24, 8, 3, 1));
        image.extend(record(0, 8, 13, 9));
        let offset = 16 - (CODE as i32 + 7);
        image.extend([0x48, 0x8d, 0x35]);
        image.extend(offset.to_le_bytes());
        let sections = Sections {
            names: section(0, RECORDS),
            records: section(RECORDS, CODE),
            code: section(CODE, image.len()),
            data: vec![section(0, RECORDS), section(RECORDS, CODE)],
        };
        (image, sections)
    }

    #[test]
    fn locations_and_their_names_are_blanked_and_nothing_else() {
        let (before, sections) = image();
        let mut after = before.clone();
        blank(&mut after, &sections);
        let mut expected = before;
        // The first name has only locations, the others a record without a line, an instruction, and no path.
        expected[..8].fill(0);
        for record in [0, 2, 4] {
            let start = RECORDS + record * RECORD;
            expected[start..start + RECORD].fill(0);
        }
        assert_eq!(after, expected);
    }

    #[test]
    fn a_name_that_anything_else_points_to_stays() {
        let (before, mut sections) = image();
        let end = before.len();
        let offset = -(end as i32 + 7);
        // cmp byte [rip + offset], 1
        let instruction = [&[0x80, 0x3d][..], &offset.to_le_bytes(), &[1]].concat();
        let mut after = [&before[..], &instruction].concat();
        sections.code.range.end = after.len();
        blank(&mut after, &sections);
        assert_eq!(after[..8], before[..8]);

        // An address that is not aligned to its size.
        let (_, mut sections) = image();
        let mut after = [&before[..], &[1], &BASE.to_le_bytes()].concat();
        sections.data.push(section(end, after.len()));
        blank(&mut after, &sections);
        assert_eq!(after[..8], before[..8]);
    }
}
