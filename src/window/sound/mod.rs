//! Sound and its clock.
//!
//! A thread writes samples to the device up to 400 ms before they are heard, so slow frames do not
//! interrupt the sound. Pictures follow the [time](Player::time) that is heard.

#[cfg_attr(feature = "windows", path = "waveout.rs")]
#[cfg_attr(all(target_os = "linux", not(feature = "windows")), path = "alsa.rs")]
#[cfg_attr(target_os = "macos", path = "cpal.rs")]
#[cfg_attr(not(any(target_os = "linux", target_os = "macos")), path = "none.rs")]
mod device;
mod heard;
mod lead;

use core::ffi::c_void;
use core::ptr::null_mut;
use core::sync::atomic::{AtomicI64, AtomicU64, Ordering::Relaxed};

use device::Device;
use heard::Heard;
use lead::Lead;

use crate::backend::threads::spawn;
use crate::clock::{self, Clock};
use crate::{line, system};

pub const RATE: u32 = 48_000;

pub trait Source: Send {
    /// Returns the next few milliseconds of samples: left and right, full scale 1.
    fn chunk(&mut self) -> &[[f32; 2]];
}

/// The show's time, from the audible sound, or from a clock that excludes stops of the process.
pub struct Player {
    pub clock: Clock,
    heard: Heard,
    last: u64,
    stops: u32,
    /// The duration of stops while no sound was heard, in nanoseconds.
    stopped: u64,
}

/// The sound's lead over the clock in nanoseconds, of the program's only player.
static AHEAD: AtomicI64 = AtomicI64::new(0);

/// The end of the written sound in nanoseconds; the maximum without sound.
static WRITTEN: AtomicI64 = AtomicI64::new(i64::MAX);

/// The time when the device was opened, in [`Clock::start`]'s system time, or one of the constants
/// below.
static OPENED: AtomicU64 = AtomicU64::new(OPENING);
const OPENING: u64 = u64::MAX;
const SILENT: u64 = u64::MAX - 1;

impl Player {
    #[must_use]
    pub fn silent() -> Player {
        Player::by(Clock::start())
    }

    fn by(clock: Clock) -> Player {
        system::heed_stops();
        Player { clock, heard: Heard::default(), last: 0, stops: system::stops(), stopped: 0 }
    }

    /// Plays a source until the process ends, on the default device. If the device does not open
    /// within three seconds, the clock sets the time, and standard error has the reason.
    pub fn start(source: &'static mut dyn Source) -> Player {
        let source = Box::leak(Box::new(source));
        // SAFETY: the box is never freed, and only this thread uses it.
        if unsafe { spawn(play, (&raw mut *source).cast()) }.is_none() {
            say_silent("sound thread is missing");
            return Player::silent();
        }
        match wait_for_device() {
            SILENT => Player::silent(),
            start => Player::by(Clock { start }),
        }
    }

    /// Returns the nanoseconds of the show until now, by the clock if the device is lost.
    pub fn time(&mut self) -> u64 {
        let (ahead, written) = (AHEAD.load(Relaxed), WRITTEN.load(Relaxed));
        let now = self.clock.time();
        // Subtract a stop. With sound, `written` limits the time.
        let stops = system::stops();
        if stops != self.stops && written == i64::MAX {
            self.stopped += now - self.last;
        }
        self.stops = stops;
        self.last = now;
        let clock = (now - self.stopped) as i64;
        self.heard.time(clock, ahead, written)
    }
}

fn say_silent(why: &str) {
    line::complain(why, "; playing silently");
}

fn wait_for_device() -> u64 {
    let opened = clock::wait_while(&OPENED, OPENING);
    if opened != OPENING {
        return opened;
    }
    let late = OPENED.compare_exchange(OPENING, SILENT, Relaxed, Relaxed);
    if late.is_ok() {
        say_silent("sound device does not answer");
    }
    late.err().unwrap_or(SILENT)
}

extern "C" fn play(source: *mut c_void) -> *mut c_void {
    // SAFETY: `Player::start` passes it, never frees it, and does not use it.
    let source = unsafe { &mut *source.cast::<&'static mut dyn Source>() };
    let opened = Device::open(RATE, lead::LATENCY);
    let clock = Clock::start();
    let begin = |opened| OPENED.compare_exchange(OPENING, opened, Relaxed, Relaxed).is_ok();
    let mut device = match opened {
        Ok(device) if begin(clock.start) => device,
        Err(why) if OPENED.load(Relaxed) == OPENING => {
            say_silent(why);
            begin(SILENT);
            return null_mut();
        }
        // The player has given up waiting.
        _ => return null_mut(),
    };
    let mut lead = Lead::default();
    loop {
        let chunk = source.chunk();
        if !device.write(chunk) {
            WRITTEN.store(i64::MAX, Relaxed);
            say_silent("sound device is lost");
            return null_mut();
        }
        lead.count(chunk.len() as u64);
        WRITTEN.store(lead.written(), Relaxed);
        let now = clock.time();
        if let Some(delay) = device.delay() {
            AHEAD.store(lead.ahead(now, delay), Relaxed);
        }
        if let Some(due) = lead.due(now) {
            clock.sleep_until(due);
        }
    }
}
