//! Copies the program to its addresses and protects them, as Windows' loader does.

use crate::elf::{FileHeader, LOAD, ProgramHeader};
use crate::system::{READ, READ_EXECUTE, READ_WRITE, System, protect};

#[inline(always)]
fn protection(header: &ProgramHeader) -> u32 {
    match header.flags & 3 {
        0 => READ,
        1 => READ_EXECUTE,
        _ => READ_WRITE,
    }
}

pub type Load = unsafe extern "C" fn(&FileHeader, &System) -> usize;

/// Loads a program. Returns its entry point, or 0 if Windows refuses a protection.
///
/// # Safety
/// `file` has to be an executable whose addresses are zeroed, writable memory.
#[unsafe(no_mangle)]
#[unsafe(link_section = ".text.loader")]
unsafe extern "C" fn load(file: &FileHeader, system: &System) -> usize {
    // SAFETY: required of the caller.
    unsafe {
        for header in file.headers() {
            if header.kind == LOAD {
                file.copy(header);
                if !protect(system, header.address, header.size, protection(header)) {
                    return 0;
                }
            }
        }
    }
    file.entry
}
