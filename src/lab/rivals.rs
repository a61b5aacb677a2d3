//! What people do instead of filling squares: they trace a smaller frame and enlarge it, or trace every second pixel.

use crate::arguments::Size;
use crate::error::worst_channel;
use crate::threaded_renderer::ThreadedRenderer;
use eightfold_tracer::scene::Scene;
use eightfold_tracer::{Counts, Level, Quality};
use fast_image_resize::images::{Image, ImageRef};
use fast_image_resize::{FilterType, PixelType, ResizeAlg, ResizeOptions, Resizer};
use std::cell::RefCell;

/// How the pixels of a frame come about.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Way {
    /// The tracer draws them all.
    #[default]
    Drawn,
    /// They are those of a smaller frame, whose sides are multiplied by this, enlarged by the Catmull-Rom filter.
    Enlarged(f64),
    /// Half of them are traced. Each of the others is the mean of the two neighbours, left and right or above and below, that differ
    /// less.
    Checkerboard,
}

/// Memory that stays from frame to frame.
#[derive(Default)]
struct Scratch {
    resizer: Resizer,
    small: Vec<u32>,
}

thread_local! {
    static SCRATCH: RefCell<Scratch> = RefCell::default();
}

/// Draws a frame `width` pixels wide that fills `pixels`.
pub fn draw(
    way: Way,
    renderer: &mut ThreadedRenderer,
    level: Level,
    scene: &Scene,
    quality: &Quality,
    width: usize,
    pixels: &mut [u32],
) -> Counts {
    let size = Size::new(width, pixels.len() / width);
    SCRATCH.with_borrow_mut(|Scratch { resizer, small }| match way {
        Way::Drawn => renderer.draw(level, scene, quality, width, pixels),
        Way::Enlarged(scale) => {
            let of = |side: usize| ((side as f64 * scale).round() as usize).max(1);
            let part = Size::new(of(size.width), of(size.height));
            small.resize(part.area(), 0);
            let counts = renderer.draw(level, scene, quality, part.width, small);
            enlarge(resizer, part, small, size, pixels);
            counts
        }
        Way::Checkerboard => {
            // A pixel of a frame of half the size covers 2 x 2 pixels: two such frames have the upper left ones and the lower right ones.
            let part = Size::new(size.width.div_ceil(2), size.height.div_ceil(2));
            small.resize(part.area(), 0);
            let mut counts = Counts::NONE;
            for (place, offset) in [(0, -0.25), (1, 0.25)] {
                renderer.set_offset(offset, offset);
                counts += renderer.draw(level, scene, quality, part.width, small);
                for (y, row) in pixels.chunks_exact_mut(width).enumerate() {
                    if y % 2 == place {
                        let traced = &small[y / 2 * part.width..][..part.width];
                        let places = row.iter_mut().skip(place).step_by(2);
                        places
                            .zip(traced)
                            .for_each(|(pixel, &traced)| *pixel = traced);
                    }
                }
            }
            renderer.set_offset(0.0, 0.0);
            fill_gaps(size, pixels);
            counts
        }
    })
}

/// Enlarges a picture of size `part` to `pixels` of another size.
fn enlarge(resizer: &mut Resizer, part: Size, small: &[u32], size: Size, pixels: &mut [u32]) {
    let side = |side: usize| side as u32;
    let [of, to] = [part, size].map(|size| (side(size.width), side(size.height)));
    let small = bytemuck::cast_slice(small);
    let small = ImageRef::new(of.0, of.1, small, PixelType::U8x4).expect("a whole picture");
    let pixels = bytemuck::cast_slice_mut(pixels);
    let mut picture =
        Image::from_slice_u8(to.0, to.1, pixels, PixelType::U8x4).expect("a whole picture");
    let filter = ResizeAlg::Convolution(FilterType::CatmullRom);
    let options = ResizeOptions::new().resize_alg(filter).use_alpha(false);
    let resized = resizer.resize(&small, &mut picture, &options);
    resized.expect("pictures of one type");
}

/// Fills every pixel of a checkerboard that lies beside traced ones.
fn fill_gaps(size: Size, pixels: &mut [u32]) {
    let Size { width, height } = size;
    for y in 0..height {
        for x in (1 - y % 2..width).step_by(2) {
            let at = y * width + x;
            // At the picture's rim the neighbour inside is taken twice.
            let pair = |place: usize, side: usize, step: usize| {
                let before = if place > 0 { at - step } else { at + step };
                let after = if place + 1 < side { at + step } else { before };
                [pixels[before], pixels[after]]
            };
            let (beside, above) = (pair(x, width, 1), pair(y, height, width));
            let difference = |[a, b]: [u32; 2]| worst_channel(a, b);
            let [a, b] = if difference(beside) <= difference(above) {
                beside
            } else {
                above
            };
            // The mean of all channels, rounded up.
            pixels[at] = (a | b) - ((a ^ b) >> 1 & 0x007f_7f7f);
        }
    }
}
