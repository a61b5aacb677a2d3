//! A font of straight strokes on a grid of 3 by 5 points, for text of any size and for letters built of spheres.

use glam::{Vec2, vec2};

/// Grid units from a letter's left side to the next one's.
pub(crate) const ADVANCE: f32 = 3.0;

/// Capitals: the points that the pen goes through; a space lifts it. The points are
///
/// ```text
/// a b c
/// d e f
/// g h i
/// j k l
/// m n o
/// ```
#[rustfmt::skip]
static CAPITALS: [&str; 26] = [
    "mdbfo gi", // A
    "gfbamnlg", // B
    "cbdjno", // C
    "abflnma", // D
    "camo gh", // E
    "cam gh", // F
    "cbdjnoih", // G
    "am gi co", // H
    "ac mo bn", // I
    "clnj", // J
    "am cgo", // K
    "amo", // L
    "mahco", // M
    "maoc", // N
    "bdjnlfb", // O
    "mabfhg", // P
    "bdjnlfbo", // Q
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

/// Digits, likewise.
#[rustfmt::skip]
static DIGITS: [&str; 10] = [
    "bdjnlfb", // 0
    "dbn", // 1
    "dbfmo", // 2
    "achlnm", // 3
    "ocgl", // 4
    "cadelnm", // 5
    "bdjnlig", // 6
    "acn", // 7
    "bfjnldb", // 8
    "nlfbdig", // 9
];

/// The straight strokes of a capital or a digit in ASCII, each from one end to the other, in grid units right and down from
/// the letter's upper left; none of any other letter.
pub(crate) fn strokes(letter: u8) -> impl Iterator<Item = (Vec2, Vec2)> {
    let points = match letter {
        b'A'..=b'Z' => CAPITALS[usize::from(letter - b'A')],
        b'0'..=b'9' => DIGITS[usize::from(letter - b'0')],
        _ => "",
    };
    points
        .as_bytes()
        .windows(2)
        .filter(|ends| !ends.contains(&b' '))
        .map(|ends| (place(ends[0]), place(ends[1])))
}

/// Where a point of the grid is.
fn place(point: u8) -> Vec2 {
    let number = point - b'a';
    vec2(f32::from(number % 3), f32::from(number / 3))
}

#[cfg(test)]
mod tests {
    use super::strokes;

    #[test]
    fn every_letter_has_strokes_on_its_grid_and_nothing_else_has() {
        for letter in 0..=u8::MAX {
            let count = strokes(letter)
                .inspect(|&(from, to)| {
                    let is_on_grid = |p: glam::Vec2| p.x <= 2.0 && p.y <= 4.0;
                    assert!(is_on_grid(from) && is_on_grid(to) && from != to);
                })
                .count();
            let is_letter = letter.is_ascii_uppercase() || letter.is_ascii_digit();
            assert_eq!(count > 0, is_letter, "{letter}");
        }
    }
}
