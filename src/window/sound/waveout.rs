//! Sound by the functions of Windows for waves.

use core::{ffi::CStr, mem::size_of, ptr::null_mut};

use crate::{
    backend::{
        functions::{waveOutGetPosition, waveOutOpen, waveOutPrepareHeader, waveOutWrite},
        types::{Handle, Position, WaveFormat, WaveHeader},
    },
    clock::{self, SECOND},
    fixed::Fixed,
};

/// Samples of a buffer, 10 ms.
const LENGTH: usize = 480;

/// Buffers in turns: 80 ms. Windows mixes what it is given by 10 ms, some of them ahead.
const COUNT: usize = 8;

/// How long a writer sleeps until a buffer has been played: 2 ms.
const TURN: u64 = SECOND / 500;

/// So many times, until the device is taken for lost: 2 s.
const MOST_TURNS: usize = 1000;

/// A header's flag: the device has it.
const IN_QUEUE: u32 = 0x10;

/// Samples that are given to the device together.
struct Buffer {
    header: WaveHeader,
    samples: [[f32; 2]; LENGTH],
}

// SAFETY: its pointers are to itself, or null.
unsafe impl Send for Buffer {}

static BUFFERS: Fixed<[Buffer; COUNT]> = Fixed::new(
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

/// A device that plays two sides, as long as the process lasts.
pub struct Device {
    device: Handle,
    buffers: &'static mut [Buffer; COUNT],
    /// Samples that have been written.
    written: usize,
}

impl Device {
    /// Opens the device that the desktop plays on, whatever the name. Or says why not: there is no device, or it refuses the sound
    /// as it is made.
    pub fn open(_: &CStr, rate: u32, _: u32) -> Result<Device, &'static str> {
        const FLOAT: u16 = 3;
        const SIDES: u16 = 2;
        const SAMPLE: u16 = size_of::<[f32; 2]>() as u16;
        /// Stands for the desktop's.
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
        // SAFETY: what is pointed to outlives the call.
        match unsafe { waveOutOpen(&mut device, MAPPER, &format, 0, 0, 0) } {
            0 => {}
            BAD_FORMAT => return Err("sound device refuses 48 kHz stereo"),
            _ => return Err("no sound device"),
        }
        let buffers = BUFFERS.take();
        for buffer in buffers.iter_mut() {
            buffer.header.samples = buffer.samples.as_ptr();
            buffer.header.length = size_of_val(&buffer.samples) as u32;
            // SAFETY: the header stays where it is, and says of the samples what is so.
            unsafe { waveOutPrepareHeader(device, &mut buffer.header, HEADER) };
        }
        Ok(Device {
            device,
            buffers,
            written: 0,
        })
    }

    /// Gives samples to the device, waiting while it has enough of them. False if the device is lost.
    pub fn write(&mut self, samples: &[[f32; 2]]) -> bool {
        samples.iter().all(|&sample| self.add(sample))
    }

    /// Adds a sample to those that are given to the device next.
    fn add(&mut self, sample: [f32; 2]) -> bool {
        let (number, place) = (self.written / LENGTH % COUNT, self.written % LENGTH);
        let buffer = &mut self.buffers[number];
        let flags = &raw const buffer.header.flags;
        let mut turns = 0;
        // SAFETY: the device writes to it meanwhile.
        while unsafe { flags.read_volatile() } & IN_QUEUE != 0 {
            turns += 1;
            if turns == MOST_TURNS {
                return false;
            }
            clock::sleep(TURN);
        }
        buffer.samples[place] = sample;
        self.written += 1;
        // SAFETY: the header has been prepared, and the device has it not.
        place + 1 < LENGTH || unsafe { waveOutWrite(self.device, &mut buffer.header, HEADER) } == 0
    }

    /// Samples that have been written and not been heard yet.
    pub fn delay(&mut self) -> Option<i64> {
        const SAMPLES: u32 = 2;
        let mut position = Position {
            kind: SAMPLES,
            samples: 0,
            unused: 0,
        };
        let size = size_of::<Position>() as u32;
        // SAFETY: there is room for the answer.
        let known = unsafe { waveOutGetPosition(self.device, &mut position, size) } == 0;
        // The device counts modulo 2^32.
        let delay = (self.written as u32).wrapping_sub(position.samples) as i32;
        (known && position.kind == SAMPLES).then_some(delay.into())
    }
}

/// The size of a header.
const HEADER: u32 = size_of::<WaveHeader>() as u32;
