//! The terminal as a screen: two pixels in each cell, above each other, in 24-bit colour, or in 256 colours by GNU screen.

use core::{
    cell::UnsafeCell,
    ffi::{CStr, c_int},
    fmt::{self, Write},
    mem::{MaybeUninit, zeroed},
    sync::atomic::{
        AtomicBool, AtomicI32,
        Ordering::{AcqRel, Acquire, Relaxed, Release},
    },
};

use crate::{
    backend::memory::pixels,
    line::{self, Decimal, Text, Writer},
    screen::{Next, Screen},
    system,
};

/// The upper half of a cell in the foreground's colour; the lower half shows the background's.
const UPPER_HALF: &str = "\u{2580}";

/// The code that a foreground colour begins with.
const FOREGROUND: &str = "38";
/// The code that a background colour begins with.
const BACKGROUND: &str = "48";

/// Resets the colours and clears the screen.
const CLEAR: &str = "\x1b[0m\x1b[2J";

/// Takes the alternate screen, hides the cursor, and does not wrap at the right edge.
const ENTER: &[u8] = b"\x1b[?1049h\x1b[?25l\x1b[?7l\x1b[2J";

/// Undoes [`ENTER`], and the colours.
const LEAVE: &[u8] = b"\x1b[0m\x1b[?7h\x1b[?25h\x1b[?1049l";

/// The signals that end no process: what it does with them stays as it is. No process can heed SIGKILL and SIGSTOP.
const HARMLESS: u64 = bits(&[
    libc::SIGPIPE,
    libc::SIGCHLD,
    libc::SIGCONT,
    libc::SIGTSTP,
    libc::SIGTTIN,
    libc::SIGTTOU,
    libc::SIGURG,
    libc::SIGWINCH,
    #[cfg(not(target_os = "linux"))]
    libc::SIGINFO,
]);

/// The signals of a process's own mistakes, which it can't go on after.
const MISTAKES: u64 = bits(&[
    libc::SIGILL,
    libc::SIGTRAP,
    libc::SIGABRT,
    libc::SIGBUS,
    libc::SIGFPE,
    libc::SIGSEGV,
    libc::SIGSYS,
]);

/// A set of signals, a bit for each from 1 on.
const fn bits(signals: &[c_int]) -> u64 {
    let (mut set, mut i) = (0, 0);
    while i < signals.len() {
        set |= 1 << (signals[i] - 1);
        i += 1;
    }
    set
}

/// The most cells beside each other and above each other that are drawn on: the pixels of the largest frame.
const MOST_COLUMNS: usize = 3840;
const MOST_ROWS: usize = 2160 / 2;

/// The terminal on standard output. Esc and Ctrl-C end the show, H is for numbers over the picture.
///
/// It is given back as it was when this is dropped, when the process aborts, and after the signals
/// that ask a process to end.
pub struct Terminal {
    keys: Keys,
    pixels: &'static mut [u32],
    size: (usize, usize),
    shown: (usize, usize),
    /// Whether it has 256 colours only.
    is_coarse: bool,
}

/// A variable of the environment.
fn variable(name: &CStr) -> Option<&'static CStr> {
    // SAFETY: nobody changes the environment; what is there is a string.
    unsafe {
        let value = libc::getenv(name.as_ptr());
        (!value.is_null()).then(|| CStr::from_ptr(value))
    }
}

impl Terminal {
    /// Whether standard output is a terminal that [`Terminal::open`] takes over: one that says of itself that it knows no colours
    /// and no places is none.
    #[must_use]
    pub fn is_there() -> bool {
        line::terminal(line::OUTPUT) && variable(c"TERM") != Some(c"dumb")
    }

    /// Takes over the terminal on standard output, if there is one.
    #[must_use]
    pub fn open() -> Option<Terminal> {
        if !Terminal::is_there() {
            return None;
        }
        let terminal = Terminal {
            keys: Keys::default(),
            pixels: pixels(),
            size: (0, 0),
            shown: (0, 0),
            // GNU screen, unless it says otherwise, takes the parts of a colour of 24 bits for commands.
            is_coarse: variable(c"STY").is_some() && variable(c"COLORTERM").is_none(),
        };
        SAVED.take_over();
        Some(terminal)
    }

