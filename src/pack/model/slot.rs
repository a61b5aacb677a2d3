//! A slot: what is known of a bit in one context.

use super::lanes::Lanes;

/// From the lowest bits on: a probability that the bit is 1, in 65,536ths, less one half (16 bits); the last bits that were seen
/// there behind a 1, of which five are kept, exclusive-or 1 (8); and how many were seen, at most 127 (8). So memory that is zero
/// holds new slots.
#[derive(Clone, Copy)]
pub struct Slot(u32);

/// More than the highest history, and a power of two.
pub const HISTORIES: usize = 32;

/// The bits of a slot that make it one of the opposite bit, once it has learned the last bit of its history. Shifted right by one
/// they do so before: the rest of a history is as it was seen in its context.
pub const OPPOSITE: u32 = 0x1_ffff;

impl Slot {
    pub const NEW: Slot = Slot(0);

    /// No slot, but a number in its place.
    pub fn named(number: u32) -> Slot {
        Slot(number)
    }

    #[inline(always)]
    pub fn exclusive_or(self, bits: u32) -> Slot {
        Slot(self.0 ^ bits)
    }

    /// Whether it is that number.
    pub fn is(self, number: u32) -> bool {
        self.0 == number
    }

    /// The probability less one half, as the 16 bits of a signed number.
    #[inline(always)]
    pub fn probability(self) -> u16 {
        self.0 as u16
    }

    /// The last bits.
    #[inline(always)]
    pub fn history(self) -> usize {
        (self.0 >> 16) as usize & (HISTORIES - 1)
    }

    /// How many bits were seen.
    #[inline(always)]
    pub fn count(self) -> usize {
        (self.0 >> 24) as usize
    }
}

/// The lowest rate: from 46 bits on, what was seen longer ago counts less and less.
const LOWEST_RATE: u32 = 2200;

/// How far a probability moves to what was seen, in 65,536ths of the distance, when so many were seen before: 16 / (10 n + 17), and at
/// least [`LOWEST_RATE`].
pub struct Rates([u32; 256]);

impl Rates {
    /// Fills memory that is zero.
    #[inline(always)]
    pub fn fill(&mut self) {
        for (count, rate) in self.0.iter_mut().enumerate() {
            *rate = (0x10000 * 16 / (10 * count as u32 + 17)).max(LOWEST_RATE);
        }
    }
}

/// Rows of slots.
pub const ROWS: usize = 6;

/// Copies of slots that learn together, four at a time.
#[repr(C)]
pub struct Slots {
    slots: [[u32; 4]; ROWS],
    /// The rate of each. They are looked up when a slot is copied: a processor waits for what it reads right after it was written in
    /// smaller pieces.
    rates: [[u32; 4]; ROWS],
}

impl Slots {
    #[inline(always)]
    pub fn set(&mut self, index: usize, slot: Slot, rates: &Rates) {
        self.slots.as_flattened_mut()[index] = slot.0;
        self.rates.as_flattened_mut()[index] = rates.0[slot.count()];
    }

    #[inline(always)]
    pub fn get(&self, index: usize) -> Slot {
        Slot(self.slots.as_flattened()[index])
    }

    /// Has all slots take note of a bit.
    #[inline(always)]
    pub fn learn(&mut self, bit: u32) {
        // Makes a probability its distance to 0 or, exclusive-or 0xffff, to 65,535: to what was not seen. And a history what it is.
        let flip = 0x1_8000 - bit;
        // The same back, and the bit at the end of the history.
        let flip_back = Lanes::splat_pair(flip ^ bit << 16);
        let flip = Lanes::splat_pair(flip);
        for (slots, rates) in self.slots.iter_mut().zip(&self.rates) {
            let old = Lanes::pairs(slots).xor(flip);
            // A rate is the lower number of its pair; the upper one is 0, so this leaves histories and counts alone.
            let moved = old.subtract(old.multiply_high_unsigned(Lanes::pairs(rates)));
            // This sum stops at a count of 127; what it then has for a history is masked out.
            let counted = moved.saturating_add(Lanes::splat_pair(0x100_0000));
            let rest = counted.and(Lanes::splat_pair(0xff00_ffff));
            let history = old
                .add(old)
                .and(Lanes::splat_pair((HISTORIES as u32 - 2) << 16));
            *slots = rest.xor(history).xor(flip_back).to_pairs();
        }
    }
}
