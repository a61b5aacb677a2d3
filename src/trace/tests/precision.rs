//! How well a ray finds a sphere that is small and far away.

use super::*;

/// Rays for each row.
const RAYS: usize = 200_000;

/// For a distance in radii: how many of a million rays may be wrong about hit or miss where multiplying and adding is
/// one operation with one rounding, and where it is two (SSE2); and how far off a hit may be, in radii, but for the
/// outermost tenth of the sphere.
const ROWS: [(f64, [f64; 2], f64); 7] = [
    (1e0, [0.0, 10.0], 3e-7),
    (1e1, [0.0, 0.0], 3e-6),
    (1e2, [0.0, 0.0], 3e-5),
    (1e3, [0.0, 30.0], 3e-4),
    (1e4, [0.0, 60.0], 3e-3),
    (1e5, [10.0, 1000.0], 3e-2),
    (1e6, [1500.0, 11_000.0], 3e-1),
];

struct HitOrMiss;

impl Property for HitOrMiss {
    #[inline(always)]
    fn hold<S: Isa>(&self, simd: S, isa: &str) {
        for (distance, most_wrong, farthest) in ROWS {
            let most_wrong = most_wrong[usize::from(isa == "sse2")];
            let mut random = Random(2019);
            let (mut wrong, mut off) = (0, 0.0_f64);
            for _ in 0..RAYS / 64 {
                let radius = random.between(0.5, 2.0) as f32;
                let r = f64::from(radius);
                // Outside, at distance 1 too.
                let o = (1e-5 + distance) * r * random.direction();
                let o = o.as_vec3a();
                let scene = prepared(&one_sphere(Vec3A::ZERO, radius, Material::default()));
                for _ in 0..64 / lanes::<S>() {
                    let mut ways = [Vec3A::ZERO; MAX_LANES];
                    for way in &mut ways {
                        let aim = 1.2 * r * random.direction();
                        *way = unit(aim - o.as_dvec3());
                    }
                    let hit = hits(simd, &scene, &packet(simd, o, &ways));
                    for (i, way) in ways.iter().enumerate().take(lanes::<S>()) {
                        let is_hit = hit.object.as_slice()[i] == 0;
                        let exact = exact(o, *way, r);
                        wrong += usize::from(is_hit != exact.is_some());
                        let Some((t, across)) = exact.filter(|_| is_hit) else {
                            continue;
                        };
                        if across < 0.9 {
                            off = off.max((f64::from(hit.t.as_slice()[i]) - t).abs() / r);
                        }
                    }
                }
            }
            let wrong = wrong as f64 * 1e6 / RAYS as f64;
            assert!(
                wrong <= most_wrong,
                "{isa}: {wrong} of a million at {distance}"
            );
            assert!(off <= farthest, "{isa}: {off} radii at {distance}");
        }
    }
}

/// The first hit of a sphere in the origin by the very ray that f32 holds, in f64: the way in units of length, and how
/// far from the middle, in radii.
fn exact(o: Vec3A, d: Vec3A, radius: f64) -> Option<(f64, f64)> {
    let (o, d) = (o.as_dvec3(), d.as_dvec3());
    let length = d.length();
    let d = d / length;
    let b = o.dot(d);
    let across = (o - b * d).length();
    let half2 = radius * radius - across * across;
    let t = -b - half2.max(0.0).sqrt();
    (half2 >= 0.0 && t > 0.0).then_some((t / length, across / radius))
}

#[test]
fn a_small_sphere_far_away_is_hit_where_it_is() {
    on_every_instruction_set(&HitOrMiss);
}
