use super::{STEP, voice::Mix};
use glam::{Vec4, Vec4Swizzles, vec4};

/// The echo's ring buffer in samples: above [`DELAY`], and a power of two for fast remainders.
const ECHO: usize = 1 << 15;

/// The echo's delay in samples: three sixteenths, between the beats.
const DELAY: usize = 3 * STEP as usize;

const FEEDBACK: f32 = 0.5;

/// The delays in samples of allpass filters before the reverberation, 2 to 14 ms, which multiply
/// its echoes.
const DIFFUSERS: [usize; 3] = [113, 307, 677];

/// The allpass filters' ring buffers in samples, above the longest of [`DIFFUSERS`].
const DIFFUSION: usize = 1 << 10;

/// The allpass filters' feedback.
const DENSITY: f32 = 0.6;

/// The reverberation's ring buffers in samples, above the longest of [`LENGTHS`].
const ROOM: usize = 1 << 12;

/// The reverberation's delays in samples, 30 to 83 ms: primes, whose echoes rarely coincide.
const LENGTHS: [usize; 6] = [1433, 1801, 2269, 2749, 3323, 4001];

/// The feedback of the delays. With 54 ms per round on average, the sound falls by 60 dB in 2.5 s.
const DECAY: f32 = 0.86;

/// The coefficient of the one-pole low pass in each delay: 5 kHz.
const WALL: f32 = 0.5;

const LEFT: Vec4 = vec4(0.5, 0.0, 0.5, 0.0);
const RIGHT: Vec4 = vec4(0.0, 0.5, 0.0, 0.5);

/// Echo, and reverberation from a feedback delay network. Silence is all zeros. [`Mix`] explains
/// the lanes.
pub(super) struct Space {
    echo: [Vec4; ECHO],
    diffusion: [[Vec4; DIFFUSERS.len()]; DIFFUSION],
    room: [[Vec4; LENGTHS.len()]; ROOM],
    walls: [Vec4; LENGTHS.len()],
}

impl Space {
    pub const ZERO: Space = Space {
        echo: [Vec4::ZERO; ECHO],
        diffusion: [[Vec4::ZERO; DIFFUSERS.len()]; DIFFUSION],
        room: [[Vec4::ZERO; LENGTHS.len()]; ROOM],
        walls: [Vec4::ZERO; LENGTHS.len()],
    };

    pub fn play(&mut self, position: usize, mix: &Mix) -> Vec4 {
        // Echoes alternate between left and right.
        let echo = self.echo[(position + ECHO - DELAY) % ECHO];
        self.echo[position % ECHO] = mix.echo + echo.yxwz() * FEEDBACK;
        let (mut taps, mut difference, mut sign) = (Vec4::ZERO, Vec4::ZERO, Vec4::ONE);
        for (line, &length) in LENGTHS.iter().enumerate() {
            let tap = self.room[(position + ROOM - length) % ROOM][line];
            taps += tap;
            difference += tap * sign;
            sign = -sign;
        }
        // A Householder reflection mixes all delays and preserves the energy. Rotating the lanes
        // spreads the sound between left and right.
        let reflected = taps * (-2.0 / LENGTHS.len() as f32);
        let mut sent = mix.room + echo * 0.5;
        for (line, &length) in DIFFUSERS.iter().enumerate() {
            let tap = self.diffusion[(position + DIFFUSION - length) % DIFFUSION][line];
            let fed = sent + tap * DENSITY;
            self.diffusion[position % DIFFUSION][line] = fed;
            sent = tap - fed * DENSITY;
        }
        for (line, &length) in LENGTHS.iter().enumerate() {
            let tap = self.room[(position + ROOM - length) % ROOM][line];
            let wall = &mut self.walls[line];
            *wall += (sent + (tap + reflected) * DECAY - *wall) * WALL;
            self.room[position % ROOM][line] = wall.yzwx();
        }
        // Alternate signs on the right make left and right independent.
        mix.dry + echo + taps * LEFT + difference * RIGHT
    }
}
