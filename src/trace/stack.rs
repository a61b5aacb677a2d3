//! The stack of secondary rays that wait to be traced.

use crate::lanes::*;

/// A packet of rays, one per lane, in scene coordinates.
#[derive(Clone, Copy)]
pub(crate) struct Rays<S: Isa> {
    /// Origin.
    pub o: Vec3x<S>,
    /// Direction, of length 1.
    pub d: Vec3x<S>,
    /// The product of the coefficients along the ray's path.
    pub weight: F<S>,
    /// The point of the batch that the ray belongs to, and its node in that point's ray tree: `slot << PATH_BITS | path`. The
    /// path of a primary ray is 1; a ray with path p has the reflected ray 2 p and the transmitted ray 2 p + 1.
    pub slot_path: U<S>,
}

/// The bit of a `slot_path` that marks reflections of primary rays in the first plane.
const MIRRORED: u32 = 1 << 31;

/// The bits of a path: enough for [`crate::Quality::MAX_DEPTH`].
const PATH_BITS: u32 = 8;

impl<S: Isa> Rays<S> {
    /// The `slot_path`s of the primary rays of successive points, beginning with point number `slot`.
    #[inline(always)]
    pub fn slot_paths(simd: S, slot: usize) -> U<S> {
        (numbers(simd) << PATH_BITS) + ((slot as u32) << PATH_BITS | 1)
    }

    /// The points that the rays belong to.
    #[inline(always)]
    pub fn slots(&self) -> U<S> {
        (self.slot_path & !MIRRORED) >> PATH_BITS
    }

    /// The rays' paths in their trees.
    #[inline(always)]
    pub fn paths(&self) -> U<S> {
        self.slot_path & ((1 << PATH_BITS) - 1)
    }

    /// The `slot_path`s of the reflected rays. Those of the transmitted rays are one more.
    #[inline(always)]
    pub fn reflected_slot_paths(&self) -> U<S> {
        (self.slot_path + self.paths()) & !MIRRORED
    }

    /// The marks for reflected rays: set if the first plane, object number `plane`, reflects a primary ray.
    #[inline(always)]
    pub fn mirror_marks(&self, simd: S, objects: U<S>, plane: usize) -> U<S> {
        let plane = objects.simd_eq(U::<S>::splat(simd, plane as u32));
        let mirrored = plane & self.paths().simd_eq(U::<S>::splat(simd, 1));
        mirrored.to_vector().bitcast::<U<S>>() & MIRRORED
    }

    /// Which rays have this mark.
    #[inline(always)]
    pub fn mirrored(&self, simd: S) -> M<S> {
        self.slot_path
            .bitcast::<I<S>>()
            .simd_lt(I::<S>::splat(simd, 0))
    }
}

/// The capacity of the stack, a power of two.
///
/// A packet of depth d is taken from the top and replaced by at most two packets of depth d + 1. So at most two packets of each
/// of the depths 1 to 7 wait at once.
const CAPACITY: usize = 256;

/// The waiting rays as a structure of arrays. The arrays are longer than the capacity, so that a whole packet can be written at
/// the top.
pub(crate) struct Stack {
    /// Origin, direction, weight, and the bits of `slot_path`.
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

    /// Pushes the rays whose lane is in `mask`.
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

    /// Pops as many rays as there are lanes, or all if there are fewer. Returns them, in the first lanes, and their number.
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
        // One Newton step normalises the direction. Otherwise its error would grow with each reflection, and after four of them
        // exceed the bound that tells a ray's origin from a hit.
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

/// Loads a packet's values from a column.
#[inline(always)]
fn load<S: Isa>(simd: S, column: &[f32; CAPACITY + MAX_LANES], start: usize) -> F<S> {
    F::<S>::from_slice(simd, &column[start..start + lanes::<S>()])
}
