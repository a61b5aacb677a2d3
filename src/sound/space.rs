//! Echo and room.

use super::{STEP, voice::Sum};
use glam::{Vec4, Vec4Swizzles};

/// Samples that the echo remembers: a ring, longer than [`DELAY`]; a power of two, by which places are cheaply had.
const ECHO: usize = 1 << 15;

/// Samples until the echo: three sixteenths, so that it falls between the beats.
const DELAY: usize = 3 * STEP as usize;

/// How much of an echo is in the next one.
const FEEDBACK: f32 = 0.5;

/// Samples that the room remembers: a ring, longer than the longest of [`LENGTHS`].
const ROOM: usize = 1 << 12;

/// Samples of the room's delays, 30 to 83 ms: primes, so that their echoes hardly ever meet.
const LENGTHS: [usize; 6] = [1433, 1801, 2269, 2749, 3323, 4001];

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
    pub fn play(&mut self, position: usize, sum: &Sum) -> Vec4 {
        // Each echo comes from the other side.
        let echo = self.echo[(position + ECHO - DELAY) % ECHO];
        self.echo[position % ECHO] = sum.echo + echo.yxwz() * FEEDBACK;
        let mut taps = Vec4::ZERO;
        for (line, &length) in LENGTHS.iter().enumerate() {
            taps += self.room[(position + ROOM - length) % ROOM][line];
        }
        // A reflection in the diagonal of all delays mixes each with each and keeps the energy; the lanes
        // take turns.
        let reflected = taps * (-2.0 / LENGTHS.len() as f32);
        let sent = sum.room + echo * 0.5;
        for (line, &length) in LENGTHS.iter().enumerate() {
            let tap = self.room[(position + ROOM - length) % ROOM][line];
            let wall = &mut self.walls[line];
            *wall += (sent + (tap + reflected) * DECAY - *wall) * WALL;
            self.room[position % ROOM][line] = wall.yzwx();
        }
        sum.dry + echo + taps * 0.5
    }
}
