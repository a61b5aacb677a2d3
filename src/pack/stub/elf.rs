//! Executables as ELF has them, as far as the loaders read them.

use core::arch::asm;

/// The header of an ELF file, as far as it matters.
#[repr(C)]
pub struct FileHeader {
    unused: [u8; 24],
    pub entry: usize,
    /// Where in the file the program headers are.
    headers: usize,
    unused_too: [u8; 16],
    pub header_count: u16,
}

/// A part of the program, as its header describes it.
#[repr(C)]
pub struct ProgramHeader {
    pub kind: u32,
    /// 1 for execute, 2 for write, 4 for read.
    pub flags: u32,
    pub offset: usize,
    pub address: usize,
    unused: usize,
    /// Bytes in the file, and in memory, where zeros follow them.
    pub file_size: usize,
    pub size: usize,
    alignment: usize,
}

/// The kind of a program header of what is loaded.
pub const LOAD: u32 = 1;

pub const PAGE: usize = 4096;

impl FileHeader {
    /// # Safety
    /// The header has to be in memory with the program headers behind it.
    #[inline(always)]
    pub unsafe fn headers(&self) -> &[ProgramHeader] {
        let start = (&raw const *self).cast::<u8>();
        // SAFETY: the caller vouches for it.
        unsafe {
            core::slice::from_raw_parts(start.add(self.headers).cast(), self.header_count.into())
        }
    }

    /// Copies a part of the file in memory to its address.
    ///
    /// # Safety
    /// The file has to be in memory, and at that address memory that can be written to.
    #[inline(always)]
    pub unsafe fn copy(&self, header: &ProgramHeader) {
        // SAFETY: the caller vouches for it. (`copy_nonoverlapping` would call a function of libc.)
        unsafe {
            let from = (&raw const *self).cast::<u8>().add(header.offset);
            asm!(
                "rep movsb",
                inout("rsi") from => _,
                inout("rdi") header.address => _,
                inout("rcx") header.file_size => _,
                options(nostack, preserves_flags),
            );
        }
    }
}

impl ProgramHeader {
    /// Bytes from the beginning of its first page.
    #[inline(always)]
    pub fn lead(&self) -> usize {
        self.address % PAGE
    }
}
