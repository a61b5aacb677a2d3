use crate::{model::Coder, new_model, with_addresses};

/// Returns the cost of each byte in bits. The packed code also has a few bits at its end.
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
