use super::rays::Rays;
use crate::lanes::*;

/// A packet of depth d is replaced by at most two of depth d + 1, so at most two of each depth, 1
/// to 7, wait at once.
const CAPACITY: usize = 256;

/// Secondary rays, in columns longer than the capacity: a whole packet can be written at the top.
pub(crate) struct RayStack {
    /// Origin, direction, weight, and bits of `slot_path`.
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
        let [x, y, z, dx, dy, dz, weight, slot_path] = self.columns.each_ref().map(
            #[inline(always)]
            |column| F::<S>::from_slice(simd, &column[start..start + lanes::<S>()]),
        );
        let d = Vec3x::<S> { x: dx, y: dy, z: dz };
        // One Newton step normalises the direction, whose error would exceed the hit error after
        // four reflections.
        let correction = d.dot(d).mul_add(splat(simd, -0.5), splat(simd, 1.5));
        let rays = Rays {
            o: Vec3x { x, y, z },
            d: d.scaled(correction),
            weight,
            slot_path: slot_path.bitcast(),
        };
        (rays, count)
    }
}
