# The entry point of the packed program: the dynamic linker jumps here after initialising libc, with the arguments on the stack. The
# rest of `__libc_start_main` would take 100 packed bytes. Unpacked programs start with that function instead.
.section .text.eightfold_start, "ax"
.globl eightfold_start
eightfold_start:
    mov edi, [rsp]
    lea rsi, [rsp + 8]
    call main
    mov edi, eax
    call _exit
