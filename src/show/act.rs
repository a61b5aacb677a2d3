//! A scene of the show as a record: its set, its shots and its captions.
//!
//! "Scene" alone is what one frame shows, [`eightfold_tracer::scene::Scene`]; in the code a scene of the show is an act.

use super::captions::Line;
use super::path::Key;
use super::set::Set;

/// A scene of the show.
#[derive(Clone, Copy)]
pub(super) struct Act {
    /// Where it is filmed.
    pub set: &'static Set,
    /// The bars for which the act before it was filmed on the same set, whose movements go on; 0 on a set of its own.
    pub set_since: u32,
    /// Its shots, one after another.
    pub shots: &'static [Shot],
    /// Its captions.
    pub captions: &'static [Line],
}

/// One uninterrupted movement of the camera.
pub(super) struct Shot {
    /// Its length in bars.
    pub bars: u8,
    /// The keys that the camera passes through, at equal distances in time, from the start to the end; two at least.
    pub keys: &'static [Key],
}

impl Act {
    /// One without captions, on a set of its own.
    pub const fn new(set: &'static Set, shots: &'static [Shot]) -> Act {
        Act {
            set,
            set_since: 0,
            shots,
            captions: &[],
        }
    }

    /// Its length in bars: that of its shots.
    pub const fn bars(&self) -> u32 {
        let (mut bars, mut i) = (0, 0);
        while i < self.shots.len() {
            bars += self.shots[i].bars as u32;
            i += 1;
        }
        bars
    }
}

/// A shot of so many bars, through several keys.
pub(super) const fn shot(bars: u8, keys: &'static [Key]) -> Shot {
    Shot { bars, keys }
}
