//! Draws the spectrogram: time to the right, frequency upwards on a logarithmic scale.

use super::axes::Heights;
use eightfold::sound::RATE;
use rustfft::{FftPlanner, num_complex::Complex};
use std::f32::consts::{PI, TAU};

/// The length of the analysis window in samples: 0.17 s, which resolves semitones down to 110 Hz.
const WINDOW: usize = 8192;

/// The lowest and the highest frequency drawn, in Hz: about the limits of hearing.
const FREQUENCIES: (f32, f32) = (25.0, 22_000.0);

/// The level that is drawn black, in dB of a sine of full scale, which is drawn white.
const FLOOR: f32 = -100.0;

/// The colour map, from the floor to full scale.
const COLOURS: [[f32; 3]; 6] = [
    [0.0, 0.0, 0.0],
    [30.0, 12.0, 80.0],
    [130.0, 25.0, 110.0],
    [225.0, 70.0, 60.0],
    [250.0, 170.0, 50.0],
    [255.0, 255.0, 220.0],
];

/// Draws the spectrogram of samples.
pub fn draw(samples: &[[f32; 2]], width: usize, height: usize) -> Vec<u32> {
    let transform = FftPlanner::new().plan_fft_forward(WINDOW);
    let mut pixels = vec![0; width * height];
    let mut window = vec![Complex::default(); WINDOW];
    for x in 0..width {
        let middle = (2 * x + 1) * samples.len() / (2 * width);
        for (i, value) in window.iter_mut().enumerate() {
            let position = (middle + i).checked_sub(WINDOW / 2);
            let sample = position
                .and_then(|at| samples.get(at))
                .map_or(0.0, |[left, right]| 0.5 * (left + right));
            // The Hann window.
            let weight = 0.5 - 0.5 * (TAU * i as f32 / WINDOW as f32).cos();
            *value = Complex::new(sample * weight, 0.0);
        }
        transform.process(&mut window);
        for y in 0..height {
            let edges = [y + 1, y].map(|y| frequency(y as f32 / height as f32));
            pixels[y * width + x] = colour(level(&window, edges));
        }
    }
    pixels
}

/// The frequency at a height, given as a share from the top.
fn frequency(share: f32) -> f32 {
    let (lowest, highest) = FREQUENCIES;
    highest * (lowest / highest).powf(share)
}

/// The values of its heights.
pub fn heights() -> Heights {
    let (lowest, highest) = FREQUENCIES;
    let share = |hertz: f32| (hertz / highest).ln() / (lowest / highest).ln();
    let numbers = [
        50.0, 100.0, 200.0, 500.0, 1000.0, 2000.0, 5000.0, 10_000.0, 20_000.0,
    ];
    Heights {
        ticks: numbers
            .map(|hertz| (share(hertz), hertz.to_string()))
            .to_vec(),
        unit: "Hz",
    }
}

/// The largest level between two frequencies in dB, 0 for a sine of full scale.
fn level(spectrum: &[Complex<f32>], edges: [f32; 2]) -> f32 {
    let [first, last] = edges.map(|edge| (edge * WINDOW as f32 / RATE as f32) as usize);
    let most = spectrum[first..=last]
        .iter()
        .map(|value| value.norm())
        .fold(0.0, f32::max);
    // A sine has half of its amplitude at the positive frequency. The window's mean is one half, too.
    20.0 * (most * 4.0 / WINDOW as f32).log10()
}

/// The colour of a level in dB.
fn colour(level: f32) -> u32 {
    let position = (1.0 - level / FLOOR).clamp(0.0, 0.999_9) * (COLOURS.len() - 1) as f32;
    let (below, share) = (position as usize, position.fract());
    // Smooth, so that no edge is visible where two colours meet.
    let share = 0.5 - 0.5 * (share * PI).cos();
    let mix = |channel: usize| {
        let (a, b) = (COLOURS[below][channel], COLOURS[below + 1][channel]);
        (a + (b - a) * share) as u32
    };
    mix(0) << 16 | mix(1) << 8 | mix(2)
}
