//! Connected pixels that the show loses, without a similar pixel nearby.

use crate::drawn::{draw_best, jagged};
use crate::error::{Difference, worst_channel};
use crate::errors::patches;
use eightfold_lab::scenes::SceneName;
use eightfold_tracer::Quality;

const SIZE: [usize; 2] = [1280, 720];

/// The most pixels of a patch. The largest, of 229, is the lit edge of a column in a mirror in another mirror.
const LARGEST: usize = 240;

/// Returns the exact pixels without a drawn one within 2 pixels and 32 of 255.
fn lost(exact: &[u32], drawn: &[u32]) -> Vec<usize> {
    let [width, height] = SIZE;
    let is_alike =
        |i: usize, x: usize, y: usize| worst_channel(exact[i], drawn[y * width + x]) <= 32;
    let is_lost = |&i: &usize| {
        let (x, y) = (i % width, i / width);
        let mut near = (y.saturating_sub(2)..height.min(y + 3))
            .flat_map(|y| (x.saturating_sub(2)..width.min(x + 3)).map(move |x| (x, y)));
        !is_alike(i, x, y) && !near.any(|(x, y)| is_alike(i, x, y))
    };
    (0..exact.len()).filter(is_lost).collect()
}

fn hold(times: impl Iterator<Item = f32>) {
    let (mut largest, mut least) = (0, f64::INFINITY);
    for time in times {
        for quality in [jagged(Quality::DEFAULT), Quality::DEFAULT] {
            let scene = SceneName::Show.without_overlay(time);
            let [exact, drawn] = [quality.reference(), quality]
                .map(|quality| draw_best(&scene, &quality, SIZE[0], SIZE[1]).pixels);
            let psnr = Difference::between(&exact, &drawn).psnr;
            let patches = patches(&lost(&exact, &drawn), SIZE[0]);
            let patch = patches.iter().map(Vec::len).max().unwrap_or(0);
            println!(
                "{time} s: {psnr:.1} dB, a patch of {patch}, {}",
                quality.antialias
            );
            largest = largest.max(patch);
            least = least.min(psnr);
        }
    }
    assert!(
        largest <= LARGEST && least >= 42.0,
        "{largest}, {least:.1} dB"
    );
}

#[test]
fn show_worst_frames_have_small_patches() {
    hold([66.1, 86.1].into_iter());
}

#[test]
#[ignore = "many frames"]
fn long_show_has_small_patches() {
    hold((0..116).map(|second| second as f32 + 0.1));
}
