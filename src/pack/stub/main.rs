//! What starts the packed program: it unpacks the program behind it and puts that in its own place.
//!
//! It is compiled by itself, to an object that the packer links; see `src/pack/build`.

#![no_std]
#![no_main]
#![warn(clippy::undocumented_unsafe_blocks)]

mod loader;
#[path = "../model/mod.rs"]
mod model;
mod system;

use core::{arch::naked_asm, panic::PanicInfo, slice};
use loader::FileHeader;
use model::Model;
use system::{EXECVEAT, MADVISE, MEMFD_CREATE, MMAP, MUNMAP, WRITE, call, fail, is_error};

/// Bytes of a page with which a processor rarely has to look up where memory is. The model reads all over its memory: by such pages
/// it takes three quarters of the time.
const HUGE_PAGE: usize = 1 << 21;
/// Advice to have huge pages.
const HUGE_PAGES: usize = 14;
/// Advice to have all pages at once: one by one takes longer, above all if they are small.
const POPULATE: usize = 23;

/// Linux comes here, with a stack that the dynamic linker is given as it was. The register `rdx` could have a function to be called
/// at the end, and has none.
#[unsafe(naked)]
#[unsafe(no_mangle)]
#[unsafe(link_section = ".text.first")]
unsafe extern "C" fn _start() {
    naked_asm!("mov rdi, rsp", "call {}", "xor edx, edx", "jmp rax", sym start)
}

unsafe extern "C" {
    /// What was packed, and its end: the packer has them in the file behind the stub.
    static PACKED: u8;
    static PACKED_END: u8;
}

/// Unpacks the program and loads it. Returns where its dynamic linker starts.
unsafe extern "C" fn start(stack: *mut usize) -> usize {
    let start = &raw const PACKED;
    // SAFETY: the packer has put the bytes there.
    let packed =
        unsafe { slice::from_raw_parts(start, (&raw const PACKED_END).addr() - start.addr()) };
    let Some((length, code)) = model::open(packed) else {
        fail("eightfold: this file is damaged\n");
    };
    let used = size_of::<Model>() + length;
    let size = used + HUGE_PAGE;
    // For reading and writing, private, of nothing.
    // SAFETY: nobody has that memory.
    let mapped = unsafe { call(MMAP, [0, size, 3, 0x22, usize::MAX]) };
    if is_error(mapped) {
        fail("eightfold: there are no 71 MB of memory to unpack it\n");
    }
    let memory = mapped.next_multiple_of(HUGE_PAGE);
    for advice in [HUGE_PAGES, POPULATE] {
        // Where the system does not know one, or has no huge pages, it only takes longer.
        // SAFETY: it is part of that memory.
        unsafe { call(MADVISE, [memory, used, advice]) };
    }
    // SAFETY: there is as much memory, and zeros are a model.
    let (model, file) = unsafe {
        (
            &mut *(memory as *mut Model),
            slice::from_raw_parts_mut((memory + size_of::<Model>()) as *mut u8, length),
        )
    };
    model.fill();
    model::decode(model, code, file);
    // SAFETY: the packer has packed an executable. The program header of this file has its addresses as memory.
    let entry = unsafe {
        let header = &*(file.as_ptr() as *const FileHeader);
        match loader::load(header) {
            Some(loaded) => loaded.link(memory, stack),
            None => execute(file, stack),
        }
    };
    let Some(entry) = entry else {
        fail("eightfold: the system does not let it start\n");
    };
    // SAFETY: nobody uses it any more.
    unsafe { call(MUNMAP, [mapped, size]) };
    entry
}

/// Has the system execute the program from a file in memory, where it refuses to execute what has been written to. Returns if that
/// fails too.
unsafe fn execute(file: &[u8], stack: *mut usize) -> Option<usize> {
    // SAFETY: the name is a string, the bytes are there, and the stack has the arguments and the environment.
    unsafe {
        let name = c"eightfold".as_ptr() as usize;
        let descriptor = call(MEMFD_CREATE, [name, 1]);
        call(WRITE, [descriptor, file.as_ptr() as usize, file.len()]);
        let arguments = stack.add(1);
        let environment = stack.add(*stack + 2);
        call(
            EXECVEAT,
            [
                descriptor,
                name + 9,
                arguments as usize,
                environment as usize,
                0x1000,
            ],
        );
    }
    None
}

#[panic_handler]
fn panic(_: &PanicInfo<'_>) -> ! {
    unsafe extern "C" {
        /// Nowhere: a check that could panic fails the packer, which finds no such function.
        fn a_panic_in_the_stub() -> !;
    }
    // SAFETY: it is not there.
    unsafe { a_panic_in_the_stub() }
}
