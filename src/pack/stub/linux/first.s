# The first stage. The dynamic linker later gets the same stack, and 0 in `rdx`: no function to call at exit.
#
# Reading the last pages of a truncated file would end the process with a signal. So Linux first reads the last eight bytes, as the
# signal set of `rt_sigprocmask` (14) with an invalid operation (14), and reports EFAULT (-14).
    .section .text.first, "ax"
    .globl no_memory, fail, _start
no_memory:
    mov edi, offset memory_line
    push 34
    jmp 2f
1:
    mov edi, offset damaged_line
    push 32
2:
    pop rsi
    # Prints `rsi` bytes at `rdi` on standard error, and exits with code 1.
fail:
    mov edx, esi
    mov rsi, rdi
    push 2
    pop rdi
    push 1
    pop rax
    syscall
    push 1
    pop rdi
    mov eax, 231
    syscall
memory_line:
    .ascii "eightfold: memory is below 105 MB\n"
damaged_line:
    .ascii "eightfold: this file is damaged\n"
_start:
    push 14
    pop rax
    mov edi, eax
    mov esi, offset FILE_END - 8
    xor edx, edx
    push 8
    pop r10
    syscall
    cmp al, -14
    je 1b
    checksum
    # The next section follows. It maps the program's memory and the second stage behind it: readable and writable, private, fixed,
    # anonymous.
    .section .text.unpack, "ax"
checked:
    push 9
    pop rax
    mov edi, offset PROGRAM
    mov esi, offset MEMORY_SIZE
    push 3
    pop rdx
    push 0x32
    pop r10
    xor r9d, r9d
    syscall
    test eax, eax
    js no_memory
    unpack_stage
    # Some systems refuse to execute written memory, but execute files: `memfd_create` with an empty name, `write`, `mmap`, `close`.
    mov eax, 319
    xor esi, esi
    syscall
    mov r8d, eax
    xchg edi, eax
    mov esi, offset STAGE
    mov edx, offset STAGE_LENGTH
    push 1
    pop rax
    syscall
    xchg edi, esi
    mov esi, edx
    push 5
    pop rdx
    push 0x12
    pop r10
    push 9
    pop rax
    syscall
    test eax, eax
    jns 3f
    # Without a free descriptor or files in memory: `mprotect`.
    push 10
    pop rax
    syscall
    test eax, eax
    js no_memory
3:
    mov edi, r8d
    push 3
    pop rax
    syscall
    mov rdi, rsp
    call STAGE
    xor edx, edx
    jmp rax
