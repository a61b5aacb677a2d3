//! Text on standard output and standard error.
//!
//! `write!` and `format_args!` format values as usual. This module replaces only std's I/O, with its locks and error messages.

use core::fmt::{self, Arguments, Display, Formatter, Write};

use crate::system;
pub use crate::system::{ERROR, OUTPUT, write};

/// A buffered writer to a file descriptor.
///
/// It writes when its buffer is full and when it is [flushed](Writer::flush), but not when it is dropped. After an error it writes
/// nothing more, and every call returns the error again.
pub struct Writer {
    file: i32,
    has_failed: bool,
    length: usize,
    buffer: [u8; 1024],
}

impl Writer {
    /// Creates a writer to an open file descriptor, which stays open.
    #[must_use]
    pub const fn new(file: i32) -> Writer {
        Writer {
            file,
            has_failed: false,
            length: 0,
            buffer: [0; _],
        }
    }

    /// Writes the buffered bytes.
    ///
    /// # Errors
    /// If this or an earlier write failed.
    pub fn flush(&mut self) -> fmt::Result {
        let is_written = !self.has_failed && write(self.file, &self.buffer[..self.length]);
        self.has_failed = !is_written;
        self.length = 0;
        if is_written { Ok(()) } else { Err(fmt::Error) }
    }
}

impl Write for Writer {
    fn write_str(&mut self, text: &str) -> fmt::Result {
        let mut rest = text.as_bytes();
        while !rest.is_empty() {
            if self.length == self.buffer.len() {
                self.flush()?;
            }
            let room = &mut self.buffer[self.length..];
            let (fitting, later) = rest.split_at(rest.len().min(room.len()));
            room[..fitting.len()].copy_from_slice(fitting);
            self.length += fitting.len();
            rest = later;
        }
        Ok(())
    }
}

/// An integer in decimal. The integers' own `Display`, with padding, alignment and sign, takes 628 more packed bytes.
pub struct Decimal(pub u64);

impl Display for Decimal {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        if self.0 >= 10 {
            Decimal(self.0 / 10).fmt(f)?;
        }
        f.write_char(char::from(b'0' + (self.0 % 10) as u8))
    }
}

/// Tenths, shown with one decimal: 594 as `59.4`.
pub struct Tenths(pub u64);

impl Display for Tenths {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        write!(f, "{}.{}", Decimal(self.0 / 10), Decimal(self.0 % 10))
    }
}

/// Hundredths, shown with two decimals: 101 as `1.01`.
pub struct Hundredths(pub u64);

impl Display for Hundredths {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        write!(f, "{}{}", Tenths(self.0 / 10), Decimal(self.0 % 10))
    }
}

/// Text without padding. `str`'s own `Display` takes 364 more packed bytes.
pub struct Text<'a>(pub &'a str);

impl Display for Text<'_> {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        f.write_str(self.0)
    }
}

/// Bytes from the user, made harmless to a terminal: `?` for everything except printable ASCII, at most 60.
pub struct Printable<'a>(pub &'a [u8]);

impl Display for Printable<'_> {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        for &byte in self.0.iter().take(60) {
            let is_printable = byte == b' ' || byte.is_ascii_graphic();
            f.write_char(if is_printable { byte.into() } else { '?' })?;
        }
        Ok(())
    }
}

/// Returns bytes as text if they are ASCII.
#[must_use]
pub fn ascii(bytes: &[u8]) -> Option<&str> {
    // `[u8]::is_ascii`, which is faster, takes 267 more packed bytes.
    let is_ascii = bytes.iter().all(u8::is_ascii);
    // SAFETY: ASCII is UTF-8.
    is_ascii.then(|| unsafe { str::from_utf8_unchecked(bytes) })
}

/// Writes the program's name and a message to standard error.
///
/// Ignores errors, which it could not report.
pub fn complain(message: Arguments<'_>) {
    let mut errors = Writer::new(ERROR);
    let _ = writeln!(errors, "eightfold: {message}").and_then(|()| errors.flush());
}

/// Returns whether a standard stream is a terminal.
#[must_use]
pub fn terminal(file: i32) -> bool {
    system::is_terminal(file)
}

#[cfg(test)]
mod tests {
    use super::{Hundredths, Printable, Tenths, Writer};
    use core::fmt::{self, Write};
    use std::{
        format,
        io::{Read, pipe},
        os::fd::AsRawFd,
        string::String,
    };

    #[test]
    fn decimals_keep_leading_zeros() {
        for (hundredths, expected) in [(0, "0.00"), (7, "0.07"), (123, "1.23"), (2513, "25.13")] {
            assert_eq!(format!("{}", Hundredths(hundredths)), expected);
        }
        assert_eq!(format!("{}", Tenths(0)), "0.0");
        assert_eq!(format!("{}", Tenths(u64::MAX)), "1844674407370955161.5");
    }

    #[test]
    fn printable_replaces_control_bytes() {
        let shown = format!("{}", Printable(b"a b\x1b[2J\xff\n"));
        assert_eq!(shown, "a b?[2J??");
    }

    #[test]
    fn text_longer_than_buffer_is_written() {
        let (mut read, write) = pipe().unwrap();
        let mut writer = Writer::new(write.as_raw_fd());
        let long = "x".repeat(5000);
        write!(writer, "{long}y{}", 1).unwrap();
        writer.flush().unwrap();
        drop(write);
        let mut written = String::new();
        read.read_to_string(&mut written).unwrap();
        assert_eq!(written, long + "y1");
    }

    #[test]
    fn write_error_persists() {
        let (read, write) = pipe().unwrap();
        drop(read);
        // Rust's programs ignore SIGPIPE.
        let mut writer = Writer::new(write.as_raw_fd());
        assert_eq!(writer.write_str("x"), Ok(()), "it is only in the buffer");
        assert_eq!(writer.flush(), Err(fmt::Error));
        assert_eq!(writer.flush(), Err(fmt::Error));
        assert_eq!(writer.write_str(&"x".repeat(1025)), Err(fmt::Error));
    }
}
