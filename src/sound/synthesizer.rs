//! The synthesizer: plays the song, block by block.

use super::instruments::INSTRUMENTS;
use super::space::Space;
use super::voice::{Mood, Sum, Voice};
use super::{LENGTH, STEP, STEPS_PER_BAR, song};
use glam::{Vec4, Vec4Swizzles};

/// Samples that are made at once, a millisecond: what changes slowly changes this often.
pub(super) const BLOCK: usize = 48;

/// How late every other sixteenth comes, in blocks: a little swing.
const SWING: u32 = 8;

/// How much of the way to a bar's brightness it goes in a block: in a second, two thirds.
const DAWN: f32 = 0.001;

/// No sample is louder: -1.3 dB of full scale.
const CEILING: f32 = 0.86;

/// Plays the song.
///
/// 1 MB of fixed size, all zero at first, which belongs to the caller.
pub struct Synthesizer {
    mood: Mood,
    /// The mean of what is heard, which is taken off it.
    mean: Vec4,
    /// Where the next block begins.
    position: u32,
    /// The next step, and blocks until it comes.
    step: u32,
    wait: u32,
    /// The last number of the noise.
    seed: i32,
    /// How much of the block has been taken.
    taken: usize,
    block: [[f32; 2]; BLOCK],
    voices: [Voice; song::TRACKS],
    sums: [Sum; BLOCK],
    space: Space,
}

impl Synthesizer {
    /// A synthesizer at the start of the song.
    #[must_use]
    pub const fn new() -> Self {
        Self {
            voices: [Voice::ZERO; _],
            mood: Mood {
                kick: Vec4::ZERO,
                next_kick: Vec4::ZERO,
                light: Vec4::ZERO,
            },
            sums: [Sum::SILENCE; BLOCK],
            space: Space::ZERO,
            mean: Vec4::ZERO,
            seed: 0,
            position: 0,
            step: 0,
            wait: 0,
            block: [[0.0; 2]; BLOCK],
            taken: 0,
        }
    }

    /// The next samples, left and right, each at most -1 dB of full scale. After the song's end comes its start.
    pub fn play(&mut self, samples: &mut [[f32; 2]]) {
        for sample in samples {
            if self.taken == 0 {
                self.block();
            }
            *sample = self.block[self.taken];
            self.taken = (self.taken + 1) % BLOCK;
        }
    }

    /// Goes to a sample of the song, counted from its start.
    ///
    /// What is heard there depends on all that was before, so it is played, unheard: a second of it takes some
    /// milliseconds.
    pub fn seek(&mut self, position: u32) {
        *self = const { Self::new() };
        for _ in 0..position % LENGTH {
            self.play(&mut [[0.0; 2]]);
        }
    }

    /// The next millisecond, instead of [`Self::play`]. After the song's end comes its start.
    pub fn block(&mut self) -> &[[f32; 2]] {
        if self.position == LENGTH {
            *self = const { Self::new() };
        }
        self.follow();
        for (voice, instrument) in self.voices.iter_mut().zip(&INSTRUMENTS) {
            voice.play(instrument, &self.mood, &mut self.sums);
        }
        for (sum, sample) in self.sums.iter_mut().zip(&mut self.block) {
            let heard = self.space.play(self.position as usize, sum);
            self.position += 1;
            *sum = Sum::SILENCE;
            for noise in &mut sum.noise {
                *noise = random(&mut self.seed);
            }
            self.mean += (heard - self.mean) * 0.001;
            let heard = heard - self.mean;
            *sample = bend(heard + heard.zwxy());
        }
        &self.block
    }

    /// Begins the notes and the mood of the next block.
    fn follow(&mut self) {
        /// Blocks of a step.
        const BLOCKS: u32 = STEP / BLOCK as u32;
        /// How much of a kick is left after a block: half after 50 of them.
        const FADE: f32 = 0.986;
        let mood = &mut self.mood;
        let (light, chord) = song::mood(self.position / (STEP * STEPS_PER_BAR));
        mood.light += (light - mood.light) * DAWN;
        mood.kick = mood.next_kick;
        mood.next_kick *= FADE;
        if self.wait == 0 {
            for (track, voice) in self.voices.iter_mut().enumerate() {
                let digit = song::step(track, self.step);
                if digit > 0 {
                    voice.begin(&INSTRUMENTS[track], digit, chord);
                    if track == song::KICK {
                        mood.next_kick = Vec4::ONE;
                    }
                }
            }
            self.step += 1;
            self.wait = if self.step % 2 == 1 {
                BLOCKS + SWING
            } else {
                BLOCKS - SWING
            };
        }
        self.wait -= 1;
    }
}

impl Default for Synthesizer {
    fn default() -> Self {
        Self::new()
    }
}

/// A number from -1 to 1 that looks random, by the generator of Knuth and Lewis ("Numerical Recipes").
fn random(seed: &mut i32) -> f32 {
    *seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
    *seed as f32 / (1_u32 << 31) as f32
}

/// Bends left and right, the first two lanes, into range: what is quiet stays as it is, nothing gets above the ceiling.
fn bend(heard: Vec4) -> [f32; 2] {
    // x - x^3 / (3 top^2) goes up to 2/3 of the top, where it is level.
    const TOP: f32 = 1.5 * CEILING;
    let x = heard.clamp(Vec4::splat(-TOP), Vec4::splat(TOP));
    let y = x - x * x * x * (1.0 / (3.0 * TOP * TOP));
    [y.x, y.y]
}
