use super::spectrum::windows;
use super::{BAR, cues, song};
use eightfold::show;
use eightfold::sound::{RATE, Track};
use std::collections::HashSet;

const FRAMES: usize = 16;
const BANDS: usize = 64;
const WINDOW: usize = 4096;

/// Returns the bins at the borders of bands that are equally wide in mel, from 40 Hz to 16 kHz.
fn borders() -> Vec<usize> {
    let mel = |hertz: f64| 2595.0 * (1.0 + hertz / 700.0).log10();
    let hertz = |mel: f64| 700.0 * (10_f64.powf(mel / 2595.0) - 1.0);
    let (low, high) = (mel(40.0), mel(16_000.0));
    let border = |i: usize| hertz(low + (high - low) * i as f64 / BANDS as f64);
    let bin = |i: usize| (border(i) * WINDOW as f64 / f64::from(RATE)).round() as usize;
    (0..=BANDS).map(bin).collect()
}

fn spectrogram(bar: &[[f32; 2]]) -> Vec<f64> {
    let borders = borders();
    let frames = windows(bar, WINDOW, (BAR - WINDOW) / (FRAMES - 1));
    let levels = frames.iter().flat_map(|frame| {
        borders.windows(2).map(|border| {
            let bins = &frame[border[0]..border[1].max(border[0] + 1)];
            let power: f64 = bins.iter().map(|[left, right, _]| left + right).sum();
            // -100 dB of full scale, nearly.
            let floor = 1e-10;
            (power / (WINDOW * WINDOW / 4) as f64 + floor).log10()
        })
    });
    levels.collect()
}

#[test]
fn two_thirds_of_all_bars_are_new() {
    let mut bars: Vec<Vec<f64>> = song().chunks_exact(BAR).map(spectrogram).collect();
    for band in 0..BANDS {
        let levels = bars.iter().flat_map(|bar| bar.iter().skip(band).step_by(BANDS));
        let mean = levels.sum::<f64>() / (bars.len() * FRAMES) as f64;
        let levels = bars.iter_mut().flat_map(|bar| bar.iter_mut().skip(band).step_by(BANDS));
        levels.for_each(|level| *level -= mean);
    }
    let product = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    let cosine =
        |a: &Vec<f64>, b: &Vec<f64>| product(a, b) / (product(a, a) * product(b, b)).sqrt();
    let is_old = |&i: &usize| bars[..i].iter().any(|earlier| cosine(earlier, &bars[i]) > 0.8);
    let old: Vec<usize> = (1..bars.len()).filter(is_old).collect();
    assert!(old.len() <= 20, "{}: {old:?}", old.len());
}

#[test]
fn drums_play_at_least_20_different_bars() {
    use Track::{Clap, Hat, Kick, OpenHat, Tom};
    let bar = |bar| [Kick, Clap, Hat, OpenHat, Tom].map(|drum| cues::notes(drum, bar, 1));
    let bars = (0..show::BARS).map(bar).filter(|drums| drums.iter().any(|notes| !notes.is_empty()));
    let different: HashSet<String> = bars.map(|drums| format!("{drums:?}")).collect();
    assert!(different.len() >= 20, "{}", different.len());
}
