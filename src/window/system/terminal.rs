//! The terminal as a target for frames: two pixels in each cell, in 24-bit colour, in 256 colours (GNU screen), in ASCII with one
//! colour a cell (locales other than UTF-8), or as characters by brightness (terminals without colours).

use core::{
    cell::UnsafeCell,
    ffi::{CStr, c_int},
    mem::{MaybeUninit, zeroed},
    sync::atomic::{
        AtomicBool, AtomicI32,
        Ordering::{AcqRel, Acquire, Relaxed, Release},
    },
};

use libc::{
    SIGABRT, SIGBUS, SIGCHLD, SIGCONT, SIGFPE, SIGILL, SIGPIPE, SIGSEGV, SIGSYS, SIGTRAP, SIGTSTP,
    SIGTTIN, SIGTTOU, SIGURG, SIGWINCH,
};

use crate::{
    backend::memory::pixels,
    line::{self, Writer},
    render_target::{MAX_HEIGHT, MAX_WIDTH, Next, RenderTarget},
    system,
};

/// The upper half of a cell in the foreground colour; the lower half shows the background.
const UPPER_HALF: &str = "\u{2580}";

/// Characters by brightness, for terminals without colours.
const RAMP: &[u8; 10] = b" .:-=+*#%@";

const FOREGROUND: u64 = 38;
const BACKGROUND: u64 = 48;

const CLEAR: &str = "\x1b[0m\x1b[2J";

/// Switches to the alternate screen, hides the cursor, and disables wrapping at the right edge.
const ENTER: &[u8] = b"\x1b[?1049h\x1b[?25l\x1b[?7l\x1b[2J";

/// Reverts [`ENTER`] and resets the colours.
const LEAVE: &[u8] = b"\x1b[0m\x1b[?7h\x1b[?25h\x1b[?1049l";

/// Signals that do not end a process.
const HARMLESS: u64 =
    bits(&[SIGPIPE, SIGCHLD, SIGCONT, SIGTSTP, SIGTTIN, SIGTTOU, SIGURG, SIGWINCH]);

/// Signals of errors in the process, which cannot continue.
const MISTAKES: u64 = bits(&[SIGILL, SIGTRAP, SIGABRT, SIGBUS, SIGFPE, SIGSEGV, SIGSYS]);

/// Returns a set of signals. Bit 0 stands for signal 64.
const fn bits(signals: &[c_int]) -> u64 {
    let (mut set, mut i) = (0, 0);
    while i < signals.len() {
        set |= 1 << signals[i];
        i += 1;
    }
    set
}

/// The terminal on standard output, restored when this is dropped, when the process aborts, and after signals that end it.
pub struct Terminal {
    keys: KeyParser,
    pixels: &'static mut [u32],
    size: (usize, usize),
    shown: (usize, usize),
    has_colours: bool,
    /// 256 colours instead of 24 bits.
    is_coarse: bool,
    /// One colour a cell, in ASCII.
    is_plain: bool,
}

#[inline(never)]
fn variable(name: &CStr) -> &'static [u8] {
    // SAFETY: the environment is constant, and its values are strings.
    unsafe {
        let value = libc::getenv(name.as_ptr());
        if value.is_null() {
            return b"";
        }
        CStr::from_ptr(value).to_bytes()
    }
}

impl Terminal {
    /// Returns whether standard output is a terminal with colours or cursor positions, unlike `TERM=dumb`.
    #[must_use]
    #[inline(never)]
    pub fn is_there() -> bool {
        line::is_terminal(line::OUTPUT) && variable(c"TERM") != b"dumb"
    }

    /// The first variable that is not empty sets the locale.
    #[must_use]
    pub fn is_utf8() -> bool {
        for name in [c"LC_ALL", c"LC_CTYPE", c"LANG"] {
            let locale = variable(name);
            if !locale.is_empty() {
                let mut parts = locale.windows(3);
                return parts.any(|part| part.eq_ignore_ascii_case(b"utf"));
            }
        }
        false
    }

