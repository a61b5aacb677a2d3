//! Calls of Linux. Each returns what Linux does: from -4095 on, an error.

use core::arch::asm;

pub const READ: usize = 0;
pub const WRITE: usize = 1;
pub const OPEN: usize = 2;
pub const MMAP: usize = 9;
pub const MPROTECT: usize = 10;
pub const MUNMAP: usize = 11;
pub const MADVISE: usize = 28;
pub const CLOSE: usize = 3;
pub const EXIT_GROUP: usize = 231;
pub const MEMFD_CREATE: usize = 319;
pub const EXECVEAT: usize = 322;

/// Calls Linux with up to six arguments.
///
/// # Safety
/// The call has to do nothing to memory that is in use, but for what its arguments point to.
#[inline(always)]
pub unsafe fn call<const N: usize>(number: usize, arguments: [usize; N]) -> usize {
    let argument = |i: usize| arguments.get(i).copied().unwrap_or_default();
    let result;
    // SAFETY: the caller vouches for the call, which changes no registers but these.
    unsafe {
        asm!(
            "syscall",
            inout("rax") number => result,
            in("rdi") argument(0),
            in("rsi") argument(1),
            in("rdx") argument(2),
            in("r10") argument(3),
            in("r8") argument(4),
            in("r9") argument(5),
            lateout("rcx") _,
            lateout("r11") _,
            options(nostack),
        );
    }
    result
}

/// Whether a call failed.
pub fn is_error(result: usize) -> bool {
    result > -4096_isize as usize
}

/// Says a line on standard error and ends the process.
pub fn fail(line: &str) -> ! {
    // SAFETY: the line is there, and nothing is left to be used.
    unsafe {
        call(WRITE, [2, line.as_ptr() as usize, line.len()]);
        loop {
            call(EXIT_GROUP, [1]);
        }
    }
}
