use eightfold_harness::Size;
use eightfold_harness::error::worst_channel;
use eightfold_harness::threaded_renderer::{MomentRef, ThreadedRenderer};
use eightfold_tracer::{Counts, Level, Preset, Quality};
use fast_image_resize::images::{Image, ImageRef};
use fast_image_resize::{FilterType, PixelType, ResizeAlg, ResizeOptions, Resizer};
use std::cell::RefCell;

#[derive(Clone, Debug, PartialEq)]
pub struct Technique {
    pub name: String,
    pub quality: Quality,
    pub sampling: Sampling,
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Sampling {
    Full,
    /// The relative side of a smaller frame, enlarged by a Catmull-Rom filter.
    Enlarged(f64),
    /// Every second pixel is traced; the others are means of the two opposite neighbours that
    /// differ less.
    Checkerboard,
}

#[derive(Default)]
struct Scratch {
    resizer: Resizer,
    small: Vec<u32>,
}

thread_local! {
    static SCRATCH: RefCell<Scratch> = RefCell::default();
}

impl Technique {
    pub fn new(name: &str, quality: Quality, antialias: bool, sampling: Sampling) -> Self {
        let edge = if antialias { quality.edge } else { Quality::EXHAUSTIVE.edge };
        Self { name: name.to_owned(), quality: Quality { antialias, edge, ..quality }, sampling }
    }

    pub fn named(preset: Preset, antialias: bool) -> Self {
        Self::new(preset.name(), *preset.quality(), antialias, Sampling::Full)
    }

    pub fn reference(&self) -> Self {
        let quality = self.quality.reference();
        Self::new("", quality, quality.antialias, Sampling::Full)
    }

    /// The checkerboard cannot be antialiased.
    pub fn rivals(antialias: bool) -> impl Iterator<Item = Self> {
        let enlarged = (3..10).map(move |tenths| {
            let sampling = Sampling::Enlarged(f64::from(tenths) / 10.0);
            let name = format!("resolution:0.{tenths}");
            Self::new(&name, Quality::EXHAUSTIVE, antialias, sampling)
        });
        let (exhaustive, sampling) = (Quality::EXHAUSTIVE, Sampling::Checkerboard);
        let unguarded = Quality { guarded: false, ..Quality::DEFAULT };
        enlarged.chain([
            Self::new("checkerboard", exhaustive, false, sampling),
            Self::new("unguarded", unguarded, antialias, Sampling::Full),
        ])
    }

    pub fn draw<'a>(
        &self,
        renderer: &mut ThreadedRenderer,
        level: Level,
        moment: impl Into<MomentRef<'a>>,
        width: usize,
        pixels: &mut [u32],
    ) -> Counts {
        let size = Size::new(width, pixels.len() / width);
        let (quality, scene) = (&self.quality, moment.into());
        SCRATCH.with_borrow_mut(|Scratch { resizer, small }| match self.sampling {
            Sampling::Full => renderer.draw(level, scene, quality, width, pixels),
            Sampling::Enlarged(scale) => {
                let part = size.scaled(scale);
                small.resize(part.area(), 0);
                let counts = renderer.draw(level, scene, quality, part.width, small);
                enlarge(resizer, part, small, size, pixels);
                counts
            }
            Sampling::Checkerboard => {
                // Draw each 2x2's upper left, then lower right pixels as frames of half the side.
                let part = Size::new(size.width.div_ceil(2), size.height.div_ceil(2));
                small.resize(part.area(), 0);
                let mut counts = Counts::NONE;
                for (place, offset) in [(0, -0.25), (1, 0.25)] {
                    renderer.set_offset(offset, offset);
                    counts += renderer.draw(level, scene, quality, part.width, small);
                    let rows = pixels.chunks_exact_mut(width).skip(place).step_by(2);
                    for (row, traced) in rows.zip(small.chunks_exact(part.width)) {
                        let places = row.iter_mut().skip(place).step_by(2);
                        places.zip(traced).for_each(|(to, &from)| *to = from);
                    }
                }
                renderer.set_offset(0.0, 0.0);
                fill_gaps(size, pixels);
                counts
            }
        })
    }
}

fn enlarge(resizer: &mut Resizer, part: Size, small: &[u32], size: Size, pixels: &mut [u32]) {
    const WHOLE: &str = "the buffer has the size of the picture";
    let [from, to] = [part, size].map(|size| (size.width as u32, size.height as u32));
    let small = bytemuck::cast_slice(small);
    let small = ImageRef::new(from.0, from.1, small, PixelType::U8x4).expect(WHOLE);
    let pixels = bytemuck::cast_slice_mut(pixels);
    let mut picture = Image::from_slice_u8(to.0, to.1, pixels, PixelType::U8x4).expect(WHOLE);
    let filter = ResizeAlg::Convolution(FilterType::CatmullRom);
    let options = ResizeOptions::new().resize_alg(filter).use_alpha(false);
    let resized = resizer.resize(&small, &mut picture, &options);
    resized.expect("both pictures have the same pixel type");
}

fn fill_gaps(size: Size, pixels: &mut [u32]) {
    let Size { width, height } = size;
    for y in 0..height {
        for x in (1 - y % 2..width).step_by(2) {
            let at = y * width + x;
            // The border mirrors the neighbour inside.
            let pair = |place: usize, side: usize, step: usize| {
                let before = if place > 0 { at - step } else { at + step };
                let after = if place + 1 < side { at + step } else { before };
                [pixels[before], pixels[after]]
            };
            let pairs = [pair(x, width, 1), pair(y, height, width)];
            let [across, down] = pairs.map(|[a, b]| worst_channel(a, b));
            let [a, b] = pairs[usize::from(down < across)];
            // The mean per channel, rounded up.
            pixels[at] = (a | b) - ((a ^ b) >> 1 & 0x007f_7f7f);
        }
    }
}
