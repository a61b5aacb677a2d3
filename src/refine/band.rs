//! A band of the picture: the unit of work that threads share.

use super::Border;
use super::fill::Canvas;
use super::refiner::Refiner;
use crate::lanes::*;
use crate::observe::Observer;
use crate::prepare::{Prepared, Seen};
use crate::quality::Quality;
use crate::worker::Worker;
use fearless_simd::Level;

/// Rows of a band, unless its squares are larger: enough for full lanes, few enough to share a picture evenly.
const ROWS: usize = 16;

/// Some rows of the picture.
pub struct Band<'a> {
    /// The picture's rows from here.
    pub(crate) top: usize,
    pub(crate) width: usize,
    pub(crate) pixels: &'a mut [u32],
    /// The borders above and below.
    pub(crate) borders: &'a mut [Border],
    /// Whether they hold what the band above and the band below traced.
    pub(crate) are_done: [bool; 2],
}

impl Band<'_> {
    /// No rows.
    pub(crate) const fn none() -> Self {
        Self {
            top: 0,
            width: 0,
            pixels: &mut [],
            borders: &mut [],
            are_done: [false; 2],
        }
    }

    /// Rows of a band for squares of a size.
    pub(crate) const fn rows(square: usize) -> usize {
        if square > ROWS {
            square
        } else {
            ROWS / square * square
        }
    }
}

/// Renders a band: refines in the lanes that every CPU has, traces by the given instruction set.
pub(crate) fn render(
    level: Level,
    scene: &Prepared,
    quality: &Quality,
    worker: &mut Worker,
    band: &mut Band<'_>,
) {
    render_observed(level, scene, quality, (), worker, band);
}

/// Like [`render`], and the observer hears of it.
pub(crate) fn render_observed<O: Observer>(
    level: Level,
    scene: &Prepared,
    quality: &Quality,
    observer: O,
    worker: &mut Worker,
    band: &mut Band<'_>,
) {
    #[cfg(target_arch = "x86_64")]
    if let Some(simd) = level.as_sse2() {
        render_by(simd, level, scene, quality, observer, worker, band);
    }
    #[cfg(not(target_arch = "x86_64"))]
    fearless_simd::dispatch!(level, simd => render_by(simd, level, scene, quality, observer, worker, band));
}

fn render_by<S: Simd, O: Observer>(
    simd: S,
    level: Level,
    scene: &Prepared,
    quality: &Quality,
    observer: O,
    worker: &mut Worker,
    band: &mut Band<'_>,
) {
    let height = band.pixels.len() / band.width.max(1);
    let mut refiner = Refiner {
        simd,
        level,
        scene,
        quality,
        observer,
        top: band.top,
        seen: Seen::default(),
        limits: quality.limits(),
        next: 0,
        end: 0,
        worker,
        canvas: Canvas {
            pixels: &mut *band.pixels,
            width: band.width,
            height,
        },
    };
    if quality.square == 1 {
        refiner.every_pixel();
        return;
    }
    refiner.exchange(band.borders, band.are_done, true);
    refiner.squares();
    refiner.exchange(band.borders, band.are_done, false);
    refiner.show_method();
}
