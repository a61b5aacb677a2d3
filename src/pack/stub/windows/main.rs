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

use core::{
    arch::{asm, global_asm},
    mem::transmute,
};
use model::Model;
use packed::fail;
use system::{COMMIT_RESERVE, READ_EXECUTE, READ_WRITE, RELEASE, System, protect};

// The first stage. On entry `rsp` is a multiple of 16, minus 8. The program gets this `rsp`, `LoadLibraryA` in `rcx` and
// `GetProcAddress` in `rdx`.
//
// It checks the FNV-1a checksum of all bytes after this section. `fail` attaches to the parent's console (-1), prints `rsi` bytes
// at `rdi` on standard error (-12), and exits with code 1.
global_asm!(
    ".section .text.first, \"ax\"",
    ".globl unprotected, fail, _start",
    "unprotected:",
    "mov edi, offset protection_line",
    "push 38",
    "jmp 2f",
    "1:",
    "mov edi, offset damaged_line",
    "push 32",
    "2:",
    "pop rsi",
    "fail:",
    "and rsp, -16",
    "sub rsp, 48",
    "or rcx, -1",
    "call [rip + SYSTEM + 40]",
    "push -12",
    "pop rcx",
    "call [rip + SYSTEM + 48]",
    "mov rcx, rax",
    "mov rdx, rdi",
    "mov r8d, esi",
    "lea r9, [rsp + 40]",
    "and qword ptr [rsp + 32], 0",
    "call [rip + SYSTEM + 56]",
    "push 1",
    "pop rcx",
    "call [rip + SYSTEM + 64]",
    "protection_line:",
    ".ascii \"eightfold: memory cannot be protected\\n\"",
    "damaged_line:",
    ".ascii \"eightfold: this file is damaged\\n\"",
    "_start:",
    "sub rsp, 40",
    "mov esi, offset checked",
    "mov eax, 0x811c9dc5",
    "2:",
    "movzx edx, byte ptr [rsi]",
    "xor eax, edx",
    "imul eax, eax, 0x1000193",
    "inc esi",
    "cmp esi, offset FILE_END",
    "jne 2b",
    "cmp eax, dword ptr [rip + SUM]",
    "jne 1b",
    // The next section follows.
    ".section .text.unpack, \"ax\"",
    "checked:",
    include_str!("../small.s"),
    // Make the second stage readable and executable.
    "mov ecx, offset STAGE",
    "mov edx, offset STAGE_LENGTH",
    "push 0x20",
    "pop r8",
    "lea r9, [rsp + 32]",
    "call [rip + SYSTEM + 24]",
    "test eax, eax",
    "jz unprotected",
    "call STAGE",
    "mov rcx, [rip + SYSTEM]",
    "mov rdx, [rip + SYSTEM + 8]",
    "add rsp, 40",
    "jmp rax",
);

unsafe extern "C" {
    /// The import table, filled in by Windows.
    static SYSTEM: System;
    /// The first stage's counts, and their size as an address. The program needs zeroed memory.
    static PROGRAM: u8;
    static COUNTS_SIZE: u8;

    safe fn unprotected() -> !;
}

#[unsafe(link_section = ".text.stage")]
#[unsafe(no_mangle)]
unsafe extern "C" fn start() -> usize {
    let length = packed::length();
    // SAFETY: the memory is part of the section `.bss`.
    unsafe {
        asm!(
            "rep stosb",
            inout("rdi") &raw const PROGRAM => _,
            inout("rcx") &raw const COUNTS_SIZE => _,
            in("al") 0_u8,
            options(nostack, preserves_flags),
        );
    }
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
    unprotected()
}
