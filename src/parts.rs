//! Texts in parts.

/// The parts of a text between separators: what `split` is, of which each use takes some hundred bytes.
pub struct Parts {
    rest: Option<&'static [u8]>,
    separator: u8,
}

impl Parts {
    pub fn of(text: &'static [u8], separator: u8) -> Parts {
        Parts {
            rest: Some(text),
            separator,
        }
    }
}

impl Iterator for Parts {
    type Item = &'static [u8];

    #[inline(never)]
    fn next(&mut self) -> Option<&'static [u8]> {
        let text = self.rest.take()?;
        for (end, &byte) in text.iter().enumerate() {
            if byte == self.separator {
                self.rest = text.get(end + 1..);
                return text.get(..end);
            }
        }
        Some(text)
    }
}
