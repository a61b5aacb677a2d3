//! A bit per square, or per point, of a row.

use crate::picture::TILE_WIDTH;
use core::array;
use core::ops::{BitAnd, BitOr};

pub(crate) const WORDS: usize = TILE_WIDTH / 64;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Bits(pub [u64; WORDS]);

zero! { Bits = Self::NONE; }

impl Bits {
    pub const NONE: Self = Self([0; WORDS]);

    pub const EVEN: Self = Self([0x5555_5555_5555_5555; WORDS]);

    pub const ODD: Self = Self([0xaaaa_aaaa_aaaa_aaaa; WORDS]);

    #[inline(never)]
    pub fn below(count: usize) -> Self {
        let mut bits = Self::NONE;
        for (i, word) in bits.0.iter_mut().enumerate() {
            let count = count.saturating_sub(64 * i).min(64) as u32;
            // A shift by 64 overflows.
            *word = u64::MAX.checked_shr(64 - count).unwrap_or(0);
        }
        bits
    }

    pub fn set(&mut self, i: usize) {
        self.0[i / 64] |= 1 << (i % 64);
    }

    pub fn clear(&mut self, i: usize) {
        self.0[i / 64] &= !(1 << (i % 64));
    }

    pub fn has(&self, i: usize) -> bool {
        self.0[i / 64] >> (i % 64) & 1 != 0
    }

    pub fn is_empty(&self) -> bool {
        self.0.iter().fold(0, |all, word| all | word) == 0
    }

    #[inline(never)]
    pub fn without(self, others: Self) -> Self {
        Self(array::from_fn(|i| self.0[i] & !others.0[i]))
    }

    /// The left and right corners of squares.
    pub fn ends(self) -> Self {
        let mut bits = self;
        let mut carry = 0;
        for (to, word) in bits.0.iter_mut().zip(self.0) {
            *to |= word << 1 | carry;
            carry = word >> 63;
        }
        bits
    }

    /// The halves of squares, at the level below.
    pub fn halves(self) -> Self {
        let mut bits = Self::NONE;
        for (to, &word) in bits.0.as_chunks_mut::<2>().0.iter_mut().zip(&self.0) {
            *to = [word & 0xffff_ffff, word >> 32].map(|half| 3 * spread(half));
        }
        bits
    }

    /// Calls `call` with the index of each word from bit `first` to `last` (included), and the mask
    /// of these bits. The range may be empty.
    #[inline(always)]
    pub fn masks(first: i32, last: i32, mut call: impl FnMut(usize, u64)) {
        if first > last {
            return;
        }
        let [first, last] = [first, last].map(|i| i as usize % TILE_WIDTH);
        for i in first / 64..=last / 64 {
            let mut mask = u64::MAX;
            if i == first / 64 {
                mask <<= first % 64;
            }
            if i == last / 64 {
                mask &= u64::MAX >> (63 - last % 64);
            }
            call(i, mask);
        }
    }

    #[inline(always)]
    pub fn for_each(self, mut call: impl FnMut(usize)) {
        for (i, word) in self.0.into_iter().enumerate() {
            each(word, |bit| call(64 * i + bit));
        }
    }
}

#[inline(always)]
pub(crate) fn each(mut word: u64, mut call: impl FnMut(usize)) {
    while word != 0 {
        call(word.trailing_zeros() as usize % 64);
        word &= word - 1;
    }
}

fn spread(word: u64) -> u64 {
    let mut bits = word;
    for (shift, mask) in [
        (16, 0x0000_ffff_0000_ffff),
        (8, 0x00ff_00ff_00ff_00ff),
        (4, 0x0f0f_0f0f_0f0f_0f0f),
        (2, 0x3333_3333_3333_3333),
        (1, 0x5555_5555_5555_5555),
    ] {
        bits = (bits | bits << shift) & mask;
    }
    bits
}

impl BitAnd for Bits {
    type Output = Self;

    fn bitand(self, other: Self) -> Self {
        Self(array::from_fn(|i| self.0[i] & other.0[i]))
    }
}

impl BitOr for Bits {
    type Output = Self;

    fn bitor(self, other: Self) -> Self {
        Self(array::from_fn(|i| self.0[i] | other.0[i]))
    }
}
