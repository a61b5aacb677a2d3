//! Text on standard output and standard error.
//!
//! `docs/size.md` has the bytes that this saves over `core::fmt`.

pub use crate::system::{ERROR, OUTPUT, is_terminal, write};

/// A buffered writer to a file descriptor. It writes when it is full or [flushed](Writer::flush),
/// until an error.
pub struct Writer {
    file: i32,
    has_failed: bool,
    length: usize,
    buffer: [u8; 1024],
}

impl Writer {
    #[must_use]
    pub const fn new(file: i32) -> Writer {
        Writer { file, has_failed: false, length: 0, buffer: [0; _] }
    }

    /// Writes the buffered bytes. Returns false if this or an earlier write failed.
    ///
    /// Not inlined, like `text`: saves 400 packed bytes.
    #[inline(never)]
    pub fn flush(&mut self) -> bool {
        self.has_failed = self.has_failed || !write(self.file, &self.buffer[..self.length]);
        self.length = 0;
        !self.has_failed
    }

    pub fn byte(&mut self, byte: u8) {
        if self.length == self.buffer.len() {
            self.flush();
        }
        self.buffer[self.length] = byte;
        self.length += 1;
    }

    #[inline(never)]
    pub fn text(&mut self, text: &str) -> &mut Writer {
        for byte in text.bytes() {
            self.byte(byte);
        }
        self
    }

    /// Adds up to 60 bytes from the user. `?` replaces bytes that are not printable ASCII: they
    /// could control the terminal.
    pub fn printable(&mut self, bytes: &[u8]) -> &mut Writer {
        for &byte in bytes.iter().take(60) {
            let is_printable = byte == b' ' || byte.is_ascii_graphic();
            self.byte(if is_printable { byte } else { b'?' });
        }
        self
    }

    fn decimal(&mut self, number: u64, decimals: u8) {
        if number >= 10 || decimals > 0 {
            self.decimal(number / 10, decimals.saturating_sub(1));
        }
        if decimals == 1 {
            self.byte(b'.');
        }
        self.byte(b'0' + (number % 10) as u8);
    }

    /// Adds text with numbers in place of signs: `#` an integer, `$` tenths, `%` hundredths.
    #[inline(never)]
    pub fn format(&mut self, text: &str, numbers: &[u64]) -> &mut Writer {
        let mut numbers = numbers.iter();
        for byte in text.bytes() {
            let decimals = byte.wrapping_sub(b'#');
            if decimals > 2 {
                self.byte(byte);
            } else if let Some(&number) = numbers.next() {
                self.decimal(number, decimals);
            }
        }
        self
    }
}

/// Begins an error message. Errors of its writes cannot be reported.
#[must_use]
pub fn complaint() -> Writer {
    let mut errors = Writer::new(ERROR);
    errors.text("eightfold: ");
    errors
}

#[inline(never)]
pub fn complain(what: &str, then: &str) {
    complaint().text(what).text(then).text("\n").flush();
}

#[must_use]
pub fn ascii(bytes: &[u8]) -> Option<&str> {
    // `[u8]::is_ascii`, which is faster, takes 267 more packed bytes.
    let is_ascii = bytes.iter().all(u8::is_ascii);
    // SAFETY: ASCII is UTF-8.
    is_ascii.then(|| unsafe { str::from_utf8_unchecked(bytes) })
}

#[cfg(test)]
mod tests {
    use super::Writer;
    use std::io::{Read, pipe};
    use std::os::fd::AsRawFd;
    use std::string::String;

    fn written(write: impl FnOnce(&mut Writer)) -> String {
        let (mut read, file) = pipe().unwrap();
        let mut writer = Writer::new(file.as_raw_fd());
        write(&mut writer);
        assert!(writer.flush());
        drop(file);
        let mut written = String::new();
        read.read_to_string(&mut written).unwrap();
        written
    }

    #[test]
    fn decimals_keep_leading_zeros() {
        for (hundredths, expected) in [(0, "0.00"), (7, "0.07"), (123, "1.23"), (2513, "25.13")] {
            let text = written(|writer| _ = writer.format("%", &[hundredths]));
            assert_eq!(text, expected);
        }
        let text = written(|writer| _ = writer.format("$ $, #%", &[0, u64::MAX, 10, 9]));
        assert_eq!(text, "0.0 1844674407370955161.5, 100.09");
    }

    #[test]
    fn printable_replaces_control_bytes() {
        let text = written(|writer| _ = writer.printable(b"a b\x1b[2J\xff\n"));
        assert_eq!(text, "a b?[2J??");
    }

    #[test]
    fn text_longer_than_buffer_is_written() {
        let long = "x".repeat(5000);
        let text = written(|writer| _ = writer.text(&long).format("y#", &[1]));
        assert_eq!(text, long + "y1");
    }

    #[test]
    fn writer_stops_after_an_error() {
        let (read, write) = pipe().unwrap();
        drop(read);
        // Rust's programs ignore SIGPIPE.
        let mut writer = Writer::new(write.as_raw_fd());
        writer.text("x");
        assert!(!writer.flush());
        let (mut read, write) = pipe().unwrap();
        writer.file = write.as_raw_fd();
        assert!(!writer.text(&"x".repeat(1025)).flush());
        drop(write);
        assert_eq!(read.read(&mut [0]).unwrap(), 0);
    }
}