    #[must_use]
    pub fn open() -> Option<Terminal> {
        if !Terminal::is_there() {
            return None;
        }
        let pixels = pixels();
        let name = variable(c"TERM");
        let [screen, tmux] = [c"STY", c"TMUX"].map(|name| !variable(name).is_empty());
        const VT: u16 = u16::from_le_bytes(*b"vt");
        const VTE: u32 = u32::from_le_bytes(*b"\0vte");
        const M: u16 = u16::from_be_bytes(*b"-m");
        const MONO: u64 = u64::from_be_bytes(*b"-mono\0\0\0");
        const SCREEN: u64 = u64::from_le_bytes(*b"\0\0screen");
        const MUX: u32 = u32::from_le_bytes(*b"tmux");
        // Join the first characters from the lowest byte up, and the last ones from the highest byte down.
        let join = |word, &byte: &u8| word << 8 | u64::from(byte);
        let [start, end] = [name.iter().rev().fold(0, join), name.iter().fold(0, join)];
        // Monochrome are DEC's terminals such as `vt100`, unlike `vte`, and variants such as `xterm-mono` and `linux-m`.
        let is_dec = start as u16 == VT && (start as u32) << 8 != VTE;
        let has_colours = !(is_dec || end as u16 == M || end << 24 == MONO);
        // GNU screen misreads the parts of a 24-bit colour as commands; tmux, which may have the same TERM, converts colours.
        // Programs in GNU screen inherit COLORTERM from the outer terminal.
        let is_screen = screen || start << 16 == SCREEN && !tmux;
        let terminal = Terminal {
            keys: KeyParser::default(),
            pixels,
            size: (0, 0),
            shown: (0, 0),
            has_colours,
            is_coarse: is_screen && start as u32 != MUX,
            is_plain: !(has_colours & Terminal::is_utf8()),
        };
        SAVED.take_over();
        Some(terminal)
    }

    fn draw(&mut self) -> bool {
        let mut text = Writer::new(line::OUTPUT);
        if self.shown != self.size {
            text.text(CLEAR);
            self.shown = self.size;
        }
        let (width, height) = self.size;
        for row in 0..height / 2 {
            text.format("\x1b[#;1H", &[row as u64 + 1]);
            // No pixel has all bits set, so each row begins with its colours.
            let (mut foreground, mut background) = (u32::MAX, u32::MAX);
            for x in 0..width {
                let upper = self.pixels[2 * row * width + x];
                let lower = self.pixels[(2 * row + 1) * width + x];
                if self.is_plain {
                    let mean = (upper & lower) + ((upper ^ lower) >> 1 & 0x7f_7f7f);
                    self.set_cell(&mut text, &mut background, mean);
                    continue;
                }
                self.set_colour(&mut text, FOREGROUND, &mut foreground, upper);
                self.set_colour(&mut text, BACKGROUND, &mut background, lower);
                text.text(UPPER_HALF);
            }
        }
        text.flush()
    }

    fn set_cell(&self, text: &mut Writer, set: &mut u32, colour: u32) {
        if self.has_colours {
            self.set_colour(text, BACKGROUND, set, colour);
            text.text(" ");
        } else {
            let [_, red, green, blue] = colour.to_be_bytes().map(usize::from);
            let brightness = (2 * red + 5 * green + blue) * RAMP.len() / 2048;
            text.printable(&RAMP[brightness..=brightness]);
        }
    }

    #[inline(never)]
    fn set_colour(&self, text: &mut Writer, which: u64, set: &mut u32, colour: u32) {
        if *set == colour {
            return;
        }
        *set = colour;
        let [_, red, green, blue] = colour.to_be_bytes().map(u64::from);
        if self.is_coarse {
            text.format("\x1b[#;5;#m", &[which, coarse(colour)]);
        } else {
            text.format("\x1b[#;2;#;#;#m", &[which, red, green, blue]);
        }
    }
}

/// Returns the number of a similar colour: six levels for each channel, from 16 on.
fn coarse(colour: u32) -> u64 {
    let [_, channels @ ..] = colour.to_be_bytes();
    // The levels are 0, 95, 135, 175, 215 and 255.
    channels.iter().fold(0, |sum, channel| 6 * sum + u64::from(channel.saturating_sub(15) / 45))
        + 16
}

impl RenderTarget for Terminal {
    fn size(&self) -> (usize, usize) {
        // SAFETY: zero is valid for all fields, and the request writes to `size`.
        let size = unsafe {
            let mut size: libc::winsize = zeroed();
            libc::ioctl(line::OUTPUT, libc::TIOCGWINSZ, &raw mut size);
            size
        };
        // Some terminals report no size. The picture covers a part of an oversized one.
        let side = |size: u16, usual: usize, most: usize| match usize::from(size) {
            0 => usual,
            size => size.min(most),
        };
        (side(size.ws_col, 80, MAX_WIDTH), 2 * side(size.ws_row, 24, MAX_HEIGHT / 2))
    }

    fn canvas(&mut self, width: usize, height: usize) -> &mut [u32] {
        self.size = (width, height);
        &mut self.pixels[..width * height]
    }

