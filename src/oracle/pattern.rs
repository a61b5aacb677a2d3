use super::light::smooth;
use eightfold_tracer::scene::Pattern;
use glam::DVec3;

/// Returns a pattern's factors at `p` in the object's own axes; a pixel covers `footprint` scene
/// units.
pub fn reflectance(pattern: &Pattern, p: DVec3, footprint: f64) -> DVec3 {
    if pattern.depth == 0.0 {
        return DVec3::ONE;
    }
    let p = swirled(pattern, p, footprint);
    let waves = pattern.waves.as_dvec3();
    let mut v = p * waves;
    v.x += turbulence(pattern, p);
    let waves_there = v.to_array().map(wave);
    let sign: f64 = waves_there.into_iter().map(f64::signum).product();
    let lowest = waves_there.into_iter().map(f64::abs).fold(1.0, f64::min);
    // A wave falls from 1 to -1 in half a period.
    let steepest = 0.5 / (footprint * waves.abs().max_element());
    let edge = f64::from(pattern.edge).min(steepest);
    let shift = f64::from(pattern.balance) * edge.max(1.0);
    let height = (sign * lowest * edge + shift).clamp(-1.0, 1.0);
    let dark = f64::from(pattern.depth) * (0.5 - 0.5 * height);
    DVec3::ONE.lerp(pattern.tint.as_dvec3(), dark)
}

fn swirled(pattern: &Pattern, mut p: DVec3, footprint: f64) -> DVec3 {
    let [grain, swirl, flat] = [pattern.grain, pattern.swirl, 1.0 - pattern.stretch].map(f64::from);
    if grain * swirl > 0.0 {
        p *= DVec3::new(flat, 1.0, flat);
        let sine = |u: f64| {
            let f = u - u.round();
            8.0 * f * (1.0 - 2.0 * f.abs())
        };
        for octave in 0..7 {
            let cells = grain * 1.618_034_f64.powi(octave);
            let share = (0.125 / (footprint * cells) - 0.5).clamp(0.0, 1.0);
            let strength = share * swirl / cells;
            p.x += strength * sine(p.y * cells);
            p.y += strength * sine(p.z * cells);
            p.z += strength * sine(p.x * cells);
        }
    }
    p
}

fn wave(v: f64) -> f64 {
    1.0 - 4.0 * (v - v.round()).abs()
}

/// Returns the noise in periods, constant along an oblique direction.
fn turbulence(pattern: &Pattern, p: DVec3) -> f64 {
    let (u, v) = (p.x + 0.6 * p.z, p.y + 0.8 * p.z);
    let mut grain = f64::from(pattern.grain);
    let mut strength = f64::from(pattern.warp);
    let mut sum = 0.0;
    while strength > f64::from(Pattern::MIN_WARP) {
        sum += strength * noise([u * grain, v * grain]);
        strength /= 2.0;
        grain *= 2.0;
    }
    sum
}

fn noise(p: [f64; 2]) -> f64 {
    let cell = p.map(f64::floor);
    let s = [0, 1].map(|i| smooth(p[i] - cell[i]));
    let mut sum = 0.0;
    for corner in [[0, 0], [1, 0], [0, 1], [1, 1]] {
        let share = |i: usize| if corner[i] == 1 { s[i] } else { 1.0 - s[i] };
        let point = [0, 1].map(|i| (cell[i] as i32).wrapping_add(corner[i]) as u32);
        sum += share(0) * share(1) * random(point);
    }
    sum
}

/// Returns the random number, -1 to 1, at integer coordinates, hashed as offsets to the bits of the
/// float 1.5 * 2^23.
fn random(point: [u32; 2]) -> f64 {
    let [u, v] = point.map(|n| n.wrapping_add(0x4b40_0000));
    let h = u.wrapping_mul(0x9e37_79b9).wrapping_add(v.wrapping_mul(0x85eb_ca6b));
    let h = (h ^ (h >> 15)).wrapping_mul(0x846c_a68b);
    f64::from(h as i32) / 2.0f64.powi(31)
}
