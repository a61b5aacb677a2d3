//! Packs the intro when it is linked, and unpacks it when it starts.
//!
//! | what | where |
//! | --- | --- |
//! | a model of programs, which says how likely the next bit is 1 | `model` |
//! | bytes packed by it, and back | [`pack`], [`unpack`] |
//! | what panics have for messages, left out | `panics` |
//! | an executable packed, and back | [`pack_executable`], [`unpack_executable`] |
//! | what each byte takes of the packed file | [`costs`] |
//! | what starts a packed executable | `stub`: a program of its own, with the model in it |
//! | the intro's build script, and its linker | [`build`] |
//!
//! # Why a packer of our own
//!
//! The intro of 116,673 bytes takes so many when packed by
//!
//! | packer | packed | unpacker | time to unpack |
//! | --- | ---: | ---: | ---: |
//! | upkr -9 | 59,318 | 494 | 8 ms |
//! | xz (LZMA1, filter for x86) | 58,108 | 1,478 | 8 ms |
//! | zpaq -m5 | 52,543 | (no small one) | |
//! | this one, at that time | 41,640 | 3,600 with its loader | 0.12 s |
//!
//! # The same bytes on every machine
//!
//! The model computes with integers alone, in a fixed order, by one function for both sides. A slot of its table is found by a hash
//! of what was read, not by an address. So what is packed depends on the bytes that are packed and on nothing else; a test holds
//! SSE2 to the plain loops that take its place on other processors.
//!
//! # How long it takes
//!
//! `time target/release/eightfold --version` unpacks all and does next to nothing else: about 1.1 microseconds a byte. What that
//! came from, and what it takes of the packed file, which had 63,659 bytes:
//!
//! | step | time | bytes |
//! | --- | ---: | ---: |
//! | before | 0.25 s | |
//! | memory in huge pages, where the system has them | -0.03 s | +40 |
//! | slots learn four at a time, by SSE2 | -0.04 s | +350 |
//! | a third set of weights, for each byte that may come before | +0.01 s | -600 |
//! | contexts searched anew | | -270 |
//! | what the same field of instructions held before, as a context | | -220 |
//! | faster steps of slots that have seen little | | -63 |
//! | contexts, rates and first weights searched again, when it had 64,563 bytes | | -182 |
//! | sixteen contexts, not twelve; histories of pairs; features for operations, destinations, pages, operands | +0.07 s | -935 |
//! | two buckets for each hash, of which what was seen less goes | | -506 |
//! | logits of pairs limited | | -121 |
//! | a lowest rate of slots | | -45 |
//! | sets of weights by reference | -0.02 s | -16 |
//! | the loader packed with the program, when it had 65,287 bytes | | -427 |
//! | contexts that expect a byte, targets of jumps as a feature | | -697 |
//! | what followed the last bytes before, as such a byte; eighteen contexts; a fourth set of weights | +0.04 s | -612 |
//! | slots found four at a time, constants made by instructions | -0.02 s | -132 |
//! | contexts searched again | | -98 |
//!
//! Tried, and not worth it: prefetching the buckets, the hash of a context once a byte, inputs put together in registers (none
//! changes more than the measure's noise); four buckets for each hash (-76 bytes, +0.03 s); 32 MB of buckets (no less time, +220
//! bytes); a longer history (none); other sets of weights, by opcodes, lengths or destinations (none). More is in `docs/size.md`.
#![deny(missing_docs, unsafe_code)]

pub mod build;
mod costs;
mod elf;
mod encoder;
mod executable;
mod model;
mod panics;
mod pe;
mod stub;
#[cfg(test)]
mod tests;

use std::{error, fmt};

pub use costs::costs;
use encoder::Encoder;
pub use executable::{System, Version, pack_executable, strip, unpack_executable};
use model::Model;

/// Why a program can't be packed, or not be built as it should be.
pub type Error = Box<dyn error::Error>;

/// Bytes packed: a checksum of all that follows it, how many bytes there were (both as 32 bits, little-endian), and their code.
///
/// # Panics
/// If they are longer than [`LONGEST`].
#[must_use]
pub fn pack(bytes: &[u8]) -> Vec<u8> {
    assert!(bytes.len() <= LONGEST, "{} bytes are too many", bytes.len());
    let length = (bytes.len() as u32).to_le_bytes();
    let rest = [&length, &*encode(bytes)].concat();
    [&checksum(&rest).to_le_bytes(), &*rest].concat()
}

/// The code of bytes.
fn encode(bytes: &[u8]) -> Vec<u8> {
    let mut model = new_model();
    let mut encoder = Encoder::new();
    for byte in with_addresses(bytes) {
        encoder.byte = byte;
        model.byte(&mut encoder);
    }
    encoder.end()
}

/// Bytes of a program with addresses in place of the offsets in its instructions.
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

/// The bytes that were packed.
///
/// # Errors
/// If it is not what [`pack`] has made.
pub fn unpack(packed: &[u8]) -> Result<Vec<u8>, Damaged> {
    let (sum, rest) = packed.split_first_chunk().ok_or(Damaged)?;
    let (length, code) = rest.split_first_chunk().ok_or(Damaged)?;
    if u32::from_le_bytes(*sum) != checksum(rest) {
        return Err(Damaged);
    }
    decode(code, u32::from_le_bytes(*length) as usize)
}

/// As many bytes as a code is of.
fn decode(code: &[u8], length: usize) -> Result<Vec<u8>, Damaged> {
    if length > LONGEST {
        return Err(Damaged);
    }
    let mut bytes = vec![0; length];
    let is_whole = model::decode(&mut new_model(), code, &mut bytes);
    is_whole.then_some(bytes).ok_or(Damaged)
}

/// The FNV-1a hash.
fn checksum(bytes: &[u8]) -> u32 {
    bytes.iter().fold(0x811c_9dc5, |hash, &byte| {
        (hash ^ u32::from(byte)).wrapping_mul(0x0100_0193)
    })
}

/// The most bytes that can be packed: they take 16 seconds.
pub const LONGEST: usize = 1 << 24;

/// An error: what was to be unpacked was never packed, or has changed since.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Damaged;

impl fmt::Display for Damaged {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("what was packed is damaged")
    }
}

impl error::Error for Damaged {}

#[allow(unsafe_code, reason = "68 MB do not fit on a stack")]
fn new_model() -> Box<Model> {
    // SAFETY: it is made of integers, of which zero is a value.
    let mut model = unsafe { Box::<Model>::new_zeroed().assume_init() };
    model.fill();
    model
}
