//! The method made visible: what was traced and filled, on top of the picture.
//!
//! Of the points on the upper row of a band those have no mark that only the band above it traced, once this one was
//! done. Where every pixel is traced there is nothing to show.

use super::refiner::Refiner;
use crate::lanes::*;
use crate::observe::Observer;

/// Set in a pixel on a side of a filled square, above its channels, until the band is done.
const SIDE: u32 = 1 << 24;

impl<S: Simd, O: Observer> Refiner<'_, S, O> {
    /// Whether the scene asks for more than the plain picture.
    #[inline(always)]
    fn shows_method(&self) -> bool {
        self.scene.shows_method()
    }

    /// What the pixels on the upper and the left side of a filled square are noted by: the others are its neighbours'.
    #[inline(always)]
    pub(super) fn side(&self) -> u32 {
        if self.shows_method() { SIDE } else { 0 }
    }

    /// Draws the points and sides of a band that is done, as bright as the scene wants them.
    #[inline(always)]
    pub(super) fn show_method(&mut self) {
        if !self.shows_method() {
            return;
        }
        let method = &self.scene.scene.method;
        let both = method.squares.max(method.points);
        let marks = [0.0, method.squares, method.points, both];
        let mut pixels = self.canvas.pixels.iter_mut();
        for points in self.worker.points.rows() {
            for x in 0..self.canvas.width {
                let Some(pixel) = pixels.next() else {
                    return;
                };
                let place = *pixel / SIDE + 2 * u32::from(points.is_traced(x));
                let mark = marks[place as usize % 4];
                // What is left of the picture, in 256ths, and the white that is added to it.
                let (left, white) = (byte((1.0 - mark) * method.picture), byte(mark));
                let red_blue = (((*pixel & 0xff_00_ff) * left) >> 8) & 0xff_00_ff;
                let green = (((*pixel & 0xff_00) * left) >> 8) & 0xff_00;
                *pixel = red_blue + green + white * 0x01_01_01;
            }
        }
    }
}

/// A share of 255, rounded: adding 2^23 leaves it in the low bits.
#[inline(always)]
fn byte(share: f32) -> u32 {
    u32::from((share * 255.0 + 8_388_608.0).to_bits() as u8)
}
