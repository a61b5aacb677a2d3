pub trait Coder {
    /// Codes a bit and returns it; the probability of a 1 is in 65,536ths.
    fn bit(&mut self, probability: u32) -> u32;
}

pub struct Decoder<'a> {
    bytes: &'a [u8],
    range: u64,
    /// The code minus the interval's lower end.
    place: u64,
    pub missing: bool,
}

impl<'a> Decoder<'a> {
    #[inline(always)]
    pub fn new(bytes: &'a [u8]) -> Decoder<'a> {
        // A range of 1 makes the first bit read four bytes.
        Decoder { bytes, range: 1, place: 0, missing: false }
    }

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
