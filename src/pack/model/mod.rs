//! A model of x86-64 programs, which says how likely the next bit is 1: packer and unpacker have it in common.
//!
//! It is context mixing, as in PAQ. A context is some of the last bytes or of what the [instruction](machine_code) is; each has a
//! [slot](slot) for every beginning of the next byte, with a probability and the last bits. What such rows of bits of two contexts
//! were followed by, anywhere in those, is a probability of that pair. A [mixer] weighs those of all contexts and pairs.
//!
//! There are only integers, and one function for both sides, so that the bytes are the same on every machine.

mod addresses;
mod coder;
mod lanes;
mod machine_code;
mod mixer;
mod operands;
mod slot;

pub use addresses::to_address;
pub use coder::{Coder, Decoder};
pub use machine_code::Reader;

use machine_code::{
    DESTINATION, EXTENSION, FIRST, KIND, LENGTH, MODRM, OPCODE, OPERAND, PAGE, PLACE, PREFIXES,
    SAME_OPCODE, SAME_OPERAND, before,
};
use mixer::Mixer;
use slot::{HISTORIES, Rates, Slot, Slots};

/// The features that each context is made of, as a bit for each: found by changing one at random and keeping what packs the intro
/// better. The order matters: two neighbours are a pair, whose histories are looked at together.
static CONTEXTS: [u32; COUNT] = [
    context(&[KIND, OPCODE, FIRST, LENGTH]),
    context(&[KIND, OPCODE, before(OPCODE, 1)]),
    context(&[0, PLACE]),
    context(&[KIND, SAME_OPCODE]),
    context(&[
        KIND,
        OPCODE,
        before(OPCODE, 1),
        before(OPCODE, 2),
        before(OPCODE, 3),
    ]),
    context(&[KIND]),
    context(&[PLACE]),
    context(&[
        0,
        3,
        PREFIXES,
        before(OPCODE, 1),
        before(OPCODE, 2),
        before(MODRM, 2),
        before(PREFIXES, 2),
        before(OPCODE, 3),
        before(PREFIXES, 3),
        LENGTH,
        SAME_OPERAND,
    ]),
    context(&[KIND, PREFIXES, PAGE, OPERAND]),
    context(&[KIND, before(DESTINATION, 1), EXTENSION]),
    context(&[1, OPCODE, before(OPCODE, 1), before(OPCODE, 2), SAME_OPCODE]),
    context(&[SAME_OPERAND]),
    context(&[0, KIND]),
    context(&[
        0,
        KIND,
        before(OPCODE, 1),
        before(DESTINATION, 1),
        OPERAND,
        EXTENSION,
    ]),
    context(&[
        2,
        3,
        OPCODE,
        PREFIXES,
        before(OPCODE, 1),
        before(PREFIXES, 1),
        FIRST,
    ]),
    context(&[0, 1, PREFIXES]),
];
const COUNT: usize = 16;
const PAIRS: usize = COUNT / 2;

const fn context(mut features: &[usize]) -> u32 {
    let mut set = 0;
    while let [first, rest @ ..] = features {
        set |= 1 << *first;
        features = rest;
    }
    set
}

/// A cache line: whose it is, in place of a slot 0, and a slot for each beginning of four bits.
#[repr(align(64))]
struct Bucket([Slot; 16]);

/// 64 MB of them for all contexts, which is too few: one takes the place of another that was seen less often. Half of that packs the
/// intro to 220 bytes more.
const BUCKETS: usize = 1 << 20;

/// The model's memory. It begins with zeros. Small fields come first: instructions reach them by offsets of one byte.
#[repr(C)]
pub struct Model {
    /// The bucket of each context.
    buckets: [usize; COUNT],
    pub reader: Reader,
    /// Copies of the slots for the next bit, one of each context, then one of each pair.
    slots: Slots,
    mixer: Mixer,
    rates: Rates,
    /// What the histories of two contexts were followed by.
    pairs: [[Slot; HISTORIES * HISTORIES]; PAIRS],
    table: [Bucket; BUCKETS],
}

impl Model {
    /// Makes memory that is zero ready.
    #[inline(always)]
    pub fn fill(&mut self) {
        self.mixer.fill();
        self.rates.fill();
    }

    /// Codes a byte and learns from it.
    #[inline(always)]
    pub fn byte(&mut self, coder: &mut impl Coder) -> u8 {
        let mut byte = 1;
        while byte < 0x100 {
            self.find_buckets(byte);
            let mut nibble = 1;
            while nibble < 0x10 {
                let bit = self.bit(byte, nibble, coder);
                nibble = nibble * 2 + bit as usize;
                byte = byte * 2 + bit;
            }
        }
        self.reader.read(byte & 0xff);
        byte as u8
    }

