//! Sound, and the time by which it is heard.
//!
//! A thread makes samples and gives them to the device, which wants them 400 ms before they are heard; a frame that takes long
//! does not keep it from that. Whoever draws the picture asks for the [time](Player::time) that is heard.

#[cfg_attr(feature = "windows", path = "waveout.rs")]
#[cfg_attr(all(target_os = "linux", not(feature = "windows")), path = "alsa.rs")]
#[cfg_attr(target_os = "macos", path = "cpal.rs")]
#[cfg_attr(not(any(target_os = "linux", target_os = "macos")), path = "none.rs")]
mod device;
mod heard;

use core::{
    ffi::{CStr, c_void},
    ptr::null_mut,
    sync::atomic::{AtomicI64, AtomicU64, Ordering::Relaxed},
};

use device::Device;
use heard::Heard;

use crate::{
    backend::threads::spawn,
    clock::{self, Clock, SECOND},
    line::{self, Text},
    system,
};

/// Samples in a second, for each side.
pub const RATE: u32 = 48_000;

/// Microseconds that the device wants samples ahead: long enough for a thread that is woken up late. With less than 320 ms PulseAudio
/// plays holes, as its devices take more at once, and tells nobody: 4 s take 6.
const LATENCY: u32 = 400_000;

/// Nanoseconds until the next sample has to be made, in the long run. Half a percent less than it lasts, for a device may
/// be fast; one that plays nothing would take samples as fast as they come.
const PACE: u64 = SECOND * 199 / 200 / RATE as u64;

/// Nanoseconds that blocks may come ahead of their pace: what the device wants, and half of that to catch up. Then it is time
/// to sleep until half of them are left: to wake up for each block alone takes four times as long as to make them.
const SLACK: u64 = LATENCY as u64 * 1500;

/// By what share of the time a device can be ahead of the clock: a thousandth, more than any quartz. One that plays nothing
/// has heard at once all that it is given, which is no time to go by.
const FASTEST: u64 = 1000;

/// A source of sound.
pub trait Source: Send {
    /// Makes the next samples, some milliseconds at most: left and right, full scale 1.
    fn block(&mut self) -> &[[f32; 2]];
}

/// The time of the show: by what is heard, or by the clock where nothing is, but for the time that the process was stopped.
pub struct Player {
    clock: Clock,
    heard: Heard,
    /// The time of the clock that the show was last asked for.
    last: u64,
    /// How often the process was stopped.
    stops: u32,
    /// How long it was, in nanoseconds, while no sound was heard.
    stopped: u64,
}

/// Nanoseconds that the sound is ahead of the clock, of the one player that a program has.
static AHEAD: AtomicI64 = AtomicI64::new(0);

/// Nanoseconds of sound that its device has been given; without end where there is none.
static WRITTEN: AtomicI64 = AtomicI64::new(i64::MAX);

/// When the device was open, by the clock that [`Clock::start`] takes; before, [`OPENING`], and [`SILENT`] if it is not in time.
static OPENED: AtomicU64 = AtomicU64::new(OPENING);
const OPENING: u64 = u64::MAX;
const SILENT: u64 = u64::MAX - 1;

/// The state of the thread that plays. It lives as long as the process.
struct Work {
    device: &'static CStr,
    source: &'static mut dyn Source,
}

impl Player {
    /// The clock, which started with the time.
    #[must_use]
    pub fn clock(&self) -> Clock {
        self.clock
    }

    /// Plays nothing: the time goes by the clock.
    #[must_use]
    pub fn silent() -> Player {
        Player::by(Clock::start())
    }

    /// A player of which the time begins with a clock.
    fn by(clock: Clock) -> Player {
        system::heed_stops();
        Player {
            clock,
            heard: Heard::default(),
            last: 0,
            stops: system::stops(),
            stopped: 0,
        }
    }

    /// Plays a source on a device of ALSA's, by its name: `default` is what the desktop plays on. The thread that does
    /// ends with the process.
    ///
    /// If there is no such device, or it refuses the sound as it is made, or can't be opened in three seconds, the time goes
    /// by the clock, and standard error says why.
    pub fn start(device: &'static CStr, source: &'static mut dyn Source) -> Player {
        let work = Box::leak(Box::new(Work { device, source }));
        // SAFETY: the work lasts, and there is one thread that does it.
        if unsafe { spawn(play, (&raw mut *work).cast()) }.is_none() {
            say_silent("no thread for sound");
            return Player::silent();
        }
        match wait_for_device() {
            SILENT => Player::silent(),
            start => Player::by(Clock { start }),
        }
    }

    /// Nanoseconds of the show until now. If the device is lost, it goes on from where it was.
    pub fn time(&mut self) -> u64 {
        let (ahead, written) = (AHEAD.load(Relaxed), WRITTEN.load(Relaxed));
        let now = self.clock.time();
        // With sound, what nobody has given to the device is not heard.
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

/// How long so many samples last.
fn nanoseconds(samples: i64) -> i64 {
    samples * (SECOND as i64 / 1000) / i64::from(RATE / 1000)
}

/// Says why the show goes on without sound.
fn say_silent(why: &str) {
    line::complain(format_args!("{}; playing silently", Text(why)));
}

/// Waits until [`play`] has opened the device, or said why it can't, or has taken too long. Returns [`OPENED`].
fn wait_for_device() -> u64 {
    let opened = clock::wait_while(&OPENED, OPENING);
    if opened != OPENING {
        return opened;
    }
    let late = OPENED.compare_exchange(OPENING, SILENT, Relaxed, Relaxed);
    if late.is_ok() {
        say_silent("sound device does not open");
    }
    late.err().unwrap_or(SILENT)
}

/// Opens the device, and plays until it is lost, or the process ends.
extern "C" fn play(work: *mut c_void) -> *mut c_void {
    // SAFETY: `Player::start` passes it, never frees it, and nobody else looks at it.
    let Work { device, source } = unsafe { &mut *work.cast::<Work>() };
    // Open the device, unless that came too late.
    let opened = Device::open(device, RATE, LATENCY);
    let clock = Clock::start();
    let begin = |opened| {
        OPENED
            .compare_exchange(OPENING, opened, Relaxed, Relaxed)
            .is_ok()
    };
    let mut device = match opened {
        Ok(device) if begin(clock.start) => device,
        Err(why) if OPENED.load(Relaxed) == OPENING => {
            say_silent(why);
            begin(SILENT);
            return null_mut();
        }
        // Nobody waits for it any more.
        _ => return null_mut(),
    };
    let mut written = 0;
    let mut due = 0;
    loop {
        // Write a block.
        let block = source.block();
        if !device.write(block) {
            WRITTEN.store(i64::MAX, Relaxed);
            say_silent("sound device lost");
            return null_mut();
        }
        let count = block.len() as u64;
        written += count;
        WRITTEN.store(nanoseconds(written as i64), Relaxed);
        // Find how far what is heard is ahead of the clock.
        let now = clock.time();
        if let Some(delay) = device.delay() {
            let heard = nanoseconds(written as i64 - delay);
            let most = now / FASTEST;
            AHEAD.store((heard - now as i64).min(most as i64), Relaxed);
        }
        // Wait while the device has enough.
        due = u64::max(due + count * PACE, now);
        if due > now + SLACK {
            clock.sleep_until(due - SLACK / 2);
        }
    }
}
