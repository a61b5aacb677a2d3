//! A model of x86-64 programs that predicts the next bit, by context mixing as in PAQ.
//!
//! A context is a set of features: the last bytes, parts of the [instruction](machine_code). It has
//! a [slot](slot) for every beginning of the next byte, with a probability and the last bits, from
//! which pairs of contexts predict. A context may expect a byte, such as the one after the last
//! match; its slots then predict differences from it. A [mixer] weighs all predictions.

mod coder;
mod lanes;
mod machine_code;
mod mixer;
mod operands;
mod slot;

pub use coder::{Coder, Decoder};

use lanes::Lanes;
use machine_code::{
    AFTER_MATCH, DESTINATION, EXTENSION, FIRST, KIND, LENGTH, MATCH, MODRM, OPCODE, OPERAND, PLACE,
    PREFIXES, Reader, SAME_OPCODE, SAME_OPERAND, TARGET, before,
};
use mixer::Mixer;
use slot::{HISTORIES, OPPOSITE, Rates, Slot, Slots};

/// Bit sets of features, found by random changes. Two neighbours at an even index form a pair.
static CONTEXTS: [u32; COUNT] = [
    context(&[KIND, OPCODE, before(OPCODE, 1), before(OPCODE, 2), before(OPCODE, 3)]),
    expecting(SAME_OPCODE, &[KIND, OPCODE]),
    context(&[0, KIND]),
    context(&[0, PLACE]),
    context(&[KIND, OPERAND, EXTENSION, FIRST, LENGTH]),
    expecting(SAME_OPERAND, &[KIND, DESTINATION, FIRST, LENGTH]),
    expecting(SAME_OPERAND, &[0, 3, TARGET, OPERAND, LENGTH, SAME_OPERAND])
        | LAST_TWO
        | context(&[before(OPCODE, 2), before(PREFIXES, 2)]),
    expecting(AFTER_MATCH, &[MATCH]),
    context(&[PLACE]),
    context(&[KIND]),
    context(&[KIND, OPCODE, TARGET, FIRST, LENGTH]),
    context(&[KIND, OPCODE, before(OPCODE, 1), TARGET]),
    context(&[0, 1, PREFIXES]),
    context(&[0, OPCODE, MODRM, before(OPCODE, 1), before(DESTINATION, 1), OPERAND, EXTENSION]),
    expecting(SAME_OPERAND, &[0, KIND, before(OPCODE, 1)]),
    expecting(SAME_OPERAND, &[KIND, SAME_OPCODE, SAME_OPERAND]),
    expecting(SAME_OPERAND, &[2, TARGET, FIRST]) | LAST_TWO,
    context(&[KIND, before(DESTINATION, 1), TARGET, OPERAND, EXTENSION]),
];
/// The context of the last two instructions.
const LAST_TWO: u32 = context(&[OPCODE, PREFIXES, before(OPCODE, 1), before(PREFIXES, 1)]);

const COUNT: usize = 18;
const PAIRS: usize = 6;
const INPUTS: usize = COUNT + PAIRS;
const ROWS: usize = COUNT.div_ceil(4);

/// The lowest bit of the expected feature's number, counted from [`MATCH`], whose lowest byte is 0.
const EXPECTED: u32 = 30;

const fn context(mut features: &[usize]) -> u32 {
    let mut set = 0;
    while let [first, rest @ ..] = features {
        set |= 1 << *first;
        features = rest;
    }
    set
}

/// Returns a context that learns differences from the byte in `feature`, to share experience
/// between expected bytes.
const fn expecting(feature: usize, features: &[usize]) -> u32 {
    context(features) | ((feature - MATCH) as u32) << EXPECTED
}

/// Slots in a bucket, a cache line. Slot 0 is the owner's hash; the others are for the beginnings
/// of four bits.
const BUCKET: u32 = 16;

/// The number of slots: 64 MB. Of two buckets the less visited one is replaced. Half the slots cost
/// 220 bytes.
const SLOTS: usize = 1 << 24;

/// The first slots are for pairs, by the two histories and whether both expect the same bit.
const PAIR_SLOTS: usize = 2 * HISTORIES * HISTORIES;

#[repr(align(64))]
struct Table([Slot; SLOTS]);

/// The model's memory, initially zero. Small fields are first, for 8-bit offsets.
#[repr(C)]
pub struct Model {
    buckets: [[u32; 4]; ROWS],
    /// Each context's four expected bits, shifted as they are used.
    expected: [[u32; 4]; ROWS],
    /// The slots for the next bit: one for each context, then one for each pair.
    places: [[u32; 4]; slot::ROWS],
    /// The mask for each slot after learning: 0, or [`OPPOSITE`] where a 1 is expected.
    opposites: [[u32; 4]; slot::ROWS],
    pub reader: Reader,
    slots: Slots,
    mixer: Mixer,
    rates: Rates,
    table: Table,
}

impl Model {
    #[inline(always)]
    pub fn fill(&mut self) {
        self.mixer.fill();
        self.rates.fill();
    }

    #[inline(always)]
    pub fn byte(&mut self, coder: &mut impl Coder) -> u8 {
        let mut byte = 1;
        while byte < 0x100 {
            self.find_buckets(byte);
            let mut nibble = 1;
            while nibble < 0x10 {
                let bit = self.bit(byte, nibble, coder);
                nibble = nibble * 2 + bit;
                byte = byte * 2 + bit;
            }
        }
        self.reader.read(byte & 0xff);
        byte as u8
    }

