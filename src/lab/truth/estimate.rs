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

/// Mean and variance of numbers that come one by one, each channel for itself (Welford, 1962).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Welford {
    count: u32,
    mean: DVec3,
    /// The sum of squared differences from the mean.
    squares: DVec3,
}

impl Welford {
    /// Adds a number.
    pub fn add(&mut self, number: DVec3) {
        self.count += 1;
        let before = number - self.mean;
        self.mean += before / f64::from(self.count);
        self.squares += before * (number - self.mean);
    }

    /// The mean; 0 without any numbers.
    pub fn mean(&self) -> DVec3 {
        self.mean
    }

    /// The variance of the numbers, without bias; 0 of fewer than two.
    pub fn variance(&self) -> DVec3 {
        self.squares / f64::from(self.count.saturating_sub(1).max(1))
    }

    /// The variance of the mean.
    pub fn variance_of_mean(&self) -> DVec3 {
        self.variance() / f64::from(self.count.max(1))
    }
}

impl FromIterator<DVec3> for Welford {
    fn from_iter<T: IntoIterator<Item = DVec3>>(numbers: T) -> Self {
        let mut all = Self::default();
        numbers.into_iter().for_each(|number| all.add(number));
        all
    }
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
        let all: Welford = means.collect();
        Self {
            mean: all.mean(),
            variance: all.variance_of_mean(),
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
