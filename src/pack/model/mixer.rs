//! Makes one probability of many, by a neuron that learns which of them to trust (logistic mixing).

use super::{lanes::Lanes, machine_code::KINDS};

/// Rows of inputs.
pub const ROWS: usize = 3;

/// A weight for each input, in 65,536ths.
type Weights = [Lanes; ROWS];

/// What every weight is to begin with. Two sets are added up, so that all 24 inputs together are believed half of what they say.
const FIRST_WEIGHT: i16 = 700;

/// How fast weights are learned: of 2, 3, 4, 6 and 8 the best.
const RATE: i32 = 6;

/// The numbers of probabilities and of logits in tables.
const STEPS: usize = 4096;

/// The mixer's memory. A probability is in 65,536ths; its logit, ln(p / (1 - p)), in 256ths, from -2048 to 2047.
pub struct Mixer {
    /// The probability of each logit.
    probabilities: [i32; STEPS],
    /// The logit of each probability, in steps of 16.
    logits: [i16; STEPS],
    inputs: [[i16; 8]; ROWS],
    /// For each kind of byte and each beginning of it a set; that of beginning 0, which no byte has, is for all of that kind.
    weights: [[Weights; 256]; KINDS],
    /// What was predicted last.
    probability: i32,
}

impl Mixer {
    /// Fills memory that is zero.
    #[inline(always)]
    pub fn fill(&mut self) {
        // The logistic function solves p' = p (1 - p). From p(-8) on, in 2^-32nds, by steps of 1/256.
        let mut p = 1_440_000_u64;
        let mut first = 0;
        for (x, probability) in self.probabilities.iter_mut().enumerate() {
            *probability = (p >> 16) as i32;
            let end = (p >> 20) as usize + 1;
            for logit in self.logits.get_mut(first..end).unwrap_or_default() {
                *logit = x as i16 - 2048;
            }
            first = end;
            p += (p * ((1 << 32) - p)) >> 40;
        }
        for weights in self.weights.as_flattened_mut() {
            *weights = [Lanes::splat(FIRST_WEIGHT); ROWS];
        }
    }

    /// Says to the mixer what one of its inputs predicts.
    #[inline(always)]
    pub fn input(&mut self, number: usize, probability: u32) {
        let logit = self.logits[probability as usize >> 4 & (STEPS - 1)];
        if let Some(input) = self.inputs.as_flattened_mut().get_mut(number) {
            *input = logit;
        }
    }

    /// How likely the next bit is 1, if the byte is of this kind and begins with these bits behind a 1.
    #[inline(always)]
    pub fn predict(&mut self, (kind, beginning): (usize, usize)) -> u32 {
        let Some(sets) = self.weights.get(kind) else {
            return 0;
        };
        let (own, all) = (&sets[beginning & 255], &sets[0]);
        let inputs = self.inputs.each_ref().map(Lanes::new);
        let mut weights = *own;
        for (weight, other) in weights.iter_mut().zip(all) {
            *weight = weight.saturating_add(*other);
        }
        let logit = (Lanes::dot(weights, inputs) >> 14).clamp(-2048, 2047) + 2048;
        self.probability = self.probabilities[logit as usize & (STEPS - 1)];
        self.probability as u32
    }

    /// Corrects the weights of the last prediction by what the bit was.
    #[inline(always)]
    pub fn learn(&mut self, (kind, beginning): (usize, usize), bit: u32) {
        let error = ((bit as i32) << 16) - self.probability;
        let error = Lanes::splat(((error * RATE) >> 5) as i16);
        let Some(sets) = self.weights.get_mut(kind) else {
            return;
        };
        for (row, inputs) in self.inputs.iter().enumerate() {
            let inputs = Lanes::new(inputs);
            let change = inputs.saturating_add(inputs).multiply_high(error);
            let change = change.saturating_add(Lanes::splat(1)).halve();
            sets[0][row] = sets[0][row].saturating_add(change);
            sets[beginning & 255][row] = sets[beginning & 255][row].saturating_add(change);
        }
    }
}
