use super::threads::{Job, Threads};
use crate::counts::Counts;
use crate::picture::{Band, MAX_BANDS, TILE_HEIGHT};

/// Sorts bands by their rays in the previous frame, most first: threads finish at about the same
/// time. Without a previous frame bands are drawn from the bottom up: the sky needs the fewest
/// rays.
pub(super) struct Schedule {
    rays: [u64; MAX_BANDS],
}

zero! { Schedule { rays } }

impl Schedule {
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
    use crate::zero::Zero;
    use std::sync::Mutex;
    use std::vec::Vec;

    #[test]
    fn bands_with_most_rays_are_drawn_first() {
        const RAYS: [u64; 5] = [3, 0, 9, 3, 4];
        const PIXELS: usize = 2 * (4 * TILE_HEIGHT + 6);
        let order = Mutex::new(Vec::new());
        let job = |_: &mut Worker, band: &mut Band<'_>| {
            let number = band.top / TILE_HEIGHT;
            order.lock().unwrap().push(number);
            band.counts.rays = RAYS[number];
            band.pixels.fill(1);
        };
        let mut schedule = Schedule::ZERO;
        for expected in [[4, 3, 2, 1, 0], [2, 4, 3, 0, 1]] {
            let mut pixels = [0; PIXELS];
            let mut picture = Band {
                width: 2,
                stride: 2,
                pixels: &mut pixels,
                rough: &mut [[0; _]; CELL_ROWS * 5],
                ..Band::none()
            };
            let counts = schedule.run(&mut picture, &job, &mut Worker::new());
            assert_eq!(core::mem::take(&mut *order.lock().unwrap()), expected);
            assert_eq!(counts.rays, 19);
            assert_eq!(pixels, [1; PIXELS], "each band is drawn once");
        }
    }
}
