use super::lanes::Lanes;

/// From the lowest bits on: the probability of a 1 in 65,536ths, minus one half (16 bits); the last
/// five bits after a 1, exclusive-or 1 (8); the number of bits seen, at most 127 (8). Zeroed memory
/// is a new slot.
#[derive(Clone, Copy)]
pub struct Slot(u32);

pub const HISTORIES: usize = 32;

/// The mask that turns a slot into the opposite bit's after learning. Before, it is shifted right
/// by one: the older bits of a history remain.
pub const OPPOSITE: u32 = 0x1_ffff;

impl Slot {
    pub const NEW: Slot = Slot(0);

    pub fn named(number: u32) -> Slot {
        Slot(number)
    }

    #[inline(always)]
    pub fn exclusive_or(self, bits: u32) -> Slot {
        Slot(self.0 ^ bits)
    }

    pub fn is(self, number: u32) -> bool {
        self.0 == number
    }

    #[inline(always)]
    pub fn probability(self) -> u16 {
        self.0 as u16
    }

    #[inline(always)]
    pub fn history(self) -> usize {
        (self.0 >> 16) as usize & (HISTORIES - 1)
    }

    #[inline(always)]
    pub fn count(self) -> usize {
        (self.0 >> 24) as usize
    }
}

/// The minimum rate, reached after 51 bits: older bits fade.
const MIN_RATE: u32 = 2200;

/// The adaptation rate in 65,536ths by the count n of bits seen: 16 / (9 n + 18), at least
/// [`MIN_RATE`].
pub struct Rates([u32; 256]);

impl Rates {
    #[inline(always)]
    pub fn fill(&mut self) {
        for (count, rate) in self.0.iter_mut().enumerate() {
            *rate = (0x10000 * 16 / (9 * count as u32 + 18)).max(MIN_RATE);
        }
    }
}

pub const ROWS: usize = 6;

#[repr(C)]
pub struct Slots {
    slots: [[u32; 4]; ROWS],
    /// Looked up when a slot is copied, to avoid a failed store forwarding.
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

    #[inline(always)]
    pub fn learn(&mut self, bit: u32) {
        // Map a probability to its distance from the unseen value, 0 or 65,535, and restore the
        // history's encoding.
        let flip = 0x1_8000 - bit;
        // Revert this, and append the bit to the history.
        let flip_back = Lanes::splat_pair(flip ^ bit << 16);
        let flip = Lanes::splat_pair(flip);
        for (slots, rates) in self.slots.iter_mut().zip(&self.rates) {
            let old = Lanes::pairs(slots).xor(flip);
            // The rate is the lower number of its pair; the upper one is 0, so histories and counts
            // stay.
            let moved = old.subtract(old.multiply_high_unsigned(Lanes::pairs(rates)));
            // The sum saturates at a count of 127; the mask drops its effect on the history.
            let counted = moved.saturating_add(Lanes::splat_pair(0x100_0000));
            let rest = counted.and(Lanes::splat_pair(0xff00_ffff));
            let history = old.add(old).and(Lanes::splat_pair((HISTORIES as u32 - 2) << 16));
            *slots = rest.xor(history).xor(flip_back).to_pairs();
        }
    }
}
