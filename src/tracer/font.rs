//! A vector font of straight strokes on a grid of 3 by 5 points.

use glam::{Vec2, vec2};

/// The capitals, each as the points that a pen visits; a space lifts the pen. The grid's rows are
/// `abc`, `def`, `ghi`, `jkl`, `mno`.
#[rustfmt::skip]
static CAPITALS: [&str; 26] = [
    "mdbfo gi", // A
    "gfbamnlg", // B
    "cbdjno", // C
    "abflnma", // D
    "camo gh", // E
    "cam gh", // F
    "cbdjnoih", // G
    "am co gi", // H
    "bn", // I
    "clnj", // J
    "am cgo", // K
    "amo", // L
    "mahco", // M
    "maoc", // N
    "bdjnlfb", // O
    "mabfhg", // P
    "bdjnlfb ko", // Q
    "mabfhgo", // R
    "cbdlnm", // S
    "ac bn", // T
    "ajnlc", // U
    "anc", // V
    "amhoc", // W
    "ao cm", // X
    "ahc hn", // Y
    "acmo", // Z
];

/// A full stop, ± at the slash, and the digits.
#[rustfmt::skip]
static DIGITS: [&str; 12] = [
    "kn", // .
    "ek gi mo", // /
    "bdjnlfb", // 0
    "dbn", // 1
    "dbfmo", // 2
    "achlnm", // 3
    "ocgi", // 4
    "cadelnm", // 5
    "bdjnlig", // 6
    "acn", // 7
    "bfjnldb", // 8
    "nlfbdgi", // 9
];

/// Returns the strokes of an ASCII capital, digit or full stop, of ± for a slash, and none for
/// other bytes. Ends are in grid units from the letter's upper left, y down.
pub fn strokes(letter: u8) -> impl Iterator<Item = (Vec2, Vec2)> {
    points(letter)
        .windows(2)
        .filter(|ends| ends[0] != b' ' && ends[1] != b' ')
        .map(|ends| (position(ends[0]), position(ends[1])))
}

#[inline(never)]
fn points(letter: u8) -> &'static [u8] {
    let points = match letter {
        b'A'..=b'Z' => CAPITALS[usize::from(letter - b'A')],
        b'.'..=b'9' => DIGITS[usize::from(letter - b'.')],
        _ => "",
    };
    points.as_bytes()
}

fn position(point: u8) -> Vec2 {
    let index = point - b'a';
    vec2(f32::from(index % 3), f32::from(index / 3))
}

#[cfg(test)]
mod tests {
    use super::strokes;

    #[test]
    fn letters_have_strokes_on_grid() {
        for letter in 0..=u8::MAX {
            let count = strokes(letter)
                .inspect(|&(from, to)| {
                    let is_on_grid = |p: glam::Vec2| p.x <= 2.0 && p.y <= 4.0;
                    assert!(is_on_grid(from) && is_on_grid(to) && from != to);
                })
                .count();
            let is_letter = letter.is_ascii_uppercase() || (b'.'..=b'9').contains(&letter);
            assert_eq!(count > 0, is_letter, "{letter}");
        }
    }
}
