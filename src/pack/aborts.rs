//! Simplifies the ways to a panic.
//!
//! Before code calls a function that panics, it puts arguments into registers and onto the stack: the number that was too large, the
//! place in the source, and so on. Where the diet has all of these functions redirected to one that has no arguments and does not
//! return, nobody reads them, but a linker can't know that. So here, in the linked program,
//!
//! - instructions right before such a call that only write registers or the stack become `nop`s,
//! - jumps to one of them or to the call go to the first of all these calls, and
//! - calls by way of the global offset table, which has a slot for each function, go by one slot.
//!
//! Each way in is still one to the same call, and all others are as they were, so nothing that runs on is changed. Of 63,792 bytes
//! this saves 705.
//!
//! It needs to know where instructions begin. [`Reader`] finds that out from the first byte of the code on; if a function does not
//! begin where an instruction does, the reader has lost its way, and nothing is changed.

use std::collections::HashSet;

use crate::{
    elf::{Section, number},
    model::Reader,
};

/// The instruction that does nothing.
const NOP: u8 = 0x90;

/// What is to be known of a program.
pub struct Code<'a> {
    pub code: &'a Section,
    /// The global offset table.
    pub table: Option<&'a Section>,
    /// The addresses of functions.
    pub functions: &'a [u64],
    /// The address that functions which panic are redirected to.
    pub abort: u64,
}

/// Simplifies all ways to [`Code::abort`].
pub fn simplify(program: &mut [u8], code: &Code<'_>) {
    let Some(instructions) = instructions(program, code) else {
        return;
    };
    let ways = ways(program, code, &instructions);
    let Some(first) = ways.first() else {
        return;
    };
    let slot = ways.iter().find_map(|way| way.slot);
    let mut targets = HashSet::new();
    for way in &ways {
        program[way.start..way.call].fill(NOP);
        targets.extend(way.start..=way.call);
        if let Some(slot) = slot.filter(|_| way.slot.is_some()) {
            set_target(program, code, way.call + 2, slot);
        }
    }
    for &start in &instructions {
        let field = match program[start..] {
            [0x0f, 0x80..=0x8f, ..] => start + 2,
            [0xe9, ..] => start + 1,
            _ => continue,
        };
        let target = code.code.place(target(program, code, field), 1);
        if target.is_some_and(|target| targets.contains(&target.start)) {
            set_target(program, code, field, code.code.address_of(first.call));
        }
    }
}

/// Instructions in the file that end in a call of [`Code::abort`], and before that only set up its arguments.
struct Way {
    start: usize,
    call: usize,
    /// The address of the slot that it is called by.
    slot: Option<u64>,
}

fn ways(program: &[u8], code: &Code<'_>, instructions: &[usize]) -> Vec<Way> {
    let mut ways = Vec::new();
    let mut start = None;
    for pair in instructions.windows(2) {
        let instruction = &program[pair[0]..pair[1]];
        let (aborts, slot) = match *instruction {
            [0xe8, _, _, _, _] => (target(program, code, pair[0] + 1) == code.abort, None),
            [0xff, 0x15, ..] if instruction.len() == 6 => {
                let slot = target(program, code, pair[0] + 2);
                let place = code.table.and_then(|table| table.place(slot, 8));
                let aborts =
                    place.is_some_and(|place| number(program, place.start, 8) == code.abort);
                (aborts, Some(slot))
            }
            _ => (false, None),
        };
        if aborts {
            ways.push(Way {
                start: start.unwrap_or(pair[0]),
                call: pair[0],
                slot,
            });
        }
        start = is_set_up(instruction).then_some(start.unwrap_or(pair[0]));
    }
    ways
}

