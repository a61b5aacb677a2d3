# The first stage. On entry `rsp` is a multiple of 16, minus 8. The program gets this `rsp`, `LoadLibraryA` in `rcx` and
# `GetProcAddress` in `rdx`. `fail` attaches to the parent's console (-1), prints `rsi` bytes at `rdi` on standard error (-12), and
# exits with code 1.
    .section .text.first, "ax"
    .globl unprotected, fail, _start
unprotected:
    mov edi, offset protection_line
    push 38
    jmp 2f
1:
    mov edi, offset damaged_line
    push 32
2:
    pop rsi
fail:
    and rsp, -16
    sub rsp, 48
    or rcx, -1
    call [rip + SYSTEM + 40]
    push -12
    pop rcx
    call [rip + SYSTEM + 48]
    mov rcx, rax
    mov rdx, rdi
    mov r8d, esi
    lea r9, [rsp + 40]
    and qword ptr [rsp + 32], 0
    call [rip + SYSTEM + 56]
    push 1
    pop rcx
    call [rip + SYSTEM + 64]
protection_line:
    .ascii "eightfold: memory cannot be protected\n"
damaged_line:
    .ascii "eightfold: this file is damaged\n"
_start:
    sub rsp, 40
    checksum
    # The next section follows.
    .section .text.unpack, "ax"
checked:
    unpack_stage
    # Make the second stage readable and executable.
    mov ecx, offset STAGE
    mov edx, offset STAGE_LENGTH
    push 0x20
    pop r8
    lea r9, [rsp + 32]
    call [rip + SYSTEM + 24]
    test eax, eax
    jz unprotected
    call STAGE
    mov rcx, [rip + SYSTEM]
    mov rdx, [rip + SYSTEM + 8]
    add rsp, 40
    jmp rax
