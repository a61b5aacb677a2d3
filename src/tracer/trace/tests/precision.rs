//! The accuracy of hits on small distant spheres.

use super::*;

const RAYS: usize = 200_000;

/// The probability that the rays exceed their bound.
const EXCEEDED: f64 = 1e-6;

/// Distances in radii, and bounds on the wrong rays per million: at the origin with and without
/// FMA, and anywhere.
const BOUNDS: [(f64, [f64; 3]); 7] = [
    (1e0, [3.0, 4.0, 5.0]),
    (1e1, [1.0, 1.0, 1.0]),
    (1e2, [1.0, 1.0, 2.5]),
    (1e3, [1.0, 1.0, 12.0]),
    (1e4, [1.0, 1.0, 100.0]),
    (1e5, [16.0, 20.0, 930.0]),
    (1e6, [1400.0, 1650.0, 9700.0]),
];

/// The largest error of a hit's distance, relative to distance and radius, except in the sphere's
/// outermost tenth.
const OFF: [f64; 2] = [4e-7, 1e-7];

/// Poisson's distribution exceeds this with a probability below [`EXCEEDED`].
fn poisson_bound(mean: f64) -> usize {
    // Logarithms do not underflow.
    let (mut count, mut log_p, mut at_most) = (0, -mean, (-mean).exp());
    while at_most < 1.0 - EXCEEDED {
        count += 1;
        log_p += (mean / count as f64).ln();
        at_most += log_p.exp();
    }
    count
}

/// Returns the number of wrong rays, and the largest error of a hit's distance, in radii.
fn outcome(by: &dyn Kernels, distance: f64, is_in_origin: bool) -> (usize, f64) {
    let mut random = Random(distance as u64);
    let (mut wrong, mut off) = (0, 0.0_f64);
    for _ in 0..RAYS / 64 {
        let radius = random.between(0.5, 2.0) as f32;
        let r = f64::from(radius);
        let from_origin = if is_in_origin { 0.0 } else { 2.0 };
        let from_origin = from_origin * random.between(0.0, distance * r);
        let centre = (from_origin * random.direction()).as_vec3();
        let c = centre.as_dvec3();
        // Outside, also at distance 1.
        let o = (c + (1e-5 + distance) * r * random.direction()).as_vec3();
        let scene = prepared(&one_sphere(centre, radius, Material::default()));
        for _ in 0..64 / by.lanes() {
            let mut directions = [Vec3::ZERO; MAX_LANES];
            for d in directions.iter_mut().take(by.lanes()) {
                let aim = c + 1.2 * r * random.direction();
                *d = unit(aim - o.as_dvec3());
            }
            let hits = by.hits(scene.world(), &packet(o, &directions), 0);
            for (d, (t_hit, object)) in directions.iter().zip(hits).take(by.lanes()) {
                let is_hit = object == 0;
                let exact = exact(o.as_dvec3() - c, *d, r);
                wrong += usize::from(is_hit != exact.is_some());
                let Some((t, across)) = exact.filter(|_| is_hit) else { continue };
                if across < 0.9 {
                    off = off.max((f64::from(t_hit) - t).abs() / r);
                }
            }
        }
    }
    (wrong, off)
}

fn assert_hits_are_exact(by: &dyn Kernels, isa: &str, is_in_origin: bool) {
    let millions = RAYS as f64 / 1e6;
    for (distance, [fused, unfused, anywhere]) in BOUNDS {
        let mean = match is_in_origin {
            true if by.fuses_mul_add() => fused,
            true => unfused,
            false => anywhere,
        };
        let (wrong, off) = outcome(by, distance, is_in_origin);
        let bound = poisson_bound(mean * millions);
        let what = std::format!(
            "{isa} at {distance} radii: {wrong} of {RAYS} rays are wrong ({bound} allowed); distances off by {off:.1e} radii"
        );
        assert!(wrong <= bound, "{what}");
        assert!(off <= OFF[0] * distance + OFF[1], "{what}");
    }
}

/// Returns the exact hit of a ray from `o`, relative to the centre: the distance in lengths of `d`,
/// and the ray's distance from the centre in radii.
fn exact(o: DVec3, d: Vec3, radius: f64) -> Option<(f64, f64)> {
    let d = d.as_dvec3();
    let length = d.length();
    let d = d / length;
    let b = o.dot(d);
    let across = (o - b * d).length();
    let half2 = radius * radius - across * across;
    let t = -b - half2.max(0.0).sqrt();
    (half2 >= 0.0 && t > 0.0).then_some((t / length, across / radius))
}

#[test]
fn small_sphere_far_away_is_hit_exactly() {
    for is_in_origin in [true, false] {
        on_every_instruction_set(|by, isa| assert_hits_are_exact(by, isa, is_in_origin));
    }
}
