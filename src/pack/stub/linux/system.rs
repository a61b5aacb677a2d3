//! System calls of Linux. Results from -4095 on are errors.

use core::arch::asm;

pub const READ: usize = 0;
pub const WRITE: usize = 1;
pub const OPEN: usize = 2;
pub const MMAP: usize = 9;
pub const MPROTECT: usize = 10;
pub const MUNMAP: usize = 11;
pub const MADVISE: usize = 28;
pub const CLOSE: usize = 3;
pub const MEMFD_CREATE: usize = 319;
pub const EXECVEAT: usize = 322;

/// Calls Linux, which changes only `rax`, `rcx` and `r11`.
macro_rules! with_registers {
    ($number:expr $(, $register:tt $argument:expr)*) => {{
        let result;
        asm!(
            "syscall",
            inout("rax") $number => result,
            $(in($register) $argument,)*
            lateout("rcx") _,
            lateout("r11") _,
            options(nostack),
        );
        result
    }};
}

/// Calls Linux; unused argument registers are undefined.
///
/// # Safety
/// The call must not change memory in use, except through its arguments.
#[inline(always)]
pub unsafe fn call<const N: usize>(number: usize, arguments: [usize; N]) -> usize {
    // SAFETY: required of the caller.
    unsafe {
        match arguments[..] {
            [a] => with_registers!(number, "rdi" a),
            [a, b] => with_registers!(number, "rdi" a, "rsi" b),
            [a, b, c] => with_registers!(number, "rdi" a, "rsi" b, "rdx" c),
            [a, b, c, d, e] => {
                with_registers!(number, "rdi" a, "rsi" b, "rdx" c, "r10" d, "r8" e)
            }
            [a, b, c, d, e, f] => {
                with_registers!(number, "rdi" a, "rsi" b, "rdx" c, "r10" d, "r8" e, "r9" f)
            }
            _ => -1_isize as usize,
        }
    }
}

pub fn is_error(result: usize) -> bool {
    result > -4096_isize as usize
}
