//! A simulated ALSA library with one device and its own time.
//!
//! Preloaded, it also replaces the program's clock: time stands still while any of the program's threads works, and skips to the
//! next wake-up when all of them sleep. So a minute and a half takes seconds, and is the same on any machine. Standard output
//! counts as a terminal.
//!
//! | variable | meaning |
//! | --- | --- |
//! | `SIMULATED_FAST` | the device's deviation in parts per million |
//! | `SIMULATED_LATE`, `SIMULATED_STOP` | the times of an underrun and of a stop of the program, in nanoseconds |
//! | `SIMULATED_SLOW` | nanoseconds that the device takes to open |
//! | `SIMULATED_FILE` | the output: chunks, each after the nanosecond from which it is heard |

use std::{
    env,
    ffi::{c_char, c_int, c_long, c_uint, c_ulong, c_void},
    fs::{self, File},
    io::{BufWriter, Write},
    ptr::null_mut,
    slice,
    sync::{Condvar, LazyLock, Mutex, MutexGuard},
};

/// The buffer in samples (400 ms), and the samples that the device takes at once.
const ROOM: u64 = 19_200;
const PERIOD: u64 = 4800;

/// The steps of the reported position, in samples: 5 ms.
const STEP: u64 = 240;

/// The delay of a late writer: 700 ms.
const LATE: u64 = 700_000_000;

/// The duration of a stop: 1.5 s.
const STOP: u64 = 1_500_000_000;

const OUT_OF_SAMPLES: c_int = -32;
const NO_DEVICE: c_int = -19;

/// The number of threads that sleep, once the device plays. Before that, threads come and go.
const THREADS: usize = 2;

struct World {
    now: u64,
    sleepers: Vec<u64>,
    plays: bool,
    /// Samples that the device plays in a million seconds.
    rate: u64,
    late: u64,
    stop: u64,
    start: Option<u64>,
    written: u64,
    waiting: Vec<(u64, Vec<u8>)>,
    file: BufWriter<File>,
}

fn number(name: &str) -> i64 {
    env::var(name).map_or(0, |text| text.parse().expect("a number"))
}

static WORLD: LazyLock<Mutex<World>> = LazyLock::new(|| {
    // Without a time: never.
    let time = |name| match number(name) {
        0 => u64::MAX,
        time => time as u64,
    };
    let path = env::var_os("SIMULATED_FILE").expect("a file");
    Mutex::new(World {
        now: 0,
        sleepers: Vec::new(),
        plays: false,
        rate: 48_000 * (1_000_000 + number("SIMULATED_FAST")) as u64,
        late: time("SIMULATED_LATE"),
        stop: time("SIMULATED_STOP"),
        start: None,
        written: 0,
        waiting: Vec::new(),
        file: BufWriter::new(File::create(path).expect("a file that can be made")),
    })
});
static WOKEN: Condvar = Condvar::new();

fn world() -> MutexGuard<'static, World> {
    WORLD.lock().expect("no thread panics")
}

