//! Loads the program and its dynamic linker as `execve` does, and passes the program's addresses to
//! the linker.

use crate::elf::{FileHeader, LOAD, PAGE, ProgramHeader};
use crate::system::{CLOSE, MMAP, MPROTECT, OPEN, READ, call, is_error};

const INTERPRETER: u32 = 3;
const PROGRAM_HEADERS: u32 = 6;

const READ_WRITE: usize = 3;
const PRIVATE: usize = 2;
const FIXED: usize = 0x10;
const ANONYMOUS: usize = 0x20;

struct Loaded {
    headers: usize,
    header_count: usize,
    entry: usize,
    interpreter: usize,
}

#[inline(always)]
fn protection(header: &ProgramHeader) -> usize {
    0x7351_6240 >> (header.flags * 4) & 7
}

pub type Load = unsafe extern "C" fn(&FileHeader, usize, *mut usize) -> usize;

/// Loads a program. `memory` is a temporary page, `stack` the process' initial stack. Returns the
/// dynamic linker's entry point, or 0 after an error.
///
/// # Safety
/// `file` has to be an executable whose addresses are zeroed, writable memory.
#[unsafe(no_mangle)]
#[unsafe(link_section = ".text.loader")]
unsafe extern "C" fn load(file: &FileHeader, memory: usize, stack: *mut usize) -> usize {
    // SAFETY: required of the caller.
    let entry = unsafe { place(file).and_then(|loaded| loaded.link(memory, stack)) };
    entry.unwrap_or(0)
}

/// Copies a program to its addresses, unless the system refuses to execute written memory.
#[inline(always)]
unsafe fn place(file: &FileHeader) -> Option<Loaded> {
    let mut loaded = Loaded {
        headers: 0,
        header_count: file.header_count.into(),
        entry: file.entry,
        interpreter: 0,
    };
    // SAFETY: required of the caller.
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
    /// Maps the dynamic linker, and returns its entry point.
    ///
    /// # Safety
    /// `memory` has to be a page, and `stack` the process' initial stack.
    #[inline(always)]
    unsafe fn link(&self, memory: usize, stack: *mut usize) -> Option<usize> {
        // SAFETY: the path is in the program; the rest is required of the caller.
        unsafe {
            let file = call(OPEN, [self.interpreter, 0]);
            // Reading fails too if the file could not be opened.
            if is_error(call(READ, [file, memory, PAGE])) {
                return None;
            }
            let header = &*(memory as *const FileHeader);
            let loads = header.headers().iter().filter(|header| header.kind == LOAD);
            let size = loads.clone().map(|header| header.address + header.size).last()?;
            let base = call(MMAP, [0, size, READ_WRITE, PRIVATE | ANONYMOUS, usize::MAX, 0]);
            if is_error(base) {
                return None;
            }
            for header in loads {
                let lead = header.lead();
                let start = base + header.address - lead;
                let size = header.file_size + lead;
                let mapped = call(
                    MMAP,
                    [start, size, protection(header), PRIVATE | FIXED, file, header.offset - lead],
                );
                if is_error(mapped) {
                    return None;
                }
                if header.size > header.file_size {
                    let mut end = start + size;
                    while end % PAGE != 0 {
                        *(end as *mut u8) = 0;
                        end += 1;
                    }
                }
            }
            call(CLOSE, [file]);
            self.correct_auxiliary(stack, base);
            Some(base + header.entry)
        }
    }

    #[inline(always)]
    unsafe fn correct_auxiliary(&self, stack: *mut usize, base: usize) {
        // SAFETY: the caller guarantees the stack: argument count, arguments, 0, environment, 0,
        // pairs.
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
