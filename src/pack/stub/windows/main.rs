//! The Windows stub: unpacks the program and loads it at its addresses. The packer links it from a separate object (see
//! `src/pack/build`), an ELF file, because the build machine has only Linux's core library.

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

// The entry point. On entry `rsp` is a multiple of 16, minus 8. The program gets this `rsp`, `LoadLibraryA` in `rcx` and
// `GetProcAddress` in `rdx`.
//
// It checks the FNV-1a checksum of all bytes after this section. `fail` attaches to the parent's console (-1), prints `rsi` bytes
// at `rdi` on standard error (-12), and exits with code 1.
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
    static PACKED_END: u8;
    static CHECKED: u8;
    static SUM: u32;
    /// The import table, filled in by Windows.
    static SYSTEM: System;
}

unsafe extern "C" fn start() -> usize {
    let length = packed::length();
    // SAFETY: the packer placed the table, and Windows filled it.
    let system = unsafe { &SYSTEM };
    // SAFETY: this allocates new, zeroed memory.
    let memory =
        unsafe { (system.allocate)(0, size_of::<Model>() + length, COMMIT_RESERVE, READ_WRITE) };
    if memory == 0 {
        let line = "eightfold: memory is below 70 MB\n";
        fail(line.as_ptr(), line.len());
    }
    // SAFETY: the memory is large enough, and the packer has packed an executable and the loader.
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
    let line = "eightfold: memory cannot be protected\n";
    fail(line.as_ptr(), line.len());
}
