# The entry point, which the unpacker calls with `LoadLibraryA` in `rcx` and `GetProcAddress` in `rdx`, and the functions over bytes
# that a compiler expects. They consist of string instructions; whole frames are never copied.
.section .text.eightfold_start, "ax"
.globl eightfold_start
eightfold_start:
    push rax
    mov rdi, rcx
    mov rsi, rdx
    # It ends the process, and does not return.
    call main
.globl memcpy
memcpy:
    mov rax, rdi
    mov rcx, rdx
    rep movsb
    ret
.globl memmove
memmove:
    mov rax, rdi
    mov rcx, rdx
    # Backwards, if the destination begins within the source.
    sub rdi, rsi
    cmp rdi, rdx
    lea rdi, [rax]
    jae 2f
    lea rdi, [rdi + rdx - 1]
    lea rsi, [rsi + rdx - 1]
    std
2:
    rep movsb
    cld
    ret
.globl memset
memset:
    push rdi
    mov eax, esi
    mov rcx, rdx
    rep stosb
    pop rax
    ret
.globl memcmp
.globl bcmp
memcmp:
bcmp:
    mov rcx, rdx
    xchg rsi, rdi
    # Equal, if there are no bytes.
    xor eax, eax
    repe cmpsb
    je 2f
    sbb eax, eax
    or eax, 1
2:
    ret
# The entry point of threads, with their `MainCall` in `rcx`. It need not preserve registers.
.section .text.eightfold_thread, "ax"
.globl eightfold_thread
eightfold_thread:
    push rax
    mov rdi, [rcx + 8]
    call [rcx]
    pop rcx
    ret
