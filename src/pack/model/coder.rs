//! The arithmetic decoder; `Encoder` in `encoder.rs` is its other side.

/// Codes bits by how likely they are.
pub trait Coder {
    /// The next bit, which is 1 with a probability of so many 65,536ths.
    fn bit(&mut self, probability: u32) -> u32;
}

/// Reads bits from bytes.
pub struct Decoder<'a> {
    bytes: &'a [u8],
    /// How wide the interval of all numbers that begin with the bits so far is.
    range: u64,
    /// Where in it the packed number is.
    place: u64,
    /// Whether there were fewer bytes than asked for.
    pub missing: bool,
}

impl<'a> Decoder<'a> {
    #[inline(always)]
    pub fn new(bytes: &'a [u8]) -> Decoder<'a> {
        // A range of 1 is widened before the first bit, by reading five bytes.
        Decoder {
            bytes,
            range: 1,
            place: 0,
            missing: false,
        }
    }

    /// Whether all bytes were read, and none beyond.
    pub fn is_at_end(&self) -> bool {
        self.bytes.is_empty() && !self.missing
    }
}

impl Coder for Decoder<'_> {
    #[inline(always)]
    fn bit(&mut self, probability: u32) -> u32 {
        while self.range < 1 << 32 {
            self.range <<= 8;
            self.place <<= 8;
            if let [first, rest @ ..] = self.bytes {
                self.place |= u64::from(*first);
                self.bytes = rest;
            } else {
                self.missing = true;
            }
        }
        let bound = (self.range >> 16) * u64::from(probability);
        if self.place < bound {
            self.range = bound;
            1
        } else {
            self.place -= bound;
            self.range -= bound;
            0
        }
    }
}
