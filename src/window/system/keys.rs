use core::{ffi::c_int, mem::replace};

use crate::system;

/// Recognises Esc, Ctrl-C, Q and H. Sequences of many other keys begin with Esc, too.
#[derive(Default)]
pub struct KeyParser {
    /// The last byte was Esc, which may begin a sequence.
    open: bool,
    pub toggles: bool,
}

impl KeyParser {
    pub fn read(&mut self, keyboard: c_int) -> bool {
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
        let was_open = replace(&mut self.open, typed.last() == Some(&ESCAPE));
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

#[cfg(test)]
mod tests {
    use super::KeyParser;

    /// `^` is Esc, and `|` separates reads.
    const ENDINGS: &str =
        "q fwq ^OAq ^| ^^| ^|x ab\x03 ^[A^| x^[A^[27uy x^[A^[99;5uy x^[A^[27;5;99~y";
    /// Alt and a letter, the keypad's 1, other keys with modifiers, letters, an arrow and a
    /// function key, an arrow in two parts.
    const OTHERS: &str = "^x| ^q| ^Oq| ^|Oq| ^[99u^[27;5;98~^[27~| |fw| ^[A^OP| ^|[A|";

    #[test]
    fn escape_and_q_end_show_and_sequences_do_not() {
        for (rows, expected) in [(ENDINGS, true), (OTHERS, false)] {
            for row in rows.split(' ') {
                let (mut keys, reads) = (KeyParser::default(), row.replace('^', "\x1b"));
                let is_end = reads.split('|').any(|typed| keys.ends(typed.as_bytes()));
                assert_eq!(is_end, expected, "{row}");
            }
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
