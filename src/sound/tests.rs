//! Instruments and effects alone.

extern crate std;

use super::instruments::INSTRUMENTS;
use super::song::{self, Track};
use super::space::Space;
use super::voice::{Mix, Mood, Voice};
use super::{BARS, CHUNK, RATE, STEPS_PER_BAR};
use glam::Vec4;
use rustfft::{FftPlanner, num_complex::Complex};
use std::{boxed::Box, vec::Vec};

/// Plays a second of a note.
fn play(track: Track, digit: u8, bar: u32) -> Vec<[f32; 2]> {
    let instrument = &INSTRUMENTS[track as usize];
    let mood = Mood { kick: Vec4::ZERO, next_kick: Vec4::ZERO, light: Vec4::ONE, rest: false };
    let mut voice = Voice::ZERO;
    voice.start(instrument, digit, bar);
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

#[test]
fn reverberation_of_the_centre_is_wide() {
    let mut space = Box::new(Space::ZERO);
    let struck = Mix { room: Vec4::ONE, ..Mix::SILENCE };
    let (mut left, mut right, mut both) = (0.0_f32, 0.0_f32, 0.0_f32);
    for position in 0..2 * RATE as usize {
        let heard = space.play(position, if position == 0 { &struck } else { &Mix::SILENCE });
        if position > RATE as usize / 10 {
            let [l, r] = [heard.x + heard.z, heard.y + heard.w];
            (left, right, both) = (left + l * l, right + r * r, both + l * r);
        }
    }
    let correlation = both / (left * right).sqrt();
    assert!(correlation.abs() < 0.3, "{correlation}");
}
