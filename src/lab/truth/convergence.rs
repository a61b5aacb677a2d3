//! How fast pictures come near to the truth: the error against the number of samples, by the sampler and by random points.

use super::render::Picture;
use crate::output;
use crate::sampler::Sequence;
use anyhow::Result;
use eightfold_tracer::glam::DVec3;
use rayon::ThreadPool;
use std::path::Path;

/// The seed of the picture that errors are measured against.
const REFERENCE_SEED: u32 = 0x5eed;
/// How many times as many samples it has as the last row of the table.
const REFERENCE: usize = 8;

/// Draws pictures with 8, 16, 32 samples and so on up to those asked for, and prints their errors.
pub fn run(truth: &Picture<'_>, scene: &str, pool: &ThreadPool) -> Result<()> {
    let counts: Vec<usize> = (0..)
        .map(|power| 1 << power)
        .take_while(|&count| count <= truth.sampling.count)
        .collect();
    let reference = radiances(truth, pool, Sequence::Sobol, REFERENCE_SEED, {
        REFERENCE * truth.sampling.count
    });
    let mut text = format!(
        "{scene}, {}: root mean square of the pixels' errors, of 255\n\n\
         | samples a pixel | Owen-scrambled Sobol | random |\n| ---: | ---: | ---: |\n",
        truth.size
    );
    let mut errors = Vec::new();
    for &count in &counts {
        let both = [Sequence::Sobol, Sequence::Random].map(|sequence| {
            let picture = radiances(truth, pool, sequence, truth.sampling.seed, count);
            root_mean_square(&picture, &reference)
        });
        let samples = count * super::REPLICATIONS;
        text += &format!("| {samples} | {:.2} | {:.2} |\n", both[0], both[1]);
        errors.push(both);
    }
    let slope = |i: usize| {
        let points = counts.iter().zip(&errors);
        slope(points.map(|(&count, both)| (count as f64, both[i])))
    };
    text += &format!("| slope | {:.2} | {:.2} |\n", slope(0), slope(1));
    output::write(Path::new("-"), text.as_bytes())
}

/// The means of the pixels of a picture, with so many samples of each replication.
fn radiances(
    truth: &Picture<'_>,
    pool: &ThreadPool,
    sequence: Sequence,
    seed: u32,
    count: usize,
) -> Vec<DVec3> {
    let mut picture = *truth;
    picture.sampling.sequence = sequence;
    picture.sampling.seed = seed;
    picture.sampling.count = count;
    let estimates = picture.draw(pool);
    estimates.iter().map(|estimate| estimate.mean).collect()
}

/// The root mean square difference of two pictures in all channels, of 255.
fn root_mean_square(a: &[DVec3], b: &[DVec3]) -> f64 {
    let pairs = a.iter().zip(b);
    let sum: f64 = pairs.map(|(a, b)| a.distance_squared(*b)).sum();
    255.0 * (sum / (3 * a.len()) as f64).sqrt()
}

/// The slope of the line that fits points best in a plot with logarithmic axes: -0.5 if the error halves with four times the
/// samples.
pub fn slope(points: impl Iterator<Item = (f64, f64)>) -> f64 {
    let (mut n, mut sum, mut products, mut squares) = (0.0, [0.0; 2], 0.0, 0.0);
    for (x, y) in points.map(|(x, y)| (x.ln(), y.ln())) {
        n += 1.0;
        sum[0] += x;
        sum[1] += y;
        products += x * y;
        squares += x * x;
    }
    (n * products - sum[0] * sum[1]) / (n * squares - sum[0] * sum[0])
}