    #[inline(always)]
    fn find_buckets(&mut self, byte: u32) {
        let left = if byte == 1 { 4 } else { 0 };
        for (i, &context) in CONTEXTS.iter().enumerate() {
            let expected = self.reader.feature(MATCH + (context >> EXPECTED) as usize);
            let expected = (expected & 0xff) >> left;
            self.expected.as_flattened_mut()[i] = expected & 0xf;
            let mut hash = (i as u32) << 8 | (byte ^ expected >> 4);
            let mut features = context & ((1 << EXPECTED) - 1);
            while features != 0 {
                let feature = self.reader.feature(features.trailing_zeros() as usize);
                hash = hash.wrapping_mul(0x2c1b_3c6d).rotate_left(13) ^ feature;
                features &= features - 1;
            }
            self.buckets.as_flattened_mut()[i] = hash.wrapping_mul(0x9e37_79b1);
        }
        // Computing all hashes first overlaps the cache misses.
        for i in 0..COUNT {
            let hash = self.buckets.as_flattened()[i];
            self.buckets.as_flattened_mut()[i] = self.find_bucket(hash);
        }
    }

    #[inline(always)]
    fn find_bucket(&mut self, hash: u32) -> u32 {
        let first = hash >> (u32::BITS - SLOTS.ilog2()) & !(BUCKET - 1);
        let first = first.max((PAIRS * PAIR_SLOTS) as u32);
        let mut place = first;
        if !self.slot(place).is(hash) {
            place = first ^ BUCKET;
            if !self.slot(place).is(hash) {
                // Slot 1 counts all visits to a bucket.
                if self.slot(first | 1).count() < self.slot(place | 1).count() {
                    place = first;
                }
                for i in 0..BUCKET {
                    *self.slot(place | i) = Slot::NEW;
                }
                *self.slot(place) = Slot::named(hash);
            }
        }
        place
    }

    #[inline(always)]
    fn slot(&mut self, place: u32) -> &mut Slot {
        &mut self.table.0[place as usize % SLOTS]
    }

    #[inline(always)]
    fn find_slots(&mut self, nibble: u32) {
        for row in 0..ROWS {
            let expected = Lanes::pairs(&self.expected[row]);
            self.expected[row] = expected.shift_left::<1>().to_pairs();
            let slot = Lanes::splat_pair(nibble).xor(expected.shift_right::<4>());
            self.places[row] = slot.xor(Lanes::pairs(&self.buckets[row])).to_pairs();
            // All ones where a 1 is expected, else 0.
            let is_one = expected.shift_left::<28>().shift_right::<31>();
            self.opposites[row] = is_one.and(Lanes::splat_pair(OPPOSITE)).to_pairs();
        }
        // Overwrite the padding of the last row with the pairs.
        for i in 0..PAIRS {
            let [first, second] = [2 * i, 2 * i + 1];
            let history = self.slot(self.place(first)).history() * HISTORIES;
            let histories = history + self.slot(self.place(second)).history();
            let opposites = self.opposites.as_flattened_mut();
            let differ = opposites[first] ^ opposites[second];
            opposites[COUNT + i] = opposites[first];
            self.places.as_flattened_mut()[COUNT + i] =
                (i * PAIR_SLOTS + histories) as u32 | (differ & (HISTORIES * HISTORIES) as u32);
        }
    }

    #[inline(always)]
    fn place(&self, input: usize) -> u32 {
        self.places.as_flattened()[input]
    }

    /// Codes a bit, after the bits `byte` and `nibble`, which begin with a 1.
    #[inline(never)]
    fn bit(&mut self, byte: u32, nibble: u32, coder: &mut impl Coder) -> u32 {
        self.find_slots(nibble);
        let mut experienced = 0;
        for i in 0..INPUTS {
            let opposite = self.opposites.as_flattened()[i];
            let slot = self.slot(self.place(i)).exclusive_or(opposite >> 1);
            experienced += u32::from(slot.count() != 0);
            self.slots.set(i, slot, &self.rates);
            self.mixer.input(i, slot.probability());
        }
        let sets = mixer::sets(&self.reader, byte, experienced);
        let bit = coder.bit(self.mixer.predict(&sets));
        self.mixer.learn(&sets, bit);
        self.slots.learn(bit);
        for i in 0..INPUTS {
            let opposite = self.opposites.as_flattened()[i];
            *self.slot(self.place(i)) = self.slots.get(i).exclusive_or(opposite);
        }
        bit
    }
}

/// Returns false if `packed` is damaged.
#[inline(always)]
pub fn decode(model: &mut Model, packed: &[u8], bytes: &mut [u8]) -> bool {
    let mut decoder = Decoder::new(packed);
    for i in 0..bytes.len() {
        bytes[i] = model.byte(&mut decoder);
        if decoder.missing {
            return false;
        }
        if let Some(offset) = model.reader.ended_offset() {
            to_offset(&mut bytes[..=i], offset);
        }
    }
    decoder.is_at_end()
}

/// Converts the relative offset of an instruction that ends with `bytes` to an address from the
/// program's first byte: references to one place are equal bytes.
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
