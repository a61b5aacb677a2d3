//! Does for a program what `execve` does: puts its segments to their addresses, and its dynamic linker to some, and tells the
//! latter where the former is. It is packed with the program, and so may be anywhere in memory.

use crate::{
    elf::{FileHeader, LOAD, PAGE, ProgramHeader},
    system::{CLOSE, MMAP, MPROTECT, OPEN, READ, call, is_error},
};

// Kinds of program headers.
const INTERPRETER: u32 = 3;
const PROGRAM_HEADERS: u32 = 6;

// For `mmap`.
const READ_WRITE: usize = 3;
const PRIVATE: usize = 2;
const FIXED: usize = 0x10;
const ANONYMOUS: usize = 0x20;

/// A program that was put to its addresses.
struct Loaded {
    headers: usize,
    header_count: usize,
    entry: usize,
    interpreter: usize,
}

/// The flags of a program header as `mmap` has them, in the opposite order.
#[inline(always)]
fn protection(header: &ProgramHeader) -> usize {
    0x7351_6240 >> (header.flags * 4) & 7
}

/// The type of [`load`].
pub type Load = unsafe extern "C" fn(&FileHeader, usize, *mut usize) -> usize;

/// Loads a program, with a page of memory to be used and the stack that the process was started with. Returns where its dynamic
/// linker starts, or 0 if the system refuses something.
///
/// # Safety
/// `file` has to be an executable, and at its addresses has to be memory that can be written to and is zero.
#[unsafe(no_mangle)]
#[unsafe(link_section = ".text.loader")]
unsafe extern "C" fn load(file: &FileHeader, memory: usize, stack: *mut usize) -> usize {
    // SAFETY: the caller vouches for it.
    let entry = unsafe { place(file).and_then(|loaded| loaded.link(memory, stack)) };
    entry.unwrap_or(0)
}

/// Puts a program to its addresses. None if the system refuses to execute what was written.
#[inline(always)]
unsafe fn place(file: &FileHeader) -> Option<Loaded> {
    let mut loaded = Loaded {
        headers: 0,
        header_count: file.header_count.into(),
        entry: file.entry,
        interpreter: 0,
    };
    // SAFETY: the caller vouches for it.
    for header in unsafe { file.headers() } {
        match header.kind {
            LOAD => {
                let start = header.address - header.lead();
                let size = header.size + header.lead();
                // SAFETY: as above.
                unsafe {
                    file.copy(header);
                    if is_error(call(MPROTECT, [start, size, protection(header)])) {
                        return None;
                    }
                }
            }
            INTERPRETER => loaded.interpreter = header.address,
            PROGRAM_HEADERS => loaded.headers = header.address,
            _ => {}
        }
    }
    Some(loaded)
}

impl Loaded {
    /// Maps the dynamic linker and tells it of the program. Returns where it starts, or an error.
    ///
    /// # Safety
    /// `memory` has to be a page, and `stack` what the process was started with.
    #[inline(always)]
    unsafe fn link(&self, memory: usize, stack: *mut usize) -> Option<usize> {
        // SAFETY: the path is in the program, the caller vouches for the rest.
        unsafe {
            // Read the headers of the dynamic linker.
            let file = call(OPEN, [self.interpreter, 0]);
            // Nothing can be read where it was not opened.
            if is_error(call(READ, [file, memory, PAGE])) {
                return None;
            }
            let header = &*(memory as *const FileHeader);
            let loads = header.headers().iter().filter(|header| header.kind == LOAD);
            // Reserve memory for all of its segments.
            let size = loads
                .clone()
                .map(|header| header.address + header.size)
                .last()?;
            let base = call(
                MMAP,
                [0, size, READ_WRITE, PRIVATE | ANONYMOUS, usize::MAX, 0],
            );
            if is_error(base) {
                return None;
            }
            // Map each segment to its place.
            for header in loads {
                let lead = header.lead();
                let start = base + header.address - lead;
                let size = header.file_size + lead;
                let mapped = call(
                    MMAP,
                    [
                        start,
                        size,
                        protection(header),
                        PRIVATE | FIXED,
                        file,
                        header.offset - lead,
                    ],
                );
                if is_error(mapped) {
                    return None;
                }
                if header.size > header.file_size {
                    // The rest of the last page is the next segment's, or nobody's.
                    let mut end = start + size;
                    while end % PAGE != 0 {
                        *(end as *mut u8) = 0;
                        end += 1;
                    }
                }
            }
            // Tell the dynamic linker where it is.
            call(CLOSE, [file]);
            self.tell(stack, base);
            Some(base + header.entry)
        }
    }

    /// Corrects what the system has told of the program.
    #[inline(always)]
    unsafe fn tell(&self, stack: *mut usize, base: usize) {
        // SAFETY: the caller vouches for the stack: the number of arguments, these, 0, the environment, 0, and pairs.
        unsafe {
            let mut pair = stack.add(*stack + 2);
            while *pair != 0 {
                pair = pair.add(1);
            }
            pair = pair.add(1);
            loop {
                let value = match *pair {
                    0 => break,
                    3 => self.headers,
                    5 => self.header_count,
                    7 => base,
                    9 => self.entry,
                    _ => *pair.add(1),
                };
                *pair.add(1) = value;
                pair = pair.add(2);
            }
        }
    }
}
