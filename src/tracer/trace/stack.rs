use super::rays::Rays;
use crate::lanes::*;

/// The capacity, a power of two.
///
/// A packet of depth d is replaced by at most two of depth d + 1, so at most two of each depth, 1 to 7, wait at once.
const CAPACITY: usize = 256;

/// Secondary rays, in columns longer than the capacity: a whole packet can be written at the top.
pub(crate) struct RayStack {
    /// Origin, direction, weight, and the bits of `slot_path`.
    columns: [[f32; CAPACITY + MAX_LANES]; 8],
    len: usize,
}

zero! { RayStack { columns, len } }

impl RayStack {
    pub fn len(&self) -> usize {
        self.len
    }

    #[inline(always)]
    pub fn push<S: Isa>(&mut self, simd: S, rays: &Rays<S>, mask: M<S>) {
        let (o, d) = (&rays.o, &rays.d);
        let slot_path = rays.slot_path.bitcast();
        let mut rows = [o.x, o.y, o.z, d.x, d.y, d.z, rays.weight, slot_path];
        simd.gather_first(&mut rows, mask);
        let start = self.len;
        for (column, row) in self.columns.iter_mut().zip(&rows) {
            row.store_slice(&mut column[start..start + lanes::<S>()]);
        }
        self.len = start + mask.to_bitmask().count_ones() as usize;
    }

    /// Pops up to a full packet of rays. Returns them in the first lanes, and their number.
    #[inline(always)]
    pub fn pop<S: Isa>(&mut self, simd: S) -> (Rays<S>, usize) {
        let count = self.len.min(lanes::<S>());
        self.len -= count;
        let start = self.len;
        let [ox, oy, oz, dx, dy, dz, weight, slot_path] = &self.columns;
        let d: Vec3x<S> =
            Vec3x { x: load(simd, dx, start), y: load(simd, dy, start), z: load(simd, dz, start) };
        // One Newton step normalises the direction, whose error would exceed the hit error after four reflections.
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

#[inline(always)]
fn load<S: Isa>(simd: S, column: &[f32; CAPACITY + MAX_LANES], start: usize) -> F<S> {
    F::<S>::from_slice(simd, &column[start..start + lanes::<S>()])
}
