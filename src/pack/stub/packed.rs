//! The common part of both stubs: the packer's constants, and unpacking.

use crate::model::{self, Model};
use core::{panic::PanicInfo, slice};

unsafe extern "C" {
    static PACKED: u8;
    static PACKED_END: u8;
    /// The unpacked length, as an address.
    static LENGTH: u8;
    /// The program's length, as an address. The loader follows the program.
    static PROGRAM_LENGTH: u8;

    pub safe fn fail(line: *const u8, length: usize) -> !;
}

#[inline(always)]
pub fn length() -> usize {
    (&raw const LENGTH).addr()
}

#[inline(always)]
pub fn program_length() -> usize {
    (&raw const PROGRAM_LENGTH).addr()
}

/// Unpacks behind the model. Returns the address of the unpacked bytes.
///
/// # Safety
/// `memory` has to have zeroed space for the model, and [`length`] bytes more.
#[inline(always)]
pub unsafe fn unpack(memory: usize) -> *const u8 {
    let packed = &raw const PACKED;
    // SAFETY: the packer has put the bytes there; the caller guarantees the memory, and zeros are a
    // valid model.
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
        /// Undefined: linking the stub fails if it can panic.
        fn a_panic_in_the_stub() -> !;
    }
    // SAFETY: never linked.
    unsafe { a_panic_in_the_stub() }
}
