//! Replacements for functions of std in the intro.
//!
//! The intro is linked without what std needs to explain a panic, which is larger than all the rest of it: `src/pack/build/diet.rs`
//! redirects the functions that lead there to these. In other programs nobody calls them.
//!
//! Code that must report an error never goes through a panic, so that is only for mistakes in the code.

use crate::{line, terminal};

/// Instead of a panic: gives the terminal back, says one line on standard error and aborts.
#[unsafe(no_mangle)]
pub extern "C" fn eightfold_abort() -> ! {
    terminal::restore();
    line::write(
        line::ERROR,
        b"eightfold: a mistake in the program ended it\n",
    );
    // The code for mistakes is the one of C's `abort`.
    #[cfg(feature = "windows")]
    super::arguments::end(3);
    // SAFETY: it may be called at any time.
    #[cfg(not(feature = "windows"))]
    unsafe {
        libc::abort()
    }
}

/// Instead of the function that counts the characters of texts of 32 bytes and more, where they are padded.
#[unsafe(no_mangle)]
pub fn eightfold_count_chars(text: &str) -> usize {
    text.bytes().fold(0, |count, byte| {
        // All bytes of a character but the first are 10xxxxxx.
        count + usize::from(byte & 0xc0 != 0x80)
    })
}

#[cfg(test)]
mod tests {
    use super::eightfold_count_chars;

    #[test]
    fn characters_are_counted_and_not_bytes() {
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
