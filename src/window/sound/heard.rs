//! Time by what is heard.

/// Turns the time of a clock into the time of the sound: smooth, never backwards, and never far from what is heard.
///
/// A device says every few milliseconds how far it has come, in steps and a little late or early; and its quartz is not
/// the clock's. So the time goes on by the clock, and is pulled to what the device says, in a quarter of a second at 60
/// frames a second.
#[derive(Default)]
pub struct Heard {
    /// How far the time is ahead of the clock, in nanoseconds.
    ahead: i64,
    /// The last time that was given.
    time: i64,
}

/// What a difference is divided by for each frame.
const PULL: i64 = 16;

impl Heard {
    /// The time of the sound at a time of the clock, where the device was so far ahead of the clock when it was last
    /// asked. All in nanoseconds.
    pub fn time(&mut self, clock: u64, ahead: i64) -> u64 {
        self.ahead += (ahead - self.ahead) / PULL;
        self.time = self.time.max(clock as i64 + self.ahead);
        self.time as u64
    }
}
