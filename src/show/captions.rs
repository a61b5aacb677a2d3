//! What is said, and when.

use super::path::smooth;
use crate::scene::{Caption, Scene};

/// Lines of text: the first beat, how many beats, how far down in percent, height of a letter in thousandths.
#[rustfmt::skip]
pub(super) static ROWS: [[u8; 4]; 10] = [
    [12, 11, 82, 40],
    // The method.
    [57,  7, 86, 45],
    [65,  7, 86, 45],
    [73,  7, 86, 45],
    // Names.
    [170, 7, 18, 90],
    [177, 7, 14, 40],
    [178, 6, 24, 65],
    [179, 5, 35, 65],
    [184, 7, 16, 45],
    [184, 7, 24, 45],
];

/// A line for each row.
static TEXT: [u8; 194] = *b"RAYS BY SQUARES OF EIGHT
TRACE A POINT EVERY 8 PIXELS
FILL WHERE CORNERS AGREE
DIVIDE WHERE THEY DIFFER
EIGHTFOLD
GREETINGS TO
HEAVEN SEVEN
REALSTORM
AND THE 2008 THESIS
ON ADAPTIVE RAY TRACING
";

/// Gives a scene the captions of the show so many beats after its begin.
#[inline(never)]
pub(super) fn set(beat: f32, scene: &mut Scene) {
    scene.captions.clear();
    let mut text = TEXT.iter();
    for &[first, beats, middle, size] in &ROWS {
        let since = beat - f32::from(first);
        let caption: &mut Caption = scene.captions.grow();
        caption.middle = f32::from(middle) * 0.01;
        caption.size = f32::from(size) * 0.001;
        caption.brightness = smooth(since.min(f32::from(beats) - since));
        caption.letters.clear();
        for &letter in text.by_ref() {
            if letter == b'\n' {
                break;
            }
            *caption.letters.grow() = letter;
        }
    }
}
