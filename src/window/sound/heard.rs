/// Converts a clock's time to the sound's time: smooth, monotonic, close to the audible sound.
///
/// A device reports its position in steps, with jitter, on its own quartz, so the time is pulled to
/// it within a quarter of a second.
#[derive(Default)]
pub struct Heard {
    /// The time's lead over the clock, in nanoseconds.
    ahead: i64,
    clock: i64,
    time: i64,
}

/// Each frame corrects 1 / `PULL` of a difference.
const PULL: i64 = 16;

/// The least difference that means lost sound rather than jitter: 50 ms.
const LOST: u64 = 50_000_000;

/// The maximum progress of a frame without sound, as on a device that hangs: 50 ms, so 20 fps keep
/// the clock's pace.
const MAX_UNHEARD: i64 = 50_000_000;

impl Heard {
    /// Returns the sound's time at the time `clock`. `ahead` is the device's lead over the clock,
    /// `written` the end of the written sound. All are in nanoseconds.
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
