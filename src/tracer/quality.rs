use crate::range_error::{Checked, Range, RangeError};
use core::fmt;
use core::str::FromStr;

/// Settings that trade accuracy for speed: the refinement of squares and the depth of rays.
///
/// A square is filled if its corners show one object, in one 8-bit colour or in colours within a
/// tolerance; otherwise it is split. Corners with equal *keys* show the same objects in the same
/// light and, in mirrors and glass, the same half-waves of patterns. A tolerance is in units of
/// 1/255 of a channel, for squares of 8 pixels; it doubles for squares of 4 pixels, where an error
/// covers a quarter of the pixels, and so on.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(default, deny_unknown_fields))]
pub struct Quality {
    /// The side of the largest squares in pixels: a power of two up to [`Quality::MAX_SQUARE`].
    pub square: usize,
    /// The tolerance for equal keys, 0 to infinity.
    pub tolerance_agreeing: f32,
    /// The tolerance for different keys of one object, 0 to infinity. If both tolerances are equal,
    /// keys are not computed.
    pub tolerance_differing: f32,
    /// The tolerance for the midpoint of a split square's side, 0 to infinity. If both ends have
    /// the same key and colours within it, the midpoint is their mean.
    pub tolerance_side: f32,
    /// Whether a square is also split if an object, a shadow on a plane, an image in a flat first
    /// plane, or a highlight may be between its corners, or if it is between two split squares.
    /// [`limits`](crate::limits) lists exceptions. The rules of 2008 are
    /// `Quality { guarded: false, ..Quality::THESIS }`.
    pub guarded: bool,
    /// The least weight of reflected or refracted light that splits a square down to pixels, 0 to
    /// infinity: most such light has no bounds. Below infinity, a square is also split where a
    /// sphere or a block may be in shadow: no thin thing is missed. Ignored unless `guarded`.
    pub unguarded_weight: f32,
    /// The largest depth of rays whose objects are part of the key; 0 for primary rays only.
    pub key_depth: u32,
    /// The least weight of rays whose objects are part of the key, 0 to infinity. It excludes weak
    /// reflections of a floor. A ray's weight is the exposure times `kr`, `kt` and the haze's
    /// factors along its path.
    pub key_weight: f32,
    /// Whether crowds are refined: in dense clusters reflections are tiny. In a scene of twelve or
    /// more mirrors and glass solids with a `kr + kt` of 0.3, all their points have different keys,
    /// except on large glass spheres, and squares have 4 pixels at most.
    pub crowds: bool,
    /// The largest depth of rays at whose hits the lights' states are part of the key.
    pub state_depth: u32,
    /// The strength `ks (r.v)^h` above which a light's state is "lit with a highlight" instead of
    /// "lit", 0 to infinity.
    pub highlight: f32,
    /// The largest depth of rays, 0 to [`Quality::MAX_DEPTH`]. A deeper ray returns the background
    /// in its direction or the ambient light, the brighter in each channel; black if the scene is
    /// [`Scene::black_beyond`](crate::scene::Scene::black_beyond).
    pub depth: u32,
    /// The least weight of secondary rays, 0 to infinity. Weaker rays return the light of rays
    /// beyond `depth`.
    pub least_contribution: f32,
    /// Whether edges are antialiased. The midpoint between two pixels at an edge is traced and
    /// mixed into both pixels; up to three more points on each side find the edge by bisection.
    pub antialias: bool,
    /// The least difference of neighbouring pixels at an edge, in a channel, in units of 1/255; 0
    /// counts as 1. A smaller number bisects deeper.
    pub edge: u8,
}

default!(Quality = Self::DEFAULT);

impl Quality {
    /// The largest [`Quality::square`], the capacity of the working memory.
    pub const MAX_SQUARE: usize = 32;
    /// The largest [`Quality::depth`]: paths have 8 bits.
    pub const MAX_DEPTH: u32 = 7;

    /// Every pixel traced.
    pub const EXHAUSTIVE: Self = Self {
        square: 1,
        tolerance_agreeing: 0.0,
        tolerance_differing: 0.0,
        tolerance_side: 0.0,
        guarded: true,
        unguarded_weight: f32::INFINITY,
        key_depth: 5,
        key_weight: 0.0,
        crowds: false,
        state_depth: 0,
        highlight: 1.0 / 256.0,
        depth: 5,
        least_contribution: 0.01,
        antialias: false,
        edge: 20,
    };

