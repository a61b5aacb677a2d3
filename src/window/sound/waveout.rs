//! Sound by Windows' waveOut functions.

use core::{ffi::CStr, mem::size_of, ptr::null_mut};

use crate::{
    backend::{
        functions::{waveOutGetPosition, waveOutOpen, waveOutPrepareHeader, waveOutWrite},
        types::{Handle, Position, WaveFormat, WaveHeader},
    },
    clock::{self, SECOND},
    static_cell::StaticCell,
};

/// Samples in a buffer: 10 ms.
const LENGTH: usize = 480;

/// The number of buffers: 80 ms. Windows mixes chunks of 10 ms, some of them in advance.
const COUNT: usize = 8;

/// A writer's polling interval: 2 ms.
const TURN: u64 = SECOND / 500;

/// The number of polls after which the device is lost: 2 s.
const MOST_TURNS: usize = 1000;

/// The header's flag of queued buffers (`WHDR_INQUEUE`).
const IN_QUEUE: u32 = 0x10;

struct Buffer {
    header: WaveHeader,
    samples: [[f32; 2]; LENGTH],
}

// SAFETY: its pointers are to itself, or null.
unsafe impl Send for Buffer {}

static BUFFERS: StaticCell<[Buffer; COUNT]> = StaticCell::new(
    [const {
        Buffer {
            header: WaveHeader {
                samples: null_mut(),
                length: 0,
                recorded: 0,
                pointer: 0,
                flags: 0,
                loops: 0,
                next: null_mut(),
                reserved: 0,
            },
            samples: [[0.0; 2]; LENGTH],
        }
    }; COUNT],
);

/// A stereo device, open as long as the process lasts.
pub struct Device {
    device: Handle,
    buffers: &'static mut [Buffer; COUNT],
    written: usize,
}

impl Device {
    /// Opens the desktop's default device. Returns the reason if there is none, or if it refuses the format.
    pub fn open(_: &CStr, rate: u32, _: u32) -> Result<Device, &'static str> {
        const FLOAT: u16 = 3;
        const SIDES: u16 = 2;
        const SAMPLE: u16 = size_of::<[f32; 2]>() as u16;
        /// `WAVE_MAPPER`, the default device.
        const MAPPER: u32 = u32::MAX;
        const BAD_FORMAT: u32 = 32;
        let format = WaveFormat {
            format: FLOAT,
            channels: SIDES,
            rate,
            bytes_a_second: rate * u32::from(SAMPLE),
            bytes_a_sample: SAMPLE,
            bits: 32,
            extra: 0,
        };
        let mut device = null_mut();
        // SAFETY: pointers outlive the call.
        match unsafe { waveOutOpen(&mut device, MAPPER, &format, 0, 0, 0) } {
            0 => {}
            BAD_FORMAT => return Err("sound device refuses 48 kHz stereo"),
            _ => return Err("no sound device"),
        }
        let buffers = BUFFERS.take();
        for buffer in buffers.iter_mut() {
            buffer.header.samples = buffer.samples.as_ptr();
            buffer.header.length = size_of_val(&buffer.samples) as u32;
            // SAFETY: the header has a fixed address, and describes these samples.
            unsafe { waveOutPrepareHeader(device, &mut buffer.header, HEADER) };
        }
        Ok(Device {
            device,
            buffers,
            written: 0,
        })
    }

    pub fn write(&mut self, samples: &[[f32; 2]]) -> bool {
        samples.iter().all(|&sample| self.add(sample))
    }

    /// Adds a sample to the next buffer, and queues the buffer when it is full.
    fn add(&mut self, sample: [f32; 2]) -> bool {
        let (number, place) = (self.written / LENGTH % COUNT, self.written % LENGTH);
        let buffer = &mut self.buffers[number];
        let flags = &raw const buffer.header.flags;
        let mut turns = 0;
        // SAFETY: the field is valid; volatile, because the device changes it.
        while unsafe { flags.read_volatile() } & IN_QUEUE != 0 {
            turns += 1;
            if turns == MOST_TURNS {
                return false;
            }
            clock::sleep(TURN);
        }
        buffer.samples[place] = sample;
        self.written += 1;
        // SAFETY: the header has been prepared, and is not queued.
        place + 1 < LENGTH || unsafe { waveOutWrite(self.device, &mut buffer.header, HEADER) } == 0
    }

    pub fn delay(&mut self) -> Option<i64> {
        const SAMPLES: u32 = 2;
        let mut position = Position {
            kind: SAMPLES,
            samples: 0,
            unused: 0,
        };
        let size = size_of::<Position>() as u32;
        // SAFETY: `position` is writable.
        let known = unsafe { waveOutGetPosition(self.device, &mut position, size) } == 0;
        // The device counts modulo 2^32.
        let delay = (self.written as u32).wrapping_sub(position.samples) as i32;
        (known && position.kind == SAMPLES).then_some(delay.into())
    }
}

const HEADER: u32 = size_of::<WaveHeader>() as u32;
