use core::arch::asm;

#[repr(C)]
pub struct FileHeader {
    unused: [u8; 24],
    pub entry: usize,
    headers: usize,
    unused_too: [u8; 16],
    pub header_count: u16,
}

#[repr(C)]
pub struct ProgramHeader {
    pub kind: u32,
    /// 1 for execute, 2 for write, 4 for read.
    pub flags: u32,
    pub offset: usize,
    pub address: usize,
    unused: usize,
    /// Bytes in the file; zeros follow in memory.
    pub file_size: usize,
    pub size: usize,
    alignment: usize,
}

pub const LOAD: u32 = 1;

pub const PAGE: usize = 4096;

impl FileHeader {
    /// # Safety
    /// The program headers have to follow the header in memory.
    #[inline(always)]
    pub unsafe fn headers(&self) -> &[ProgramHeader] {
        let start = (&raw const *self).cast::<u8>();
        // SAFETY: required of the caller.
        unsafe {
            core::slice::from_raw_parts(start.add(self.headers).cast(), self.header_count.into())
        }
    }

    /// Copies a segment of the file in memory to its address.
    ///
    /// # Safety
    /// The file has to be in memory, and the segment's address has to be writable.
    #[inline(always)]
    pub unsafe fn copy(&self, header: &ProgramHeader) {
        // SAFETY: required of the caller. (`copy_nonoverlapping` would call libc.)
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
    #[inline(always)]
    pub fn lead(&self) -> usize {
        self.address % PAGE
    }
}
