//! The parameters that trade accuracy for speed.

use crate::range_error::{Checked, Range, RangeError};

/// How far a frame is refined and how far its rays are followed.
///
/// A square is filled if its corners have the same 8-bit colour, or if their colours differ by no more than a tolerance;
/// otherwise it is split. One tolerance applies to corners whose *keys* agree, which means that they show the same objects in the
/// same light, another to corners whose keys differ. A tolerance is the largest difference in any channel, in units of 1/255, for
/// squares of 8 pixels. For squares of 4 it is doubled, since an error there covers a quarter of the pixels, and so on.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Quality {
    /// The side of the largest squares in pixels: a power of two up to [`Quality::MAX_SQUARE`]. A square is split into four. With 1
    /// every pixel is traced.
    pub square: usize,
    /// The tolerance for corners whose keys agree, 0 to infinity.
    pub tolerance_agreeing: f32,
    /// The tolerance for corners whose keys differ, 0 to infinity. If both tolerances are the same, keys are not computed.
    pub tolerance_differing: f32,
    /// The tolerance for the midpoint of a split square's side, 0 to infinity: if the side's ends have the same key and their
    /// colours are within it, the midpoint gets their mean and is not traced. With 0 all midpoints are traced.
    pub tolerance_side: f32,
    /// Whether a square is also split if an object, the shadow of a sphere on a plane, an image in a flat first plane, or a highlight
    /// may be visible in it that none of its corners shows. Then no object is missed that tracing every pixel would show, nor an image
    /// of 2x2 pixels that no other one hides, unless it is a cylinder's or a capsule's; nor such a shadow, but for one that is dark
    /// only where it would be so without it; and hardly ever a highlight of five pixels (see [`limits`](crate::limits)). All named
    /// qualities are guarded,
    /// [`Quality::THESIS`] included. The original rules of 2008, which miss objects between corners, are
    /// `Quality { guarded: false, ..Quality::THESIS }`.
    pub guarded: bool,
    /// The largest depth of rays whose hit objects are part of the key. Primary rays have depth 0.
    pub key_depth: u32,
    /// The smallest weight of rays whose hit objects are part of the key, 0 to infinity; a ray's weight is the product of `kr` and
    /// `kt` along its path, and of what the air leaves. So a key tells what a mirror or a glass shows, and not what a dull floor does.
    /// If it is not 0, and a scene has twelve solids that are strong mirrors or glass, no two points of such a solid have the same key,
    /// and squares are of 4 pixels at most: what is shown between them is as small as the crowd that it shows.
    pub key_weight: f32,
    /// The largest depth of rays at whose hits the lights' states are part of the key, if their objects are.
    pub state_depth: u32,
    /// The strength `ks (r.v)^h` above which a light's highlight makes its state "lit with a highlight" instead of "lit", 0 to
    /// infinity. With infinity a light is either lit or dark.
    pub highlight: f32,
    /// The largest depth of rays that are followed, 0 to [`Quality::MAX_DEPTH`].
    pub depth: u32,
    /// The smallest weight of secondary rays that are followed, 0 to infinity. A ray's weight is the product of `kr` and `kt` along
    /// its path.
    pub least_contribution: f32,
    /// Whether edges are antialiased: where two neighbouring pixels differ by 20/255 or more in a channel, the point half-way
    /// between them is traced and mixed into both, and up to two more points for each of them find the edge by bisection.
    pub antialias: bool,
}

impl Quality {
    /// The largest [`Quality::square`]: the working memory has room for squares of this side.
    pub const MAX_SQUARE: usize = 32;
    /// The largest [`Quality::depth`]: a ray's path in its tree is stored in 8 bits.
    pub const MAX_DEPTH: u32 = 7;

    /// Every pixel is traced: the reference with which the other qualities are compared.
    pub const EXHAUSTIVE: Self = Self {
        square: 1,
        tolerance_agreeing: 0.0,
        tolerance_differing: 0.0,
        tolerance_side: 0.0,
        guarded: true,
        key_depth: 5,
        key_weight: 0.0,
        state_depth: 0,
        highlight: 1.0 / 256.0,
        depth: 5,
        least_contribution: 0.01,
        antialias: false,
    };

    /// The rules of the 2008 thesis: squares of 8 pixels are filled if the corners agree in the objects of the whole ray tree and
    /// in the lights' states at the primary hit, whatever their colours.
    pub const THESIS: Self = Self {
        square: 8,
        tolerance_agreeing: f32::INFINITY,
        ..Self::EXHAUSTIVE
    };

