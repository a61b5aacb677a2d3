//! Every dial that trades accuracy for speed.

/// How a frame is refined and how far its rays are followed.
///
/// Two frames of the same scene, time and size differ only by this.
///
/// A square is filled where its corners are the same pixel, or where their colours are within a tolerance; else it is split.
/// There are two tolerances: one for corners whose *keys* agree, which saw the same objects in the same light, and one for
/// corners whose keys differ. A tolerance is the largest difference in a channel, in 255ths, for a square of 8 pixels: in one
/// of 4 it is twice as much, since an error there covers a quarter of the pixels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quality {
    /// Side of the largest square in pixels, 1 to [`Quality::MAX_SQUARE`]. At 1 every pixel is traced. A square is split in two
    /// along each side as long as its side is even, and then into pixels: one of 12 into squares of 6, these into squares of 3.
    /// Powers of two are filled fastest.
    pub square: usize,
    /// The tolerance where the corners' keys agree, 0 to infinity.
    pub tolerance_agreeing: f32,
    /// The tolerance where the keys differ, 0 to infinity. Keys are not computed where both tolerances are the same.
    pub tolerance_differing: f32,
    /// The middle of a split square's side is not traced but averaged where the side's ends have the same key and colours
    /// within this tolerance. 0: always traced.
    pub tolerance_side: f32,
    /// Whether a square is split also where an object may be seen in it that none of its corners shows, or the shadow of a
    /// sphere on a plane: then all of these are shown that tracing every pixel shows. On in all named qualities,
    /// [`Quality::THESIS`] too; the rules of 2008 as they were, which miss what lies between corners, are
    /// `Quality { guarded: false, ..Quality::THESIS }`.
    pub guarded: bool,
    /// A key holds the objects hit by rays of at most this depth (the primary ray has depth 0).
    pub key_depth: u32,
    /// A key holds the lights' states at hits of rays of at most this depth, among those whose objects it holds.
    pub state_depth: u32,
    /// A highlight `ks (r.v)^h` above this makes a lit light "lit with a highlight", a state of its own. Infinity: a light is lit
    /// or dark.
    pub highlight: f32,
    /// Rays of a depth above this are not followed, 0 to [`Quality::MAX_DEPTH`].
    pub depth: u32,
    /// A secondary ray is followed while the product of the coefficients along its path is at least this.
    pub least_contribution: f32,
    /// A pixel that differs from a neighbour gets the mean of so many samples a side, on a regular grid: 2 for four of them;
    /// 0 or 1: none does. Up to [`Quality::MAX_ANTIALIAS`]. All named qualities have 0.
    pub antialias: usize,
}

impl Quality {
    /// The largest [`Quality::square`]: what the working memory has room for.
    pub const MAX_SQUARE: usize = 32;
    /// The largest [`Quality::depth`]: a ray's place in its tree is a number of 8 bits.
    pub const MAX_DEPTH: u32 = 7;

    /// The largest [`Quality::antialias`]: 64 samples of a pixel. (The widest picture's are fewer than 2^16 side by side.)
    pub const MAX_ANTIALIAS: usize = 8;

    /// Every pixel is traced: the oracle that the other qualities are measured against.
    pub const EXHAUSTIVE: Self = Self {
        square: 1,
        tolerance_agreeing: 0.0,
        tolerance_differing: 0.0,
        tolerance_side: 0.0,
        guarded: true,
        key_depth: 5,
        state_depth: 0,
        highlight: 1.0 / 256.0,
        depth: 5,
        least_contribution: 0.01,
        antialias: 0,
    };

    /// The rules of 2008: squares of 8 pixels, filled where the objects of the whole ray tree and the lights' states at
    /// the primary hit agree, whatever the colours.
    pub const THESIS: Self = Self {
        square: 8,
        tolerance_agreeing: f32::INFINITY,
        ..Self::EXHAUSTIVE
    };

    /// What the intro plays: squares of 8 pixels, filled where the corners' colours are close, and the objects hit and the
    /// lights' states there agree.
    pub const DEFAULT: Self = Self::within(8, 10.0);

