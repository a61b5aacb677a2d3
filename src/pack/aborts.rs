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
//! Of 63,908 bytes this saves 728.
//!
//! # Why it changes nothing that runs
//!
//! - What is called has no arguments and does not return, so it does the same whatever is in the registers, and in whichever
//!   function it is called. Nothing behind it runs.
//! - Instructions become as many bytes of `nop`s, so whoever came to one of them, by a jump, a jump table or from the instruction
//!   before, comes to the same call as before. The stack pointer is never among what they write: it stays aligned for the call.
//! - Only the offsets of jumps to such an instruction change, and they lead to such a call as well. Nothing moves, so all other
//!   addresses, in jump tables, relocations or anywhere else, are right as they are.
//!
//! All that needs to know where instructions begin. [`Reader`](crate::model::Reader) finds that out from the first byte of the code
//! on. If there were data between instructions, or an instruction that it does not know the length of, it would lose its way: then
//! functions, or what jumps and calls lead to, would not be where it sees instructions begin. Of these the intro has some thousands
//! in 160 kB; if a single one is elsewhere, nothing is changed.

use std::{collections::HashSet, ops::Range};

use crate::{
    elf::{Section, number},
    new_model,
};

/// The instruction that does nothing.
const NOP: u8 = 0x90;

/// The number of the register `rsp`. (With a prefix it is another one, which may be left as well.)
const STACK_POINTER: u8 = 4;

/// A program's code, with what is known of its parts.
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
        (0, 0x8b | 0x8d) => !matches!(operands, [modrm, ..] if modrm >> 3 & 7 == STACK_POINTER),
        (0, 0xb8..=0xbf) => opcode & 7 != STACK_POINTER,
        (1, 0x10 | 0x28) => true,
        // `mov` of a register or a number, and `xor`, to a register or the stack.
        (0, 0x89 | 0xc7 | 0x31) => {
            is_own && !matches!(operands, [modrm, ..] if modrm & 0xc7 == 0xc0 | STACK_POINTER)
        }
        // `movups` and `movaps` to memory.
        (1, 0x11 | 0x29) => is_own,
        _ => false,
    }
}

/// Where instructions begin in the file, and where the last one ends. None if a function begins elsewhere, or a jump or a call leads
/// elsewhere.
fn instructions(program: &[u8], code: &Code<'_>) -> Option<Vec<usize>> {
    let range = code.code.range.clone();
    let reader = &mut new_model().reader;
    let mut instructions = vec![range.start];
    for place in range {
        reader.read(program[place].into());
        if reader.is_between_instructions() {
            instructions.push(place + 1);
        }
    }
    let begins = |address| match code.code.place(address, 1) {
        Some(place) => instructions.binary_search(&place.start).is_ok(),
        None => true,
    };
    let mut jumps = instructions.windows(2);
    let is_right = code.functions.iter().all(|&function| begins(function))
        && jumps.all(|pair| jump_target(program, code, pair[0]..pair[1]).is_none_or(begins));
    is_right.then_some(instructions)
}

/// The address that an instruction jumps to or calls, if it does so by an offset.
fn jump_target(program: &[u8], code: &Code<'_>, instruction: Range<usize>) -> Option<u64> {
    let end = instruction.end;
    match program[instruction] {
        [0x70..=0x7f | 0xeb, offset] => {
            let next = code.code.address_of(end);
            Some(next.wrapping_add_signed((offset as i8).into()))
        }
        [0x0f, 0x80..=0x8f, _, _, _, _] | [0xe8 | 0xe9, _, _, _, _] => {
            Some(target(program, code, end - 4))
        }
        _ => None,
    }
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
    use super::{Code, is_set_up, simplify};
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
        simplified_program(program(), functions)
    }

    fn simplified_program(mut program: Vec<u8>, functions: &[u64]) -> Vec<u8> {
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

    #[test]
    fn a_jump_into_an_instruction_leaves_all_as_it_is() {
        for jump in [
            &[0xeb, 0xff][..],
            &[0x74, 0xff],
            &[0xe8, 0xfe, 0xff, 0xff, 0xff],
        ] {
            let before = [&program(), jump].concat();
            assert_eq!(simplified_program(before.clone(), &[ADDRESS]), before);
        }
    }

    /// A jump table, say. Whatever follows is read as part of it, and the jump to the call before it leads into an instruction.
    #[test]
    fn data_between_functions_leaves_all_as_it_is() {
        let data = [0x48, 0xb8, 0, 0, 0];
        let jump = [0xe9, 0, 0, 0, 0];
        let before = [&program(), &data[..], &jump, &program()].concat();
        let second = ADDRESS + (program().len() + data.len()) as u64;
        assert_eq!(
            simplified_program(before.clone(), &[ADDRESS, second]),
            before
        );
    }

    #[test]
    fn only_what_writes_other_registers_or_the_stack_sets_up_a_call() {
        for instruction in [
            // mov edi, 5; lea rsi, [rip]; mov rdi, rax; xor edi, edi; mov [rsp + 8], rax; movups [rsp], xmm0
            &[0xbf, 5, 0, 0, 0][..],
            &[0x48, 0x8d, 0x35, 0, 0, 0, 0],
            &[0x48, 0x89, 0xc7],
            &[0x31, 0xff],
            &[0x48, 0x89, 0x44, 0x24, 8],
            &[0x0f, 0x11, 0x04, 0x24],
        ] {
            assert!(is_set_up(instruction), "{instruction:x?}");
        }
        for instruction in [
            // lea rsp, [rbp - 8]; mov rsp, rbp; mov esp, 5; mov rsp, [rax]; xor esp, esp
            &[0x48, 0x8d, 0x65, 0xf8][..],
            &[0x48, 0x89, 0xec],
            &[0xbc, 5, 0, 0, 0],
            &[0x48, 0x8b, 0x20],
            &[0x31, 0xe4],
            // mov [rdi], eax; movups [rdi], xmm0; push rax; sub rsp, 8; jmp 0; ret
            &[0x89, 0x07],
            &[0x0f, 0x11, 0x07],
            &[0x50],
            &[0x48, 0x83, 0xec, 8],
            &[0xeb, 0xfe],
            &[0xc3],
        ] {
            assert!(!is_set_up(instruction), "{instruction:x?}");
        }
    }
}
