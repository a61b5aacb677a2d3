//! Does for a program what Windows does when it starts one: puts its segments to their addresses and protects them. It is packed
//! with the program, and so may be anywhere in memory.

use crate::{
    elf::{FileHeader, LOAD, ProgramHeader},
    system::{READ, READ_EXECUTE, READ_WRITE, System, protect},
};

/// The flags of a program header as Windows has them.
#[inline(always)]
fn protection(header: &ProgramHeader) -> u32 {
    match header.flags & 3 {
        0 => READ,
        1 => READ_EXECUTE,
        _ => READ_WRITE,
    }
}

/// The type of [`load`].
pub type Load = unsafe extern "C" fn(&FileHeader, &System) -> usize;

/// Loads a program. Returns where it begins, or 0 if the system refuses something.
///
/// # Safety
/// `file` has to be an executable, and at its addresses has to be memory that can be written to and is zero.
#[unsafe(no_mangle)]
#[unsafe(link_section = ".text.loader")]
unsafe extern "C" fn load(file: &FileHeader, system: &System) -> usize {
    // SAFETY: the caller vouches for it.
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
