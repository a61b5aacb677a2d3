use super::instruments::INSTRUMENTS;
use super::song::{self, Track};
use super::space::Space;
use super::voice::{Mix, Mood, Voice};
use super::{CHUNK, SONG_LENGTH, STEP, STEPS_PER_BAR};
use glam::{Vec4, Vec4Swizzles};

/// The delay of every other sixteenth, in chunks: a slight swing.
const SWING: u32 = 8;

/// The share of the difference to the bar's brightness that each chunk adds: 63 % in a second.
const BRIGHTENING: f32 = 0.001;

/// The share of the difference to the bar's amplification that each chunk adds: 63 % in 25 ms.
const SWELLING: f32 = 0.04;

/// The ratio of amplitudes for 1 dB, the sixth root of 2.
const DECIBEL: f32 = 1.122_462;

/// The deviation of the notes' amplitudes, as players have it: up to 1 dB.
const DYNAMICS: f32 = 0.12;

/// The end of the last note, in samples: 60 ms after its start, a beat before the end.
const END: u32 = SONG_LENGTH - 4 * STEP + 60 * CHUNK as u32;

/// The maximum sample: -1.7 dB of full scale.
const CEILING: f32 = 0.82;

/// A synthesizer of the song, with 1 MB of memory, initially zero.
pub struct Synthesizer {
    mood: Mood,
    gain: f32,
    /// The last sample's noise.
    noise: Vec4,
    /// A running mean, subtracted to remove the DC offset.
    mean: Vec4,
    /// Of the next chunk, in samples.
    position: u32,
    step: u32,
    wait: u32,
    seed: i32,
    /// Samples in `chunk` that [`Synthesizer::play`] has returned.
    taken: usize,
    chunk: [[f32; 2]; CHUNK],
    voices: [Voice; song::TRACKS],
    mixes: [Mix; CHUNK],
    space: Space,
}

impl Synthesizer {
    /// Creates a synthesizer at the start of the song.
    #[must_use]
    pub const fn new() -> Self {
        Self {
            voices: [Voice::ZERO; _],
            mood: Mood { kick: Vec4::ZERO, next_kick: Vec4::ZERO, light: Vec4::ZERO, rest: false },
            gain: 0.0,
            noise: Vec4::ZERO,
            mixes: [Mix::SILENCE; CHUNK],
            space: Space::ZERO,
            mean: Vec4::ZERO,
            seed: 0,
            position: 0,
            step: 0,
            wait: 0,
            chunk: [[0.0; 2]; CHUNK],
            taken: 0,
        }
    }

    /// Writes the next samples, left and right, each below -1 dB of full scale. The song repeats.
    pub fn play(&mut self, samples: &mut [[f32; 2]]) {
        for sample in samples {
            if self.taken == 0 {
                self.chunk();
            }
            *sample = self.chunk[self.taken];
            self.taken = (self.taken + 1) % CHUNK;
        }
    }

    /// Moves to a position in samples. This synthesizes the song up to there, a few milliseconds
    /// per second of sound.
    pub fn seek(&mut self, position: u32) {
        *self = const { Self::new() };
        for _ in 0..position % SONG_LENGTH {
            self.play(&mut [[0.0; 2]]);
        }
    }

    /// Returns the next millisecond, faster than [`Synthesizer::play`]. The song repeats.
    pub fn chunk(&mut self) -> &[[f32; 2]] {
        if self.position == SONG_LENGTH {
            *self = const { Self::new() };
        }
        self.follow();
        for (voice, instrument) in self.voices.iter_mut().zip(&INSTRUMENTS) {
            voice.play(instrument, &self.mood, &mut self.mixes);
        }
        for (mix, sample) in self.mixes.iter_mut().zip(&mut self.chunk) {
            let heard = self.space.play(self.position as usize, mix);
            self.position += 1;
            *mix = Mix::SILENCE;
            let noise = Vec4::from_array([0; 4].map(|_| random(&mut self.seed)));
            // A mean of two, without the highest treble.
            mix.noise = noise + self.noise;
            self.noise = noise;
            self.mean += (heard - self.mean) * 0.001;
            let heard = heard - self.mean;
            *sample = limit((heard + heard.zwxy()) * self.gain);
        }
        &self.chunk
    }

    fn follow(&mut self) {
        const CHUNKS: u32 = STEP / CHUNK as u32;
        /// The factor on the kick's level in each chunk: it halves in 50 ms.
        const FADE: f32 = 0.986;
        let mood = &mut self.mood;
        const BAR: u32 = STEP * STEPS_PER_BAR;
        let bar = self.position / BAR;
        let (light, gain) = song::mood(bar);
        mood.light += (light - mood.light) * BRIGHTENING;
        let is_over = self.position >= END;
        let gain = if is_over { 0.0 } else { (0..gain).fold(0.25, |gain, _| gain * DECIBEL) };
        self.gain += (gain - self.gain) * SWELLING;
        mood.rest = song::is_last(bar) && self.position % BAR >= BAR - 2 * STEP;
        mood.kick = mood.next_kick;
        mood.next_kick *= FADE;
        if self.wait == 0 {
            for (track, voice) in self.voices.iter_mut().enumerate() {
                let digit = song::digit(track, self.step);
                if digit > 0 {
                    let amplitude = 1.0 + DYNAMICS * random(&mut self.seed);
                    voice.start(&INSTRUMENTS[track], digit, bar, amplitude);
                    if track == Track::Kick as usize {
                        mood.next_kick = Vec4::ONE;
                    }
                }
            }
            self.step += 1;
            self.wait = if self.step % 2 == 1 { CHUNKS + SWING } else { CHUNKS - SWING };
        }
        self.wait -= 1;
    }
}

impl Default for Synthesizer {
    fn default() -> Self {
        Self::new()
    }
}

/// Returns a pseudorandom number from -1 to 1, by the linear congruential generator of Knuth and
/// Lewis ("Numerical Recipes").
fn random(seed: &mut i32) -> f32 {
    *seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
    *seed as f32 / (1_u32 << 31) as f32
}

/// Limits left and right, the first two lanes, to [`CEILING`]; quiet sounds pass unchanged.
fn limit(heard: Vec4) -> [f32; 2] {
    // x - x^3 / (3 top^2) rises to 2/3 of the top, with slope 0 there.
    const TOP: f32 = 1.5 * CEILING;
    let x = heard.clamp(Vec4::splat(-TOP), Vec4::splat(TOP));
    let y = x - x * x * x * (1.0 / (3.0 * TOP * TOP));
    [y.x, y.y]
}
