//! YUV4MPEG2, the stream of raw pictures that video programs read.
//!
//! A header of one line, then for each frame the line `FRAME` and three planes. The colours are those of HDTV (BT.709,
//! limited range), in full resolution (4:4:4): what players take a stream of more than 576 rows or 1280 columns for.
//! The format itself has no word for the matrix; ffmpeg takes BT.601 for what it is not told, so it has to be told.

use crate::arguments::Size;
use crate::rate::Rate;

/// What a stream begins with.
pub fn header(size: Size, rate: Rate) -> Vec<u8> {
    let (Size { width, height }, Rate { num, den }) = (size, rate);
    format!("YUV4MPEG2 W{width} H{height} F{num}:{den} Ip A1:1 C444 XCOLORRANGE=LIMITED\n")
        .into_bytes()
}

/// What stands before each picture.
const MARK: &[u8] = b"FRAME\n";

/// Bytes of a frame.
pub fn frame_bytes(size: Size) -> usize {
    MARK.len() + 3 * size.area()
}

/// A picture in `0x00RRGGBB` as a frame.
pub fn frame(pixels: &[u32]) -> Vec<u8> {
    let mut bytes = Vec::with_capacity(MARK.len() + 3 * pixels.len());
    bytes.extend_from_slice(MARK);
    for plane in [LUMA, BLUENESS, REDNESS] {
        bytes.extend(pixels.iter().map(|&pixel| plane.of(pixel)));
    }
    bytes
}

/// A plane's byte of a colour, by weights of red, green and blue in 65536ths.
#[derive(Clone, Copy)]
struct Plane {
    weights: [i32; 3],
    /// The byte of black.
    base: i32,
}

/// Shares of red and blue in brightness (Rec. ITU-R BT.709-6, 3.2); the rest is green's.
const RED: f64 = 0.2126;
const BLUE: f64 = 0.0722;
/// Steps from black to white, and from one end of a colour difference to the other (BT.709-6, 4.6).
const LUMA_STEPS: f64 = 219.0;
const CHROMA_STEPS: f64 = 224.0;

const LUMA: Plane = Plane {
    weights: [
        fixed(LUMA_STEPS * RED),
        fixed(LUMA_STEPS * (1.0 - RED - BLUE)),
        fixed(LUMA_STEPS * BLUE),
    ],
    base: 16,
};
const BLUENESS: Plane = Plane {
    weights: difference(BLUE, RED, [2, 0, 1]),
    base: 128,
};
const REDNESS: Plane = Plane {
    weights: difference(RED, BLUE, [0, 2, 1]),
    base: 128,
};

/// A weight in 65536ths of a step, for channels of 255 steps.
const fn fixed(weight: f64) -> i32 {
    let scaled = weight * 65536.0 / 255.0;
    (if scaled < 0.0 {
        scaled - 0.5
    } else {
        scaled + 0.5
    }) as i32
}

/// The weights of a colour's difference to the brightness. It and another colour have these shares in the brightness;
/// `places` are those of the colour, the other one, and green. The weights' sum is 0, so that greys have no colour.
const fn difference(share: f64, other: f64, places: [usize; 3]) -> [i32; 3] {
    let scale = CHROMA_STEPS / (2.0 * (1.0 - share));
    let mut weights = [0; 3];
    weights[places[0]] = fixed(scale * (1.0 - share));
    weights[places[1]] = fixed(-scale * other);
    weights[places[2]] = -weights[places[0]] - weights[places[1]];
    weights
}

impl Plane {
    fn of(self, pixel: u32) -> u8 {
        let [_, rgb @ ..] = pixel.to_be_bytes();
        let [r, g, b] = rgb.map(i32::from);
        let [red, green, blue] = self.weights;
        // Half a step, so that cutting off rounds.
        (self.base + ((red * r + green * g + blue * b + 0x8000) >> 16)) as u8
    }
}
