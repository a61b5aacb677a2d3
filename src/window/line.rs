//! Lines of text, without `format!` (whose machinery is 6 KB) and without std's buffers and locks.

use crate::{
    clock::{self, SECOND},
    system,
};

/// Standard output.
pub const OUTPUT: i32 = libc::STDOUT_FILENO;
/// Standard error.
pub const ERROR: i32 = libc::STDERR_FILENO;

/// Text for a file, put together piece by piece and written by so many bytes at a time.
pub struct Line {
    file: i32,
    written: bool,
    length: usize,
    bytes: [u8; 1024],
}

impl Line {
    /// An empty one for a file descriptor.
    #[must_use]
    pub const fn to(file: i32) -> Line {
        Line {
            file,
            written: true,
            length: 0,
            bytes: [0; _],
        }
    }

    /// Adds text in which the bytes 0, 1 and 2 stand for the numbers, in their order, with so many digits after the point,
    /// and the bytes 3 for the words, of which somebody may have typed any: what isn't printable ASCII becomes `?`.
    pub fn form(&mut self, text: &str, numbers: &[u64], words: &[&[u8]]) -> &mut Line {
        let mut numbers = numbers.iter();
        let mut words = words.iter();
        for &byte in text.as_bytes() {
            if byte < 3 {
                self.decimal(*numbers.next().unwrap_or(&u64::MAX), byte.into());
            } else if byte == 3 {
                for &byte in *words.next().unwrap_or(&&[][..]) {
                    let printable = byte == b' ' || byte.is_ascii_graphic();
                    self.add(if printable { byte } else { b'?' });
                }
            } else {
                self.add(byte);
            }
        }
        self
    }

    /// Adds a number that counts units of `10^-digits`: `decimal(2513, 2)` adds `25.13`.
    #[inline(never)]
    fn decimal(&mut self, number: u64, digits: i32) {
        if digits > 0 || number >= 10 {
            self.decimal(number / 10, digits - 1);
        }
        if digits == 1 {
            self.add(b'.');
        }
        self.add(b'0' + (number % 10) as u8);
    }

    /// Adds a byte.
    #[inline(never)]
    fn add(&mut self, byte: u8) {
        if self.length == self.bytes.len() {
            self.flush();
        }
        if let Some(end) = self.bytes.get_mut(self.length) {
            *end = byte;
            self.length += 1;
        }
    }

    /// Writes what is left. False if that fails, or has failed.
    #[inline(never)]
    pub fn flush(&mut self) -> bool {
        let bytes = self.bytes.get(..self.length).unwrap_or_default();
        self.written = self.written && write(self.file, bytes);
        self.length = 0;
        self.written
    }
}

/// Writes a [form](Line::form) to standard error.
pub fn complain(text: &str, words: &[&[u8]]) {
    Line::to(ERROR).form(text, &[], words).flush();
}

/// Whether a file descriptor is a terminal.
#[must_use]
pub fn terminal(file: i32) -> bool {
    crate::terminal::mode(file).is_some()
}

/// Says on standard error if standard output could not be written to. Returns whether it could.
pub fn printed(written: bool) -> bool {
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
            bytes = bytes.get(written as usize..).unwrap_or_default();
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
    use std::{
        io::{Read, pipe},
        os::fd::AsRawFd,
        string::String,
    };

    /// What a line writes.
    fn text(fill: impl FnOnce(&mut Line)) -> String {
        let (mut read, write) = pipe().unwrap();
        let mut line = Line::to(write.as_raw_fd());
        fill(&mut line);
        assert!(line.flush());
        drop(write);
        let mut text = String::new();
        read.read_to_string(&mut text).unwrap();
        text
    }

    #[test]
    fn numbers_have_the_digits_asked_for() {
        for (number, digits, expected) in [
            (0, 0, "0"),
            (7, 0, "7"),
            (1230, 0, "1230"),
            (0, 2, "0.00"),
            (7, 2, "0.07"),
            (123, 2, "1.23"),
            (2513, 2, "25.13"),
            (u64::MAX, 1, "1844674407370955161.5"),
        ] {
            assert_eq!(text(|line| line.decimal(number, digits)), expected);
        }
    }

    #[test]
    fn values_are_where_the_form_has_them() {
        let said = text(|line| {
            let form = "\0 \u{3} in \u{2} s: \u{1} fps\n";
            line.form(form, &[60, 101, 594], &[b"frames"]);
        });
        assert_eq!(said, "60 frames in 1.01 s: 59.4 fps\n");
    }

    #[test]
    fn nothing_is_cut_off() {
        let long = "x".repeat(5000);
        let said = text(|line| {
            line.form(&long, &[], &[]).form("y\0", &[1], &[]);
        });
        assert_eq!(said, long + "y1");
    }

    #[test]
    fn what_was_typed_can_not_steer_a_terminal() {
        let said = text(|line| {
            line.form("\u{3}", &[], &[b"a b\x1b[2J\xff\n"]);
        });
        assert_eq!(said, "a b?[2J??");
    }

    #[test]
    fn a_closed_file_is_told() {
        let (read, write) = pipe().unwrap();
        drop(read);
        // (Rust's programs ignore the signal for this.)
        let mut line = Line::to(write.as_raw_fd());
        line.form("x", &[], &[]);
        assert!(!line.flush() && !line.flush());
    }
}
