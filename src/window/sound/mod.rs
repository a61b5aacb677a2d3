//! Sound, and the time by which it is heard.
//!
//! A thread makes samples and gives them to ALSA, which wants them 40 ms before they are heard; a frame that takes long
//! does not keep it from that. Whoever draws the picture asks for the [time](Player::time) that is heard.

mod alsa;
mod heard;

use core::{
    cell::UnsafeCell,
    ffi::{CStr, c_void},
    ptr::null_mut,
    sync::atomic::{AtomicI64, Ordering::Relaxed},
};

use alsa::Device;
pub use heard::Heard;

use crate::{
    clock::{Clock, SECOND},
    line, pool,
};

/// Samples in a second, for each side.
pub const RATE: u32 = 48_000;

/// Microseconds that the device wants samples ahead: long enough for a thread that is woken up late.
const LATENCY: u32 = 40_000;

/// Nanoseconds until the next sample has to be made, in the long run. Half a percent less than it lasts, for a device may
/// be fast; one that plays nothing would take samples as fast as they come.
const PACE: u64 = SECOND * 199 / 200 / RATE as u64;

/// Nanoseconds that blocks may come ahead of their pace: what the device wants, and twice that to catch up.
const SLACK: u64 = 3 * LATENCY as u64 * 1000;

/// What makes sound.
pub trait Source: Send {
    /// Makes the next samples, some milliseconds at most: left and right, full scale 1.
    fn block(&mut self) -> &[[f32; 2]];
}

/// The time of the show: by what is heard, or by the clock where nothing is.
pub struct Player {
    clock: Clock,
    heard: Heard,
    /// Nanoseconds that the sound is ahead of the clock.
    ahead: &'static AtomicI64,
}

/// What the thread that plays works with. It lives as long as the process.
struct Work {
    clock: Clock,
    /// The thread's alone.
    instruments: UnsafeCell<(Device, &'static mut dyn Source)>,
    /// See [`Player`].
    ahead: AtomicI64,
}

impl Player {
    /// The time by the clock, without sound.
    #[must_use]
    pub fn silent() -> Player {
        static AHEAD: AtomicI64 = AtomicI64::new(0);
        Player {
            clock: Clock::start(),
            heard: Heard::default(),
            ahead: &AHEAD,
        }
    }

    /// Plays a source on a device of ALSA's, by its name: `default` is what the desktop plays on. The thread that does
    /// ends with the process.
    ///
    /// If there is no such device, or it refuses the sound as it is made, standard error says so, and the time goes by the
    /// clock.
    pub fn start(device: &CStr, source: &'static mut dyn Source) -> Player {
        let mut player = Player::silent();
        let Some(device) = Device::open(device, RATE, LATENCY) else {
            say_silent();
            return player;
        };
        let work: &Work = Box::leak(Box::new(Work {
            clock: player.clock,
            instruments: UnsafeCell::new((device, source)),
            ahead: AtomicI64::new(0),
        }));
        let pointer = (&raw const *work).cast_mut().cast();
        // SAFETY: the work lasts, and there is one thread that does it.
        if !unsafe { pool::spawn(&mut 0, play, pointer) } {
            say_silent();
        }
        player.ahead = &work.ahead;
        player
    }

    /// Nanoseconds of the show until now. If the device is lost, it goes on from where it was.
    pub fn time(&mut self) -> u64 {
        self.heard.time(self.clock.time(), self.ahead.load(Relaxed))
    }
}

fn say_silent() {
    line::write(
        line::ERROR,
        b"eightfold: no libasound, or no device for 48 kHz; playing silently\n",
    );
}

/// Plays until the device is lost, or the process ends.
extern "C" fn play(work: *mut c_void) -> *mut c_void {
    // SAFETY: `Player::start` passes it, and never frees it.
    let work = unsafe { &*work.cast::<Work>() };
    // SAFETY: nobody else looks at it.
    let (device, source) = unsafe { &mut *work.instruments.get() };
    let mut written = 0;
    let mut due = 0;
    loop {
        let block = source.block();
        if !device.write(block) {
            say_silent();
            return null_mut();
        }
        let count = block.len() as u64;
        written += count;
        let now = work.clock.time();
        if let Some(delay) = device.delay() {
            let heard = (written as i64 - delay) * (SECOND as i64 / 1000) / i64::from(RATE / 1000);
            work.ahead.store(heard - now as i64, Relaxed);
        }
        due = u64::max(due + count * PACE, now);
        work.clock.sleep_until(due - due.min(SLACK));
    }
}
