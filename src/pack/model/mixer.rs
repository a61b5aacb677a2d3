//! Makes one probability of many, by a neuron that learns which of them to trust (logistic mixing).

use super::{lanes::Lanes, machine_code::KINDS};

/// Rows of inputs.
pub const ROWS: usize = 3;

/// A weight for each input, in 65,536ths.
type Weights = [Lanes; ROWS];

/// What the sum of two weights is to begin with: all 24 inputs together are believed half of what they say.
const FIRST_WEIGHT: i16 = 1400;

const SETS: usize = KINDS << 8;

/// For the number of a set, which is 256 times the kind of byte plus how it begins.
const OWN: usize = SETS - 1;
/// For the number of the set of all beginnings.
const ALL: usize = OWN & !0xff;

/// How fast weights are learned: of 2, 3, 4, 6 and 8 the best.
const RATE: i32 = 6;

/// The numbers of probabilities and of logits in tables.
const STEPS: usize = 4096;

/// The mixer's memory. A probability is in 65,536ths; its logit, ln(p / (1 - p)), in 256ths, from -2048 to 2047.
#[repr(C)]
pub struct Mixer {
    /// The logits of what is mixed.
    inputs: [[i16; 8]; ROWS],
    /// What was predicted last.
    probability: i32,
    /// The probability of each logit.
    probabilities: [i32; STEPS],
    /// The logit of each probability, in steps of 16.
    logits: [i16; STEPS],
    /// For each kind of byte and each beginning of it a set; that of beginning 0, which no byte has, is for all of that kind.
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
                self.logits[next as usize & (STEPS - 1)] = x as i16 - 2048;
                next += 1;
            }
            p += (p * ((1 << 32) - p)) >> 40;
        }
    }

    /// Says to the mixer what is to be mixed: pairs of probabilities.
    #[inline(always)]
    pub fn input(&mut self, pairs: impl Iterator<Item = (u32, u32)>) {
        let logit = |probability: u32| self.logits[probability as usize >> 4 & (STEPS - 1)];
        let inputs = self.inputs.as_flattened_mut().as_chunks_mut().0;
        for (input, (first, second)) in inputs.iter_mut().zip(pairs) {
            // By two writes: `map` would put both to another place and then read them, for which the processor waits.
            let [one, other] = input;
            *one = logit(first);
            *other = logit(second);
        }
    }

    /// How likely the next bit is 1, by a set of weights.
    #[inline(always)]
    pub fn predict(&mut self, set: usize) -> u32 {
        let (own, all) = (&self.weights[set & OWN], &self.weights[set & ALL]);
        let mut sum = Lanes::splat(0);
        for ((inputs, own), all) in self.inputs.iter().zip(own).zip(all) {
            let weights = own
                .saturating_add(*all)
                .saturating_add(Lanes::splat(FIRST_WEIGHT));
            sum = sum.add_products(weights, Lanes::new(inputs));
        }
        let logit = (sum.sum() >> 14).clamp(-2048, 2047) + 2048;
        self.probability = self.probabilities[logit as usize & (STEPS - 1)];
        self.probability as u32
    }

    /// Corrects the weights of the last prediction by what the bit was.
    #[inline(always)]
    pub fn learn(&mut self, mut set: usize, bit: u32) {
        let error = ((bit as i32) << 16) - self.probability;
        let error = Lanes::splat(((error * RATE) >> 5) as i16);
        loop {
            for (weight, inputs) in self.weights[set & OWN].iter_mut().zip(&self.inputs) {
                let inputs = Lanes::new(inputs);
                let change = inputs.saturating_add(inputs).multiply_high(error);
                let change = change.saturating_add(Lanes::splat(1)).halve();
                *weight = weight.saturating_add(change);
            }
            if set == set & ALL {
                return;
            }
            set &= ALL;
        }
    }
}
