//! What both stubs share: what the packer tells them, and how the packed bytes are unpacked.

use crate::model::{self, Model};
use core::{panic::PanicInfo, slice};

unsafe extern "C" {
    /// The packed bytes, and their end: the packer has them in the file behind the stub.
    static PACKED: u8;
    static PACKED_END: u8;
    /// Its address is no address, but how many bytes were packed.
    static LENGTH: u8;
    /// Likewise; how many of those are the program. Behind them is the loader.
    static PROGRAM_LENGTH: u8;

    pub safe fn fail(line: *const u8, length: usize) -> !;
}

/// How many bytes were packed.
#[inline(always)]
pub fn length() -> usize {
    (&raw const LENGTH).addr()
}

/// How many of those are the program.
#[inline(always)]
pub fn program_length() -> usize {
    (&raw const PROGRAM_LENGTH).addr()
}

/// Unpacks what was packed to behind the model's memory. Returns where it is.
///
/// # Safety
/// There has to be memory for the model, which is zero, and [`length`] bytes more.
#[inline(always)]
pub unsafe fn unpack(memory: usize) -> *const u8 {
    let packed = &raw const PACKED;
    // SAFETY: the packer has put the bytes there; the caller vouches for the memory, and zeros are a model.
    let (code, model, unpacked) = unsafe {
        (
            slice::from_raw_parts(packed, (&raw const PACKED_END).addr() - packed.addr()),
            &mut *(memory as *mut Model),
            slice::from_raw_parts_mut((memory + size_of::<Model>()) as *mut u8, length()),
        )
    };
    model.fill();
    model::decode(model, code, unpacked);
    unpacked.as_ptr()
}

#[panic_handler]
fn panic(_: &PanicInfo<'_>) -> ! {
    unsafe extern "C" {
        /// Nowhere: a check that could panic fails the packer, which finds no such function.
        fn a_panic_in_the_stub() -> !;
    }
    // SAFETY: it is not there.
    unsafe { a_panic_in_the_stub() }
}