    fn show(&mut self) -> Next {
        let drawn = self.draw();
        match signal() {
            // If the terminal does not read, the show continues without this frame.
            0 if !drawn && system::error() != libc::EAGAIN => Next::End(1),
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

/// Recognises Esc, Ctrl-C, Q and H. Sequences of many other keys begin with Esc, too.
#[derive(Default)]
struct KeyParser {
    /// The last byte was Esc, which may begin a sequence.
    open: bool,
    toggles: bool,
}

impl KeyParser {
    fn read(&mut self, keyboard: c_int) -> bool {
        let mut typed = [0; 64];
        let mut count = 0;
        // A shell may have left the terminal in a mode in which reading blocks.
        if system::is_ready(keyboard, libc::POLLIN, 0) {
            // SAFETY: `typed` has this length.
            count = unsafe { libc::read(keyboard, typed.as_mut_ptr().cast(), typed.len()) };
        }
        self.ends(typed.get(..count as usize).unwrap_or_default())
    }

    /// Returns true if these bytes end the show. Bytes that follow Esc immediately belong to it.
    fn ends(&mut self, typed: &[u8]) -> bool {
        const ESCAPE: u8 = 0x1b;
        const CONTROL_C: u8 = 0x03;
        // The keypad's 1 sends these bytes and `q`.
        const KEYPAD: u16 = u16::from_be_bytes(*b"\x1bO");
        // Esc and Ctrl-C in the protocols of Kitty and xterm for modified keys.
        const ESCAPE_U: u64 = u64::from_be_bytes(*b"\x1b[27u\0\0\0");
        const CONTROL_C_U: u64 = u64::from_be_bytes(*b"\x1b[99;5u\0");
        const CONTROL_C_TILDE: u64 = u64::from_be_bytes(*b"27;5;99~");
        let was_open = core::mem::replace(&mut self.open, typed.last() == Some(&ESCAPE));
        let mut is_end = was_open && !matches!(typed.first(), Some(b'[' | b'O'));
        let mut last = u64::from(if was_open { ESCAPE } else { 0 });
        for &byte in typed {
            let is_alone = last as u8 != ESCAPE;
            self.toggles ^= byte == b'h' && is_alone;
            is_end |= byte == b'q' && is_alone && last as u16 != KEYPAD;
            last = last << 8 | u64::from(byte);
            is_end |= byte == CONTROL_C
                || last << 24 == ESCAPE_U
                || last << 8 == CONTROL_C_U
                || last == CONTROL_C_TILDE;
        }
        is_end
    }
}

struct Saved {
    active: AtomicBool,
    /// One more than the descriptor of the keyboard's terminal, or 0.
    keyboard: AtomicI32,
    mode: UnsafeCell<MaybeUninit<libc::termios>>,
}

// SAFETY: `mode` is written before `active` is set, and only read afterwards.
unsafe impl Sync for Saved {}

static SAVED: Saved = Saved {
    active: AtomicBool::new(false),
    keyboard: AtomicI32::new(0),
    mode: UnsafeCell::new(MaybeUninit::uninit()),
};

static SIGNAL: AtomicI32 = AtomicI32::new(0);

/// The timeout of a blocked write in milliseconds: infinite (-1), or a second for a [`Terminal`].
static PATIENCE: AtomicI32 = AtomicI32::new(-1);

pub(crate) fn patience() -> c_int {
    PATIENCE.load(Relaxed)
}

/// Returns the signal that asked a process with a [`Terminal`] to end, or 0.
pub(crate) fn signal() -> c_int {
    SIGNAL.load(Relaxed)
}

extern "C" fn note(signal: c_int) {
    if MISTAKES >> (signal % 64) & 1 == 0 {
        SIGNAL.store(signal, Relaxed);
        return;
    }
    restore();
    // SAFETY: signal handlers may call both. The signal is delivered again when this handler has returned.
    unsafe {
        on_signal(signal, libc::SIG_DFL);
        libc::raise(signal);
    }
}

/// Sets a signal's action.
///
/// # Safety
/// The action has to be `SIG_IGN`, `SIG_DFL`, or a function that is async-signal-safe.
#[inline(never)]
pub(crate) unsafe fn on_signal(signal: c_int, action: libc::sighandler_t) {
    // SAFETY: zero is valid for all fields. Without SA_RESTART, signals interrupt blocked writes.
    unsafe {
        let mut change: libc::sigaction = zeroed();
        change.sa_sigaction = action;
        libc::sigaction(signal, &change, core::ptr::null_mut());
    }
}

pub(crate) fn mode(file: c_int) -> Option<libc::termios> {
    // SAFETY: zero is valid for all fields.
    let mut mode: libc::termios = unsafe { zeroed() };
    // SAFETY: `mode` is writable.
    let is_known = unsafe { libc::tcgetattr(file, &mut mode) } == 0;
    is_known.then_some(mode)
}

fn set_mode(file: c_int, mode: &libc::termios) {
    // SAFETY: the mode outlives the call.
    unsafe { libc::tcsetattr(file, libc::TCSAFLUSH, mode) };
}

impl Saved {
    fn keyboard(&self) -> c_int {
        self.keyboard.load(Acquire) - 1
    }

    fn take_over(&self) {
        // SAFETY: `note` is async-signal-safe. `mode` is written while `active` is not set.
        unsafe {
            // The last are real-time signals; invalid numbers are refused.
            for signal in (1..65).filter(|signal| HARMLESS >> (signal % 64) & 1 == 0) {
                on_signal(signal, note as extern "C" fn(c_int) as libc::sighandler_t);
            }
            PATIENCE.store(1000, Relaxed);
            system::never_wait(line::OUTPUT, c"/dev/stdout");
            if line::is_terminal(line::ERROR) {
                system::never_wait(line::ERROR, c"/dev/stderr");
            }
            let mut keyboard = libc::STDIN_FILENO;
            if !line::is_terminal(keyboard) {
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

    fn mode(&self) -> Option<libc::termios> {
        // SAFETY: `keyboard` is set after `mode`.
        (self.keyboard() >= 0).then(|| unsafe { (*self.mode.get()).assume_init() })
    }

    #[inline(never)]
    fn enter(&self) {
        if let Some(mut mode) = self.mode() {
            // Keys without delay and echo, including Ctrl-C.
            mode.c_lflag &= !(libc::ICANON | libc::ECHO | libc::ISIG | libc::IEXTEN);
            mode.c_iflag &= !libc::IXON;
            set_mode(self.keyboard(), &mode);
        }
        line::write(line::OUTPUT, ENTER);
    }
}

/// Takes the terminal over again after a stop. Async-signal-safe.
pub(crate) fn resume() {
    if SAVED.active.load(Acquire) {
        SAVED.enter();
    }
}

/// Restores the terminal, if it was taken over. Async-signal-safe.
#[inline(never)]
pub(crate) fn restore() {
    if SAVED.active.swap(false, AcqRel) {
        // A pending signal must not interrupt these writes.
        SIGNAL.store(0, Relaxed);
        line::write(line::OUTPUT, LEAVE);
        if let Some(mode) = SAVED.mode() {
            set_mode(SAVED.keyboard(), &mode);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::KeyParser;

    #[test]
    fn escape_and_q_end_show_and_sequences_do_not() {
        let endings: [&[&[u8]]; 11] = [
            &[b"q"],
            &[b"fwq"],
            &[b"\x1bOAq"],
            &[b"\x1b", b""],
            &[b"\x1b\x1b", b""],
            &[b"\x1b", b"x"],
            &[b"\x1b[A\x1b", b""],
            &[b"ab\x03"],
            &[b"x\x1b[A\x1b[27uy"],
            &[b"x\x1b[A\x1b[99;5uy"],
            &[b"x\x1b[A\x1b[27;5;99~y"],
        ];
        // Alt and a letter, the keypad's 1, other keys with modifiers, letters, an arrow and a function key, an arrow in two parts.
        let others: [&[&[u8]]; 8] = [
            &[b"\x1bx", b""],
            &[b"\x1bq", b""],
            &[b"\x1bOq", b""],
            &[b"\x1b", b"Oq", b""],
            &[b"\x1b[99u\x1b[27;5;98~\x1b[27~", b""],
            &[b"", b"fw", b""],
            &[b"\x1b[A\x1bOP", b""],
            &[b"\x1b", b"[A", b""],
        ];
        for (reads, expected) in
            endings.map(|reads| (reads, true)).into_iter().chain(others.map(|reads| (reads, false)))
        {
            let mut keys = KeyParser::default();
            assert_eq!(reads.iter().any(|typed| keys.ends(typed)), expected, "{reads:?}");
        }
    }

    #[test]
    fn h_toggles_numbers() {
        let toggles = |typed: &[u8]| {
            let mut keys = KeyParser::default();
            assert!(!keys.ends(typed));
            keys.toggles
        };
        assert!(toggles(b"h") && toggles(b"\x1b[Ah") && toggles(b"hfhh"));
        assert!(!toggles(b"f\x1b[H") && !toggles(b"hh"), "Home is no H");
    }
}
