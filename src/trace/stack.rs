//! Rays that wait to be traced.

use crate::lanes::*;

/// Rays in lanes.
#[derive(Clone, Copy)]
pub(crate) struct Rays<S: Simd> {
    pub o: Vec3x<S>,
    /// Direction, of length 1.
    pub d: Vec3x<S>,
    /// The product of the coefficients along the ray's path.
    pub weight: F<S>,
    /// Where its colour goes and where it stands in its tree: `slot << PATH_BITS | path`. The path of a primary ray is
    /// 1; a ray with path p has the reflected ray 2 p and the transmitted ray 2 p + 1.
    pub place: U<S>,
}

/// Enough for the paths of [`crate::Quality::MAX_DEPTH`].
const PATH_BITS: u32 = 8;

impl<S: Simd> Rays<S> {
    /// The places of the primary rays of eight points from number `slot` on.
    #[inline(always)]
    pub fn places(simd: S, slot: usize) -> U<S> {
        U::from_fn(
            simd,
            #[inline(always)]
            |i| ((slot + i) as u32) << PATH_BITS | 1,
        )
    }

    /// Which points the rays belong to.
    #[inline(always)]
    pub fn slots(&self) -> U<S> {
        self.place >> PATH_BITS
    }

    /// Where the rays stand in their trees.
    #[inline(always)]
    pub fn paths(&self) -> U<S> {
        self.place & ((1 << PATH_BITS) - 1)
    }

    /// The places of the reflected rays; those of the transmitted rays are one more.
    #[inline(always)]
    pub fn reflected_places(&self) -> U<S> {
        self.place + self.paths()
    }
}

/// The most rays that can wait, a power of two.
///
/// A packet of eight rays of depth d is replaced by at most sixteen of depth d + 1 and is taken from the top, so at
/// most 8 + 7 rays of each of the depths 1 to 7 wait at once.
const CAPACITY: usize = 128;

/// The waiting rays, structure of arrays; a packet can be written from any place below the capacity.
pub(crate) struct Stack {
    columns: [[f32; CAPACITY + LANES]; 7],
    place: [u32; CAPACITY + LANES],
    len: usize,
}

impl Stack {
    pub const fn new() -> Self {
        Self {
            columns: [[0.0; CAPACITY + LANES]; 7],
            place: [0; CAPACITY + LANES],
            len: 0,
        }
    }

    #[inline(always)]
    pub fn len(&self) -> usize {
        self.len
    }

    /// Puts those rays on top whose lane is in `mask`.
    #[inline(always)]
    pub fn push<S: Simd>(&mut self, rays: &Rays<S>, mask: M<S>) {
        let Rays {
            o,
            d,
            weight,
            place,
        } = rays;
        let rows = [o.x, o.y, o.z, d.x, d.y, d.z, *weight];
        let start = self.len % CAPACITY;
        for (column, row) in self.columns.iter_mut().zip(rows) {
            row.compress(mask)
                .store_slice(&mut column[start..start + LANES]);
        }
        place
            .compress(mask)
            .store_slice(&mut self.place[start..start + LANES]);
        self.len = start + mask.to_bitmask().count_ones() as usize;
    }

    /// Takes up to eight rays from the top, and says how many; they are in the first lanes.
    #[inline(always)]
    pub fn pop<S: Simd>(&mut self, simd: S) -> (Rays<S>, usize) {
        let count = self.len.min(LANES);
        self.len -= count;
        let start = self.len % CAPACITY;
        let row = |i: usize| F::from_slice(simd, &self.columns[i][start..start + LANES]);
        let rays = Rays {
            o: Vec3x {
                x: row(0),
                y: row(1),
                z: row(2),
            },
            d: Vec3x {
                x: row(3),
                y: row(4),
                z: row(5),
            },
            weight: row(6),
            place: U::from_slice(simd, &self.place[start..start + LANES]),
        };
        (rays, count)
    }
}
