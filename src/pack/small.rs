//! A small context-mixing model, for the stub's second stage. Its decoder is `stub/small.s`, which
//! computes the same floats.
//!
//! Six contexts count the zeros and ones after them; each bit halves the opposite count. The odds
//! of a 1 are the fourth root of the product of all odds.

/// Sets of the three bytes before, in the decoder's order: 1 for the last byte, 2 and 4 for those
/// before it.
const CONTEXTS: [u32; 6] = [5, 4, 3, 2, 1, 0];

/// The count of an unseen bit.
const UNSEEN: f32 = f32::from_bits(0x3e28_0000);

/// Quartering the slots would cost 35 bytes.
const SLOTS: usize = 1 << 20;

/// The size of the decoder's memory, which is zero at first.
pub const MEMORY: u64 = (SLOTS * size_of::<Counts>()) as u64;

type Counts = [u32; 2];

struct Encoder {
    low: u64,
    range: u32,
    bits: Vec<bool>,
}

impl Encoder {
    fn widen(&mut self) {
        while self.range < 1 << 31 {
            self.range <<= 1;
            self.shift();
        }
    }

    fn shift(&mut self) {
        self.bits.push(self.low >> 31 == 1);
        self.low = self.low << 1 & 0xffff_ffff;
    }

    fn add(&mut self, summand: u32) {
        self.low += u64::from(summand);
        if self.low >> 32 != 0 {
            self.low &= 0xffff_ffff;
            let carried = self.bits.iter().rposition(|&bit| !bit).expect("a code below 1");
            self.bits[carried] = true;
            self.bits[carried + 1..].fill(false);
        }
    }

    fn code(&mut self, bit: usize, chance: f32) {
        self.widen();
        let bound = bound(self.range, chance);
        if bit == 1 {
            self.range = bound;
        } else {
            self.range -= bound;
            self.add(bound);
        }
    }

    fn end(mut self) -> Vec<u8> {
        // Two bits suffice. The first bit only receives carries, and the code is below 1.
        self.widen();
        self.add((1 << 30) - 1);
        self.shift();
        self.shift();
        let mut words = vec![u32::MAX; (self.bits.len() - 1) / 32 + 1];
        for (i, bit) in self.bits.iter().skip(1).enumerate() {
            words[i / 32] ^= u32::from(!bit) << (i % 32);
        }
        // The decoder reads words. The last bit is 1, so that any cut of the file changes it in
        // memory.
        words.into_iter().flat_map(u32::to_le_bytes).collect()
    }
}

/// Returns the part of an interval that is for a 1.
fn bound(range: u32, chance: f32) -> u32 {
    let bound = (range as f32 * chance) as u32;
    assert!(0 < bound && bound < range, "stage of the stub is too uniform");
    bound
}

/// Codes the byte after `before`. `code` gets the probability of a 1, and returns a bit.
fn byte(counts: &mut [Counts], before: &[u8], mut code: impl FnMut(f32) -> usize) -> u8 {
    let mut beginning = 1;
    while beginning < 0x100 {
        let slots = CONTEXTS.map(|context| slot(before, context, beginning as u32));
        let mut odds = [UNSEEN; 2];
        for slot in slots {
            for (odds, count) in odds.iter_mut().zip(counts[slot]) {
                *odds *= count as f32 + UNSEEN;
            }
        }
        let [zero, one] = odds.map(|odds| odds.sqrt().sqrt());
        let bit = code(one / (zero + one));
        for slot in slots {
            counts[slot][bit] += 1;
            counts[slot][1 - bit] = counts[slot][1 - bit].div_ceil(2);
        }
        beginning = beginning * 2 + bit;
    }
    beginning as u8
}

fn slot(before: &[u8], mut context: u32, beginning: u32) -> usize {
    let mut hash = context | beginning << 8;
    let mut last = before.iter().rev();
    loop {
        // Zeros are before the first byte.
        let byte = last.next().copied().unwrap_or_default();
        hash = (hash ^ ((context & 1) * u32::from(byte))).wrapping_mul(0x0100_0193);
        context >>= 1;
        if context == 0 {
            return (hash >> (u32::BITS - SLOTS.ilog2())) as usize;
        }
    }
}

pub fn encode(bytes: &[u8]) -> Vec<u8> {
    let mut counts = vec![Counts::default(); SLOTS];
    let mut encoder = Encoder { low: 0, range: 1 << 31, bits: Vec::new() };
    for (place, &next) in bytes.iter().enumerate() {
        let mut left = next;
        byte(&mut counts, &bytes[..place], |chance| {
            let bit = usize::from(left >> 7);
            left <<= 1;
            encoder.code(bit, chance);
            bit
        });
    }
    encoder.end()
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::{collection::vec, prelude::*};

    fn decode(code: &[u8], length: usize) -> Vec<u8> {
        let mut bits = code.iter().flat_map(|byte| (0..8).map(move |i| u32::from(byte >> i & 1)));
        let (mut place, mut range) = (0, 1_u32);
        let mut counts = vec![Counts::default(); SLOTS];
        let mut bytes = Vec::new();
        for _ in 0..length {
            let next = byte(&mut counts, &bytes, |chance| {
                while range < 1 << 31 {
                    range <<= 1;
                    place = place << 1 | bits.next().unwrap_or_default();
                }
                let bound = bound(range, chance);
                if place < bound {
                    range = bound;
                    return 1;
                }
                (place, range) = (place - bound, range - bound);
                0
            });
            bytes.push(next);
        }
        bytes
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(16))]

        #[test]
        fn small_bytes_round_trip(random in vec(any::<u8>(), 0..300), zeros in 0..6000_usize) {
            let bytes = [&*random, &vec![0; zeros], &random].concat();
            let code = encode(&bytes);
            prop_assert!(code.last() >= Some(&0x80), "a cut would be invisible");
            prop_assert_eq!(decode(&code, bytes.len()), bytes);
        }
    }
}
