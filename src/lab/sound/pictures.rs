//! Pictures of the soundtrack: its waveform and its spectrogram, over seconds, with the show's scenes above.

use crate::bitmap::{Area, bitmap, colour, text};
use crate::overlay::heat;
use crate::picture;
use anyhow::Result;
use eightfold::show::{BARS, CUTS, LENGTH, NAMES, grid::BAR};
use eightfold::sound::RATE;
use plotters::coord::ranged1d::{AsRangedCoord, Ranged, ValueFormatter};
use plotters::coord::types::RangedCoordf32;
use plotters::prelude::*;
use plotters::style::FontStyle;
use rustfft::{Fft, FftDirection, algorithm::Radix4, num_complex::Complex};
use std::f32::consts::TAU;

/// The size of a picture in pixels: about 33 columns per bar.
const SIZE: [usize; 2] = [2016, 552];

/// The colours of the lines at the start of a bar, and of a scene.
const LINES: [RGBColor; 2] = [RGBColor(225, 225, 225), RGBColor(150, 150, 150)];
/// The colour from the smallest to the largest sample of a column.
const PEAK: RGBColor = RGBColor(58, 110, 165);
/// The colour within the root mean square of a column.
const RMS: RGBColor = RGBColor(159, 200, 240);

/// The length of the spectrogram's window in samples: 0.17 s, which resolves semitones down to 110 Hz.
const WINDOW: usize = 8192;
/// The lowest and the highest frequency drawn, in Hz: about the limits of hearing.
const FREQUENCIES: [f32; 2] = [25.0, 22_000.0];
/// The level that is drawn black, in dB of a sine of full scale, which is drawn brightest.
const FLOOR: f32 = -100.0;

/// The waveform of the whole soundtrack as PNG: the left channel above the right.
pub fn waveform(samples: &[[f32; 2]]) -> Result<Vec<u8>> {
    draw(|area| {
        for (channel, area) in area.split_evenly((2, 1)).iter().enumerate() {
            let mut chart = chart(area, ["left", "right"][channel], -1.0..1.0_f32)?;
            for bar in 0..BARS {
                let second = bar as f32 * BAR;
                let colour = LINES[usize::from(CUTS.contains(&bar))];
                chart.draw_series([PathElement::new([(second, -1.0), (second, 1.0)], colour)])?;
            }
            let (width, _) = chart.plotting_area().dim_in_pixel();
            let columns = samples.chunks(samples.len().div_ceil(width as usize));
            for (x, column) in columns.enumerate() {
                let second = x as f32 / width as f32 * LENGTH;
                let levels = column.iter().map(|sample| sample[channel]);
                let (least, most) = levels.clone().fold((1.0, -1.0), |(least, most), level| {
                    (level.min(least), level.max(most))
                });
                let squares: f32 = levels.map(|level| level * level).sum();
                let rms = (squares / column.len() as f32).sqrt();
                for (from, to, colour) in
                    [(least, most, PEAK), (least.max(-rms), most.min(rms), RMS)]
                {
                    let line = [(second, from), (second, to)];
                    chart.draw_series([PathElement::new(line, colour)])?;
                }
            }
        }
        Ok(())
    })
}

/// The spectrogram of the whole soundtrack as PNG: frequency upwards on a logarithmic scale.
pub fn spectrogram(samples: &[[f32; 2]]) -> Result<Vec<u8>> {
    draw(|area| {
        let [lowest, highest] = FREQUENCIES;
        let chart = chart(area, "Hz", (lowest..highest).log_scale())?;
        let plot = chart.plotting_area();
        let (width, height) = plot.dim_in_pixel();
        let pixels = plot.strip_coord_spec();
        let transform = Radix4::new(WINDOW, FftDirection::Forward);
        let mut window = vec![Complex::default(); WINDOW];
        for x in 0..width as usize {
            let middle = (2 * x + 1) * samples.len() / (2 * width as usize);
            for (i, value) in window.iter_mut().enumerate() {
                let position = (middle + i).checked_sub(WINDOW / 2);
                let sample = position.and_then(|at| samples.get(at));
                let sample = sample.map_or(0.0, |[left, right]| 0.5 * (left + right));
                // The Hann window.
                let weight = 0.5 - 0.5 * (TAU * i as f32 / WINDOW as f32).cos();
                *value = Complex::new(sample * weight, 0.0);
            }
            transform.process(&mut window);
            for y in 0..height {
                let frequency =
                    |y: u32| highest * (lowest / highest).powf(y as f32 / height as f32);
                let level = level(&window, [frequency(y + 1), frequency(y)]);
                pixels.draw_pixel((x as i32, y as i32), &colour(heat(1.0 - level / FLOOR)))?;
            }
        }
        Ok(())
    })
}

/// The largest level between two frequencies in dB, 0 for a sine of full scale.
fn level(spectrum: &[Complex<f32>], edges: [f32; 2]) -> f32 {
    let [first, last] = edges.map(|edge| (edge * WINDOW as f32 / RATE as f32) as usize);
    let levels = spectrum[first..=last].iter().map(|value| value.norm());
    let most = levels.fold(0.0, f32::max);
    // A sine has half of its amplitude at the positive frequency. The window's mean is one half, too.
    20.0 * (most * 4.0 / WINDOW as f32).log10()
}

/// A PNG file of what is drawn on white.
fn draw(draw: impl FnOnce(&Area<'_>) -> Result<()>) -> Result<Vec<u8>> {
    Ok(picture::png(SIZE[0], &bitmap(SIZE, 0x00ff_ffff, draw)?)?)
}

/// A chart over the seconds of the show, with the names of its scenes above.
fn chart<'a, 'b, Y>(
    area: &'a Area<'b>,
    y_label: &str,
    y: Y,
) -> Result<ChartContext<'a, BitMapBackend<'b>, Cartesian2d<RangedCoordf32, Y::CoordDescType>>>
where
    Y: AsRangedCoord<Value = f32>,
    Y::CoordDescType: Ranged<ValueType = f32> + ValueFormatter<f32>,
{
    let style = text(14, FontStyle::Normal);
    let mut chart = ChartBuilder::on(area)
        .margin_top(24)
        .margin_right(24)
        .margin_left(10)
        .x_label_area_size(40)
        .y_label_area_size(72)
        .build_cartesian_2d(0.0..LENGTH, y)?;
    chart
        .configure_mesh()
        .disable_mesh()
        .x_labels(12)
        .x_label_formatter(&f32::to_string)
        .x_desc("seconds")
        .y_desc(y_label)
        .label_style(style.clone())
        .axis_desc_style(style.clone())
        .draw()?;
    for (name, cut) in NAMES.into_iter().zip(CUTS) {
        let corner = (cut as f32 * BAR, chart.y_range().end);
        let (left, _) = chart.plotting_area().map_coordinate(&corner);
        area.draw_text(name, &style, (left, 4))?;
    }
    Ok(chart)
}
