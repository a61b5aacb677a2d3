//! The beginning of the packed program.

use core::arch::global_asm;

// The dynamic linker comes here, with the number of arguments and the arguments on the stack. By then it has prepared libc; what
// `__libc_start_main` and the objects that belong to it do besides, such as to run functions at the end, is of no use here, and would
// take 100 bytes of the packed file. Other programs begin with that, as ever, and leave this out.
global_asm!(
    ".section .text.eightfold_start, \"ax\"",
    ".globl eightfold_start",
    "eightfold_start:",
    "mov edi, [rsp]",
    "lea rsi, [rsp + 8]",
    "call main",
    "mov edi, eax",
    "call _exit",
);
