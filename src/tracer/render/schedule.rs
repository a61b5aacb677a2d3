//! The order in which threads take the bands of a frame.

use super::threads::{Job, Threads};
use crate::counts::Counts;
use crate::picture::{Band, MAX_BANDS, TILE_HEIGHT};

/// Has those bands drawn first that took the most rays in the frame before, which looked much the same. So what threads take last is
/// short, and none has to wait long for another one.
pub(super) struct Schedule {
    /// The rays of each band, from the top, when it was last drawn.
    rays: [u64; MAX_BANDS],
}

impl Schedule {
    /// Nothing is known: bands are taken from the bottom up, since it is the sky, at the top, that takes the fewest rays.
    pub const fn new() -> Self {
        Self {
            rays: [0; MAX_BANDS],
        }
    }

    /// Has a job done on each band of a picture.
    pub fn run(
        &mut self,
        picture: &mut Band<'_>,
        job: Job<'_>,
        threads: &mut dyn Threads,
    ) -> Counts {
        let mut bands = [const { Band::none() }; MAX_BANDS];
        let parts = picture.parts();
        let count = parts.len();
        for (number, band) in parts.enumerate() {
            bands[self.rank(number, count)] = band;
        }
        let bands = &mut bands[..count];
        threads.run(bands, job);
        let mut sum = Counts::NONE;
        for band in bands {
            self.rays[band.top / TILE_HEIGHT] = band.counts.rays;
            sum += band.counts;
        }
        sum
    }

    /// How many of so many bands are taken before a band.
    fn rank(&self, number: usize, count: usize) -> usize {
        let key = |number| (self.rays[number], number);
        let is_before = |&other: &usize| key(other) > key(number);
        (0..count).filter(is_before).count()
    }
}

#[cfg(test)]
mod tests {
    extern crate std;

    use super::*;
    use crate::picture::BLOCK_ROWS;
    use crate::refine::Worker;
    use std::prelude::v1::*;

    /// Draws nothing, and keeps the tops of the bands in the order in which they came.
    struct Tops(Vec<usize>);

    impl Threads for Tops {
        fn run(&mut self, bands: &mut [Band<'_>], job: Job<'_>) {
            let mut worker = Worker::new();
            for band in bands {
                self.0.push(band.top);
                job(&mut worker, band);
            }
        }
    }

    #[test]
    fn bands_with_more_rays_are_taken_first_the_next_time() {
        const RAYS: [u64; 5] = [3, 0, 9, 3, 4];
        const PIXELS: usize = 2 * (4 * TILE_HEIGHT + 6);
        let job = |_: &mut Worker, band: &mut Band<'_>| {
            band.counts.rays = RAYS[band.top / TILE_HEIGHT];
            band.pixels.fill(1);
        };
        let mut schedule = Schedule::new();
        for tops in [[4, 3, 2, 1, 0], [2, 4, 3, 0, 1]] {
            let (mut pixels, mut threads) = ([0; PIXELS], Tops(Vec::new()));
            let mut picture = Band {
                width: 2,
                stride: 2,
                pixels: &mut pixels,
                rough: &mut [[0; _]; BLOCK_ROWS * 5],
                ..Band::none()
            };
            let counts = schedule.run(&mut picture, &job, &mut threads);
            assert_eq!(threads.0, tops.map(|band| band * TILE_HEIGHT));
            assert_eq!(counts.rays, 19);
            assert_eq!(pixels, [1; PIXELS], "each band is drawn once");
        }
    }
}