    /// The named qualities from the finest to the fastest, with [`Quality::DEFAULT`] among them.
    ///
    /// Measured by `cargo lab trade --ladder` on one thread of an AMD EPYC (Zen 4), the model scene at 1024x768: speed against
    /// [`Quality::EXHAUSTIVE`], and errors against its frames, which a test measures again. `over` counts the pixels of a
    /// frame with a channel more than 8 of 255 off, `flicker` the blocks of 8x8 pixels whose error jumps by that much to the
    /// next frame; FLIP is at 67 pixels per degree.
    ///
    /// | name | dials | speed | traced | PSNR | over | flicker | FLIP |
    /// | --- | --- | ---: | ---: | ---: | ---: | ---: | ---: |
    /// | finest | s8 c2 | 2.9 | 7.7 % | 53.8 dB | 283 | 0.1 | 0.0032 |
    /// | finer | s8 c4 | 3.5 | 5.9 % | 51.2 dB | 565 | 0.3 | 0.0051 |
    /// | fine | s8 c7 | 4.0 | 5.0 % | 48.9 dB | 1872 | 0.5 | 0.0069 |
    /// | default | s8 c10 | 4.3 | 4.6 % | 47.1 dB | 3300 | 0.7 | 0.0084 |
    /// | fast | s8 c14 d4 w0.02 | 4.7 | 4.4 % | 45.3 dB | 4797 | 1.0 | 0.0119 |
    /// | faster | s8 c22 d4 w0.02 | 4.8 | 4.2 % | 43.7 dB | 7114 | 2.0 | 0.0138 |
    /// | fastest | s8 c40 d3 w0.05 | 5.2 | 4.0 % | 41.3 dB | 12602 | 8.9 | 0.0201 |
    ///
    /// That is by AVX-512; by AVX2 an exhaustive frame takes 1.8 times as long and the default one gains 6. In the dials `s` is
    /// the square, `c` the tolerance, `d` the depth and `w` the least contribution where they are not the oracle's. Squares of
    /// 16 gain nothing over those of 8 at the same error: they save corners, and what is split between those costs as much.
    pub const LADDER: &'static [Self; 7] = &[
        Self::within(8, 2.0),
        Self::within(8, 4.0),
        Self::within(8, 7.0),
        Self::DEFAULT,
        Self::within(8, 14.0).followed(4, 0.02),
        Self::within(8, 22.0).followed(4, 0.02),
        Self::within(8, 40.0).followed(3, 0.05),
    ];

    /// The names of the [`Quality::LADDER`]'s rungs, in their order.
    pub const NAMES: [&'static str; Self::LADDER.len()] = [
        "finest", "finer", "fine", "default", "fast", "faster", "fastest",
    ];

    /// Squares that are filled within a tolerance where the first object hit and each light's state, lit or dark, agree at the
    /// corners; sides are averaged within the same tolerance.
    const fn within(square: usize, tolerance: f32) -> Self {
        Self {
            square,
            tolerance_agreeing: tolerance,
            tolerance_side: tolerance,
            key_depth: 0,
            state_depth: 0,
            highlight: f32::INFINITY,
            ..Self::EXHAUSTIVE
        }
    }

    /// The same with rays that are followed so far.
    const fn followed(self, depth: u32, least_contribution: f32) -> Self {
        Self {
            depth,
            least_contribution,
            ..self
        }
    }

    /// Whether edges get more samples once a frame is drawn.
    pub(crate) fn is_antialiased(&self) -> bool {
        self.antialias > 1
    }

    /// Whether a frame can be drawn by it.
    pub(crate) fn is_valid(&self) -> bool {
        (1..=Self::MAX_SQUARE).contains(&self.square)
            && self.depth <= Self::MAX_DEPTH
            && self.antialias <= Self::MAX_ANTIALIAS
    }

    /// Side of the smallest squares that are more than a pixel: what halving leaves of a side before it is odd, or 2.
    pub(crate) fn least_square(&self) -> usize {
        (self.square >> self.square.trailing_zeros()).max(2)
    }

    /// The level of the largest squares, where pixels are level 0 and the smallest squares level 1.
    pub(crate) fn top_level(&self) -> usize {
        (self.square / self.least_square()).ilog2() as usize + 1
    }

    /// Whether verdicts depend on keys.
    pub(crate) fn needs_keys(&self) -> bool {
        self.square > 1 && self.tolerance_agreeing != self.tolerance_differing
    }
}
