//! Rays that wait to be traced.

use crate::lanes::*;

/// Rays in lanes.
#[derive(Clone, Copy)]
pub(crate) struct Rays<S: Isa> {
    pub o: Vec3x<S>,
    /// Direction, of length 1.
    pub d: Vec3x<S>,
    /// The product of the coefficients along the ray's path.
    pub weight: F<S>,
    /// Where its colour goes and where it stands in its tree: `slot << PATH_BITS | path`. The path of a primary ray is
    /// 1; a ray with path p has the reflected ray 2 p and the transmitted ray 2 p + 1.
    pub slot_path: U<S>,
}

/// A place's bit that says that the ray is what the first plane reflects of a primary ray.
const MIRRORED: u32 = 1 << 31;

/// Enough for the paths of [`crate::Quality::MAX_DEPTH`].
const PATH_BITS: u32 = 8;

impl<S: Isa> Rays<S> {
    /// The places of the primary rays of the points from number `slot` on.
    #[inline(always)]
    pub fn slot_paths(simd: S, slot: usize) -> U<S> {
        (numbers(simd) << PATH_BITS) + ((slot as u32) << PATH_BITS | 1)
    }

    /// Which points the rays belong to.
    #[inline(always)]
    pub fn slots(&self) -> U<S> {
        (self.slot_path & !MIRRORED) >> PATH_BITS
    }

    /// Where the rays stand in their trees.
    #[inline(always)]
    pub fn paths(&self) -> U<S> {
        self.slot_path & ((1 << PATH_BITS) - 1)
    }

    /// The places of the reflected rays; those of the transmitted rays are one more.
    #[inline(always)]
    pub fn reflected_slot_paths(&self) -> U<S> {
        (self.slot_path + self.paths()) & !MIRRORED
    }

    /// Marks of the reflected rays' places where the first plane, the object number `plane`, reflects a primary ray.
    #[inline(always)]
    pub fn mirror_marks(&self, simd: S, objects: U<S>, plane: usize) -> U<S> {
        let plane = objects.simd_eq(U::<S>::splat(simd, plane as u32));
        let mirrored = plane & self.paths().simd_eq(U::<S>::splat(simd, 1));
        mirrored.to_vector().bitcast::<U<S>>() & MIRRORED
    }

    /// Which rays are so marked.
    #[inline(always)]
    pub fn mirrored(&self, simd: S) -> M<S> {
        self.slot_path
            .bitcast::<I<S>>()
            .simd_lt(I::<S>::splat(simd, 0))
    }
}

/// The most rays that can wait, a power of two.
///
/// A packet of rays of depth d is replaced by at most two packets of depth d + 1 and is taken from the top, so at most
/// two packets of rays of each of the depths 1 to 7 wait at once.
const CAPACITY: usize = 256;

/// The waiting rays, structure of arrays; a packet can be written from any place below the capacity.
pub(crate) struct Stack {
    /// Origin, direction, weight, and the bits of the place.
    columns: [[f32; CAPACITY + MAX_LANES]; 8],
    len: usize,
}

impl Stack {
    pub const fn new() -> Self {
        Self {
            columns: [[0.0; CAPACITY + MAX_LANES]; 8],
            len: 0,
        }
    }

    #[inline(always)]
    pub fn len(&self) -> usize {
        self.len
    }

    /// Puts those rays on top whose lane is in `mask`.
    #[inline(always)]
    pub fn push<S: Isa>(&mut self, simd: S, rays: &Rays<S>, mask: M<S>) {
        let Rays {
            o,
            d,
            weight,
            slot_path,
        } = rays;
        let mut rows = [o.x, o.y, o.z, d.x, d.y, d.z, *weight, slot_path.bitcast()];
        simd.gather_first(&mut rows, mask);
        let start = self.len;
        for (column, row) in self.columns.iter_mut().zip(&rows) {
            row.store_slice(&mut column[start..start + lanes::<S>()]);
        }
        self.len = start + mask.to_bitmask().count_ones() as usize;
    }

    /// Takes as many rays from the top as there are lanes or rays, and says how many; they are in the first lanes.
    #[inline(always)]
    pub fn pop<S: Isa>(&mut self, simd: S) -> (Rays<S>, usize) {
        let count = self.len.min(lanes::<S>());
        self.len -= count;
        let start = self.len;
        let [ox, oy, oz, dx, dy, dz, weight, slot_path] = &self.columns;
        let d: Vec3x<S> = Vec3x {
            x: load(simd, dx, start),
            y: load(simd, dy, start),
            z: load(simd, dz, start),
        };
        // One Newton step back to length 1: else its error grows with each reflection, and after four of them it is more
        // than what tells a ray's start from a hit.
        let correction = d.dot(d).mul_add(splat(simd, -0.5), splat(simd, 1.5));
        let rays = Rays {
            o: Vec3x {
                x: load(simd, ox, start),
                y: load(simd, oy, start),
                z: load(simd, oz, start),
            },
            d: d.scaled(correction),
            weight: load(simd, weight, start),
            slot_path: load(simd, slot_path, start).bitcast(),
        };
        (rays, count)
    }
}

/// A packet's numbers from a column.
#[inline(always)]
fn load<S: Isa>(simd: S, column: &[f32; CAPACITY + MAX_LANES], start: usize) -> F<S> {
    F::<S>::from_slice(simd, &column[start..start + lanes::<S>()])
}
