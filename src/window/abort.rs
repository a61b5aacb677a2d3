//! Replacements for functions of std in the intro, by `src/pack/build/redirect.rs`. Other programs do not call them. Only bugs
//! panic: errors never do.

use crate::{line, terminal};

/// Replaces a panic: restores the terminal, prints one line on standard error and aborts.
#[unsafe(no_mangle)]
pub extern "C" fn eightfold_abort() -> ! {
    terminal::restore();
    line::write(line::ERROR, b"eightfold: internal error\n");
    #[cfg(feature = "windows")]
    super::arguments::end(3);
    // SAFETY: it may be called at any time.
    #[cfg(not(feature = "windows"))]
    unsafe {
        libc::abort()
    }
}

/// Replaces the function that counts the characters of texts from 32 bytes on, for padding.
#[unsafe(no_mangle)]
pub fn eightfold_count_chars(text: &str) -> usize {
    text.bytes()
        .fold(0, |count, byte| count + usize::from(byte & 0xc0 != 0x80))
}

#[cfg(test)]
mod tests {
    use super::eightfold_count_chars;

    #[test]
    fn count_chars_counts_characters() {
        for text in [
            "",
            "a",
            "é",
            "日本語",
            "\u{10ffff} and a plain end, of more than 32 bytes",
        ] {
            assert_eq!(eightfold_count_chars(text), text.chars().count(), "{text}");
        }
    }
}