    /// Writes the picture.
    fn draw(&mut self) -> fmt::Result {
        let mut text = Writer::new(line::OUTPUT);
        if self.shown != self.size {
            text.write_str(CLEAR)?;
            self.shown = self.size;
        }
        let (width, height) = self.size;
        for row in 0..height / 2 {
            write!(text, "\x1b[{};1H", Decimal(row as u64 + 1))?;
            // The colours of the last cell; no pixel has one with all bits set, so each row begins with its own.
            let (mut foreground, mut background) = (u32::MAX, u32::MAX);
            for x in 0..width {
                let upper = self.pixels[2 * row * width + x];
                let lower = self.pixels[(2 * row + 1) * width + x];
                self.set_colour(&mut text, FOREGROUND, &mut foreground, upper)?;
                self.set_colour(&mut text, BACKGROUND, &mut background, lower)?;
                text.write_str(UPPER_HALF)?;
            }
        }
        text.flush()
    }

    /// Sets a colour of the cells that follow, unless it is set already.
    fn set_colour(
        &self,
        text: &mut Writer,
        which: &str,
        set: &mut u32,
        colour: u32,
    ) -> fmt::Result {
        if *set == colour {
            return Ok(());
        }
        *set = colour;
        let which = Text(which);
        if self.is_coarse {
            return write!(text, "\x1b[{which};5;{}m", Decimal(coarse(colour)));
        }
        let [_, red, green, blue] = colour.to_be_bytes().map(|channel| Decimal(channel.into()));
        write!(text, "\x1b[{which};2;{red};{green};{blue}m")
    }
}

/// Returns the number of the nearest of 256 colours: those from 16 on have six steps of each channel.
fn coarse(colour: u32) -> u64 {
    let [_, channels @ ..] = colour.to_be_bytes();
    // The steps are 0, 95, 135, 175, 215 and 255.
    channels.iter().fold(0, |sum, channel| {
        6 * sum + u64::from(channel.saturating_sub(15) / 45)
    }) + 16
}

impl Screen for Terminal {
    fn size(&self) -> (usize, usize) {
        // SAFETY: zero is a value of every field, and `size` is what this request writes to.
        let size = unsafe {
            let mut size: libc::winsize = zeroed();
            libc::ioctl(line::OUTPUT, libc::TIOCGWINSZ, &raw mut size);
            size
        };
        // Some say nothing of their size. Of one that is larger than any screen, a part is drawn on.
        let side = |size: u16, usual: usize, most: usize| match usize::from(size) {
            0 => usual,
            size => size.min(most),
        };
        (
            side(size.ws_col, 80, MOST_COLUMNS),
            2 * side(size.ws_row, 24, MOST_ROWS),
        )
    }

    fn canvas(&mut self, width: usize, height: usize) -> &mut [u32] {
        self.size = (width, height);
        &mut self.pixels[..width * height]
    }

    fn show(&mut self) -> Next {
        let drawn = self.draw();
        match signal() {
            // Where nobody reads, a later frame may find room; the show goes on meanwhile, to its end.
            0 if drawn.is_err() && system::error() != libc::EAGAIN => Next::End(1),
            0 if self.keys.read(SAVED.keyboard()) => Next::End(0),
            0 if core::mem::take(&mut self.keys.toggles) => Next::Toggle,
            0 => Next::GoOn,
            signal => Next::End(128 + signal),
        }
    }
}

impl Drop for Terminal {
    fn drop(&mut self) {
        restore();
    }
}

/// Tells Esc, Ctrl-C and H from other keys: many send sequences that begin like Esc, and so do those that are pressed with Alt.
#[derive(Default)]
struct Keys {
    /// An Esc was the last that came. What it is shows when something follows, or nothing.
    open: bool,
    /// H came an odd number of times.
    toggles: bool,
}

impl Keys {
    /// Reads what was typed. True if it means the end.
    fn read(&mut self, keyboard: c_int) -> bool {
        let mut typed = [0; 64];
        let mut count = 0;
        // A shell that had the terminal meanwhile may have left it in a mode in which reading waits.
        if system::is_ready(keyboard, libc::POLLIN, 0) {
            // SAFETY: it is as long as it says.
            count = unsafe { libc::read(keyboard, typed.as_mut_ptr().cast(), typed.len()) };
        }
        self.ends(typed.get(..count as usize).unwrap_or_default())
    }

