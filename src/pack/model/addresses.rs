//! Makes offsets from the end of an instruction to what it calls, jumps to or reads the address of that, and back: all ways to one
//! place are the same four bytes then, which a model can learn.
//!
//! Addresses begin at the program's first byte. They come out right wherever that is, as long as both sides agree.

/// Puts the address in place of an offset, where these are all bytes up to the end of the instruction.
pub fn to_address(bytes: &mut [u8], offset: usize) {
    add(bytes, offset, bytes.len() as u32);
}

/// Puts the offset in place of an address.
#[inline(always)]
pub fn to_offset(bytes: &mut [u8], offset: usize) {
    add(bytes, offset, (bytes.len() as u32).wrapping_neg());
}

#[inline(always)]
fn add(bytes: &mut [u8], place: usize, summand: u32) {
    if let Some(field) = bytes
        .get_mut(place..)
        .and_then(|rest| rest.first_chunk_mut())
    {
        *field = u32::from_le_bytes(*field)
            .wrapping_add(summand)
            .to_le_bytes();
    }
}
