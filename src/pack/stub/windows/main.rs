//! The stub that starts the packed program on Windows: it unpacks the program behind it and puts that to its addresses.
//!
//! It is compiled by itself, to an object that the packer links; see `src/pack/build`. It is an ELF object, as that of Linux: the
//! standard library's core for Linux is there wherever that is packed, too, and only calls of Windows are made in another way. What
//! only a program that has been unpacked needs, the [loader], is packed with it.

#![no_std]
#![no_main]
#![warn(clippy::undocumented_unsafe_blocks)]

#[path = "../elf.rs"]
mod elf;
mod loader;
#[path = "../../model/mod.rs"]
mod model;
#[path = "../packed.rs"]
mod packed;
mod system;

use core::{arch::global_asm, mem::transmute};
use model::Model;
use packed::fail;
use system::{COMMIT_RESERVE, READ_EXECUTE, READ_WRITE, RELEASE, System, protect};

// Windows comes here, with a stack that is aligned to 16 bytes but for the return address. The program is begun with the same stack,
// and with the functions by which it finds all others: `LoadLibraryA` in `rcx`, `GetProcAddress` in `rdx`.
//
// First of all comes a checksum of all behind these instructions, FNV-1a as in the packer: they and what they say are all that nobody
// checks, besides the headers and the import table. (A file that was cut Windows does not start.)
//
// What there is to say goes to the console of whoever started it, if that has one: `AttachConsole(-1)`; then
// `WriteFile(GetStdHandle(-12), line, length, &written, 0)` and `ExitProcess(1)`.
global_asm!(
    ".section .text.first, \"ax\"",
    ".globl _start",
    "_start:",
    "sub rsp, 40",
    "mov esi, offset {checked}",
    "mov eax, 0x811c9dc5",
    "2:",
    "movzx edx, byte ptr [rsi]",
    "xor eax, edx",
    "imul eax, eax, 0x1000193",
    "inc esi",
    "cmp esi, offset {end}",
    "jne 2b",
    "cmp eax, [rip + {sum}]",
    "jne 3f",
    "call {start}",
    "mov rcx, [rip + {system}]",
    "mov rdx, [rip + {system} + 8]",
    "add rsp, 40",
    "jmp rax",
    "3:",
    "lea rdi, [rip + 4f]",
    "push 32",
    "pop rsi",
    // Says a line of so many bytes on standard error and ends the process.
    "fail:",
    "and rsp, -16",
    "sub rsp, 48",
    "or rcx, -1",
    "call [rip + {system} + 40]",
    "push -12",
    "pop rcx",
    "call [rip + {system} + 48]",
    "mov rcx, rax",
    "mov rdx, rdi",
    "mov r8d, esi",
    "lea r9, [rsp + 40]",
    "and qword ptr [rsp + 32], 0",
    "call [rip + {system} + 56]",
    "push 1",
    "pop rcx",
    "call [rip + {system} + 64]",
    "4:",
    ".ascii \"eightfold: this file is damaged\\n\"",
    end = sym PACKED_END,
    checked = sym CHECKED,
    sum = sym SUM,
    start = sym start,
    system = sym SYSTEM,
);

unsafe extern "C" {
    /// The end of the packed bytes.
    static PACKED_END: u8;
    /// Where all begins that [`SUM`] is the checksum of, up to the end of what was packed.
    static CHECKED: u8;
    static SUM: u32;
    /// Where Windows has put the addresses of its functions.
    static SYSTEM: System;
}

/// Unpacks the program and loads it. Returns where it begins.
unsafe extern "C" fn start() -> usize {
    let length = packed::length();
    // SAFETY: the packer has put it there, and Windows has filled it.
    let system = unsafe { &SYSTEM };
    // SAFETY: it is new memory, zero to begin with.
    let memory =
        unsafe { (system.allocate)(0, size_of::<Model>() + length, COMMIT_RESERVE, READ_WRITE) };
    if memory == 0 {
        let line = "eightfold: there are no 70 MB of memory for it\n";
        fail(line.as_ptr(), line.len());
    }
    // SAFETY: there is as much memory. The packer has packed an executable and the loader.
    unsafe {
        let file = packed::unpack(memory);
        let program_length = packed::program_length();
        let loader = file.add(program_length);
        if protect(system, loader.addr(), length - program_length, READ_EXECUTE) {
            let load: loader::Load = transmute(loader);
            let entry = load(&*file.cast(), system);
            if entry != 0 {
                (system.free)(memory, 0, RELEASE);
                return entry;
            }
        }
    }
    let line = "eightfold: the system does not let it start\n";
    fail(line.as_ptr(), line.len());
}