    /// Whether what was typed since the last call means the end. What follows an Esc at once belongs to it.
    fn ends(&mut self, typed: &[u8]) -> bool {
        const ESCAPE: u8 = 0x1b;
        const CONTROL_C: u8 = 0x03;
        // Esc and Ctrl-C where Kitty and xterm write keys with modifiers as numbers.
        const ESCAPE_U: u64 = u64::from_be_bytes(*b"\x1b[27u\0\0\0");
        const CONTROL_C_U: u64 = u64::from_be_bytes(*b"\x1b[99;5u\0");
        const CONTROL_C_TILDE: u64 = u64::from_be_bytes(*b"27;5;99~");
        let was_open = core::mem::replace(&mut self.open, typed.last() == Some(&ESCAPE));
        let mut is_end = was_open && !matches!(typed.first(), Some(b'[' | b'O'));
        // The last eight bytes.
        let mut last = 0;
        for &byte in typed {
            self.toggles ^= byte == b'h' && last as u8 != ESCAPE;
            last = last << 8 | u64::from(byte);
            is_end |= byte == CONTROL_C
                || last << 24 == ESCAPE_U
                || last << 8 == CONTROL_C_U
                || last == CONTROL_C_TILDE;
        }
        is_end
    }
}

/// The settings that have to be put back when the show ends.
struct Saved {
    active: AtomicBool,
    /// One more than the number of the terminal that keys are read from, or 0.
    keyboard: AtomicI32,
    mode: UnsafeCell<MaybeUninit<libc::termios>>,
}

// SAFETY: `mode` is written before `active` is set, and only read while it is.
unsafe impl Sync for Saved {}

static SAVED: Saved = Saved {
    active: AtomicBool::new(false),
    keyboard: AtomicI32::new(0),
    mode: UnsafeCell::new(MaybeUninit::uninit()),
};

/// The last signal that asked the process to end.
static SIGNAL: AtomicI32 = AtomicI32::new(0);

/// Milliseconds that writing waits for room: without end as long as there is no [`Terminal`], for which it is a second.
static PATIENCE: AtomicI32 = AtomicI32::new(-1);

/// See [`PATIENCE`].
pub(crate) fn patience() -> c_int {
    PATIENCE.load(Relaxed)
}

/// The signal that asked a process with a [`Terminal`] to end, or 0.
pub(crate) fn signal() -> c_int {
    SIGNAL.load(Relaxed)
}

/// Handles a signal that ends a process.
extern "C" fn note(signal: c_int) {
    if MISTAKES >> (signal - 1) & 1 == 0 {
        SIGNAL.store(signal, Relaxed);
        return;
    }
    restore();
    // SAFETY: both may be called in a signal's function. The signal comes again when this one has returned.
    unsafe {
        on_signal(signal, libc::SIG_DFL);
        libc::raise(signal);
    }
}

/// Sets what is done on a signal: a function that does no more than it may there, `SIG_IGN` or `SIG_DFL`.
///
/// # Safety
/// The action has to be one of these.
pub(crate) unsafe fn on_signal(signal: c_int, action: libc::sighandler_t) {
    // SAFETY: zero is a value of every field. Without SA_RESTART, a write that waits returns.
    unsafe {
        let mut change: libc::sigaction = zeroed();
        change.sa_sigaction = action;
        libc::sigaction(signal, &change, core::ptr::null_mut());
    }
}

/// A terminal's mode, if it is a terminal.
pub(crate) fn mode(file: c_int) -> Option<libc::termios> {
    // SAFETY: zero is a value of every field.
    let mut mode: libc::termios = unsafe { zeroed() };
    // SAFETY: the mode is there to be written to.
    let is_known = unsafe { libc::tcgetattr(file, &mut mode) } == 0;
    is_known.then_some(mode)
}

/// Sets a terminal's mode when all has been written, and drops what has been typed.
fn set_mode(file: c_int, mode: &libc::termios) {
    // SAFETY: the mode outlives the call.
    unsafe { libc::tcsetattr(file, libc::TCSAFLUSH, mode) };
}

impl Saved {
    /// The terminal that keys are read from, or -1.
    fn keyboard(&self) -> c_int {
        self.keyboard.load(Acquire) - 1
    }