    /// The middle of the ladder: squares of 8 pixels are filled if the corners' colours are close and they show the same object
    /// with the same lights lit.
    pub const DEFAULT: Self = Self::within(8, 7.5).followed(5, 0.015).antialiased();

    /// The named qualities from the finest to the fastest, with [`Quality::DEFAULT`] among them.
    ///
    /// The first four are antialiased, which takes a third to a half more time. Speed, error and what a viewer sees of it are in
    /// `docs/accuracy.md`, as `cargo lab trade --ladder` measures them.
    ///
    /// The presets are chosen on the front of time against FLIP and pops, pixels that jump from a frame to the next while those of
    /// exhaustive frames stay: `cargo lab trade` prints it. By PSNR alone the default had a tolerance of 9 and a least contribution
    /// of 0.02; it now has a third of the pops in the model scene, most of which lay in squares of 2, and a third less of FLIP. The
    /// smaller tolerance and contribution take a tenth more time there.
    ///
    /// At the same error squares of 16 are no faster than squares of 8: they need fewer corners, but more of them are split.
    pub const LADDER: &'static [Self; 7] = &[
        Self::within(8, 2.0).antialiased(),
        Self::within(8, 3.0).antialiased(),
        Self::within(8, 5.0).antialiased(),
        Self::DEFAULT,
        Self::within(8, 8.0).followed(4, 0.02),
        Self::within(8, 16.0).followed(4, 0.02),
        Self::within(8, 28.0).followed(3, 0.05),
    ];

    /// The index of [`Quality::DEFAULT`] in the [`Quality::LADDER`].
    pub const DEFAULT_PRESET: usize = 3;

    /// The names of the presets of the [`Quality::LADDER`], in its order.
    pub const NAMES: [&'static str; Self::LADDER.len()] = [
        "finest", "finer", "fine", "default", "fast", "faster", "fastest",
    ];

    /// A quality that fills squares, and averages midpoints of sides, within one tolerance if the objects of the primary hit
    /// and of its stronger reflections and refractions agree, and the lights' states, lit or dark.
    const fn within(square: usize, tolerance: f32) -> Self {
        Self {
            square,
            tolerance_agreeing: tolerance,
            tolerance_side: tolerance,
            key_depth: 2,
            key_weight: 0.3,
            state_depth: 0,
            highlight: f32::INFINITY,
            ..Self::EXHAUSTIVE
        }
    }

    /// The same quality with other limits on secondary rays.
    const fn followed(self, depth: u32, least_contribution: f32) -> Self {
        Self {
            depth,
            least_contribution,
            ..self
        }
    }

    /// The same quality with antialiasing.
    const fn antialiased(self) -> Self {
        Self {
            antialias: true,
            ..self
        }
    }

    /// Every pixel traced, and antialiased in the same way: what the errors of this quality are measured against.
    #[must_use]
    pub const fn reference(&self) -> Self {
        Self {
            antialias: self.antialias,
            ..Self::EXHAUSTIVE
        }
    }

    /// Checks that every parameter is in the range of its documentation.
    ///
    /// # Errors
    /// The first one that is not.
    pub fn validate(&self) -> Result<(), RangeError> {
        let quality = Checked::one("quality");
        let is_side = self.is_square_drawable();
        quality.rule(
            "square",
            self.square as f32,
            is_side,
            "1, 2, 4, 8, 16 or 32",
        )?;
        quality.field("depth", self.depth as f32, Range(0.0, 7.0, "0 to 7"))?;
        for (name, tolerance) in [
            ("tolerance_agreeing", self.tolerance_agreeing),
            ("tolerance_differing", self.tolerance_differing),
            ("tolerance_side", self.tolerance_side),
            ("key_weight", self.key_weight),
            ("highlight", self.highlight),
            ("least_contribution", self.least_contribution),
        ] {
            quality.field(name, tolerance, Range(0.0, f32::INFINITY, "0 to infinity"))?;
        }
        Ok(())
    }

    /// Whether the working memory has room for what it asks for. A tolerance out of its range is as good as some other one.
    pub(crate) fn is_drawable(&self) -> bool {
        self.is_square_drawable() && self.depth <= Self::MAX_DEPTH
    }

    /// Whether [`Quality::square`] is in its range.
    fn is_square_drawable(&self) -> bool {
        self.square.is_power_of_two() && self.square <= Self::MAX_SQUARE
    }

    /// The level of the largest squares: squares of level `n` have `1 << n` pixels a side.
    pub(crate) fn top_level(&self) -> usize {
        self.square.trailing_zeros() as usize
    }

    /// Whether keys have to be computed.
    pub(crate) fn needs_keys(&self) -> bool {
        self.square > 1 && self.tolerance_agreeing != self.tolerance_differing
    }
}
