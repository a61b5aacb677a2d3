//! The crate that packs the intro when it is linked, and unpacks it when it starts. [`build`] is
//! the intro's build script and linker, `model` predicts the next bit of x86 code, and `stub`
//! starts a packed executable.
//!
//! The model computes with integers, in one function for packing and unpacking. Unpacking takes 1.1
//! microseconds a byte (`time target/release/eightfold --version`). Sizes of an intro of 116,673
//! bytes by packer:
//!
//! | packer | packed | unpacker | time to unpack |
//! | --- | ---: | ---: | ---: |
//! | upkr -9 | 59,318 | 494 | 8 ms |
//! | xz (LZMA1, filter for x86) | 58,108 | 1,478 | 8 ms |
//! | zpaq -m5 | 52,543 | (large) | |
//! | this one, then | 41,640 | 3,600 with its loader | 0.12 s |
#![cfg(target_arch = "x86_64")]
#![deny(unsafe_code)]

pub mod build;
mod elf;
mod executable;
mod model;
mod panics;
mod pe;
mod small;
mod stub;
#[cfg(test)]
mod tests;

use std::error;

pub use executable::{System, pack_executable, strip, unpack_executable};
use model::{Coder, Model};

pub type Error = Box<dyn error::Error>;

fn encode(bytes: &[u8]) -> Vec<u8> {
    let mut model = new_model();
    let mut encoder = Encoder::new();
    for byte in with_addresses(bytes) {
        encoder.byte = byte;
        model.byte(&mut encoder);
    }
    encoder.end()
}

/// Returns the cost of each byte in bits, without the code's few bits at its end.
#[must_use]
pub fn costs(bytes: &[u8]) -> Vec<f32> {
    let mut model = new_model();
    let bytes = with_addresses(bytes);
    let costs = bytes.into_iter().map(|byte| {
        let mut meter = Meter { byte, bits: 0.0 };
        model.byte(&mut meter);
        meter.bits
    });
    costs.collect()
}

struct Meter {
    byte: u8,
    bits: f32,
}

impl Coder for Meter {
    fn bit(&mut self, probability: u32) -> u32 {
        let bit = u32::from(self.byte >> 7);
        self.byte <<= 1;
        let of_one = probability as f32 / 65_536.0;
        let likely = if bit == 1 { of_one } else { 1.0 - of_one };
        self.bits -= likely.log2();
        bit
    }
}

/// Replaces relative offsets in instructions with addresses.
fn with_addresses(bytes: &[u8]) -> Vec<u8> {
    let mut bytes = bytes.to_vec();
    let reader = &mut new_model().reader;
    for i in 0..bytes.len() {
        reader.read(bytes[i].into());
        if let Some(offset) = reader.ended_offset() {
            model::to_address(&mut bytes[..=i], offset);
        }
    }
    bytes
}

fn decode(code: &[u8], length: usize) -> Result<Vec<u8>, Error> {
    if length > LONGEST {
        return Err(DAMAGED.into());
    }
    let mut bytes = vec![0; length];
    let is_whole = model::decode(&mut new_model(), code, &mut bytes);
    is_whole.then_some(bytes).ok_or_else(|| DAMAGED.into())
}

fn checksum(bytes: &[u8]) -> u32 {
    bytes.iter().fold(0x811c_9dc5, |hash, &byte| (hash ^ u32::from(byte)).wrapping_mul(0x0100_0193))
}

/// The maximum size of a program with its loader, which unpacks in 16 seconds.
const LONGEST: usize = 1 << 24;

const DAMAGED: &str = "packed data is damaged";

#[allow(unsafe_code, reason = "68 MB do not fit on a stack")]
fn new_model() -> Box<Model> {
    // SAFETY: all fields are integers, for which zero is valid.
    let mut model = unsafe { Box::<Model>::new_zeroed().assume_init() };
    model.fill();
    model
}

struct Encoder {
    byte: u8,
    /// The lower end of the interval, without the bytes already written.
    low: u64,
    range: u64,
    written: Vec<u8>,
}

/// The number of bits in `low`. Its top byte is written when it is shifted out.
const LOW: u32 = 40;

impl Encoder {
    fn new() -> Encoder {
        Encoder { byte: 0, low: 0, range: 1 << 32, written: Vec::new() }
    }

    fn shift(&mut self) {
        self.range <<= 8;
        self.written.push((self.low >> 32) as u8);
        self.low = self.low << 8 & ((1 << LOW) - 1);
    }

    fn end(mut self) -> Vec<u8> {
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
