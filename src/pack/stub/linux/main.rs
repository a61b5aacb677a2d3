//! The stub that starts the packed program: it unpacks the program behind it and puts that in its own place.
//!
//! It is compiled by itself, to an object that the packer links; see `src/pack/build`. What only a program that has been unpacked
//! needs, the [loader], is packed with it.

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

/// Bytes of a page with which a processor rarely has to look up where memory is. The model reads all over its memory: by such pages
/// it takes three quarters of the time.
const HUGE_PAGE: usize = 1 << 21;
/// Advice to have huge pages.
const HUGE_PAGES: usize = 14;
/// Advice to have all pages at once: one by one takes longer, above all if they are small.
const POPULATE: usize = 23;

// Linux comes here, with a stack that the dynamic linker is given as it was. The register `rdx` could have a function to be called
// at the end, and has none.
//
// First of all it finds out whether the file is as it was packed. Where it was cut, its last pages are missing, and reading them
// would end the process by a signal: so Linux is asked to read its last eight bytes, as a set of signals for `rt_sigprocmask` (14) to
// do what it does not know (14), and would have no access to them (-14). Then there is a checksum of all behind these instructions,
// FNV-1a as in the packer. They and what they say are all that nobody checks, and in the file's first page.
global_asm!(
    ".section .text.first, \"ax\"",
    ".globl _start",
    "_start:",
    "push 14",
    "pop rax",
    "mov edi, eax",
    "mov esi, offset {end} - 8",
    "xor edx, edx",
    "push 8",
    "pop r10",
    "syscall",
    "cmp al, -14",
    "je 3f",
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
    "mov rdi, rsp",
    "call {start}",
    "xor edx, edx",
    "jmp rax",
    "3:",
    "lea rdi, [rip + 4f]",
    "push 32",
    "pop rsi",
    // Says a line of so many bytes on standard error and ends the process.
    "fail:",
    "mov edx, esi",
    "mov rsi, rdi",
    "push 2",
    "pop rdi",
    "push 1",
    "pop rax",
    "syscall",
    "push 1",
    "pop rdi",
    "mov eax, 231",
    "syscall",
    "4:",
    ".ascii \"eightfold: this file is damaged\\n\"",
    end = sym PACKED_END,
    checked = sym CHECKED,
    sum = sym SUM,
    start = sym start,
);

unsafe extern "C" {
    /// The end of the packed bytes.
    static PACKED_END: u8;
    /// Where all begins that [`SUM`] is the checksum of, up to the end of what was packed.
    static CHECKED: u8;
    static SUM: u32;
    /// Where the program is loaded to.
    static PROGRAM: u8;
    /// Its address is no address, but how much memory it takes there.
    static PROGRAM_SIZE: u8;
}

/// Unpacks the program and loads it. Returns where its dynamic linker starts.
unsafe extern "C" fn start(stack: *mut usize) -> usize {
    let length = packed::length();
    let used = size_of::<Model>() + length;
    let size = used + HUGE_PAGE;
    // For reading and writing, private, of nothing; the program's memory is at a fixed place. Had this file a program header for it,
    // Linux would end a process that may not have as much before it can say so.
    // SAFETY: nobody has that memory.
    let [mapped, program] = unsafe {
        let (program, size_of_it) = (
            (&raw const PROGRAM).addr(),
            (&raw const PROGRAM_SIZE).addr(),
        );
        [
            call(MMAP, [0, size, 3, 0x22, usize::MAX, 0]),
            call(MMAP, [program, size_of_it, 3, 0x32, usize::MAX, 0]),
        ]
    };
    if is_error(mapped) || is_error(program) {
        let line = "eightfold: there are no 105 MB of memory for it\n";
        fail(line.as_ptr(), line.len());
    }
    let memory = mapped.next_multiple_of(HUGE_PAGE);
    for advice in [HUGE_PAGES, POPULATE] {
        // Where the system does not know one, or has no huge pages, it only takes longer.
        // SAFETY: it is part of that memory.
        unsafe { call(MADVISE, [memory, used, advice]) };
    }
    // SAFETY: there is as much memory.
    let file = unsafe { packed::unpack(memory) };
    let program_length = packed::program_length();
    // SAFETY: the packer has packed an executable and the loader. The former's addresses are
    // memory.
    unsafe {
        // For reading and executing, from the page before on.
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
    let line = "eightfold: the system loads no dynamic linker for it\n";
    fail(line.as_ptr(), line.len());
}

/// Has the system execute the program from a file in memory, where it refuses to execute what has been written to. Returns if that
/// fails too.
#[inline(always)]
unsafe fn execute(file: usize, length: usize, stack: *mut usize) {
    // SAFETY: the name is a string, the bytes are there, and the stack has the arguments and the environment.
    unsafe {
        let name = c"eightfold".as_ptr() as usize;
        let descriptor = call(MEMFD_CREATE, [name, 1]);
        call(WRITE, [descriptor, file, length]);
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
}
