//! Types from Windows' headers.

use core::ffi::c_void;

/// A handle of a file, a thread, a window or a device.
pub type Handle = *mut c_void;

/// `WNDCLASSA`.
#[repr(C)]
pub struct Class {
    pub style: u32,
    pub procedure: *const c_void,
    pub extra: [i32; 2],
    pub program: Handle,
    pub icon: Handle,
    pub cursor: Handle,
    pub background: Handle,
    pub menu: *const u8,
    pub name: *const u8,
}

/// `MSG`.
#[repr(C)]
pub struct Message {
    pub window: Handle,
    pub message: u32,
    pub first: usize,
    pub second: isize,
    pub time: u32,
    pub point: [i32; 2],
    pub private: u32,
}

/// `RECT`.
#[derive(Clone, Copy, Default)]
#[repr(C)]
pub struct Rectangle {
    pub left: i32,
    pub top: i32,
    pub right: i32,
    pub bottom: i32,
}

/// `MONITORINFO`.
#[derive(Default)]
#[repr(C)]
pub struct MonitorInfo {
    pub size: u32,
    pub monitor: Rectangle,
    pub work: Rectangle,
    pub flags: u32,
}

/// `WINDOWPLACEMENT`.
#[derive(Default)]
#[repr(C)]
pub struct Placement {
    pub length: u32,
    pub flags: u32,
    pub command: u32,
    pub minimised: [i32; 2],
    pub maximised: [i32; 2],
    pub normal: Rectangle,
}

/// `BITMAPINFO` for 32-bit pixels.
#[repr(C)]
pub struct BitmapInfo {
    pub size: u32,
    pub width: i32,
    /// Negative if the first row is the top.
    pub height: i32,
    pub planes: u16,
    pub bits: u16,
    pub unused: [u32; 6],
}

/// `WAVEFORMATEX`, whose 18 bytes are not a multiple of its alignment.
#[repr(C, packed)]
pub struct WaveFormat {
    pub format: u16,
    pub channels: u16,
    pub rate: u32,
    pub bytes_a_second: u32,
    pub bytes_a_sample: u16,
    pub bits: u16,
    pub extra: u16,
}

/// `WAVEHDR`, a buffer of samples.
#[repr(C)]
pub struct WaveHeader {
    pub samples: *const [f32; 2],
    pub length: u32,
    pub recorded: u32,
    pub pointer: usize,
    pub flags: u32,
    pub loops: u32,
    pub next: *mut c_void,
    pub reserved: usize,
}

/// `MMTIME`, a device's position.
#[repr(C)]
pub struct Position {
    pub kind: u32,
    pub samples: u32,
    pub unused: u32,
}
