//! Blanks panic locations, which saves 1,091 of 66,047 bytes. These are 24-byte records in
//! `.data.rel.ro`: address and length of a file's name in `.rodata`, line, column.
//!
//! Only the code of panic messages reads these records, and `build::redirect` has replaced this
//! code. A record has a name that ends in `.rs`, and a line and a column of at least 1.

use std::ops::Range;

use object::{Object, ObjectSymbol};

use crate::Error;
use crate::elf::{Section, number};

pub const ABORT: &str = "eightfold_abort";

/// The end of the panic handler's mangled name.
const HANDLER: &str = "17rust_begin_unwind";

const RECORD: usize = 24;

pub fn blank_locations(program: &mut [u8]) -> Result<(), Error> {
    let file = object::File::parse(&*program)?;
    let section = |name| Section::find(&file, name);
    if is_redirected(&file)
        && let (Some(names), Some(records)) = (section(".rodata"), section(".data.rel.ro"))
    {
        blank(program, &names, &records);
    }
    Ok(())
}

fn is_redirected(file: &object::File<'_>) -> bool {
    let address = |is_it: fn(&str) -> bool| {
        let is_it = |symbol: &object::Symbol<'_, '_>| {
            !symbol.is_undefined() && symbol.name().is_ok_and(is_it)
        };
        file.symbols().find(is_it).map(|symbol| symbol.address())
    };
    let abort = address(|name| name == ABORT);
    abort.is_some() && address(|name| name.ends_with(HANDLER)) == abort
}

fn blank(program: &mut [u8], names: &Section, records: &Section) {
    let mut blanked = Vec::new();
    for place in records.range.clone().step_by(8) {
        if let Some(name) = location(program, place, names, records) {
            program[place..place + RECORD].fill(0);
            blanked.push(name);
        }
    }
    for name in blanked {
        program[name].fill(0);
    }
}

fn location(
    program: &[u8],
    place: usize,
    names: &Section,
    records: &Section,
) -> Option<Range<usize>> {
    if place + RECORD > records.range.end {
        return None;
    }
    let [line, column] = [16, 20].map(|field| number(program, place + field, 4));
    let (address, length) = (number(program, place, 8), number(program, place + 8, 8));
    let name = names.place(address, length)?;
    let text = &program[name.clone()];
    let is_path =
        text.iter().all(|byte| byte.is_ascii_alphanumeric() || b"/._-+<>() ".contains(byte));
    (line != 0 && column != 0 && is_path && text.ends_with(b".rs")).then_some(name)
}

#[cfg(test)]
mod tests {
    use super::{RECORD, blank};
    use crate::elf::Section;

    const NAMES: &[u8] = b"src/a.rssrc/b.rssrc/c.rsno path.";
    const BASE: u64 = 0x20_0000;

    #[test]
    fn panic_locations_are_blanked() {
        let record = |name: u64, line: u32, column: u32| {
            let words = [BASE + name, 8].map(u64::to_le_bytes);
            let halves = [line, column].map(u32::to_le_bytes);
            [words.as_flattened(), halves.as_flattened()].concat()
        };
        let section = |start, end| Section { address: BASE + start as u64, range: start..end };
        // The second has no line, the fourth no path.
        let records = [record(0, 12, 5), record(8, 0, 7), record(16, 3, 1), record(24, 3, 1)];
        let before = [NAMES, &records.concat()].concat();
        let mut after = before.clone();
        let names = section(0, NAMES.len());
        blank(&mut after, &names, &section(NAMES.len(), before.len()));
        let mut expected = before;
        for place in [0, 16] {
            expected[place..place + 8].fill(0);
        }
        for record in [0, 2] {
            expected[NAMES.len() + record * RECORD..][..RECORD].fill(0);
        }
        assert_eq!(after, expected);
    }
}
