//! Converts relative offsets in instructions to addresses and back, so that references to one place are equal bytes. Addresses
//! count from the program's first byte.

/// Replaces the offset in an instruction that ends with `bytes`.
pub fn to_address(bytes: &mut [u8], offset: usize) {
    add(bytes, offset, bytes.len() as u32);
}

/// Reverts [`to_address`].
#[inline(always)]
pub fn to_offset(bytes: &mut [u8], offset: usize) {
    add(bytes, offset, (bytes.len() as u32).wrapping_neg());
}

#[inline(always)]
fn add(bytes: &mut [u8], place: usize, summand: u32) {
    if let Some(field) = bytes.get_mut(place..).and_then(|rest| rest.first_chunk_mut()) {
        *field = u32::from_le_bytes(*field).wrapping_add(summand).to_le_bytes();
    }
}
