//! Picture and sound stay together on a simulated device whose clock deviates and which underruns.

use super::super::heard::Heard;
use super::*;

/// The buffer in samples (400 ms), the samples that the device takes at once, and the steps of its
/// reported position (5 ms).
const ROOM: u64 = 19_200;
const PERIOD: u64 = 4800;
const STEP: u64 = 240;

const CHUNK: u64 = 48;
const LENGTH: u64 = 96 * SECOND;

/// The time of an event: the writer is late, or the process is stopped.
const EVENT: u64 = 30 * SECOND;
const LATE: u64 = 7 * SECOND / 10;
const STOP: u64 = 3 * SECOND / 2;

/// The maximum distance between picture and sound.
const DRIFT: u64 = SECOND / 50;

struct Device {
    /// Samples in a million seconds.
    rate: u64,
    start: Option<u64>,
    /// Samples since the start, and before it.
    written: u64,
    dropped: u64,
}

impl Device {
    fn due(&self, now: u64) -> u64 {
        let since = |start| u128::from(now - start) * u128::from(self.rate) / 1_000_000_000_000_000;
        self.start.map_or(0, |start| since(start) as u64)
    }

    /// Writes a chunk. Returns the time at which the next one has room.
    fn write(&mut self, now: u64) -> u64 {
        if self.due(now) > self.written {
            // The chunk is lost, like the samples that nobody wrote.
            *self = Self {
                start: None,
                written: 0,
                dropped: self.dropped + self.written + CHUNK,
                ..*self
            };
            return now;
        }
        self.written += CHUNK;
        if self.written >= ROOM {
            let start = *self.start.get_or_insert(now);
            let free = u128::from((self.written + PERIOD).saturating_sub(ROOM));
            let time = start + (free * 1_000_000_000_000_000 / u128::from(self.rate)) as u64;
            if self.written + CHUNK > self.due(now) + ROOM {
                // Some wake-ups are late, as on a busy machine: by up to 4 ms.
                return time + self.written * 7919 % 4_000_000;
            }
        }
        now
    }
}

/// Plays on a device that is `fast` by parts per million. Nothing is written in `pause`, no frame
/// drawn in `stop`. `check` gets each frame's time of the clock, of the show, and of the heard
/// sound. Returns the dropped samples.
fn play(fast: i64, pause: u64, stop: u64, check: impl Fn(u64, u64, u64)) -> u64 {
    let [pause, stop] = [pause, stop].map(|length| EVENT..EVENT + length);
    let rate = 48_000 * (1_000_000 + fast) as u64;
    let mut device = Device { rate, start: None, written: 0, dropped: 0 };
    let (mut lead, mut heard) = (Lead::default(), Heard::default());
    let (mut writes, mut ahead, mut last) = (0, 0, 0);
    for now in (0..LENGTH / SECOND * 60).map(|frame| frame * SECOND / 60) {
        while writes <= now {
            if pause.contains(&writes) {
                writes = pause.end;
                continue;
            }
            let next = device.write(writes);
            lead.count(CHUNK);
            let played = device.due(writes) / STEP * STEP;
            if let Some(delay) = device.written.checked_sub(played) {
                ahead = lead.ahead(writes, delay as i64);
            }
            writes = next.max(lead.due(writes).unwrap_or(0));
        }
        if stop.contains(&now) {
            continue;
        }
        let time = heard.time(now as i64, ahead, lead.written());
        let may_wait = now == 0 || !pause.is_empty() && time == last;
        assert!(time > last || may_wait, "{time} stands still");
        last = time;
        check(now, time, nanoseconds((device.dropped + device.due(now)) as i64) as u64);
    }
    device.dropped
}

fn assert_together(now: u64, time: u64, heard: u64) {
    assert!(time.abs_diff(heard) <= DRIFT, "{time} for {heard} at {now} ns");
}

#[test]
fn picture_follows_fast_and_slow_devices() {
    for fast in [-500, 20, 500] {
        assert_eq!(play(fast, 0, 0, assert_together), 0);
    }
}

#[test]
fn picture_waits_for_the_sound_after_an_underrun() {
    let dropped = play(20, LATE, 0, |now, time, heard| {
        if !(EVENT..EVENT + 2 * LATE).contains(&now) {
            assert_together(now, time, heard);
        }
    });
    assert!((30 * 48_000..=30 * 48_000 + ROOM + CHUNK).contains(&dropped), "{dropped}");
}

#[test]
fn stop_pauses_the_show() {
    assert!(play(20, STOP, STOP, assert_together) > 0);
}
