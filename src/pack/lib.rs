#![deny(unsafe_code)]
pub mod build;
mod costs;
mod elf;
mod encoder;
mod executable;
mod model;
mod stub;

pub use costs::costs;
use encoder::Encoder;
pub use executable::{pack_executable, strip, unpack_executable};
use model::{Model, Reader};

/// Why something can't be packed, or is not built.
pub type Error = Box<dyn std::error::Error>;

/// Bytes packed.
#[must_use]
pub fn pack(bytes: &[u8]) -> Vec<u8> {
    let mut packed = vec![0; 4];
    packed.extend((bytes.len() as u32).to_le_bytes());
    let mut model = new_model();
    let mut encoder = Encoder::new();
    for byte in with_addresses(bytes) {
        encoder.byte = byte;
        model.byte(&mut encoder);
    }
    packed.extend(encoder.end());
    let checksum = model::checksum(&packed[4..]);
    packed[..4].copy_from_slice(&checksum.to_le_bytes());
    packed
}

/// Bytes of a program with addresses in place of the offsets in its instructions.
fn with_addresses(bytes: &[u8]) -> Vec<u8> {
    let mut bytes = bytes.to_vec();
    let mut reader = Reader::default();
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
/// If it is not what [`pack`] made.
pub fn unpack(packed: &[u8]) -> Result<Vec<u8>, Damaged> {
    let (length, code) = model::open(packed).ok_or(Damaged)?;
    if length > LONGEST {
        return Err(Damaged);
    }
    let mut bytes = vec![0; length];
    if model::decode(&mut new_model(), code, &mut bytes) {
        Ok(bytes)
    } else {
        Err(Damaged)
    }
}

/// What is longer is not unpacked: by 1 microsecond a byte it would take longer than 16 seconds.
pub const LONGEST: usize = 1 << 24;

/// What was to be unpacked was not packed, or has changed since.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Damaged;

impl std::fmt::Display for Damaged {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str("it is damaged")
    }
}

impl std::error::Error for Damaged {}

#[allow(unsafe_code, reason = "16 MB do not fit on a stack")]
fn new_model() -> Box<Model> {
    // SAFETY: it is made of integers, of which zero is a value.
    let mut model = unsafe { Box::<Model>::new_zeroed().assume_init() };
    model.fill();
    model
}
