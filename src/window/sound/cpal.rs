//! Sound through `cpal`, on macOS, whose thread requests samples from the queue that
//! [`Device::write`] fills.

use std::collections::VecDeque;
use std::sync::{Mutex, MutexGuard, PoisonError};

use cpal::traits::{DeviceTrait, HostTrait, StreamTrait};
use cpal::{BufferSize, ErrorKind, Stream, StreamConfig};

use crate::clock::{self, Clock, SECOND};

/// A writer's polling interval: 2 ms.
const TURN: u64 = SECOND / 500;

struct Queue {
    samples: VecDeque<[f32; 2]>,
    taken: i64,
    /// The clock's time of the first sample, extrapolated from the samples that play now.
    origin: Option<i64>,
    is_lost: bool,
}

static QUEUE: Mutex<Queue> =
    Mutex::new(Queue { samples: VecDeque::new(), taken: 0, origin: None, is_lost: false });

fn queue() -> MutexGuard<'static, Queue> {
    QUEUE.lock().unwrap_or_else(PoisonError::into_inner)
}

pub struct Device {
    clock: Clock,
    rate: i64,
    ahead: usize,
    _stream: Stream,
}

impl Device {
    pub fn open(rate: u32, latency: u32) -> Result<Device, &'static str> {
        let device =
            cpal::default_host().default_output_device().ok_or("sound device is missing")?;
        let clock = Clock::start();
        let config =
            StreamConfig { channels: 2, sample_rate: rate, buffer_size: BufferSize::Default };
        let refused = |_| "sound device lacks 48 kHz stereo";
        let stream = device
            .build_output_stream(
                config,
                move |room: &mut [f32], info| {
                    let time = info.timestamp();
                    let until = time.playback.saturating_duration_since(time.callback);
                    let heard = (clock.time() as i64).saturating_add(until.as_nanos() as i64);
                    queue().give(room, heard, i64::from(rate));
                },
                |error| match error.kind() {
                    ErrorKind::DeviceChanged | ErrorKind::RealtimeDenied | ErrorKind::Xrun => {}
                    _ => queue().is_lost = true,
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

    pub fn write(&mut self, samples: &[[f32; 2]]) -> bool {
        loop {
            let mut queue = queue();
            if queue.is_lost {
                return false;
            }
            if queue.samples.is_empty() || queue.samples.len() + samples.len() <= self.ahead {
                queue.samples.extend(samples);
                return true;
            }
            drop(queue);
            clock::sleep(TURN);
        }
    }

    pub fn delay(&mut self) -> Option<i64> {
        let queue = queue();
        let time = self.clock.time() as i64 - queue.origin?;
        let heard = time / 1000 * self.rate / (SECOND as i64 / 1000);
        let written = queue.taken + queue.samples.len() as i64;
        Some(written - heard.clamp(0, queue.taken))
    }
}

impl Queue {
    /// Fills a buffer that is heard from the clock's time `heard` on, and pads it with silence.
    fn give(&mut self, room: &mut [f32], heard: i64, rate: i64) {
        if !self.samples.is_empty() {
            let played = self.taken * (SECOND as i64 / 1000) / (rate / 1000);
            self.origin = Some(heard - played);
        }
        for place in room.chunks_exact_mut(2) {
            let next = self.samples.pop_front();
            self.taken += i64::from(next.is_some());
            place.copy_from_slice(&next.unwrap_or_default());
        }
    }
}
