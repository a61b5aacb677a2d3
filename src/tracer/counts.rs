//! Work counters, and the results of probes.

use crate::maths::{log2, sqrt};
use core::f32::consts::{LOG10_2, LOG10_E};

/// The work of rendering.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct Counts {
    /// Points traced.
    pub points: u64,
    /// Primary and secondary rays.
    pub rays: u64,
    /// Rays towards a light.
    pub shadow_rays: u64,
    /// Lanes of all packets of `rays`, including idle ones.
    pub lanes: u64,
    /// The results of [`Frame::with_probes`](crate::Frame::with_probes). The other counts exclude
    /// the work of probes.
    pub probes: Probes,
}

impl Counts {
    /// All zeros.
    pub const NONE: Self =
        Self { points: 0, rays: 0, shadow_rays: 0, lanes: 0, probes: Probes::NONE };
}

impl core::ops::AddAssign for Counts {
    fn add_assign(&mut self, other: Self) {
        self.points += other.points;
        self.rays += other.rays;
        self.shadow_rays += other.shadow_rays;
        self.lanes += other.lanes;
        self.probes += other.probes;
    }
}

/// The errors of probed pixels against [`Quality::reference`](crate::Quality::reference): an
/// estimate of all pixels' errors.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Probes {
    /// The number of probed pixels.
    pub pixels: u64,
    /// The sum of the pixels' squared errors over three channels, in steps of 1/255.
    pub squares: u64,
    /// The sum of each pixel's `squares`, squared, for the confidence interval.
    pub fourths: u64,
}

/// The addend to `fourths / squares` (5 to 10,000 in a show), for rare large errors that no probe
/// met: 93 to 97 of 100 confidence intervals of 648 probes contain the truth, 65 without it.
const UNSEEN: f32 = 200.0;

impl Probes {
    /// No probes.
    pub const NONE: Self = Self { pixels: 0, squares: 0, fourths: 0 };

    /// The number of probes above which moving pictures should [halve](Probes::halve) the sums: 1.7
    /// s at 60 frames per second.
    pub const MAX_RECENT: u64 = 8_000;

    /// Halves all sums, so that later probes weigh twice as much.
    pub fn halve(&mut self) {
        self.pixels /= 2;
        self.squares /= 2;
        self.fourths /= 2;
    }

    pub(crate) fn compare(&mut self, drawn: u32, traced: u32) {
        let channels = drawn.to_le_bytes().into_iter().zip(traced.to_le_bytes());
        let square: u64 = channels.map(|(a, b)| u64::from(a.abs_diff(b)).pow(2)).sum();
        *self += Self { pixels: 1, squares: square, fourths: square * square };
    }

    /// Returns an unbiased estimate of a channel's mean squared error, in steps of 1/255; NaN
    /// without probes.
    #[must_use]
    pub fn mean_squared_error(&self) -> f64 {
        self.squares as f64 / (3 * self.pixels) as f64
    }

    /// Returns the PSNR to the exhaustive frame in dB, accurate to 0.01 dB; infinity without
    /// errors.
    #[must_use]
    #[inline(never)]
    pub fn psnr(&self) -> f32 {
        if self.squares == 0 {
            return f32::INFINITY;
        }
        10.0 * LOG10_2 * log2((255.0 * 255.0 / self.mean_squared_error()) as f32)
    }

    /// Returns the half width of the 95 % confidence interval of [`Probes::psnr`] in dB, for probes
    /// of different frames. Four times the probes halve it. It is infinite or NaN without errors,
    /// or with one probe.
    #[must_use]
    pub fn margin(&self) -> f32 {
        self.margin_with(UNSEEN)
    }

    #[inline(never)]
    pub(crate) fn margin_with(&self, unseen: f32) -> f32 {
        let [n, squares, fourths] = [self.pixels, self.squares, self.fourths].map(|sum| sum as f32);
        let fourths = fourths + unseen * squares;
        let variance = (n * fourths / (squares * squares) - 1.0) / (n - 1.0);
        // A relative error e of the mean is nearly 10 e / ln 10 dB.
        1.96 * 10.0 * LOG10_E * sqrt(variance)
    }

    /// Returns the [`Probes::margin`] for a still picture of `pixels` pixels, each probed at most
    /// once.
    #[must_use]
    pub fn margin_at_rest(&self, pixels: u64) -> f32 {
        let unknown = 1.0 - self.pixels as f32 / pixels as f32;
        self.margin() * sqrt(unknown.max(0.0))
    }
}

impl core::ops::AddAssign for Probes {
    fn add_assign(&mut self, other: Self) {
        self.pixels += other.pixels;
        self.squares += other.squares;
        self.fourths += other.fourths;
    }
}
