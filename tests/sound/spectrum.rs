use eightfold::sound::RATE;
use rustfft::{FftPlanner, num_complex::Complex};
use std::ops::Range;

/// The window in samples: bins are 5.9 Hz apart.
const WINDOW: usize = 8192;

/// The mean power spectrum of a stereo sound by Welch's method, with Hann windows that overlap by
/// half.
pub struct Spectrum {
    /// For each bin the power on the left, on the right, and the real part of their product.
    bins: Vec<[f64; 3]>,
}

impl Spectrum {
    pub fn new(samples: &[[f32; 2]]) -> Spectrum {
        let windows = windows(samples, WINDOW, WINDOW / 2);
        let sum = |bin: usize, i: usize| windows.iter().map(|window| window[bin][i]).sum::<f64>();
        let mean = |bin: usize| [0, 1, 2].map(|i| sum(bin, i) / windows.len() as f64);
        Spectrum { bins: (0..windows[0].len()).map(mean).collect() }
    }

    fn sum(&self, hertz: &Range<f64>) -> [f64; 3] {
        let bin = |hertz: f64| (hertz * WINDOW as f64 / f64::from(RATE)).round() as usize;
        let bins = &self.bins[bin(hertz.start)..bin(hertz.end)];
        [0, 1, 2].map(|i| bins.iter().map(|bin| bin[i]).sum())
    }

    pub fn power(&self, hertz: Range<f64>) -> f64 {
        let [left, right, _] = self.sum(&hertz);
        left + right
    }

    pub fn level(&self, hertz: Range<f64>) -> f64 {
        let octaves = (hertz.end / hertz.start).log2();
        10.0 * (self.power(hertz) / octaves).log10()
    }

    pub fn correlation(&self, hertz: Range<f64>) -> f64 {
        let [left, right, both] = self.sum(&hertz);
        both / (left * right).sqrt()
    }
}

pub fn windows(samples: &[[f32; 2]], window: usize, hop: usize) -> Vec<Vec<[f64; 3]>> {
    let fft = FftPlanner::new().plan_fft_forward(window);
    let hann = |i: usize| (std::f64::consts::PI * i as f64 / window as f64).sin().powi(2);
    let starts = (0..=samples.len() - window).step_by(hop);
    let spectra = starts.map(|start| {
        // Left and right are the real and the imaginary part, whose spectra are the even and the
        // odd half of the sum's spectrum.
        let samples = samples[start..start + window].iter().enumerate();
        let mut bins: Vec<_> = samples
            .map(|(i, &[left, right])| Complex::new(f64::from(left), f64::from(right)) * hann(i))
            .collect();
        fft.process(&mut bins);
        let pairs = (1..window / 2).map(|i| (bins[i], bins[window - i].conj()));
        let powers = pairs.map(|(up, down)| {
            let (left, right) = ((up + down) * 0.5, (up - down) * Complex::new(0.0, -0.5));
            [left.norm_sqr(), right.norm_sqr(), (left * right.conj()).re]
        });
        std::iter::once([0.0; 3]).chain(powers).collect()
    });
    spectra.collect()
}