    /// Finds the buckets for the next four bits of a byte that begins like this.
    #[inline(always)]
    fn find_buckets(&mut self, byte: u32) {
        for (i, &context) in CONTEXTS.iter().enumerate() {
            let mut hash = (i as u32) << 8 | byte;
            let mut features = context;
            while features != 0 {
                let feature = self.reader.feature(features.trailing_zeros() as usize);
                hash = hash.wrapping_mul(0x2c1b_3c6d).rotate_left(13) ^ feature;
                features &= features - 1;
            }
            self.buckets[i] = hash.wrapping_mul(0x9e37_79b1) as usize;
        }
        // All hashes come first: a processor then waits for several buckets at once.
        for i in 0..COUNT {
            self.buckets[i] = self.find_bucket(self.buckets[i] as u32);
        }
    }

    /// Finds the bucket of a hash, or makes it one.
    #[inline(always)]
    fn find_bucket(&mut self, hash: u32) -> usize {
        let first = (hash >> (u32::BITS - BUCKETS.ilog2())) as usize;
        let mut place = first;
        if !self.bucket(place)[0].is(hash) {
            place = first ^ 1;
            if !self.bucket(place)[0].is(hash) {
                // All that came to a bucket has gone through its slot 1.
                if self.bucket(first)[1].count() < self.bucket(place)[1].count() {
                    place = first;
                }
                let bucket = self.bucket(place);
                *bucket = [Slot::NEW; 16];
                bucket[0] = Slot::named(hash);
            }
        }
        place
    }

    #[inline(always)]
    fn bucket(&mut self, place: usize) -> &mut [Slot; 16] {
        &mut self.table[place & (BUCKETS - 1)].0
    }

    /// The slot of a context for the next bit.
    #[inline(always)]
    fn slot(&mut self, context: usize, nibble: usize) -> &mut Slot {
        &mut self.bucket(self.buckets[context])[nibble & 15]
    }

    /// The slot of a pair for the next bit.
    #[inline(always)]
    fn pair(&mut self, pair: usize, nibble: usize) -> &mut Slot {
        let first = self.slot(2 * pair, nibble).history();
        let second = self.slot(2 * pair + 1, nibble).history();
        &mut self.pairs[pair][first * HISTORIES + second]
    }

    /// Codes a bit behind those of its byte and those of its four, which begin with a 1.
    #[inline(never)]
    fn bit(&mut self, byte: u32, nibble: usize, coder: &mut impl Coder) -> u32 {
        let sets = mixer::sets(self.reader.feature(KIND), byte, self.reader.feature(0));
        for i in 0..COUNT + PAIRS {
            let slot = if i < COUNT {
                *self.slot(i, nibble)
            } else {
                *self.pair(i - COUNT, nibble)
            };
            self.slots.set(i, slot, &self.rates);
            self.mixer.input(i, slot.probability());
        }
        let bit = coder.bit(self.mixer.predict(&sets));
        self.mixer.learn(&sets, bit);
        self.slots.learn(bit);
        // The pairs first: where they are depends on the slots.
        for i in 0..PAIRS {
            *self.pair(i, nibble) = self.slots.get(COUNT + i);
        }
        for i in 0..COUNT {
            *self.slot(i, nibble) = self.slots.get(i);
        }
        bit
    }
}

/// The length of what was packed, and the code that it was packed to. None if something has changed since.
#[inline(always)]
pub fn open(packed: &[u8]) -> Option<(usize, &[u8])> {
    let (sum, rest) = packed.split_first_chunk()?;
    let (length, code) = rest.split_first_chunk()?;
    let is_whole = u32::from_le_bytes(*sum) == checksum(rest);
    is_whole.then_some((u32::from_le_bytes(*length) as usize, code))
}

/// The FNV-1a hash.
#[inline(always)]
pub fn checksum(bytes: &[u8]) -> u32 {
    let mut hash = 0x811c_9dc5_u32;
    for &byte in bytes {
        hash = (hash ^ u32::from(byte)).wrapping_mul(0x0100_0193);
    }
    hash
}

/// Unpacks bytes. False if they are not what was packed.
#[inline(always)]
pub fn decode(model: &mut Model, packed: &[u8], bytes: &mut [u8]) -> bool {
    let mut decoder = Decoder::new(packed);
    for i in 0..bytes.len() {
        bytes[i] = model.byte(&mut decoder);
        if decoder.missing {
            return false;
        }
        if let Some(offset) = model.reader.ended_offset() {
            addresses::to_offset(&mut bytes[..=i], offset);
        }
    }
    decoder.is_at_end()
}
