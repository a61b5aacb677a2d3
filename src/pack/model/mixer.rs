//! Mixes probabilities with a neuron that learns their weights (logistic mixing).

use super::lanes::Lanes;
use super::machine_code::{KIND, KINDS, MORE_KINDS, OPCODE, Reader, before};

pub const ROWS: usize = 3;

/// A weight for each input, in 16,384ths.
type Weights = [Lanes; ROWS];

/// The initial sum of an input's seven weights: together, all 24 inputs weigh nearly 1.5.
const FIRST_WEIGHT: i16 = 1000;

/// The number of weight sets, see [`sets`]. Some reuse the numbers of unused kinds.
const SETS: usize = (2 * KINDS) << 8;

/// The limit of a context pair's logit in 256ths: 94 % probability. It saves 120 bytes.
const PAIR_LIMIT: i16 = 700;

const RATE: i32 = 12;

const STEPS: usize = 4096;

/// The mixer's memory. Probabilities are in 65,536ths; logits, ln(p / (1 - p)), in 256ths, from
/// -2048 to 2047.
#[repr(C)]
pub struct Mixer {
    /// The inputs' logits; the last row is for pairs.
    inputs: [[i16; 8]; ROWS],
    probability: i32,
    probabilities: [i32; STEPS],
    /// The logits of probabilities in the format of slots: steps of 16 from one half on.
    logits: [i16; STEPS],
    /// Without [`FIRST_WEIGHT`].
    weights: [Weights; SETS],
}

impl Mixer {
    #[inline(always)]
    pub fn fill(&mut self) {
        // Integrate the logistic function's p' = p (1 - p) from p(-8) on, in 2^-32nds, in steps of
        // 1/256.
        let mut p = 1_440_000_u64;
        let mut next = 0;
        for (x, probability) in self.probabilities.iter_mut().enumerate() {
            *probability = (p >> 16) as i32;
            while next <= p >> 20 {
                self.logits[(next as usize ^ (STEPS / 2)) & (STEPS - 1)] = x as i16 - 2048;
                next += 1;
            }
            p += (p * ((1 << 32) - p)) >> 40;
        }
    }

    /// Sets an input: a probability minus one half, as a signed 16-bit number.
    #[inline(always)]
    pub fn input(&mut self, index: usize, probability: u16) {
        self.inputs.as_flattened_mut()[index] = self.logits[usize::from(probability >> 4)];
    }

    #[inline(always)]
    pub fn predict(&mut self, sets: &Sets) -> u32 {
        let pairs = &mut self.inputs[ROWS - 1];
        *pairs = Lanes::new(pairs).limit(PAIR_LIMIT).to_numbers();
        let mut sum = Lanes::splat(0);
        for (i, inputs) in self.inputs.iter().enumerate() {
            let mut weights = Lanes::splat(FIRST_WEIGHT);
            for &set in sets {
                weights = weights.saturating_add(self.weights[set as usize % SETS][i]);
            }
            sum = sum.add_products(weights, Lanes::new(inputs));
        }
        let logit = (sum.sum() >> 14).clamp(-2048, 2047) + 2048;
        self.probability = self.probabilities[logit as usize & (STEPS - 1)];
        self.probability as u32
    }

    #[inline(always)]
    pub fn learn(&mut self, sets: &Sets, bit: u32) {
        let error = ((bit as i32) << 16) - self.probability;
        let error = Lanes::splat(((error * RATE) >> 8) as i16);
        for &set in sets {
            for (weight, inputs) in self.weights[set as usize % SETS].iter_mut().zip(&self.inputs) {
                let inputs = Lanes::new(inputs);
                let change = inputs.saturating_add(inputs).multiply_high(error);
                let change = change.saturating_add(Lanes::splat(1)).halve();
                *weight = weight.saturating_add(change);
            }
        }
    }
}

pub type Sets = [u32; 7];

/// Returns a bit's weight sets, by the byte's `beginning` and the number of inputs with experience.
#[inline(always)]
pub fn sets(reader: &Reader, beginning: u32, experienced: u32) -> Sets {
    let kind = reader.feature(KIND);
    let of_kind = kind << 8;
    let by_opcode = (KINDS as u32 + MORE_KINDS) << 8;
    [
        of_kind | beginning,
        of_kind,
        (KINDS as u32) << 8 | of_kind | reader.feature(0),
        MORE_KINDS << 8 | kind << 5 | experienced,
        (MORE_KINDS + 3) << 8 | reader.feature(1) << 2 | kind & 3,
        by_opcode | reader.feature(OPCODE) & 0x7ff,
        by_opcode | ((reader.feature(before(OPCODE, 1)) * 5) ^ (kind << 7)) & 0x7ff,
    ]
}