    /// The rules of the 2008 thesis, guarded: squares of 8 pixels are filled if the corners agree
    /// in all objects of the ray tree and in the lights' states at the primary hit, whatever their
    /// colours.
    pub const THESIS: Self =
        Self { square: 8, tolerance_agreeing: f32::INFINITY, ..Self::EXHAUSTIVE };

    /// The quality of [`Preset::Default`].
    pub const DEFAULT: Self = Self::within(8, 7.7).followed(5, 0.015).antialiased(20);

    /// Keys have the objects of the primary hit and of stronger secondary rays, and whether each
    /// light is lit. Only equal keys have a tolerance.
    const fn within(square: usize, tolerance: f32) -> Self {
        Self {
            square,
            tolerance_agreeing: tolerance,
            tolerance_side: tolerance,
            key_depth: 3,
            key_weight: 0.3,
            crowds: true,
            state_depth: 0,
            highlight: f32::INFINITY,
            ..Self::EXHAUSTIVE
        }
    }

    const fn followed(self, depth: u32, least_contribution: f32) -> Self {
        Self { depth, least_contribution, ..self }
    }

    const fn antialiased(self, edge: u8) -> Self {
        Self { antialias: true, edge, ..self }
    }

    /// Returns the reference for this quality's errors: every pixel traced, antialiased in the same
    /// way.
    #[must_use]
    pub const fn reference(&self) -> Self {
        Self { antialias: self.antialias, edge: self.edge, ..Self::EXHAUSTIVE }
    }

    /// Returns the quality without antialiasing.
    #[must_use]
    pub const fn jagged(self) -> Self {
        Self { antialias: false, ..self }
    }

    /// Returns the quality with an `edge` of at least 1.
    pub(crate) fn with_positive_edge(self) -> Self {
        Self { edge: self.edge.max(1), ..self }
    }

    /// Returns the quality with squares of at least `side` pixels, rounded down to a power of two,
    /// 1 to [`Quality::MAX_SQUARE`].
    pub(crate) fn coarser(self, side: usize) -> Self {
        let side = 1 << side.clamp(1, Self::MAX_SQUARE).ilog2();
        Self { square: self.square.max(side), ..self }
    }

    /// Checks every parameter's range.
    ///
    /// # Errors
    /// The first number out of range.
    pub fn validate(&self) -> Result<(), RangeError> {
        let quality = Checked::one("quality");
        let is_side = self.is_square_drawable();
        quality.rule("square", self.square as f32, is_side, "1, 2, 4, 8, 16 or 32")?;
        quality.field("depth", self.depth as f32, Range(0.0, 7.0, "0 to 7"))?;
        for (name, tolerance) in [
            ("tolerance_agreeing", self.tolerance_agreeing),
            ("tolerance_differing", self.tolerance_differing),
            ("tolerance_side", self.tolerance_side),
            ("unguarded_weight", self.unguarded_weight),
            ("key_weight", self.key_weight),
            ("highlight", self.highlight),
            ("least_contribution", self.least_contribution),
        ] {
            quality.field(name, tolerance, Range(0.0, f32::INFINITY, "0 to infinity"))?;
        }
        Ok(())
    }

    pub(crate) fn is_drawable(&self) -> bool {
        self.is_square_drawable() && self.depth <= Self::MAX_DEPTH
    }

    fn is_square_drawable(&self) -> bool {
        self.square.is_power_of_two() && self.square <= Self::MAX_SQUARE
    }

    pub(crate) fn top_level(&self) -> usize {
        self.square.trailing_zeros() as usize
    }

    pub(crate) fn needs_keys(&self) -> bool {
        self.square > 1 && self.tolerance_agreeing != self.tolerance_differing
    }
}

