//! Rays that leave a surface of any size and position do not hit it again, wherever they came from (after `TestReintersectConvex`
//! of pbrt).

use super::*;
use crate::scene::Plane;

/// The number of shapes, each of which is hit once.
const SHAPES: usize = 4000;
/// The number of rays that leave each hit.
const RAYS: usize = 1000;

/// The hit of a ray with the only object of a scene: the point, and the normal towards the ray.
#[inline(always)]
fn hit_by<S: Isa>(simd: S, world: World<'_>, o: Vec3, d: Vec3) -> Option<(Vec3, Vec3, bool)> {
    let rays = packet(simd, o, &[d]);
    let hit = hits(simd, world, &rays);
    if hit.object.as_slice()[0] != 0 {
        return None;
    }
    let point = shading_point(simd, world, &rays, &hit);
    let inside = point.inside.to_bitmask() & 1 == 1;
    Some((lane(point.p, 0), lane(point.n, 0), inside))
}

struct Spheres {
    /// The logarithm of the largest coordinate of a centre; `None` for the origin.
    centre: Option<f64>,
}

impl Property for Spheres {
    #[inline(always)]
    fn hold<S: Isa>(&self, simd: S, isa: &str) {
        let mut random = Random::new(2008);
        let mut count = 0;
        let (mut left, mut entered) = (0, 0);
        while count < SHAPES {
            let radius = 10_f64.powf(random.between(-4.0, 4.0)) as f32;
            let centre = match self.centre {
                Some(most) => random.vector(-4.0, most).as_vec3(),
                None => Vec3::ZERO,
            };
            let o = random.vector(-8.0, 8.0);
            let corner = DVec3::splat(f64::from(radius));
            let [x, y, z] = [0; 3].map(|_| random.between(-1.0, 1.0));
            let aim = centre.as_dvec3() + corner * DVec3::new(x, y, z);
            let (o, d) = (o.as_vec3(), unit(aim - o));
            let scene = prepared(&one_sphere(centre, radius, Material::default()));
            let Some((p, n, inside)) = hit_by(simd, scene.world(), o, d) else {
                count += usize::from(random.bits().is_multiple_of(8));
                continue;
            };
            count += 1;
            let outward = if inside { -n } else { n }.as_dvec3();
            let what = std::format!("{isa}: radius {radius} at {centre}, from {o} along {d}");
            let largest = f64::from(centre.abs().max_element() + radius);
            // Two roundings of the largest coordinate: about the error of the hit.
            let off = f64::from(f32::EPSILON) * largest;
            for _ in 0..RAYS / lanes::<S>() {
                let ways = [(); MAX_LANES].map(|()| random.direction().as_vec3());
                let hit = hits(simd, scene.world(), &packet(simd, p, &ways));
                for (i, way) in ways.iter().enumerate().take(lanes::<S>()) {
                    let cosine = way.as_dvec3().dot(outward);
                    let is_hit = hit.object.as_slice()[i] == 0;
                    let chord = -2.0 * cosine * f64::from(radius);
                    if cosine >= 0.0 {
                        assert!(!is_hit, "{what}: {p} is hit again along {way}");
                        left += 1;
                    } else if chord * chord > 64.0 * off * f64::from(radius) {
                        // Not so near along the sphere that being off it matters as much as the chord.
                        let t = f64::from(hit.t.as_slice()[i]);
                        assert!(is_hit, "{what}: {way} from {p} leaks");
                        assert!(
                            (t - chord).abs() < 4.0 * off * (1.0 + 2.0 * f64::from(radius) / chord),
                            "{what}: {way} from {p} goes {t} of {chord}"
                        );
                        entered += 1;
                    }
                }
            }
        }
        assert!(left > SHAPES * RAYS / 8, "{isa}: {left} rays");
        assert!(entered > SHAPES * RAYS / 32, "{isa}: {entered} rays");
    }
}

#[test]
fn rays_that_leave_a_sphere_do_not_hit_it_again() {
    on_every_instruction_set(&Spheres { centre: None });
}

#[test]
fn rays_that_leave_a_sphere_far_from_the_origin_do_not_hit_it_again() {
    on_every_instruction_set(&Spheres { centre: Some(4.0) });
}

struct Planes;

impl Property for Planes {
    #[inline(always)]
    fn hold<S: Isa>(&self, simd: S, isa: &str) {
        let mut random = Random::new(2019);
        let mut rays = 0;
        for _ in 0..SHAPES {
            let [half_x, half_z] = [0; 2].map(|_| 10_f64.powf(random.between(-4.0, 4.0)));
            let centre = random.vector(-4.0, 4.0);
            let [x, z] = [0; 2].map(|_| random.between(-1.0, 1.0));
            let aim = centre + DVec3::new(half_x * x, 0.0, half_z * z);
            let o = random.vector(-8.0, 8.0);
            let (o, d) = (o.as_vec3(), unit(aim - o));
            let (half_x, half_z) = (half_x as f32, half_z as f32);
            let plane = Plane::new(centre.as_vec3(), half_x, half_z, Material::BLACK);
            let scene = prepared(&Scene {
                planes: List::of(&[plane]),
                ..Scene::default()
            });
            let Some((p, _, _)) = hit_by(simd, scene.world(), o, d) else {
                continue;
            };
            for _ in 0..RAYS / lanes::<S>() {
                let mut ways = [(); MAX_LANES].map(|()| random.direction().as_vec3());
                // Also along the plane, with both signs of zero.
                ways[0].y = if rays % 2 == 0 { 0.0 } else { -0.0 };
                let hit = hits(simd, scene.world(), &packet(simd, p, &ways));
                for (i, way) in ways.iter().enumerate().take(lanes::<S>()) {
                    let is_hit = hit.object.as_slice()[i] == 0;
                    assert!(!is_hit, "{isa}: {p} is hit again along {way}");
                    rays += 1;
                }
            }
        }
        assert!(rays > SHAPES * RAYS / 8, "{isa}: {rays} rays");
    }
}

#[test]
fn rays_that_leave_a_plane_do_not_hit_it_again() {
    on_every_instruction_set(&Planes);
}
