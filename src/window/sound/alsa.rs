//! ALSA, looked up when the program runs, so that it starts where there is none.

use core::{
    ffi::{CStr, c_char, c_int, c_long, c_uint, c_ulong},
    marker::{PhantomData, PhantomPinned},
    ptr::null_mut,
};

use crate::loading::{Table, loaded, why_not_loaded};

/// `snd_pcm_t`, a device that plays.
#[repr(C)]
pub struct Pcm {
    _opaque: [u8; 0],
    _marker: PhantomData<(*mut u8, PhantomPinned)>,
}

/// Writes an error to standard error, in ALSA's own words. (Variadic there; what follows isn't looked at.)
type Complain = extern "C" fn(*const c_char, c_int, *const c_char, c_int, *const c_char);

loaded! {
    /// The functions that are looked up in libasound.
    Alsa, ALSA_NAMES:
    fn snd_lib_error_set_handler(Complain) -> c_int;
    fn snd_pcm_delay(*mut Pcm, *mut c_long) -> c_int;
    fn snd_pcm_open(*mut *mut Pcm, *const c_char, c_int, c_int) -> c_int;
    fn snd_pcm_recover(*mut Pcm, c_int, c_int) -> c_int;
    fn snd_pcm_set_params(*mut Pcm, c_int, c_int, c_uint, c_uint, c_int, c_uint) -> c_int;
    fn snd_pcm_writei(*mut Pcm, *const [f32; 2], c_ulong) -> c_long;
}

static ALSA: Table<Alsa> = Table::new();

/// A device that plays 48 kHz, two sides, as long as the process lasts.
pub struct Device {
    alsa: &'static Alsa,
    pcm: *mut Pcm,
}

// SAFETY: ALSA lets any one thread at a time use a device.
unsafe impl Send for Device {}

/// No words but the intro's own.
extern "C" fn silent(_: *const c_char, _: c_int, _: *const c_char, _: c_int, _: *const c_char) {}

impl Device {
    /// Opens a device by its name in ALSA's configuration, to wait until it has so many microseconds of sound. Or says why
    /// not: there is no ALSA, no such device, or it refuses the sound as it is made.
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
        let Some(alsa) = ALSA.open(c"libasound.so.2", ALSA_NAMES) else {
            return Err(why_not_loaded());
        };
        let mut pcm = null_mut();
        // SAFETY: the functions have the signatures of ALSA's headers, and all that is pointed to
        // outlives the calls. The handler has room for fewer arguments than it is given, which the
        // caller clears away on every system of this crate.
        unsafe {
            (alsa.snd_lib_error_set_handler)(silent);
            if (alsa.snd_pcm_open)(&mut pcm, name.as_ptr(), PLAYBACK, WAITING) < 0 {
                return Err("no sound device");
            }

            if (alsa.snd_pcm_set_params)(pcm, FLOAT, INTERLEAVED, SIDES, rate, RESAMPLED, latency)
                < 0
            {
                return Err("sound device refuses 48 kHz stereo");
            }
        }
        Ok(Device { alsa, pcm })
    }

    /// Gives samples to the device, waiting while it has enough of them. False if the device is lost.
    ///
    /// If it had run out of samples, or slept, these are dropped and it goes on with the next ones.
    pub fn write(&mut self, samples: &[[f32; 2]]) -> bool {
        // SAFETY: the pointer and the length are those of a slice, and the device is open. 1 is for no words.
        unsafe {
            let written =
                (self.alsa.snd_pcm_writei)(self.pcm, samples.as_ptr(), samples.len() as c_ulong);
            written >= 0 || (self.alsa.snd_pcm_recover)(self.pcm, written as c_int, 1) >= 0
        }
    }

    /// Samples that have been given to the device and not been heard yet.
    pub fn delay(&mut self) -> Option<i64> {
        let mut delay = 0;
        // SAFETY: the device is open, and there is room for the answer.
        let known = unsafe { (self.alsa.snd_pcm_delay)(self.pcm, &mut delay) == 0 };
        known.then_some(delay)
    }
}
