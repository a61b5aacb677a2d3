# Goes to the last label 1 if the FNV-1a checksum of all bytes from `checked` on is not SUM.
.macro checksum
    mov esi, offset checked
    mov eax, 0x811c9dc5
2:
    movzx edx, byte ptr [rsi]
    xor eax, edx
    imul eax, eax, 0x1000193
    inc esi
    cmp esi, offset FILE_END
    jne 2b
    cmp eax, dword ptr [rip + SUM]
    jne 1b
.endm
