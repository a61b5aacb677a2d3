//! YUV4MPEG2, the stream of raw pictures that video programs read.
//!
//! The stream has a header of one line, then for each frame the line `FRAME`, with a comment that tells how it was made, and three
//! planes. The colours are those of HDTV
//! (BT.709, limited range) in full resolution (4:4:4). The format cannot express the matrix. Players assume BT.709 for large
//! pictures; ffmpeg assumes BT.601 and has to be told.

use crate::arguments::Size;
use crate::rate::Rate;

/// The header of a stream.
pub fn header(size: Size, rate: Rate) -> Vec<u8> {
    let (Size { width, height }, Rate { num, den }) = (size, rate);
    format!("YUV4MPEG2 W{width} H{height} F{num}:{den} Ip A1:1 C444 XCOLORRANGE=LIMITED\n")
        .into_bytes()
}

/// The line in front of each picture, with a number that tells how the picture was made. Readers pass over what begins with an X.
pub fn mark(made: u64) -> Vec<u8> {
    format!("FRAME XMADE={made:016x}\n").into_bytes()
}

/// The bytes of a frame in the stream.
pub fn frame_bytes(size: Size) -> usize {
    mark(0).len() + 3 * size.area()
}

/// Encodes a picture of `0x00RRGGBB` pixels as a frame.
pub fn frame(made: u64, pixels: &[u32]) -> Vec<u8> {
    let mut bytes = mark(made);
    bytes.reserve_exact(3 * pixels.len());
    for plane in [LUMA, CB, CR] {
        bytes.extend(pixels.iter().map(|&pixel| plane.of(pixel)));
    }
    bytes
}

/// A plane of the stream: how its byte is computed from a colour.
#[derive(Clone, Copy)]
struct Plane {
    /// The weights of red, green and blue, in 1/65536.
    weights: [i32; 3],
    /// The byte for black.
    base: i32,
}

/// The weights of red and blue in luma (Rec. ITU-R BT.709-6, 3.2); green has the rest.
const RED: f64 = 0.2126;
const BLUE: f64 = 0.0722;
/// The range of luma, from black to white (BT.709-6, 4.6).
const LUMA_STEPS: f64 = 219.0;
/// The range of a colour difference (BT.709-6, 4.6).
const CHROMA_STEPS: f64 = 224.0;

const LUMA: Plane = Plane {
    weights: [
        fixed(LUMA_STEPS * RED),
        fixed(LUMA_STEPS * (1.0 - RED - BLUE)),
        fixed(LUMA_STEPS * BLUE),
    ],
    base: 16,
};
const CB: Plane = Plane {
    weights: difference(BLUE, RED, [2, 0, 1]),
    base: 128,
};
const CR: Plane = Plane {
    weights: difference(RED, BLUE, [0, 2, 1]),
    base: 128,
};

/// A weight in 1/65536, for channels from 0 to 255.
const fn fixed(weight: f64) -> i32 {
    let scaled = weight * 65536.0 / 255.0;
    (if scaled < 0.0 {
        scaled - 0.5
    } else {
        scaled + 0.5
    }) as i32
}

/// The weights of a colour difference: a colour minus luma. `share` and `other` are the weights in luma of the colour itself and
/// of the other one besides green; `indices` are the indices of the colour, the other one and green. The weights add up to 0, so
/// that greys have no colour difference.
const fn difference(share: f64, other: f64, indices: [usize; 3]) -> [i32; 3] {
    let scale = CHROMA_STEPS / (2.0 * (1.0 - share));
    let mut weights = [0; 3];
    weights[indices[0]] = fixed(scale * (1.0 - share));
    weights[indices[1]] = fixed(-scale * other);
    weights[indices[2]] = -weights[indices[0]] - weights[indices[1]];
    weights
}

impl Plane {
    /// The byte of a pixel.
    fn of(self, pixel: u32) -> u8 {
        let [_, rgb @ ..] = pixel.to_be_bytes();
        let [r, g, b] = rgb.map(i32::from);
        let [red, green, blue] = self.weights;
        // Half a step is added to round to the nearest.
        (self.base + ((red * r + green * g + blue * b + 0x8000) >> 16)) as u8
    }
}
