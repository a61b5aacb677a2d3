//! The Windows stub: unpacks the program, and loads it to its addresses.
//!
//! The packer links it from an object of its own, see `src/pack/build`. It is an ELF object for Linux, because the packing machine
//! has that target's core library. The [loader], which runs after unpacking, is packed with the program.

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

// The entry point. The stack is aligned to 16 bytes, less the return address. The program starts with the same stack,
// `LoadLibraryA` in `rcx` and `GetProcAddress` in `rdx`.
//
// First comes an FNV-1a checksum of all bytes behind this section. This section, the headers and the import table are unverified.
// (Windows itself refuses a file that was cut.)
//
// Messages go to the parent's console, if any, by `AttachConsole(-1)` and `WriteFile(GetStdHandle(-12), line, length, &written,
// 0)`. Then comes `ExitProcess(1)`.
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
    // Prints `rsi` bytes at `rdi` on standard error, and exits with code 1.
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
    /// The first byte that the checksum [`SUM`] covers.
    static CHECKED: u8;
    static SUM: u32;
    /// The import table, filled in by Windows.
    static SYSTEM: System;
}

unsafe extern "C" fn start() -> usize {
    let length = packed::length();
    // SAFETY: the packer has put it there, and Windows has filled it.
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
