//! Echo and room.

use super::{STEP, voice::Sum};
use glam::{Vec4, Vec4Swizzles};

/// Samples that the echo remembers: a power of two above [`DELAY`].
const ECHO: usize = 1 << 15;

/// Samples until the echo: three sixteenths, so that it falls between the beats.
const DELAY: usize = 3 * STEP as usize;

/// How much of an echo is in the next one.
const FEEDBACK: f32 = 0.5;

/// Samples that the room remembers: a power of two above the longest of [`LENGTHS`].
const ROOM: usize = 1 << 12;

/// Samples of the room's delays, 30 to 83 ms: primes, so that their echoes hardly ever meet.
const LENGTHS: [u16; 6] = [1433, 1801, 2269, 2749, 3323, 4001];

/// What goes round in the room once more: at 54 ms a round, 2.5 s to -60 dB.
const DECAY: f32 = 0.86;

/// How much of a sound passes a wall at once: a low pass at 5 kHz.
const WALL: f32 = 0.5;

/// Echo and room. At rest, all of it is zero.
pub(super) struct Space {
    echo: [Vec4; ECHO],
    room: [[Vec4; LENGTHS.len()]; ROOM],
    walls: [Vec4; LENGTHS.len()],
}

impl Space {
    pub const ZERO: Space = Space {
        echo: [Vec4::ZERO; ECHO],
        room: [[Vec4::ZERO; LENGTHS.len()]; ROOM],
        walls: [Vec4::ZERO; LENGTHS.len()],
    };

    /// Everything that is heard of a sample, the one at a position.
    #[inline(never)]
    pub fn play(&mut self, position: usize, sum: &Sum) -> Vec4 {
        // Each echo comes from the other side.
        let echo = self.echo[position.wrapping_sub(DELAY) % ECHO];
        self.echo[position % ECHO] = sum.echo.get() + echo.yxwz() * FEEDBACK;
        let mut taps = Vec4::ZERO;
        for (line, &length) in LENGTHS.iter().enumerate() {
            taps += self.room[position.wrapping_sub(usize::from(length)) % ROOM][line];
        }
        // A reflection in the diagonal of all delays mixes each with each and keeps the energy; the lanes
        // take turns.
        let reflected = taps * (-2.0 / LENGTHS.len() as f32);
        let sent = sum.room.get() + echo * 0.5;
        for (line, &length) in LENGTHS.iter().enumerate() {
            let tap = self.room[position.wrapping_sub(usize::from(length)) % ROOM][line];
            let wall = &mut self.walls[line];
            *wall += (sent + (tap + reflected) * DECAY - *wall) * WALL;
            self.room[position % ROOM][line] = wall.yzwx();
        }
        sum.dry.get() + echo + taps * 0.5
    }
}
