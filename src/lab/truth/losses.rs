//! Losses of the real-time model against the truth: pictures and figures for each effect.

use super::effects::Effects;
use super::estimate::{Estimate, Intervals};
use super::render::{self, Picture};
use super::{INTERVAL_SHOWN, interval_picture, pixels};
use crate::arguments::processors;
use crate::error::Difference;
use crate::figures::sheet::{Figure, sheet};
use crate::flip::Flip;
use crate::markdown::decibels;
use crate::overlay::draw_error;
use crate::threaded_renderer::drawn;
use crate::{output, picture};
use anyhow::{Context, Result};
use eightfold_tracer::Quality;
use rayon::ThreadPool;
use std::fs;
use std::path::Path;

/// The least width of a picture on the sheet, in pixels: captions are as wide. Smaller pictures are enlarged.
const LEAST_WIDTH: usize = 400;
/// The error in a channel, in steps of 1/255, that is shown in white.
const ERROR_SHOWN: u32 = 64;

/// What takes the place of each effect of the truth, in the order of [`Effects::NAMES`], as they are switched off one by one.
const LEFT_OUT: [&str; 4] = [
    "Indirect light: ambient light instead",
    "Caustics: tinted shadows instead",
    "Soft shadows: lamps as points instead",
    "Kept energy: plain coefficients instead",
];

/// Two pictures that are compared.
struct Loss {
    name: &'static str,
    title: &'static str,
    /// The one with the effect.
    with: Vec<u32>,
    without: Vec<u32>,
    /// The cost: the difference, and the mean FLIP error.
    difference: Difference,
    flip: f64,
}

/// Draws all pictures of a scene, writes them and their sheet to a folder, and prints a table.
pub fn run(truth: &Picture<'_>, scene: &str, pool: &ThreadPool, folder: &Path) -> Result<()> {
    fs::create_dir_all(folder).with_context(|| format!("cannot make {}", folder.display()))?;
    let width = truth.size.width;
    let draw = |name: &str, effects: Effects| {
        let picture = Picture { effects, ..*truth };
        let film = picture.draw_resumably(pool, &folder.join(format!("{name}.png")), None, true)?;
        Ok(film.estimates())
    };
    let estimates = draw("truth", Effects::TRUTH)?;
    let losses = losses(truth, &pixels(&estimates), &draw)?;
    for loss in &losses {
        let png = picture::png(width, &loss.without)?;
        output::write(&folder.join(format!("{}.png", loss.name)), &png)?;
    }
    let truth_png = picture::png(width, &pixels(&estimates))?;
    output::write(&folder.join("truth.png"), &truth_png)?;
    let count = truth.sampling.count * super::REPLICATIONS;
    let heading = format!("{scene}, {}, {count} samples a pixel", truth.size);
    let mut figures = figures(&estimates, &losses);
    let by = LEAST_WIDTH.div_ceil(width);
    for figure in &mut figures {
        figure.pixels = enlarged(&figure.pixels, width, by);
    }
    let (sheet_width, pixels) = sheet(&heading, &figures, by * width, by * truth.size.height)?;
    output::write(
        &folder.join("sheet.png"),
        &picture::png(sheet_width, &pixels)?,
    )?;
    let text = format!("{heading}\n\n{}", table(&estimates, &losses));
    for name in losses.iter().map(|loss| loss.name).chain(["truth"]) {
        render::forget(&folder.join(format!("{name}.png")));
    }
    output::write(Path::new("-"), text.as_bytes())
}