/// Whether an instruction does nothing but write to a register or to the stack.
fn is_set_up(instruction: &[u8]) -> bool {
    let (instruction, map) = match instruction {
        [0x0f, rest @ ..] => (rest, 1),
        // The same by AVX.
        [0xc5, _, rest @ ..] => (rest, 1),
        // A prefix for registers.
        [0x40..=0x4f, rest @ ..] => (rest, 0),
        all => (all, 0),
    };
    let &[opcode, ref operands @ ..] = instruction else {
        return false;
    };
    // A register, or the stack pointer with a displacement.
    let is_own = matches!(operands, [0xc0..=0xff, ..] | [0x04 | 0x44 | 0x84, 0x24, ..])
        || matches!(operands, [modrm, 0x24, ..] if modrm & 7 == 4);
    match (map, opcode) {
        // `lea`, `mov` to a register, and `movups` and `movaps` to one.
        (0, 0x8b | 0x8d | 0xb8..=0xbf) | (1, 0x10 | 0x28) => true,
        // `mov` of a register or a number, `xor`, and `movups` and `movaps` to memory.
        (0, 0x89 | 0xc7 | 0x31) | (1, 0x11 | 0x29) => is_own,
        _ => false,
    }
}

/// Where instructions begin in the file, and where the last one ends. None if functions begin elsewhere.
fn instructions(program: &[u8], code: &Code<'_>) -> Option<Vec<usize>> {
    let range = code.code.range.clone();
    let mut reader = Reader::default();
    let mut instructions = vec![range.start];
    for place in range {
        reader.read(program[place].into());
        if reader.is_between_instructions() {
            instructions.push(place + 1);
        }
    }
    let mut functions = code
        .functions
        .iter()
        .filter_map(|&function| code.code.place(function, 1));
    functions
        .all(|function| instructions.binary_search(&function.start).is_ok())
        .then_some(instructions)
}

/// The address that an offset at the end of an instruction leads to.
fn target(program: &[u8], code: &Code<'_>, field: usize) -> u64 {
    let offset = number(program, field, 4) as i32;
    code.code
        .address_of(field + 4)
        .wrapping_add_signed(offset.into())
}

fn set_target(program: &mut [u8], code: &Code<'_>, field: usize, target: u64) {
    let offset = target.wrapping_sub(code.code.address_of(field + 4)) as u32;
    program[field..field + 4].copy_from_slice(&offset.to_le_bytes());
}

#[cfg(test)]
mod tests {
    use super::{Code, simplify};
    use crate::elf::Section;

    const ADDRESS: u64 = 0x1000;
    const ABORT: u64 = 0x3000;

    fn call(place: u64) -> Vec<u8> {
        let offset = (ABORT - ADDRESS - place - 5) as u32;
        [&[0xe8][..], &offset.to_le_bytes()].concat()
    }

    /// Two functions. Each jumps to a call of [`ABORT`], which arguments are set up for.
    fn program() -> Vec<u8> {
        let parts = [
            // 0: jae 7; ret
            &[0x0f, 0x83, 1, 0, 0, 0, 0xc3][..],
            // 7: mov edi, 5; lea rsi, [rip + 9]
            &[0xbf, 5, 0, 0, 0, 0x48, 0x8d, 0x35, 9, 0, 0, 0],
            &call(19),
            // 24: jae 34; mov [rdi], eax; call 0; mov edi, eax
            &[0x0f, 0x83, 4, 0, 0, 0, 0x89, 0x07],
            &[0x89, 0xc7],
            &call(34),
        ];
        parts.concat()
    }

    fn simplified(functions: &[u64]) -> Vec<u8> {
        let mut program = program();
        let code = Section {
            address: ADDRESS,
            range: 0..program.len(),
        };
        let code = Code {
            code: &code,
            table: None,
            functions,
            abort: ABORT,
        };
        simplify(&mut program, &code);
        program
    }

    #[test]
    fn arguments_of_no_use_are_gone_and_jumps_have_one_target() {
        let mut expected = program();
        expected[7..19].fill(0x90);
        expected[32..34].fill(0x90);
        // Both jumps to the first call, at 19; what writes to memory of somebody else is still there.
        expected[2] = 13;
        expected[26..30].copy_from_slice(&(19_i32 - 30).to_le_bytes());
        assert_eq!(simplified(&[ADDRESS, ADDRESS + 24]), expected);
    }

    #[test]
    fn code_that_cannot_be_followed_stays_as_it_is() {
        assert_eq!(simplified(&[ADDRESS + 1]), program());
    }
}
