//! The terminal as a target for frames, see `docs/intro.md`.

mod keys;
mod mode;

use core::ffi::CStr;
use core::mem::{take, zeroed};
use core::sync::atomic::Ordering::Relaxed;

use keys::KeyParser;
use mode::SAVED;
pub(crate) use mode::{PATIENCE, SIGNAL, mode, on_signal, restore, resume};

use crate::backend::memory::pixels;
use crate::line::{self, Writer};
use crate::render_target::{MAX_HEIGHT, MAX_WIDTH, Next, RenderTarget};
use crate::system;

/// The upper half of a cell in the foreground colour; the lower half shows the background.
const UPPER_HALF: &str = "\u{2580}";

/// Characters by brightness, for terminals without colours.
const RAMP: &[u8; 10] = b" .:-=+*#%@";

const FOREGROUND: u64 = 38;
const BACKGROUND: u64 = 48;

const CLEAR: &str = "\x1b[0m\x1b[2J";

/// The terminal on standard output, restored when this is dropped and when the process ends.
pub struct Terminal {
    keys: KeyParser,
    pixels: &'static mut [u32],
    size: (usize, usize),
    last_size: (usize, usize),
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
    /// Returns whether standard output is a terminal with colours or cursor positions, unlike
    /// `TERM=dumb`.
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
        let [vt, vte, mux, gnu] =
            ["vt", "vte", "tmux", "screen"].map(|start| name.starts_with(start.as_bytes()));
        // Monochrome are DEC's terminals such as `vt100`, unlike `vte`, and variants such as
        // `xterm-mono` and `linux-m`.
        let has_colours = !(vt && !vte || name.ends_with(b"-m") || name.ends_with(b"-mono"));
        // GNU screen misreads the parts of a 24-bit colour as commands; tmux, which may have the
        // same TERM, converts colours. Programs in GNU screen inherit COLORTERM from the outer
        // terminal.
        let is_screen = screen || gnu && !tmux;
        let terminal = Terminal {
            keys: KeyParser::default(),
            pixels,
            size: (0, 0),
            last_size: (0, 0),
            has_colours,
            is_coarse: is_screen && !mux,
            is_plain: !(has_colours & Terminal::is_utf8()),
        };
        SAVED.take_over();
        Some(terminal)
    }

    fn draw(&mut self) -> bool {
        let mut text = Writer::new(line::OUTPUT);
        if self.last_size != self.size {
            text.text(CLEAR);
            self.last_size = self.size;
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
        let side = |size: u16, usual: usize, max: usize| match usize::from(size) {
            0 => usual,
            size => size.min(max),
        };
        (side(size.ws_col, 80, MAX_WIDTH), 2 * side(size.ws_row, 24, MAX_HEIGHT / 2))
    }

    fn canvas(&mut self, width: usize, height: usize) -> &mut [u32] {
        self.size = (width, height);
        &mut self.pixels[..width * height]
    }

    fn show(&mut self) -> Next {
        let drawn = self.draw();
        match SIGNAL.load(Relaxed) {
            // If the terminal does not read, the show continues without this frame.
            0 if !drawn && system::error() != libc::EAGAIN => Next::End(1),
            0 if self.keys.read(SAVED.keyboard()) => Next::End(0),
            0 if take(&mut self.keys.toggles) => Next::Toggle,
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
