//! Single instruments and effects.

extern crate std;

use super::instruments::INSTRUMENTS;
use super::song::{self, Track};
use super::space::Space;
use super::voice::{Mix, Mood, Voice};
use super::{BARS, CHUNK, RATE, STEPS_PER_BAR};
use glam::Vec4;
use rustfft::{FftPlanner, num_complex::Complex};
use std::{boxed::Box, vec::Vec};

fn play(track: Track, digit: u8, bar: u32) -> Vec<[f32; 2]> {
    let instrument = &INSTRUMENTS[track as usize];
    let mood = Mood { kick: Vec4::ZERO, next_kick: Vec4::ZERO, light: Vec4::ONE, rest: false };
    let mut voice = Voice::ZERO;
    voice.start(instrument, digit, bar, 1.0);
    let mut seed: u32 = 1;
    let mut samples = Vec::new();
    while samples.len() < RATE as usize {
        let mut mixes = [Mix::SILENCE; CHUNK];
        for noise in mixes.iter_mut().flat_map(|mix| mix.noise.as_mut()) {
            seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            *noise = seed as f32 / (1_u32 << 31) as f32 - 1.0;
        }
        voice.play(instrument, &mood, &mut mixes);
        samples.extend(mixes.map(|mix| [mix.dry.x + mix.dry.z, mix.dry.y + mix.dry.w]));
    }
    samples
}

#[test]
fn kick_has_60_percent_of_its_energy_below_120_hz() {
    let is_struck = |&bar: &u32| song::digit(Track::Kick as usize, bar * STEPS_PER_BAR) > 0;
    for bar in (0..BARS).filter(is_struck) {
        let kick = play(Track::Kick, 15, bar);
        let mut bins: Vec<_> = kick.iter().map(|&[left, _]| Complex::new(left, 0.0)).collect();
        FftPlanner::new().plan_fft_forward(bins.len()).process(&mut bins);
        // A bin per Hz.
        let energy = |bins: &[Complex<f32>]| bins.iter().map(Complex::norm_sqr).sum::<f32>();
        let share = energy(&bins[..120]) / energy(&bins[..RATE as usize / 2]);
        assert!(share >= 0.6, "bar {bar}: {share}");
    }
}

/// Returns the reverberation of a click in the centre, from 100 ms to 2 s.
fn reverberation() -> Vec<[f32; 2]> {
    let mut space = Box::new(Space::ZERO);
    let struck = Mix { room: Vec4::ONE, ..Mix::SILENCE };
    let play = |position| {
        let heard = space.play(position, if position == 0 { &struck } else { &Mix::SILENCE });
        [heard.x + heard.z, heard.y + heard.w]
    };
    (0..2 * RATE as usize).map(play).skip(RATE as usize / 10).collect()
}

#[test]
fn reverberation_of_the_centre_is_wide() {
    let reverberation = reverberation();
    let product = |a: usize, b: usize| reverberation.iter().map(|s| s[a] * s[b]).sum::<f32>();
    let correlation = product(0, 1) / (product(0, 0) * product(1, 1)).sqrt();
    assert!(correlation.abs() < 0.3, "{correlation}");
}

/// The share of samples beyond the standard deviation, relative to 31.7 % of Gaussian noise (Abel
/// and Huang 2006).
#[test]
fn reverberation_is_dense_after_100_ms() {
    let samples = &reverberation()[..RATE as usize / 25];
    for side in [0, 1] {
        let squares = samples.iter().map(|sample| sample[side] * sample[side]);
        let variance = squares.clone().sum::<f32>() / samples.len() as f32;
        let beyond = squares.filter(|&square| square > variance).count() as f32;
        let density = beyond / samples.len() as f32 / 0.317;
        assert!(density > 0.7, "{density}");
    }
}
