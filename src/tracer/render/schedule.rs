use super::threads::{Job, Threads};
use crate::counts::Counts;
use crate::picture::{Band, MAX_BANDS, TILE_HEIGHT};

/// Sorts bands by their rays in the previous frame, most first, so that threads finish at about the same time.
pub(super) struct Schedule {
    rays: [u64; MAX_BANDS],
}

impl Schedule {
    /// Without a previous frame bands are drawn from the bottom up, since the sky needs the fewest rays.
    pub const fn new() -> Self {
        Self {
            rays: [0; MAX_BANDS],
        }
    }

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

    /// Returns the position of the band in drawing order.
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
    use crate::picture::CELL_ROWS;
    use crate::refine::Worker;
    use std::prelude::v1::*;

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
    fn bands_with_most_rays_are_drawn_first() {
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
                rough: &mut [[0; _]; CELL_ROWS * 5],
                ..Band::none()
            };
            let counts = schedule.run(&mut picture, &job, &mut threads);
            assert_eq!(threads.0, tops.map(|band| band * TILE_HEIGHT));
            assert_eq!(counts.rays, 19);
            assert_eq!(pixels, [1; PIXELS], "each band is drawn once");
        }
    }
}
