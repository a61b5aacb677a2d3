//! Sound by `cpal`, on macOS.
//!
//! The system asks for samples when it needs them, on a thread of its own; they come from a queue that [`Device::write`] fills.

use core::{
    ffi::CStr,
    sync::atomic::{
        AtomicBool, AtomicI64, AtomicU64, AtomicUsize,
        Ordering::{Acquire, Relaxed, Release},
    },
};

use cpal::{
    BufferSize, ErrorKind, Stream, StreamConfig,
    traits::{DeviceTrait, HostTrait, StreamTrait},
};

use crate::clock::{self, Clock, SECOND};

/// Samples that there is room for: more than the 40 ms that the device has ahead.
const ROOM: usize = 4096;

/// How long a writer sleeps until there is room: 2 ms.
const TURN: u64 = SECOND / 500;

/// The queue between the two threads, for the one device that a program has.
struct Queue {
    /// Both sides of a sample, as bits.
    samples: [AtomicU64; ROOM],
    /// Samples that have been written, and those that the device has taken.
    written: AtomicUsize,
    taken: AtomicUsize,
    /// When the first sample would have been heard, by the clock, if the device had played from there without a pause. Before
    /// it plays, [`NOT_YET`].
    origin: AtomicI64,
    is_lost: AtomicBool,
}

const NOT_YET: i64 = i64::MAX;

static QUEUE: Queue = Queue {
    samples: [const { AtomicU64::new(0) }; ROOM],
    written: AtomicUsize::new(0),
    taken: AtomicUsize::new(0),
    origin: AtomicI64::new(NOT_YET),
    is_lost: AtomicBool::new(false),
};

/// A device that plays two sides, as long as the process lasts.
pub struct Device {
    clock: Clock,
    rate: i64,
    /// Samples to have ahead.
    ahead: usize,
    /// It plays until this is dropped.
    _stream: Stream,
}

impl Device {
    /// Opens the device that the desktop plays on, whatever the name, to wait until it has so many microseconds of sound. Or says
    /// why not: there is no device, or it refuses the sound as it is made.
    pub fn open(_: &CStr, rate: u32, latency: u32) -> Result<Device, &'static str> {
        let device = cpal::default_host()
            .default_output_device()
            .ok_or("no sound device")?;
        let clock = Clock::start();
        let config = StreamConfig {
            channels: 2,
            sample_rate: rate,
            buffer_size: BufferSize::Default,
        };
        let refused = |_| "sound device refuses 48 kHz stereo";
        let stream = device
            .build_output_stream(
                config,
                move |room: &mut [f32], info| {
                    let time = info.timestamp();
                    let until = time.playback.saturating_duration_since(time.callback);
                    let heard = (clock.time() as i64).saturating_add(until.as_nanos() as i64);
                    QUEUE.give(room, heard, i64::from(rate));
                },
                |error| match error.kind() {
                    // It goes on after these.
                    ErrorKind::DeviceChanged | ErrorKind::RealtimeDenied | ErrorKind::Xrun => {}
                    _ => QUEUE.is_lost.store(true, Relaxed),
                },
                None,
            )
            .map_err(refused)?;
        stream.play().map_err(refused)?;
        Ok(Device {
            clock,
            rate: rate.into(),
            ahead: (u64::from(rate) * u64::from(latency) / 1_000_000) as usize,
            _stream: stream,
        })
    }

    /// Gives samples to the device, waiting while it has enough of them. False if the device is lost.
    pub fn write(&mut self, samples: &[[f32; 2]]) -> bool {
        while QUEUE.waiting() + samples.len() > self.ahead.max(samples.len()) {
            if QUEUE.is_lost.load(Relaxed) {
                return false;
            }
            clock::sleep(TURN);
        }
        QUEUE.add(samples);
        !QUEUE.is_lost.load(Relaxed)
    }

    /// Samples that have been given to the device and not been heard yet.
    pub fn delay(&mut self) -> Option<i64> {
        let origin = QUEUE.origin.load(Relaxed);
        if origin == NOT_YET {
            return None;
        }
        let time = self.clock.time() as i64 - origin;
        let heard = time / 1000 * self.rate / (SECOND as i64 / 1000);
        let taken = QUEUE.taken.load(Relaxed) as i64;
        Some(QUEUE.written.load(Relaxed) as i64 - heard.clamp(0, taken))
    }
}

impl Queue {
    /// Samples that the device has not taken yet.
    fn waiting(&self) -> usize {
        self.written.load(Relaxed) - self.taken.load(Acquire)
    }

    /// Adds samples, for which there has to be room.
    fn add(&self, samples: &[[f32; 2]]) {
        let written = self.written.load(Relaxed);
        for (number, [left, right]) in (written..).zip(samples) {
            let bits = u64::from(left.to_bits()) << 32 | u64::from(right.to_bits());
            self.samples[number % ROOM].store(bits, Relaxed);
        }
        self.written.store(written + samples.len(), Release);
    }

    /// Fills a device's room, which is heard from a time of the clock on; with silence where there are no samples.
    fn give(&self, room: &mut [f32], heard: i64, rate: i64) {
        let (taken, written) = (self.taken.load(Relaxed), self.written.load(Acquire));
        let mut next = taken;
        for place in room.chunks_exact_mut(2) {
            let mut bits = 0;
            if next < written {
                bits = self.samples[next % ROOM].load(Relaxed);
                next += 1;
            }
            place.copy_from_slice(&[(bits >> 32) as u32, bits as u32].map(f32::from_bits));
        }
        if next > taken {
            let played = taken as i64 * (SECOND as i64 / 1000) / (rate / 1000);
            self.origin.store(heard - played, Relaxed);
        }
        self.taken.store(next, Release);
    }
}
