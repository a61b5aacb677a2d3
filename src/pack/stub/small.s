# Unpacks the second stage. The model is in `src/pack/small.rs`. Uses `rbp`, `rbx` and up to 64 bytes of stack.
#
# esi: the next bit's number; ebx: the code minus the interval's lower end; ebp: the interval's size; edi: the next byte's address;
# edx: the byte's bits so far, after a 1; xmm2: the count of an unseen bit, twice
.macro unpack_stage
    xor esi, esi
    xor ebx, ebx
    mov edi, offset STAGE
    mov eax, 0x3e280000
    movd xmm2, eax
    unpcklps xmm2, xmm2
    push 1
    pop rdx
    # A size of 1 first reads 31 bits.
    mov ebp, edx
2:
    add ebp, ebp
    bt dword ptr [rip + STAGE_PACKED], esi
    inc esi
    adc ebx, ebx
3:
    test ebp, ebp
    jns 2b
    movaps xmm0, xmm2
    # Contexts 5 to 0, with a bit for each byte before.
    push 5
    pop rcx
4:
    mov eax, ecx
    mov ah, dl
    push rcx
    push rdi
5:
    dec edi
    shr ecx, 1
    jnc 6f
    xor al, byte ptr [rdi]
6:
    imul eax, eax, 0x1000193
    test ecx, ecx
    jnz 5b
    pop rdi
    pop rcx
    shr eax, 12
    lea eax, [rax * 8 + PROGRAM]
    push rax
    cvtpi2ps xmm1, qword ptr [rax]
    addps xmm1, xmm2
    mulps xmm0, xmm1
    dec ecx
    jns 4b
    sqrtps xmm0, xmm0
    sqrtps xmm0, xmm0
    pshufd xmm1, xmm0, 1
    addss xmm0, xmm1
    divss xmm1, xmm0
    cvtsi2ss xmm0, rbp
    mulss xmm0, xmm1
    cvttss2si rax, xmm0
    # The lower part is for a 1.
    sub ebp, eax
    sub ebx, eax
    jnc 6f
    add ebx, eax
    mov ebp, eax
6:
    adc edx, edx
    # Count the bit in each context, and halve the count of the other.
    push 6
    pop rcx
7:
    pop rax
    test dl, 1
    jz 8f
    xor al, 4
8:
    inc dword ptr [rax]
    xor al, 4
    shr dword ptr [rax], 1
    adc dword ptr [rax], 0
    loop 7b
    test dh, dh
    jz 3b
    mov eax, edx
    stosb
    # Leaves 1.
    shr edx, 8
    cmp edi, offset STAGE_END
    jne 3b
    # `cvtpi2ps` has put the x87 registers to use.
    emms
.endm
