//! A model of x86-64 programs, which says how likely the next bit is 1: packer and unpacker have it in common.
//!
//! It is context mixing, as in PAQ. A context is some of the last bytes or of what the [instruction](machine_code) is; each has a
//! [slot](slot) for every beginning of the next byte, with a probability and the last bits. What such a row of bits was followed by,
//! anywhere in that context, is a second probability. A [mixer] weighs both of all contexts.
//!
//! There are only integers, and one function for both sides, so that the bytes are the same on every machine.

mod addresses;
mod coder;
mod lanes;
mod machine_code;
mod mixer;
mod slot;

pub use addresses::to_address;
pub use coder::{Coder, Decoder};
pub use machine_code::Reader;

use machine_code::{KIND, MODRM, OPCODE, OPERAND, PLACE, PREFIXES, SAME_FIELD, before};
use mixer::Mixer;
use slot::{Rates, Slot, Slots};

/// The features that each context is made of, as a bit for each: found by changing one at random and keeping what packs the intro
/// better.
static CONTEXTS: [u32; COUNT] = [
    context(&[KIND, OPCODE, before(OPCODE, 2), SAME_FIELD]),
    context(&[KIND, OPCODE, before(OPCODE, 1)]),
    context(&[0, KIND]),
    context(&[KIND, OPCODE]),
    context(&[
        KIND,
        OPCODE,
        before(OPCODE, 1),
        before(OPCODE, 2),
        before(OPCODE, 3),
    ]),
    context(&[PLACE]),
    context(&[0, PLACE]),
    context(&[
        0,
        1,
        3,
        4,
        OPCODE,
        before(OPCODE, 1),
        before(MODRM, 1),
        before(PREFIXES, 1),
        OPERAND,
    ]),
    context(&[KIND, PREFIXES, OPERAND]),
    context(&[0, 1, PREFIXES]),
    context(&[
        OPCODE,
        PREFIXES,
        before(OPCODE, 1),
        before(PREFIXES, 1),
        OPERAND,
    ]),
    context(&[KIND]),
];
const COUNT: usize = 12;

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

/// 64 MB of them for all contexts. Half of that packs the intro to 359 bytes more, and takes 3 % less time.
const BUCKETS: usize = 1 << 20;

/// The model's memory. It begins with zeros. Small fields come first: instructions reach them by offsets of one byte.
#[repr(C)]
pub struct Model {
    /// The hash of each context, and which bucket that leads to.
    hashes: [u32; COUNT],
    pub reader: Reader,
    /// Copies of the slots for the next bit, two of each context.
    slots: Slots,
    mixer: Mixer,
    rates: Rates,
    /// What a row of bits was followed by in each context.
    histories: [[Slot; 256]; COUNT],
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
        for (i, (hash, &context)) in self.hashes.iter_mut().zip(&CONTEXTS).enumerate() {
            let mut mixed = (i as u32) << 8 | byte;
            let mut features = context;
            while features != 0 {
                let feature = self.reader.feature(features.trailing_zeros() as usize);
                mixed = mixed.wrapping_mul(0x2c1b_3c6d).rotate_left(13) ^ feature;
                features &= features - 1;
            }
            *hash = mixed.wrapping_mul(0x9e37_79b1);
        }
        for &hash in &self.hashes {
            let bucket = &mut self.table[bucket(hash)];
            if !bucket.0[0].is(hash) {
                *bucket = Bucket([Slot::NEW; 16]);
                bucket.0[0] = Slot::named(hash);
            }
        }
    }

    /// Codes a bit behind those of its byte and those of its four, which begin with a 1.
    #[inline(never)]
    fn bit(&mut self, byte: u32, nibble: usize, coder: &mut impl Coder) -> u32 {
        let sets = mixer::sets(self.reader.feature(KIND), byte, self.reader.feature(0));
        for i in 0..COUNT {
            let slot = self.table[bucket(self.hashes[i])].0[nibble & 15];
            let history = self.histories[i][slot.history()];
            for (j, slot) in [slot, history].into_iter().enumerate() {
                self.slots.set(2 * i + j, slot, &self.rates);
                self.mixer.input(2 * i + j, slot.probability());
            }
        }
        let bit = coder.bit(self.mixer.predict(sets));
        self.mixer.learn(sets, bit);
        self.slots.learn(bit);
        for i in 0..COUNT {
            let slot = &mut self.table[bucket(self.hashes[i])].0[nibble & 15];
            self.histories[i][slot.history()] = self.slots.get(2 * i + 1);
            *slot = self.slots.get(2 * i);
        }
        bit
    }
}

/// The bucket that a hash leads to.
#[inline(always)]
fn bucket(hash: u32) -> usize {
    (hash >> (u32::BITS - BUCKETS.ilog2())) as usize & (BUCKETS - 1)
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
