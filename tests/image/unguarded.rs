//! `finest` loses no unguarded light, see `docs/accuracy.md`.

use crate::cpu;
use crate::drawn::jagged;
use crate::patches::compared;
use eightfold_scenes::artists::{KINDS, Kind, ON_FLOORS};
use eightfold_tracer::{Preset, Quality};

const FINEST: Quality = *Preset::Finest.quality();

/// The least patch that counts, in pixels, as in docs/accuracy.md.
const PATCH: usize = 20;

const SMALL: [usize; 2] = [640, 360];
const LARGE: [usize; 2] = [1280, 720];

/// Returns the number of scenes with a patch, the largest patch, and the least PSNR in dB.
fn worst(
    kind: Kind,
    seeds: impl IntoIterator<Item = u64>,
    quality: Quality,
    size: [usize; 2],
) -> (usize, usize, f64) {
    let all = seeds.into_iter().map(|seed| {
        let (psnr, patch) = compared(cpu::best(), &kind.seeded(seed), jagged(quality), size);
        if patch >= PATCH {
            println!("{}, seed {seed}: a patch of {patch}", kind.0);
        }
        (psnr, patch)
    });
    all.fold((0, 0, f64::INFINITY), |(patched, max_patch, min_psnr), (psnr, patch)| {
        (patched + usize::from(patch >= PATCH), max_patch.max(patch), min_psnr.min(psnr))
    })
}

/// Without `unguarded_weight` some of these seeds have patches in stairs, shelves, water, mirrors, glass, nets in balls and strips
/// of light.
#[test]
fn finest_shows_thin_things_without_bounds() {
    for kind in &KINDS[ON_FLOORS..] {
        assert_eq!(worst(*kind, [0, 2, 7], FINEST, SMALL).0, 0, "{}", kind.0);
    }
}

/// Also prints the patches of `default`.
#[test]
#[ignore = "2,640 scenes"]
fn long_finest_shows_thin_things_without_bounds() {
    for kind in &KINDS[ON_FLOORS..] {
        for (count, size) in [(200, SMALL), (40, LARGE)] {
            assert_eq!(worst(*kind, 0..count, FINEST, size).0, 0, "{}", kind.0);
        }
        let (patched, patch, psnr) = worst(*kind, 0..40, Quality::DEFAULT, LARGE);
        println!("{} by default: {patched} of 40, up to {patch} pixels, {psnr:.1} dB", kind.0);
    }
}