    fn take_over(&self) {
        // SAFETY: zero is a value of every field of the structures, which outlive the calls; `note`
        // does only what a signal's function may. `mode` is written while `active` isn't set.
        unsafe {
            // The last ones are those of real time; what is none is refused.
            for signal in (1..=64).filter(|signal| HARMLESS >> (signal - 1) & 1 == 0) {
                on_signal(signal, note as extern "C" fn(c_int) as libc::sighandler_t);
            }
            PATIENCE.store(1000, Relaxed);
            system::never_wait(line::OUTPUT, c"/dev/stdout");
            if line::terminal(line::ERROR) {
                system::never_wait(line::ERROR, c"/dev/stderr");
            }
            let mut keyboard = libc::STDIN_FILENO;
            if !line::terminal(keyboard) {
                keyboard = system::open(c"/dev/tty");
            }
            if let Some(mode) = mode(keyboard) {
                (*self.mode.get()).write(mode);
                self.keyboard.store(keyboard + 1, Relaxed);
            }
        }
        self.active.store(true, Release);
        self.enter();
    }

    /// The terminal's mode before it was taken, once that is known.
    fn mode(&self) -> Option<libc::termios> {
        // SAFETY: there is a keyboard only once `mode` has been written.
        (self.keyboard() >= 0).then(|| unsafe { (*self.mode.get()).assume_init() })
    }

    /// Sets the terminal's mode and takes its alternate screen.
    fn enter(&self) {
        if let Some(mut mode) = self.mode() {
            // Keys at once and unseen, Ctrl-C among them.
            mode.c_lflag &= !(libc::ICANON | libc::ECHO | libc::ISIG | libc::IEXTEN);
            mode.c_iflag &= !libc::IXON;
            set_mode(self.keyboard(), &mode);
        }
        line::write(line::OUTPUT, ENTER);
    }
}

/// Takes the terminal again after a stop, if it was taken: meanwhile a shell had it, in a mode of its own. A signal's function
/// may call it.
pub(crate) fn resume() {
    if SAVED.active.load(Acquire) {
        SAVED.enter();
    }
}

/// Gives the terminal back as it was, if it was taken. A signal's function may call it.
pub(crate) fn restore() {
    if SAVED.active.swap(false, AcqRel) {
        // What asked for the end has been heard, and does not keep this from being written.
        SIGNAL.store(0, Relaxed);
        line::write(line::OUTPUT, LEAVE);
        if let Some(mode) = SAVED.mode() {
            set_mode(SAVED.keyboard(), &mode);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Keys;

    #[test]
    fn escape_ends_and_sequences_do_not() {
        let ends = |reads: &[&[u8]]| {
            let mut keys = Keys::default();
            reads.iter().any(|typed| keys.ends(typed))
        };
        assert!(ends(&[b"\x1b", b""]), "Esc, and nothing after it");
        assert!(ends(&[b"\x1b\x1b", b""]), "Esc twice");
        assert!(ends(&[b"\x1b", b"x"]), "Esc, and a letter later");
        assert!(!ends(&[b"\x1bx", b""]), "Alt and a letter");
        assert!(ends(&[b"ab\x03"]), "Ctrl-C");
        for sequence in ["27u", "99;5u", "27;5;99~"] {
            let typed = ["x\x1b[A\x1b[", sequence, "y"].concat();
            assert!(ends(&[typed.as_bytes()]), "{sequence}");
        }
        assert!(!ends(&[b"\x1b[99u\x1b[27;5;98~\x1b[27~", b""]), "others");
        assert!(ends(&[b"\x1b[A\x1b", b""]), "an arrow, and Esc");
        assert!(!ends(&[b"", b"fw", b""]), "letters");
        assert!(
            !ends(&[b"\x1b[A\x1bOP", b""]),
            "an arrow and a function key"
        );
        assert!(
            !ends(&[b"\x1b", b"[A", b""]),
            "an arrow that comes in two parts"
        );
    }

    #[test]
    fn h_is_heard_and_twice_is_as_good_as_never() {
        let toggles = |typed: &[u8]| {
            let mut keys = Keys::default();
            assert!(!keys.ends(typed));
            keys.toggles
        };
        assert!(toggles(b"h") && toggles(b"\x1b[Ah") && toggles(b"hfhh"));
        assert!(!toggles(b"f\x1b[H") && !toggles(b"hh"), "Home is no H");
    }
}
