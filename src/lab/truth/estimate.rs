//! Means, variances and confidence intervals.

use super::REPLICATIONS;
use eightfold_tracer::glam::DVec3;

/// The 97.5th percentile of Student's t with [`REPLICATIONS`] - 1 degrees of freedom: a mean is within that many standard errors
/// with a probability of 95 %.
const STUDENT: f64 = 2.365;
const _: () = assert!(REPLICATIONS == 8, "STUDENT is that of 7 degrees of freedom");

/// The error by the blur of photons, in what discs of half the radius change: 4/3 where light is smooth, and up to 3 at a sixth of
/// the radius from an edge of the light or farther.
const BLUR: f64 = 3.0;

/// The mean of numbers, and the variance of that without bias, 0 of a single one, each channel for itself (Welford, 1962).
pub fn mean_and_variance(numbers: impl IntoIterator<Item = DVec3>) -> (DVec3, DVec3) {
    let (mut count, mut mean, mut squares) = (0.0, DVec3::ZERO, DVec3::ZERO);
    for number in numbers {
        count += 1.0;
        let before = number - mean;
        mean += before / count;
        squares += before * (number - mean);
    }
    (mean, squares / f64::max(count - 1.0, 1.0) / count)
}

/// The samples of a pixel so far.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Pixel {
    /// The sum of each replication.
    pub sums: [DVec3; REPLICATIONS],
    /// How much more all of them are than by narrower discs of photons.
    pub blur: DVec3,
}

/// The estimate of a pixel.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Estimate {
    /// The radiance.
    pub mean: DVec3,
    /// The variance of `mean`.
    pub variance: DVec3,
    /// The change by narrower discs of photons.
    pub blur: DVec3,
}

impl Estimate {
    /// The estimate by the samples of a pixel, of which each replication has `count`.
    ///
    /// The samples of one replication depend on each other, which is what makes their mean good; the replications do not.
    pub fn of(pixel: &Pixel, count: usize) -> Self {
        let count = count.max(1) as f64;
        let means = pixel.sums.iter().map(|sum| sum / count);
        let (mean, variance) = mean_and_variance(means);
        Self {
            mean,
            variance,
            blur: pixel.blur.abs() / (REPLICATIONS as f64 * count),
        }
    }

    /// Half the width of the interval about the mean in which the radiance is with a probability of 95 %: by the noise, and by the
    /// blur of photons.
    pub fn half_interval(&self) -> DVec3 {
        STUDENT * self.variance.map(f64::sqrt) + BLUR * self.blur
    }

    /// The mean as a pixel, `0x00RRGGBB`.
    pub fn pixel(&self) -> u32 {
        let [r, g, b] = self
            .mean
            .to_array()
            .map(|c| (c.clamp(0.0, 1.0) * 255.0).round() as u32);
        r << 16 | g << 8 | b
    }
}

/// The intervals of a picture, in steps of 1/255 of its worst channel.
pub struct Intervals {
    /// Of each pixel, half its width.
    pub all: Vec<f64>,
    pub median: f64,
    pub worst: f64,
    /// The PSNR, in dB, of the picture against the one that it comes near to, in the mean.
    pub psnr: f64,
}

impl Intervals {
    /// The intervals of a picture's pixels.
    pub fn of(estimates: &[Estimate]) -> Self {
        let half = |estimate: &Estimate| 255.0 * estimate.half_interval().max_element();
        let all: Vec<f64> = estimates.iter().map(half).collect();
        let mut sorted = all.clone();
        sorted.sort_by(f64::total_cmp);
        let variance: f64 = estimates.iter().map(|e| e.variance.element_sum()).sum();
        Self {
            median: sorted[sorted.len() / 2],
            worst: sorted[sorted.len() - 1],
            psnr: -10.0 * (variance / (3 * estimates.len()) as f64).log10(),
            all,
        }
    }
}
