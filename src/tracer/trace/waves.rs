//! Waves on the first plane, see [`crate::scene::Waves`].

use super::intersect::Hit;
use super::point::ShadingPoint;
use super::rays::Rays;
use crate::lanes::*;
use crate::prepare::{PerLane, World};
use crate::scene::Waves;

const TURN: [f32; 2] = [-0.737_393_7, 0.675_463_2];

impl<S: Isa> ShadingPoint<S> {
    #[inline(always)]
    pub fn ripple(&mut self, simd: S, world: World<'_>, rays: &Rays<S>, hit: &Hit<S>) {
        let plane = U::<S>::splat(simd, world.first_plane() as u32);
        let is_water = self.shaded & hit.object.simd_eq(plane);
        if !is_water.any_true() {
            return;
        }
        let mut rows = [[0.0; MAX_LANES]; 4];
        let numbers = [self.p.x, self.p.z, rays.d.y, hit.t];
        for (row, numbers) in rows.iter_mut().zip(numbers) {
            numbers.store_slice(&mut row[..lanes::<S>()]);
        }
        tilt(world, &mut rows, lanes::<S>());
        let [x, y, z, _] = rows.map(|row| F::<S>::from_slice(simd, &row[..lanes::<S>()]));
        self.n = Vec3x::select(is_water, Vec3x { x, y, z }, self.n);
    }
}

/// Replaces the first three rows with normals. Before, the rows are x and z of `count` points, y of
/// the rays' directions, and the rays' lengths.
#[inline(never)]
fn tilt(world: World<'_>, rows: &mut [PerLane; 4], count: usize) {
    type S = Baseline;
    let simd = baseline();
    let one = splat(simd, 1.0);
    let waves = &world.scene.water;
    for first in (0..count.min(MAX_LANES)).step_by(lanes::<S>()) {
        let lanes = first..first + lanes::<S>();
        let [x, z, dy, t] = [0, 1, 2, 3].map(|i| F::<S>::from_slice(simd, &rows[i][lanes.clone()]));
        let steepness = dy.abs();
        let [slope_x, slope_z] = slopes(simd, waves, x, z, t * world.pixel / steepness);
        let slope2 = slope_x * slope_x + slope_z * slope_z;
        let scale = at_most::<S>(steepness * Waves::STEEPEST / slope2.sqrt(), one);
        let y = one / (slope2 * scale * scale + 1.0).sqrt();
        let scale = y * scale * -1.0;
        for (row, n) in rows.iter_mut().zip([slope_x * scale, y, slope_z * scale]) {
            n.store_slice(&mut row[lanes.clone()]);
        }
    }
}

#[inline(always)]
fn slopes<S: Isa>(simd: S, waves: &Waves, x: F<S>, z: F<S>, footprint: F<S>) -> [F<S>; 2] {
    let zero = splat(simd, 0.0);
    let [mut slope_x, mut slope_z] = [zero; 2];
    let [mut along_x, mut along_z] = [0.0, 1.0];
    let (mut per_unit, mut phase) = (1.0 / waves.length, waves.phase);
    let finest = Waves::FINEST * per_unit;
    while per_unit < finest {
        let share = at_least::<S>(footprint * (per_unit * -Waves::PIXELS) + 1.0, zero);
        let is_visible = share.simd_gt(zero);
        if !is_visible.any_true() {
            // Shorter waves are invisible, too.
            break;
        }
        let u = (x * along_x + z * along_z) * per_unit - phase;
        let u = off_integer::<S>(u);
        let rise = u * (u.abs() * -2.0 + 1.0) * share * (8.0 * waves.slope);
        // NaN of an invalid scene must not reach other lanes.
        let rise = is_visible.select(rise, zero);
        slope_x += rise * along_x;
        slope_z += rise * along_z;
        let [cosine, sine] = TURN;
        [along_x, along_z] = [along_x * cosine + along_z * sine, along_z * cosine - along_x * sine];
        per_unit *= 1.0 / Waves::SHORTER;
        phase *= Waves::FASTER;
    }
    [slope_x, slope_z]
}
