//! Time by what is heard.

/// Turns the time of a clock into the time of the sound: smooth, never backwards, and never far from what is heard.
///
/// A device says every few milliseconds how far it has come, in steps and a little late or early; and its quartz is not
/// the clock's. So the time goes on by the clock, and is pulled to what the device says, in a quarter of a second at 60
/// frames a second. When the device has run out of samples, the time waits for it. So it does when the process has been
/// stopped and goes on, which the clock did not wait for: samples that were never given to the device are not counted as heard.
#[derive(Default)]
pub struct Heard {
    /// How far the time is ahead of the clock, in nanoseconds.
    ahead: i64,
    /// The time of the clock at the last frame.
    clock: i64,
    /// The time that was given for it.
    time: i64,
}

/// The number by which a difference is divided for each frame.
const PULL: i64 = 16;

/// The least difference that is no step of the device's but sound that was lost: 50 ms.
const LOST: u64 = 50_000_000;

/// How far the time goes on at most from one frame to the next without any sound, as on a device that hangs: 50 ms, so that
/// it goes on by the clock at 20 frames a second or more.
const MAX_UNHEARD: i64 = 50_000_000;

impl Heard {
    /// The time of the sound at a time of the clock, where the device was so far ahead of the clock when it was last
    /// asked, and sound has been given to it up to the time `written`. All in nanoseconds.
    pub fn time(&mut self, clock: i64, ahead: i64, written: i64) -> u64 {
        let step = ahead - self.ahead;
        let pull = if step.unsigned_abs() > LOST { 1 } else { PULL };
        self.ahead += step / pull;
        let unheard = (clock - self.clock).min(MAX_UNHEARD);
        let latest = written.max(self.time + unheard);
        self.clock = clock;
        self.time = self.time.max(latest.min(clock + self.ahead));
        self.time as u64
    }
}
