//! What is known of a bit in one context.

/// A probability that the bit is 1 in 65,536ths (bits 16 to 31), the last seven bits that were seen there behind a 1 (8 to 15), and
/// how many were seen (0 to 7): exclusive-or [`NEW`], so that memory that is zero holds new ones.
#[derive(Clone, Copy)]
pub struct Slot(u32);

/// One half, nothing seen.
const NEW: u32 = 0x8000_0100;

/// What is counted to.
const LIMIT: u32 = 127;

/// How far a probability moves to what was seen, in 32,768ths of the distance, when so many were seen before: 6 / (4 n + 7). From
/// the limit on, what was seen longer ago counts less and less.
pub struct Rates([i32; 256]);

impl Rates {
    /// Fills memory that is zero.
    #[inline(always)]
    pub fn fill(&mut self) {
        for (count, rate) in self.0.iter_mut().enumerate() {
            *rate = 0x8000 * 6 / (4 * count as i32 + 7);
        }
    }
}

impl Slot {
    pub const NEW: Slot = Slot(0);

    /// No slot, but a number in its place.
    pub fn named(number: u32) -> Slot {
        Slot(number)
    }

    /// Whether it is that number.
    pub fn is(self, number: u32) -> bool {
        self.0 == number
    }

    #[inline(always)]
    pub fn probability(self) -> u32 {
        (self.0 ^ NEW) >> 16
    }

    /// The last bits.
    #[inline(always)]
    pub fn history(self) -> usize {
        ((self.0 ^ NEW) >> 8 & 0xff) as usize
    }

    /// Takes note of a bit.
    #[inline(never)]
    pub fn learn(&mut self, bit: u32, rates: &Rates) {
        let old = self.0 ^ NEW;
        let count = old & 0xff;
        let probability = (old >> 16) as i32;
        let distance = (bit * 0xffff) as i32 - probability;
        let step = (distance * rates.0[count as usize & 0xff]) >> 15;
        let mut history = (old >> 8 & 0xff) * 2 + bit;
        if history > 0xff {
            // The 1 stays where it is, before the last seven.
            history = history & 0x7f | 0x80;
        }
        let count = if count < LIMIT { count + 1 } else { count };
        self.0 = ((probability + step) as u32) << 16 | history << 8 | count;
        self.0 ^= NEW;
    }
}