/// Draws all pictures but that of the truth, which is `whole`.
fn losses(
    truth: &Picture<'_>,
    whole: &[u32],
    draw: &impl Fn(&str, Effects) -> Result<Vec<Estimate>>,
) -> Result<Vec<Loss>> {
    let real_time = |quality| drawn(processors(), truth.scene, &quality, truth.size);
    let exhaustive = real_time(Quality::EXHAUSTIVE);
    let loss = |name, title, with: &[u32], without: Vec<u32>| Loss {
        name,
        title,
        difference: Difference::between(with, &without),
        flip: Flip::between(truth.size.width, with, &without).mean(),
        with: with.to_vec(),
        without,
    };
    let all = "All of it: the real-time model";
    let mut losses = vec![loss("real-time", all, whole, exhaustive.clone())];
    for (effect, title) in LEFT_OUT.into_iter().enumerate() {
        let (name, effects) = (Effects::NAMES[effect], Effects::TRUTH.with(effect, false));
        losses.push(loss(name, title, whole, pixels(&draw(name, effects)?)));
    }
    let falloff = Effects {
        falloff: true,
        ..Effects::TRUTH
    };
    let falloff = pixels(&draw("falloff", falloff)?);
    let title = "Falloff of lamps, added to the truth";
    losses.push(loss("falloff", title, whole, falloff));
    let smooth = pixels(&draw("edges", Effects::NONE)?);
    let title = "Antialiasing: one sample a pixel instead";
    losses.push(loss("edges", title, &smooth, exhaustive));
    // Both with smooth edges.
    let [traced, filled] = [Quality::DEFAULT.reference(), Quality::DEFAULT];
    let [traced, filled] = [traced, filled].map(real_time);
    let title = "Every pixel traced: adaptive squares instead";
    losses.push(loss("squares", title, &traced, filled));
    Ok(losses)
}

/// The pictures of the sheet: the truth, the model, and then each difference.
fn figures(estimates: &[Estimate], losses: &[Loss]) -> Vec<Figure> {
    let intervals = Intervals::of(estimates);
    let model = &losses[0];
    let mut all = vec![
        Figure::new(
            "truth",
            "The truth: the rendering equation",
            format!("noise {:.1} dB", intervals.psnr),
            pixels(estimates),
        ),
        Figure::new(
            model.name,
            "The real-time model",
            "every pixel traced".to_owned(),
            model.without.clone(),
        ),
        Figure::new(
            "interval",
            "How far the truth may be off, 95 %",
            format!(
                "+-{:.1} in the median, +-{:.0} at worst",
                intervals.median, intervals.worst
            ),
            interval_picture(&intervals),
        )
        .up_to(INTERVAL_SHOWN),
    ];
    all.extend(losses.iter().map(|loss| {
        let mut pixels = loss.without.clone();
        draw_error(&mut pixels, &loss.with, ERROR_SHOWN);
        let psnr = decibels(loss.difference.psnr);
        let caption = format!("PSNR {psnr}, FLIP {:.4}", loss.flip);
        Figure::new(loss.name, loss.title, caption, pixels).up_to(ERROR_SHOWN)
    }));
    all
}

/// A picture with each pixel as a square of `by` times `by`.
fn enlarged(pixels: &[u32], width: usize, by: usize) -> Vec<u32> {
    let rows = pixels.chunks_exact(width);
    let rows = rows.flat_map(|row| std::iter::repeat_n(row, by));
    rows.flat_map(|row| row.iter().flat_map(|&pixel| std::iter::repeat_n(pixel, by)))
        .collect()
}

/// The table of what each effect costs, in Markdown.
fn table(estimates: &[Estimate], losses: &[Loss]) -> String {
    let mut text = String::from(
        "| left out | PSNR | FLIP | mean | over 8/255 |\n| --- | ---: | ---: | ---: | ---: |\n",
    );
    for loss in losses {
        let difference = loss.difference;
        text += &format!(
            "| {} | {} | {:.4} | {:.2} | {:.1} % |\n",
            loss.title,
            decibels(difference.psnr),
            loss.flip,
            difference.mean,
            100.0 * difference.over_8 as f64 / estimates.len() as f64
        );
    }
    text + &format!(
        "| (noise of the truth) | {} | | | |\n",
        decibels(Intervals::of(estimates).psnr)
    )
}
