use crate::model::Coder;

pub struct Encoder {
    pub byte: u8,
    /// The lower end of the interval, without the bytes already written.
    low: u64,
    range: u64,
    written: Vec<u8>,
}

/// The number of bits in `low`. Its top byte is written when it is shifted out.
const LOW: u32 = 40;

impl Encoder {
    pub fn new() -> Encoder {
        Encoder { byte: 0, low: 0, range: 1 << 32, written: Vec::new() }
    }

    fn shift(&mut self) {
        self.range <<= 8;
        self.written.push((self.low >> 32) as u8);
        self.low = self.low << 8 & ((1 << LOW) - 1);
    }

    pub fn end(mut self) -> Vec<u8> {
        if self.written.is_empty() && self.range == 1 << 32 {
            // No bits were encoded, so the decoder reads no bytes.
            return self.written;
        }
        for _ in 0..5 {
            self.shift();
        }
        // The first byte only receives carries, and the code is below 1.
        self.written.split_off(1)
    }
}

impl Coder for Encoder {
    fn bit(&mut self, probability: u32) -> u32 {
        while self.range < 1 << 32 {
            self.shift();
        }
        let bit = self.byte >> 7;
        self.byte <<= 1;
        let bound = (self.range >> 16) * u64::from(probability);
        if bit == 1 {
            self.range = bound;
        } else {
            self.low += bound;
            self.range -= bound;
        }
        if self.low >> LOW != 0 {
            self.low &= (1 << LOW) - 1;
            for byte in self.written.iter_mut().rev() {
                *byte = byte.wrapping_add(1);
                if *byte != 0 {
                    break;
                }
            }
        }
        bit.into()
    }
}
