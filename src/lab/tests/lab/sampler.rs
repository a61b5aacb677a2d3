//! Points of the sampler are even, and means over them come near to integrals as fast as they are said to.

use eightfold_lab::sampler::{Sampler, Sequence, around, cosine_hemisphere, disc, seed_of};
use eightfold_tracer::glam::{DVec2, DVec3, dvec2};

/// Coordinates of the points that are averaged.
const DIMENSIONS: usize = 4;

/// A smooth function of the unit cube whose integral is 1.
fn smooth(sampler: &mut Sampler) -> f64 {
    let factor = |u: f64| 1.0 + 0.6 * (std::f64::consts::PI * u).cos();
    (0..DIMENSIONS).map(|_| factor(sampler.next_1d())).product()
}

/// The root of the mean squared error of the mean of so many points, over many seeds.
fn error(sequence: Sequence, points: usize) -> f64 {
    const SEEDS: u32 = 40;
    let squared = |seed| {
        let sum: f64 = (0..points)
            .map(|i| smooth(&mut Sampler::new(sequence, i, seed_of(seed, 0))))
            .sum();
        (sum / points as f64 - 1.0).powi(2)
    };
    ((0..SEEDS).map(squared).sum::<f64>() / f64::from(SEEDS)).sqrt()
}

#[test]
fn scrambled_sobol_points_converge_faster_than_chance() {
    // The slope of the error in a plot with logarithmic axes, over a factor of 64.
    let slope = |sequence| (error(sequence, 4096) / error(sequence, 64)).log(64.0);
    let (sobol, random) = (slope(Sequence::Sobol), slope(Sequence::Random));
    assert!((-0.6..-0.4).contains(&random), "by chance: {random}");
    assert!(sobol < -1.2, "Sobol: {sobol}");
    assert!(error(Sequence::Sobol, 64) < 0.3 * error(Sequence::Random, 64));
}

#[test]
fn every_sixteen_points_fall_into_sixteen_parts() {
    for seed in 0..50 {
        for dimension in [0, 1, 5, 40, 300] {
            let mut parts = [0; 16];
            for i in 0..16 {
                let mut sampler = Sampler::new(Sequence::Sobol, i, seed);
                let number = (0..=dimension).map(|_| sampler.next_1d()).last();
                parts[(number.expect("a number") * 16.0) as usize] += 1;
            }
            assert_eq!(parts, [1; 16], "dimension {dimension}, seed {seed}");
        }
    }
}

#[test]
fn numbers_are_from_0_to_below_1_and_depend_on_all() {
    for sequence in [Sequence::Sobol, Sequence::Random] {
        let first = |index, seed| {
            let mut sampler = Sampler::new(sequence, index, seed);
            [(); 8].map(|()| sampler.next_1d())
        };
        let numbers = first(3, 7);
        assert!(numbers.iter().all(|number| (0.0..1.0).contains(number)));
        assert_eq!(numbers, first(3, 7));
        assert_ne!(numbers, first(4, 7));
        assert_ne!(numbers, first(3, 8));
        assert!(numbers.windows(2).all(|pair| pair[0] != pair[1]));
    }
}

/// The mean of a function over an even grid.
fn mean<T: std::iter::Sum + std::ops::Div<f64, Output = T>>(of: impl Fn(DVec2) -> T) -> T {
    const SIDE: usize = 64;
    let centre = |i: usize| (i as f64 + 0.5) / SIDE as f64;
    let points = (0..SIDE * SIDE).map(|i| dvec2(centre(i % SIDE), centre(i / SIDE)));
    points.map(of).sum::<T>() / (SIDE * SIDE) as f64
}

#[test]
fn directions_have_the_densities_that_they_are_said_to_have() {
    // Of a uniform disc of radius 1.
    assert!((mean(|u| disc(u).length_squared()) - 0.5).abs() < 1e-3);
    assert!(mean(|u| disc(u).length()) <= 1.0);
    for axis in [DVec3::Y, DVec3::new(0.6, 0.0, -0.8), DVec3::NEG_Z] {
        // By cosine / pi the mean direction is 2/3 of the axis, by a uniform hemisphere half of it.
        let cosine = mean(|u| cosine_hemisphere(axis, u));
        let uniform = mean(|u| around(axis, u.x, u.y));
        assert!(cosine.distance(axis * 2.0 / 3.0) < 2e-3, "{cosine}");
        assert!(uniform.distance(axis / 2.0) < 2e-3, "{uniform}");
    }
}
