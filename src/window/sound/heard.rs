//! Time by what is heard.

/// Turns the time of a clock into the time of the sound: smooth, never backwards, and never far from what is heard.
///
/// A device says every few milliseconds how far it has come, in steps and a little late or early; and its quartz is not
/// the clock's. So the time goes on by the clock, and is pulled to what the device says, in a quarter of a second at 60
/// frames a second. When the device has run out of samples, the time waits for it.
#[derive(Default)]
pub struct Heard {
    /// How far the time is ahead of the clock, in nanoseconds.
    ahead: i64,
    /// The last time that was given.
    time: i64,
}

/// What a difference is divided by for each frame.
const PULL: i64 = 16;

/// The least difference that is no step of the device's but sound that was lost: 50 ms.
const LOST: u64 = 50_000_000;

impl Heard {
    /// The time of the sound at a time of the clock, where the device was so far ahead of the clock when it was last
    /// asked. All in nanoseconds.
    pub fn time(&mut self, clock: u64, ahead: i64) -> u64 {
        let step = ahead - self.ahead;
        let pull = if step.unsigned_abs() > LOST { 1 } else { PULL };
        self.ahead += step / pull;
        self.time = self.time.max(clock as i64 + self.ahead);
        self.time as u64
    }
}
