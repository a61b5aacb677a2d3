//! Makes one probability of many, by a neuron that learns which of them to trust (logistic mixing).

use super::{
    lanes::Lanes,
    machine_code::{KINDS, MORE_KINDS},
};

/// Rows of inputs.
pub const ROWS: usize = 3;

/// A weight for each input, in 65,536ths.
type Weights = [Lanes; ROWS];

/// The sum of two weights at the beginning: all 24 inputs together are believed three eighths of what they say.
const FIRST_WEIGHT: i16 = 1000;

/// Sets of weights: for each kind of byte and each beginning of it; that of beginning 0, which no byte has, is for all of that kind;
/// for each kind of byte and each byte before it; and, in place of kinds that there are not, for each kind and each number of inputs
/// that have seen anything.
const SETS: usize = (2 * KINDS) << 8;

/// The highest logit of a pair that is believed, in 256ths: a probability of 94 %. With none, the
/// intro takes 120 bytes more. Contexts may be as sure as they like.
const PAIR_LIMIT: i16 = 700;

/// How fast weights are learned.
const RATE: i32 = 18;

/// The numbers of probabilities and of logits in tables.
const STEPS: usize = 4096;

/// The mixer's memory. A probability is in 65,536ths; its logit, ln(p / (1 - p)), in 256ths, from -2048 to 2047.
#[repr(C)]
pub struct Mixer {
    /// The logits of what is mixed; those of pairs fill the last row.
    inputs: [[i16; 8]; ROWS],
    /// The last prediction.
    probability: i32,
    /// The probability of each logit.
    probabilities: [i32; STEPS],
    /// The logit of each probability, in steps of 16; those from one half on come first, as slots have them.
    logits: [i16; STEPS],
    /// [`FIRST_WEIGHT`] is left out.
    weights: [Weights; SETS],
}

impl Mixer {
    /// Fills memory that is zero.
    #[inline(always)]
    pub fn fill(&mut self) {
        // The logistic function solves p' = p (1 - p). From p(-8) on, in 2^-32nds, by steps of 1/256.
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

    /// Says to the mixer what is to be mixed: a probability less one half, as the 16 bits of a signed number.
    #[inline(always)]
    pub fn input(&mut self, index: usize, probability: u16) {
        self.inputs.as_flattened_mut()[index] = self.logits[usize::from(probability >> 4)];
    }

    /// How likely the next bit is 1, by the sum of some sets of weights.
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

    /// Corrects the weights of the last prediction by what the bit was.
    #[inline(always)]
    pub fn learn(&mut self, sets: &Sets, bit: u32) {
        let error = ((bit as i32) << 16) - self.probability;
        let error = Lanes::splat(((error * RATE) >> 8) as i16);
        for &set in sets {
            for (weight, inputs) in self.weights[set as usize % SETS]
                .iter_mut()
                .zip(&self.inputs)
            {
                let inputs = Lanes::new(inputs);
                let change = inputs.saturating_add(inputs).multiply_high(error);
                let change = change.saturating_add(Lanes::splat(1)).halve();
                *weight = weight.saturating_add(change);
            }
        }
    }
}

/// The sets whose weights are added for a bit.
pub type Sets = [u32; 4];

/// The sets for a bit of such a byte that begins like this, behind that byte, by so many inputs that have seen anything.
#[inline(always)]
pub fn sets(kind: u32, beginning: u32, before: u32, seen: u32) -> Sets {
    let of_kind = kind << 8;
    [
        of_kind | beginning,
        of_kind,
        (KINDS as u32) << 8 | of_kind | before,
        MORE_KINDS << 8 | kind << 5 | seen,
    ]
}
