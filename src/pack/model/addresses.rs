//! Converts the relative offsets in instructions to addresses and back, so that all references to one place are the same four
//! bytes.
//!
//! Addresses count from the program's first byte.

/// Replaces the offset at `offset` by an address. `bytes` ends with the instruction.
pub fn to_address(bytes: &mut [u8], offset: usize) {
    add(bytes, offset, bytes.len() as u32);
}

/// Replaces the address at `offset` by an offset.
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
