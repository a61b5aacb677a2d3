use crate::error::worst_channel;
use std::collections::BTreeSet;

/// Returns the exhaustive pixels that differ by more than 32 of 255 from all drawn pixels within 2
/// pixels.
pub fn lost(exact: &[u32], drawn: &[u32], width: usize) -> Vec<usize> {
    let height = exact.len() / width;
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

/// Returns the number of pixels of the largest lost patch.
pub fn largest(exact: &[u32], drawn: &[u32], width: usize) -> usize {
    largest_of(&lost(exact, drawn, width), width)
}

/// Returns the number of pixels of the largest patch of `pixels`, which ascend.
pub fn largest_of(pixels: &[usize], width: usize) -> usize {
    patches(pixels, width).iter().map(Vec::len).max().unwrap_or(0)
}

/// Groups ascending pixels into patches, connected also diagonally.
pub fn patches(pixels: &[usize], width: usize) -> Vec<Vec<usize>> {
    let mut rest: BTreeSet<usize> = pixels.iter().copied().collect();
    let mut patches = Vec::new();
    while let Some(first) = rest.pop_first() {
        let mut patch = vec![first];
        let mut next = 0;
        while let Some(&pixel) = patch.get(next) {
            let (x, y) = (pixel % width, pixel / width);
            for y in y.saturating_sub(1)..=y + 1 {
                for x in x.saturating_sub(1)..=(x + 1).min(width - 1) {
                    patch.extend(rest.take(&(y * width + x)));
                }
            }
            next += 1;
        }
        patches.push(patch);
    }
    patches
}