macro_rules! presets {
    ($($(#[$doc:meta])* $preset:ident, $name:literal, $quality:expr;)*) => {
        /// A named quality.
        ///
        /// `docs/accuracy.md` has the speed and errors of each. [`Preset::LADDER`] is on the Pareto
        /// front of time, FLIP and pops (pixels that jump while the exhaustive frame's stay), see
        /// `cargo lab trade`. By PSNR only, a tolerance of 9 and a least contribution of 0.02 would
        /// be the best default: a tenth less time, but three times the pops. Squares of 16 are no
        /// faster at equal error.
        ///
        /// ```
        /// use eightfold_tracer::{Preset, Quality};
        ///
        /// assert_eq!("default".parse::<Preset>()?.quality(), &Quality::DEFAULT);
        /// # Ok::<(), eightfold_tracer::UnknownPreset>(())
        /// ```
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        #[non_exhaustive]
        // An index: 60 packed bytes less than with one byte per preset.
        #[repr(usize)]
        pub enum Preset {
            $($(#[$doc])* $preset,)*
        }

        /// Names and qualities by [`Preset::index`].
        const PRESETS: &[(&str, Quality)] = &[$(($name, $quality)),*];

        impl Preset {
            /// All presets.
            pub const ALL: [Self; PRESETS.len()] = [$(Self::$preset),*];
        }
    };
}

presets! {
    /// [`Quality::EXHAUSTIVE`].
    Exhaustive, "exhaustive", Quality::EXHAUSTIVE;
    /// The most accurate preset that fills squares. It and the next three are antialiased: a third
    /// to a half more time at `default`.
    Finest, "finest", Quality { unguarded_weight: 0.1, ..Quality::within(8, 2.0).antialiased(8) };
    /// Between [`Preset::Finest`] and [`Preset::Fine`].
    Finer, "finer", Quality::within(8, 3.0).antialiased(12);
    /// Between [`Preset::Finer`] and [`Preset::Default`].
    Fine, "fine", Quality::within(8, 5.0).antialiased(16);
    /// [`Quality::DEFAULT`].
    Default, "default", Quality::DEFAULT;
    /// Between [`Preset::Default`] and [`Preset::Faster`].
    Fast, "fast", Quality::within(8, 8.5).followed(4, 0.02);
    /// Between [`Preset::Fast`] and [`Preset::Fastest`].
    Faster, "faster", Quality::within(8, 16.0).followed(4, 0.02);
    /// The preset for slow machines.
    Fastest, "fastest", Quality::within(8, 28.0).followed(3, 0.05);
    /// [`Quality::THESIS`].
    Thesis, "thesis", Quality::THESIS;
}

impl Preset {
    /// The presets from [`Preset::Finest`] to [`Preset::Fastest`], which governors choose from.
    pub const LADDER: &'static [Self] =
        Self::ALL.split_at(Self::Thesis.index()).0.split_at(Self::Finest.index()).1;

    /// Returns the index in [`Preset::ALL`].
    #[must_use]
    pub const fn index(self) -> usize {
        self as usize
    }

    /// Returns the preset's quality.
    #[must_use]
    pub const fn quality(self) -> &'static Quality {
        &PRESETS[self.index()].1
    }

    /// Returns the preset's name, which [`Preset::from_str`] parses.
    #[must_use]
    pub const fn name(self) -> &'static str {
        PRESETS[self.index()].0
    }

    /// Returns the preset of a name.
    // In callers' code, which is optimised for size: 138 packed bytes less.
    #[inline]
    #[must_use]
    pub fn named(name: &[u8]) -> Option<Self> {
        Self::ALL.into_iter().find(|preset| preset.name().as_bytes() == name)
    }
}

impl fmt::Display for Preset {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// The error of [`Preset::from_str`]. It displays as the list of all names.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct UnknownPreset;

impl fmt::Display for UnknownPreset {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("must be one of ")?;
        for (i, preset) in Preset::ALL.into_iter().enumerate() {
            write!(f, "{}{preset}", if i > 0 { ", " } else { "" })?;
        }
        Ok(())
    }
}

impl core::error::Error for UnknownPreset {}

impl FromStr for Preset {
    type Err = UnknownPreset;

    fn from_str(name: &str) -> Result<Self, UnknownPreset> {
        Self::named(name.as_bytes()).ok_or(UnknownPreset)
    }
}
