//! The Linux stub: unpacks the program, and replaces itself with it.

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
use system::{EXECVEAT, MADVISE, MEMFD_CREATE, MMAP, MPROTECT, MUNMAP, WRITE, call, is_error};

/// A huge page. The model accesses its memory at random; fewer TLB misses save a quarter of the
/// time.
const HUGE_PAGE: usize = 1 << 21;
/// `MADV_HUGEPAGE`.
const HUGE_PAGES: usize = 14;
/// `MADV_POPULATE_WRITE`: one call is faster than a fault for each page.
const POPULATE: usize = 23;

global_asm!(include_str!("../checksum.s"), include_str!("../small.s"), include_str!("first.s"),);

unsafe extern "C" {
    static PROGRAM: u8;
    /// The program's size in memory, as an address.
    static PROGRAM_SIZE: u8;

    safe fn no_memory() -> !;
}

#[unsafe(link_section = ".text.stage")]
#[unsafe(no_mangle)]
unsafe extern "C" fn start(stack: *mut usize) -> usize {
    let length = packed::length();
    let used = size_of::<Model>() + length;
    let size = used + HUGE_PAGE;
    // Maps new memory, and the program's again at its fixed address, which clears the first stage's
    // counts. If a program header reserved it, Linux would end the process without a message when
    // memory is short. SAFETY: this memory is unused.
    let [mapped, program] = unsafe {
        let (program, size_of_it) = ((&raw const PROGRAM).addr(), (&raw const PROGRAM_SIZE).addr());
        [
            call(MMAP, [0, size, 3, 0x22, usize::MAX, 0]),
            call(MMAP, [program, size_of_it, 3, 0x32, usize::MAX, 0]),
        ]
    };
    if is_error(mapped) || is_error(program) {
        no_memory();
    }
    let memory = mapped.next_multiple_of(HUGE_PAGE);
    for advice in [HUGE_PAGES, POPULATE] {
        // Advice only saves time.
        // SAFETY: the range is part of that memory.
        unsafe { call(MADVISE, [memory, used, advice]) };
    }
    // SAFETY: the memory is large enough.
    let file = unsafe { packed::unpack(memory) };
    let program_length = packed::program_length();
    // SAFETY: the packer has packed an executable and the loader, and the executable's addresses
    // are mapped.
    unsafe {
        // Make the loader executable, from the previous page boundary on.
        let loader = file.add(program_length);
        let page = loader.addr() & !4095;
        if !is_error(call(MPROTECT, [page, length - program_length + 4096, 5])) {
            let load: loader::Load = transmute(loader);
            let entry = load(&*file.cast(), memory, stack);
            if entry != 0 {
                call(MUNMAP, [mapped, size]);
                return entry;
            }
        }
        execute(file.addr(), program_length, stack);
    }
    let line = "eightfold: dynamic linker cannot be loaded\n";
    fail(line.as_ptr(), line.len());
}

/// Executes the program from a file in memory, for systems that refuse to execute written memory.
/// Returns on failure.
#[inline(always)]
unsafe fn execute(file: usize, length: usize, stack: *mut usize) {
    // SAFETY: the name is a string, the bytes are there, and the stack has the arguments and the
    // environment.
    unsafe {
        let name = c"eightfold".as_ptr() as usize;
        let descriptor = call(MEMFD_CREATE, [name, 1]);
        call(WRITE, [descriptor, file, length]);
        let arguments = stack.add(1);
        let environment = stack.add(*stack + 2);
        call(EXECVEAT, [descriptor, name + 9, arguments as usize, environment as usize, 0x1000]);
    }
}
