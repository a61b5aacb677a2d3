use core::mem::{size_of, zeroed};
use core::ptr::null_mut;

use windows_sys::Win32::Foundation::HANDLE;
use windows_sys::Win32::Media::Audio::{
    WAVE_MAPPER, WAVEFORMATEX, WAVEHDR, WAVERR_BADFORMAT, WHDR_INQUEUE,
};
use windows_sys::Win32::Media::{MMTIME, TIME_SAMPLES};

use crate::{
    backend::functions::{waveOutGetPosition, waveOutOpen, waveOutPrepareHeader, waveOutWrite},
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
const MAX_TURNS: usize = 1000;

struct Buffer {
    header: WAVEHDR,
    samples: [[f32; 2]; LENGTH],
}

// SAFETY: its pointers are to itself, or null.
unsafe impl Send for Buffer {}

static BUFFERS: StaticCell<[Buffer; COUNT]> = StaticCell::new(
    [const {
        Buffer {
            // SAFETY: zero is valid for all fields.
            header: unsafe { zeroed() },
            samples: [[0.0; 2]; LENGTH],
        }
    }; COUNT],
);

pub struct Device {
    device: HANDLE,
    buffers: &'static mut [Buffer; COUNT],
    written: usize,
}

impl Device {
    pub fn open(rate: u32, _: u32) -> Result<Device, &'static str> {
        const FLOAT: u16 = 3;
        const SIDES: u16 = 2;
        const SAMPLE: u16 = size_of::<[f32; 2]>() as u16;
        let format = WAVEFORMATEX {
            wFormatTag: FLOAT,
            nChannels: SIDES,
            nSamplesPerSec: rate,
            nAvgBytesPerSec: rate * u32::from(SAMPLE),
            nBlockAlign: SAMPLE,
            wBitsPerSample: 32,
            cbSize: 0,
        };
        let mut device = null_mut();
        // SAFETY: pointers outlive the call.
        match unsafe { waveOutOpen(&mut device, WAVE_MAPPER, &format, 0, 0, 0) } {
            0 => {}
            WAVERR_BADFORMAT => return Err("sound device lacks 48 kHz stereo"),
            _ => return Err("sound device is missing"),
        }
        let buffers = BUFFERS.take();
        for buffer in buffers.iter_mut() {
            buffer.header.lpData = buffer.samples.as_mut_ptr().cast();
            buffer.header.dwBufferLength = size_of_val(&buffer.samples) as u32;
            // SAFETY: the header has a fixed address, and describes these samples.
            unsafe { waveOutPrepareHeader(device, &mut buffer.header, HEADER) };
        }
        Ok(Device { device, buffers, written: 0 })
    }

    pub fn write(&mut self, samples: &[[f32; 2]]) -> bool {
        samples.iter().all(|&sample| self.add(sample))
    }

    fn add(&mut self, sample: [f32; 2]) -> bool {
        let (number, place) = (self.written / LENGTH % COUNT, self.written % LENGTH);
        let buffer = &mut self.buffers[number];
        let flags = &raw const buffer.header.dwFlags;
        let mut turns = 0;
        // SAFETY: the field is valid; volatile, because the device changes it.
        while unsafe { flags.read_volatile() } & WHDR_INQUEUE != 0 {
            turns += 1;
            if turns == MAX_TURNS {
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
        let mut position = MMTIME { wType: TIME_SAMPLES, ..MMTIME::default() };
        let size = size_of::<MMTIME>() as u32;
        // SAFETY: `position` is writable, and each of its variants is any 32 bits.
        let (known, played) = unsafe {
            let result = waveOutGetPosition(self.device, &mut position, size);
            (result == 0, position.u.sample)
        };
        // The device counts modulo 2^32.
        let delay = (self.written as u32).wrapping_sub(played) as i32;
        (known && position.wType == TIME_SAMPLES).then_some(delay.into())
    }
}

const HEADER: u32 = size_of::<WAVEHDR>() as u32;
