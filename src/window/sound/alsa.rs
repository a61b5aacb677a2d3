//! ALSA, loaded at run time.

use core::{
    ffi::{CStr, c_char, c_int, c_long, c_uint, c_ulong},
    marker::{PhantomData, PhantomPinned},
    ptr::null_mut,
};

use crate::loading::{loaded, why_not_loaded};

#[repr(C)]
pub struct Pcm {
    _opaque: [u8; 0],
    _marker: PhantomData<(*mut u8, PhantomPinned)>,
}

/// The handler of error messages, without ALSA's variadic arguments.
type Complain = extern "C" fn(*const c_char, c_int, *const c_char, c_int, *const c_char);

loaded! {
    static ALSA: Alsa = c"libasound.so.2";
    fn snd_lib_error_set_handler(Complain) -> c_int;
    fn snd_pcm_delay(*mut Pcm, *mut c_long) -> c_int;
    fn snd_pcm_open(*mut *mut Pcm, *const c_char, c_int, c_int) -> c_int;
    fn snd_pcm_recover(*mut Pcm, c_int, c_int) -> c_int;
    fn snd_pcm_set_params(*mut Pcm, c_int, c_int, c_uint, c_uint, c_int, c_uint) -> c_int;
    fn snd_pcm_writei(*mut Pcm, *const [f32; 2], c_ulong) -> c_long;
}

/// A device that plays 48 kHz stereo, open as long as the process lasts.
pub struct Device {
    alsa: &'static Alsa,
    pcm: *mut Pcm,
}

// SAFETY: ALSA allows any one thread at a time to use a device.
unsafe impl Send for Device {}

extern "C" fn silent(_: *const c_char, _: c_int, _: *const c_char, _: c_int, _: *const c_char) {}

impl Device {
    /// Opens a device by its name in ALSA's configuration, with a buffer of `latency` microseconds, or returns the reason for a
    /// failure.
    pub fn open(name: &CStr, rate: u32, latency: u32) -> Result<Device, &'static str> {
        const PLAYBACK: c_int = 0;
        const WAITING: c_int = 0;
        const FLOAT: c_int = if cfg!(target_endian = "little") {
            14
        } else {
            15
        };
        const INTERLEAVED: c_int = 3;
        const SIDES: c_uint = 2;
        const RESAMPLED: c_int = 1;
        let alsa = ALSA.open().ok_or_else(why_not_loaded)?;
        let mut pcm = null_mut();
        // SAFETY: the functions have the signatures of ALSA's headers, and pointers outlive the calls. The handler has fewer
        // parameters than ALSA passes; on every supported system the caller cleans up.
        unsafe {
            (alsa.snd_lib_error_set_handler)(silent);
            if (alsa.snd_pcm_open)(&mut pcm, name.as_ptr(), PLAYBACK, WAITING) < 0 {
                return Err("sound device is missing");
            }

            if (alsa.snd_pcm_set_params)(pcm, FLOAT, INTERLEAVED, SIDES, rate, RESAMPLED, latency)
                < 0
            {
                return Err("sound device lacks 48 kHz stereo");
            }
        }
        Ok(Device { alsa, pcm })
    }

    /// Writes samples to the device, and waits while its buffer is full. Returns false if the device is lost.
    ///
    /// After an underrun or a suspend, drops these samples and continues with the next ones.
    pub fn write(&mut self, samples: &[[f32; 2]]) -> bool {
        // SAFETY: pointer and length are from a slice, and the device is open. 1 suppresses messages.
        unsafe {
            let written =
                (self.alsa.snd_pcm_writei)(self.pcm, samples.as_ptr(), samples.len() as c_ulong);
            written >= 0 || (self.alsa.snd_pcm_recover)(self.pcm, written as c_int, 1) >= 0
        }
    }

    /// Returns the number of written samples that have not been heard.
    pub fn delay(&mut self) -> Option<i64> {
        let mut delay = 0;
        // SAFETY: the device is open, and `delay` is writable.
        let known = unsafe { (self.alsa.snd_pcm_delay)(self.pcm, &mut delay) == 0 };
        known.then_some(delay)
    }
}
