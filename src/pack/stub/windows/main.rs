//! The Windows stub: unpacks the program and loads it at its addresses. It is compiled for Linux,
//! whose core library each build machine has.

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

use core::arch::{asm, global_asm};
use core::mem::transmute;
use model::Model;
use packed::fail;
use system::{COMMIT_RESERVE, READ_EXECUTE, READ_WRITE, RELEASE, System, protect};

global_asm!(include_str!("../checksum.s"), include_str!("../small.s"), include_str!("first.s"),);

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
