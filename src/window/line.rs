//! Lines of text, without `format!` (whose machinery is 6 KB) and without std's buffers and locks.

use crate::{
    clock::{self, SECOND},
    system,
};

/// Standard output.
pub const OUTPUT: i32 = libc::STDOUT_FILENO;
/// Standard error.
pub const ERROR: i32 = libc::STDERR_FILENO;

/// Text of at most [`Line::CAPACITY`] bytes, put together piece by piece; what is beyond is cut off.
pub struct Line {
    bytes: [u8; Line::CAPACITY],
    length: usize,
}

impl Line {
    /// Bytes that a line can hold: what the [`terminal`](crate::terminal) writes at a time.
    pub const CAPACITY: usize = 1 << 13;

    /// An empty line.
    #[must_use]
    pub const fn new() -> Line {
        Line {
            bytes: [0; Line::CAPACITY],
            length: 0,
        }
    }

    /// Adds text.
    pub fn text(&mut self, text: &str) -> &mut Line {
        self.add(text.as_bytes())
    }

    /// Adds what somebody typed: what isn't printable ASCII becomes `?`.
    pub fn quote(&mut self, typed: &[u8]) -> &mut Line {
        for &byte in typed {
            let printable = byte == b' ' || byte.is_ascii_graphic();
            self.add(&[if printable { byte } else { b'?' }]);
        }
        self
    }

    /// Adds text in which the bytes 0, 1 and 2 stand for the values, in their order, with so many digits after the point.
    pub fn form(&mut self, text: &str, values: &[u64]) -> &mut Line {
        let mut values = values.iter();
        for &byte in text.as_bytes() {
            match values.as_slice().first() {
                Some(&value) if byte < 3 => {
                    values.next();
                    self.decimal(value, byte.into());
                }
                _ => {
                    self.add(&[byte]);
                }
            }
        }
        self
    }

    /// Adds a number that counts units of `10^-digits`: `decimal(2513, 2)` adds `25.13`.
    pub fn decimal(&mut self, number: u64, digits: i32) {
        if digits > 0 || number >= 10 {
            self.decimal(number / 10, digits - 1);
        }
        if digits == 1 {
            self.add(b".");
        }
        self.add(&[b'0' + (number % 10) as u8]);
    }

    /// Takes all of it out.
    pub(crate) fn clear(&mut self) {
        self.length = 0;
    }

    /// The bytes so far.
    #[must_use]
    pub fn bytes(&self) -> &[u8] {
        self.bytes.get(..self.length).unwrap_or_default()
    }

    /// Adds bytes.
    pub(crate) fn add(&mut self, bytes: &[u8]) -> &mut Line {
        for &byte in bytes {
            if let Some(end) = self.bytes.get_mut(self.length) {
                *end = byte;
                self.length += 1;
            }
        }
        self
    }
}

impl Default for Line {
    fn default() -> Line {
        Line::new()
    }
}

/// Whether a file descriptor is a terminal.
#[must_use]
pub fn terminal(file: i32) -> bool {
    crate::terminal::mode(file).is_some()
}

/// Writes everything to standard output. Where that fails, says so on standard error and returns false.
pub fn print(bytes: &[u8]) -> bool {
    let written = write(OUTPUT, bytes);
    if !written {
        write(ERROR, b"eightfold: can't write to standard output\n");
    }
    written
}

/// Writes everything to a file descriptor, waiting while it is full. False if that fails, or if a
/// signal that ends the program arrives meanwhile.
pub fn write(file: i32, mut bytes: &[u8]) -> bool {
    while !bytes.is_empty() {
        let written = system::write(file, bytes);
        if written > 0 {
            bytes = &bytes[written as usize..];
            continue;
        }
        // SAFETY: errno is this thread's own.
        match unsafe { *libc::__errno_location() } {
            libc::EINTR | libc::EAGAIN if crate::terminal::signal() == 0 => {
                clock::sleep(SECOND / 1000);
            }
            _ => return false,
        }
    }
    true
}

#[cfg(test)]
mod tests {
    use super::Line;

    #[test]
    fn numbers_have_the_digits_asked_for() {
        let text = |number, digits| {
            let mut line = Line::new();
            line.decimal(number, digits);
            String::from_utf8(line.bytes().to_vec()).unwrap()
        };
        assert_eq!(text(0, 0), "0");
        assert_eq!(text(7, 0), "7");
        assert_eq!(text(1230, 0), "1230");
        assert_eq!(text(0, 2), "0.00");
        assert_eq!(text(7, 2), "0.07");
        assert_eq!(text(123, 2), "1.23");
        assert_eq!(text(2513, 2), "25.13");
        assert_eq!(text(u64::MAX, 1), "1844674407370955161.5");
    }

    #[test]
    fn values_are_where_the_form_has_them() {
        let mut line = Line::new();
        line.form("\0 in \u{2} s: \u{1} fps\n", &[60, 101, 594]);
        assert_eq!(line.bytes(), b"60 in 1.01 s: 59.4 fps\n");
    }

    #[test]
    fn what_does_not_fit_is_cut_off() {
        let mut line = Line::new();
        line.text(&"x".repeat(Line::CAPACITY + 1))
            .text("y")
            .form("\0", &[1]);
        assert_eq!(line.bytes(), "x".repeat(Line::CAPACITY).as_bytes());
    }

    #[test]
    fn what_was_typed_can_not_steer_a_terminal() {
        let mut line = Line::new();
        line.quote(b"a b\x1b[2J\xff\n");
        assert_eq!(line.bytes(), b"a b?[2J??");
    }
}
