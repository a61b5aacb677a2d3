//! ALSA, loaded at run time.

use core::ffi::{CStr, c_char, c_int, c_long, c_uint, c_ulong, c_void};
use core::ptr::null_mut;

use crate::loading::{loaded, why_not_loaded};

/// An opaque device.
type Pcm = c_void;

/// The handler of error messages, without ALSA's variadic arguments.
type Complain = extern "C" fn(*const c_char, c_int, *const c_char, c_int, *const c_char);

loaded! {
    static ALSA: Alsa = c"libasound.so.2";
    fn snd_lib_error_set_handler(Complain) -> c_int;
    fn snd_pcm_delay(*mut Pcm, *mut c_long) -> c_int;
    fn snd_pcm_open(*mut *mut Pcm, *const c_char, c_int, c_int) -> c_int;
    fn snd_pcm_recover(*mut Pcm, c_int, c_int) -> c_int;
    fn snd_pcm_set_params(*mut Pcm, c_int, c_int, c_uint, c_uint, c_int, c_uint) -> c_int;
    fn snd_pcm_writei(*mut Pcm, *const c_void, c_ulong) -> c_long;
}

pub struct Device {
    alsa: &'static Alsa,
    pcm: *mut Pcm,
    /// Takes 16-bit integers instead of floats.
    is_short: bool,
}

// SAFETY: ALSA allows any one thread at a time to use a device.
unsafe impl Send for Device {}

extern "C" fn silent(_: *const c_char, _: c_int, _: *const c_char, _: c_int, _: *const c_char) {}

// ALSA's sample formats.
const FLOAT: c_int = 14 + BIG_ENDIAN;
const SHORT: c_int = 2 + BIG_ENDIAN;
const BIG_ENDIAN: c_int = cfg!(target_endian = "big") as c_int;
const FORMATS: c_int = 52;

fn open(alsa: &Alsa, name: &CStr) -> Option<*mut Pcm> {
    const PLAYBACK: c_int = 0;
    const WAITING: c_int = 0;
    let mut pcm = null_mut();
    // SAFETY: pointers outlive the call.
    let opened = unsafe { (alsa.snd_pcm_open)(&mut pcm, name.as_ptr(), PLAYBACK, WAITING) };
    (opened >= 0).then_some(pcm)
}

impl Device {
    /// Opens the default device, with a buffer of `latency` microseconds.
    ///
    /// ALSA's plug-in `plug` converts for devices with another format, rate or number of channels.
    pub fn open(rate: u32, latency: u32) -> Result<Device, &'static str> {
        let alsa = ALSA.open().ok_or_else(why_not_loaded)?;
        // SAFETY: the function has the signature of ALSA's headers, except that the handler has
        // fewer parameters than ALSA passes; on every supported system the caller cleans up.
        unsafe { (alsa.snd_lib_error_set_handler)(silent) };
        let pcm = open(alsa, c"plug:default").or_else(|| open(alsa, c"default"));
        let pcm = pcm.ok_or("sound device is missing")?;
        let accepts = |format| {
            let (set, interleaved, sides, resampled) = (alsa.snd_pcm_set_params, 3, 2, 1);
            // SAFETY: the device is open.
            unsafe { set(pcm, format, interleaved, sides, rate, resampled, latency) >= 0 }
        };
        let mut formats = [FLOAT, SHORT].into_iter().chain(0..FORMATS);
        match formats.find(|&format| accepts(format)) {
            Some(FLOAT) => Ok(Device { alsa, pcm, is_short: false }),
            Some(SHORT) => Ok(Device { alsa, pcm, is_short: true }),
            Some(_) => Err("sound device lacks floats and 16-bit integers"),
            None => Err("sound device lacks 48 kHz stereo"),
        }
    }

    /// Writes samples, and waits while the buffer is full. Returns false if the device is lost.
    /// Underruns drop samples.
    pub fn write(&mut self, samples: &[[f32; 2]]) -> bool {
        if !self.is_short {
            return self.put(samples.as_ptr().cast(), samples.len());
        }
        // Rounds, and saturates beyond full scale.
        let short = |side: f32| (side * 32767.0 + 32768.5) as u16 ^ 0x8000;
        let mut part = [[0; 2]; 48];
        samples.chunks(part.len()).all(|samples| {
            for (to, from) in part.iter_mut().zip(samples) {
                *to = from.map(short);
            }
            self.put(part.as_ptr().cast(), samples.len())
        })
    }

    fn put(&mut self, samples: *const c_void, count: usize) -> bool {
        // SAFETY: the callers pass this number of samples in the device's format, and the device is
        // open. 1 suppresses messages.
        unsafe {
            let written = (self.alsa.snd_pcm_writei)(self.pcm, samples, count as c_ulong);
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
