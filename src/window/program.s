# The intro's file, byte for byte, as far as it is not code or data: what the system and the dynamic linker
# read, and the first instructions. A linker's own tables take 2.4 KB more: a header per section, a version,
# a hash and three table entries for each function of libc.
#
# `build.rs` adds a `c_function` line for each of those, and links this by `program.ld`, which defines
# the names beginning with `file_`.

# The ELF header, the program headers, and what they lead to.
.section .head, "a"
    .byte 0x7f, 'E', 'L', 'F', 2, 1, 1, 0   # 64 bits, little-endian, version 1
    .quad 0
    .short 2, 62                            # an executable for x86-64
    .long 1
    .quad _start, program_headers - file_start, 0
    .long 0
    .short 64, 56, 5, 64, 0, 0

# Type and flags (1 execute, 2 write, 4 read); place in the file, in memory, and again; bytes in the file
# and in memory; alignment.
.macro program_header type flags place start size memory alignment
    .long \type, \flags
    .quad \place, \start, \start, \size, \memory, \alignment
.endm

.set file_start, 0x400000
.set interpreter_size, dynamic_names - interpreter
.set dynamic_size, symbols + 16 - dynamic
program_headers:
    program_header 3, 4, interpreter - file_start, interpreter, interpreter_size, interpreter_size, 1
    program_header 1, 5, 0, file_start, file_size, file_size, 4096
    program_header 1, 6, 0, memory, 0, memory_size, 4096
    program_header 2, 4, dynamic - file_start, dynamic, dynamic_size, dynamic_size, 8
    # A stack that is not executable. Of this one only the flags count: the rest is room for names.
    .long 0x6474e551, 6
interpreter:
    .asciz "/lib64/ld-linux-x86-64.so.2"
dynamic_names:
libc_name:
    .asciz "libc.so.6"
dlsym_name:
    .asciz "dlsym"
    .space 4

# What the dynamic linker has to do: load libc and look up `dlsym`. Its end is the first symbol, which is as empty; and of
# a symbol that is looked up, the place and size are not read: there the relocation begins.
dynamic:
    .quad 1, libc_name - dynamic_names      # DT_NEEDED
    .quad 5, dynamic_names                  # DT_STRTAB
    .quad 6, symbols                        # DT_SYMTAB
    .quad 7, relocation                     # DT_RELA
    .quad 8, 24                             # DT_RELASZ
    .quad 9, 24                             # DT_RELAENT
symbols:
    .quad 0, 0, 0
    .long dlsym_name - dynamic_names
    .short 0x12, 0                          # a global function, undefined
relocation:
    .quad dlsym_slot, 1 << 32 | 6, 0        # R_X86_64_GLOB_DAT of symbol 1

.section .bss.c_slots, "aw", @nobits
dlsym_slot:
    .quad 0
c_slots:

# Defines a function of libc: its name, a slot for its address, and a jump to where that leads.
.macro c_function name
    .section .rodata.c_names, "a"
    .asciz "\name"
    .section .bss.c_slots
    \name\()_slot:
    .quad 0
    .section .text._start
    .globl \name
    .hidden \name
    \name:
    jmp *\name\()_slot(%rip)
.endm

.section .rodata.c_names, "a"
c_names:

# Fills the slots, and does what `crt1.o` does, without the other start files, which are for C++ and for
# profiles.
.section .text._start, "ax"
.globl _start
_start:
    xor %ebp, %ebp
    mov %rdx, %r13
    mov $c_names, %ebx
    mov $c_slots, %r12d
1:  xor %edi, %edi                          # RTLD_DEFAULT
    mov %rbx, %rsi
    call *dlsym_slot(%rip)
    mov %rax, (%r12)
    add $8, %r12d
2:  inc %ebx
    cmpb $0, -1(%rbx)
    jne 2b
    cmp $c_names_end, %ebx
    jne 1b

    mov %r13, %r9
    pop %rsi
    mov %rsp, %rdx
    and $-16, %rsp
    push %rax
    push %rsp
    xor %r8d, %r8d
    xor %ecx, %ecx
    mov $main, %edi
    call __libc_start_main

# minifb asks for the environment's locale, for text that the intro does not take.
.globl setlocale
.hidden setlocale
setlocale:
    ret

.globl dlsym
.hidden dlsym
dlsym:
    jmp *dlsym_slot(%rip)