fn sleep(mut world: MutexGuard<'static, World>, time: u64) -> MutexGuard<'static, World> {
    if time <= world.now {
        return world;
    }
    world.sleepers.push(time);
    WOKEN.notify_all();
    while world.now < time {
        let asleep = world.sleepers.iter().filter(|&&time| time > world.now);
        let (count, first) = (asleep.clone().count(), *asleep.min().expect("this one"));
        world.plays |= count == THREADS;
        let working = if world.plays { THREADS } else { threads() } > count;
        if !working {
            world.now = first;
            WOKEN.notify_all();
        } else if world.plays {
            world = WOKEN.wait(world).expect("no thread panics");
        } else {
            // An ending thread wakes no sleeper.
            drop(world);
            // SAFETY: it waits for a millisecond and for no files.
            unsafe { poll(null_mut(), 0, 1) };
            world = self::world();
        }
    }
    let this = world.sleepers.iter().position(|&other| other == time);
    world.sleepers.swap_remove(this.expect("it slept"));
    world
}

fn threads() -> usize {
    fs::read_dir("/proc/self/task").map_or(1, Iterator::count)
}

impl World {
    fn time_of(&self, sample: u64) -> Option<u64> {
        let after = u128::from(sample) * 1_000_000_000_000_000;
        Some(self.start? + after.div_ceil(self.rate.into()) as u64)
    }

    fn due(&self) -> u64 {
        self.start.map_or(0, |start| {
            (u128::from(self.now - start) * u128::from(self.rate) / 1_000_000_000_000_000) as u64
        })
    }

    fn note(&mut self) {
        for (sample, chunk) in std::mem::take(&mut self.waiting) {
            let time = self.time_of(sample).expect("it plays");
            self.file.write_all(&time.to_le_bytes()).expect("room");
            self.file.write_all(&chunk).expect("room");
        }
        self.file.flush().expect("room");
    }
}

#[unsafe(no_mangle)]
extern "C" fn snd_lib_error_set_handler(_: *const c_void) -> c_int {
    0
}

#[unsafe(no_mangle)]
unsafe extern "C" fn snd_pcm_open(
    pcm: *mut *mut c_void,
    _: *const c_char,
    _: c_int,
    _: c_int,
) -> c_int {
    let world = world();
    let open = world.now + number("SIMULATED_SLOW") as u64;
    drop(sleep(world, open));
    // SAFETY: the pointer is writable.
    unsafe { *pcm = null_mut() };
    0
}

#[unsafe(no_mangle)]
extern "C" fn snd_pcm_set_params(
    _: *mut c_void,
    _: c_int,
    _: c_int,
    sides: c_uint,
    rate: c_uint,
    _: c_int,
    latency: c_uint,
) -> c_int {
    let known = (sides, rate, latency) == (2, 48_000, 400_000);
    if known { 0 } else { NO_DEVICE }
}

#[unsafe(no_mangle)]
unsafe extern "C" fn snd_pcm_writei(
    _: *mut c_void,
    samples: *const [f32; 2],
    count: c_ulong,
) -> c_long {
    let mut world = world();
    if world.now >= world.late {
        world.late = u64::MAX;
        let end = world.now + LATE;
        world = sleep(world, end);
    }
    if world.due() > world.written {
        return OUT_OF_SAMPLES.into();
    }
    if world.start.is_some() && world.written + count > world.due() + ROOM {
        let end = world.time_of(world.written + PERIOD - ROOM);
        // Some wake-ups are late, as on a busy machine: by up to 4 ms.
        let end = end.expect("it plays") + world.written * 7919 % 4_000_000;
        world = sleep(world, end);
    }
    // SAFETY: the caller passes this number of samples.
    let samples = unsafe { slice::from_raw_parts(samples, count as usize) };
    let bytes = samples
        .as_flattened()
        .iter()
        .flat_map(|side| side.to_le_bytes());
    let first = world.written;
    world.waiting.push((first, bytes.collect()));
    world.written += count;
    if world.written >= ROOM && world.start.is_none() {
        world.start = Some(world.now);
    }
    if world.start.is_some() {
        world.note();
    }
    count as c_long
}

#[unsafe(no_mangle)]
unsafe extern "C" fn snd_pcm_delay(_: *mut c_void, delay: *mut c_long) -> c_int {
    let world = world();
    if world.due() > world.written {
        return OUT_OF_SAMPLES;
    }
    let played = world.due() / STEP * STEP;
    // SAFETY: the pointer is writable.
    unsafe { *delay = (world.written - played) as c_long };
    0
}

#[unsafe(no_mangle)]
extern "C" fn snd_pcm_recover(_: *mut c_void, error: c_int, _: c_int) -> c_int {
    if error != OUT_OF_SAMPLES {
        return error;
    }
    let mut world = world();
    world.start = None;
    world.written = 0;
    0
}

unsafe extern "C" {
    fn poll(files: *mut c_void, count: c_ulong, milliseconds: c_int) -> c_int;
}

/// Replaces the system's clocks.
#[unsafe(no_mangle)]
unsafe extern "C" fn clock_gettime(_: c_int, time: *mut [i64; 2]) -> c_int {
    let now = world().now as i64;
    // SAFETY: the pointer is writable.
    unsafe { *time = [now / 1_000_000_000, now % 1_000_000_000] };
    0
}

/// Sleeps until a time of the monotonic clock, or for a duration.
#[unsafe(no_mangle)]
unsafe extern "C" fn clock_nanosleep(
    _: c_int,
    flags: c_int,
    until: *const [i64; 2],
    _: *mut c_void,
) -> c_int {
    const UNTIL: c_int = 1;
    // SAFETY: the caller passes a time.
    let [seconds, nanoseconds] = unsafe { *until };
    let time = (seconds * 1_000_000_000 + nanoseconds) as u64;
    let world = world();
    let start = if flags == UNTIL { 0 } else { world.now };
    let mut world = sleep(world, start + time);
    if world.now >= world.stop {
        // The program continues with this thread. The others wake up when it sleeps again.
        world.stop = u64::MAX;
        world.now += STOP;
    }
    0
}

const OUTPUT: c_int = 1;

/// Makes standard output the only terminal.
#[unsafe(no_mangle)]
extern "C" fn tcgetattr(file: c_int, _: *mut c_void) -> c_int {
    if file == OUTPUT { 0 } else { -1 }
}

/// Returns the size of the terminal: rows, columns, unknown pixels.
#[unsafe(no_mangle)]
unsafe extern "C" fn ioctl(_: c_int, _: c_ulong, size: *mut [u16; 4]) -> c_int {
    // SAFETY: the intro has no other request than TIOCGWINSZ.
    unsafe { *size = [12, 40, 0, 0] };
    0
}
