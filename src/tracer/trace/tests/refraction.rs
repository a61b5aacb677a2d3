//! Refracted and reflected rays have directions of length 1, and carry all light at the critical angle.

use super::*;

/// The number of angles around the critical one, one rounding step apart.
const ULPS: i32 = 256;
/// The largest error of a direction's squared length: two roundings for each of its three components.
const LENGTH2: f64 = 4.0 * f32::EPSILON as f64;

const fn glass(index: f32) -> Material {
    Material { colour: Vec3::ONE, kr: 0.1, kt: 0.85, index, ..Material::BLACK }
}

fn assert_light_is_conserved(by: &dyn Kernels, isa: &str) {
    let mut batch = Box::new(Batch::new());
    let (mut through, mut total) = (0, 0);
    for index in [1.0001, 1.1, 1.33, 1.5, 2.4, 10.0_f32] {
        let scene = prepared(&one_sphere(Vec3::ZERO, 1.0, glass(index)));
        let sine = 1.0 / f64::from(index);
        // Rays along z from here meet the sphere at the critical angle.
        for from in -ULPS..=ULPS {
            let x = f32::from_bits(((sine as f32).to_bits() as i32 + from) as u32);
            let rays = packet(Vec3::new(x, 0.0, 0.0), &[Vec3::Z]);
            let [shaded, ..] = by.shaded(scene.world(), &Quality::EXHAUSTIVE, &rays, &mut batch);
            let [reflected, transmitted] = shaded.secondary;
            let what = std::format!("{isa}: index {index}, {from} roundings off");
            let (_, d, weight) = reflected.expect(&what);
            assert_unit(d, &what);
            // The rounding of the position, the normal and the cosine.
            let unsure = 1e-6 + 3e-7 * f64::from(index).powi(2);
            let beyond = f64::from(x) / sine - 1.0;
            let sent = transmitted.map_or(0.0, |ray| ray.2);
            assert_eq!(weight + sent, 0.1 + 0.85, "{what}");
            if let Some((_, d, _)) = transmitted {
                assert_unit(d, &what);
                through += 1;
                assert!(beyond < unsure, "{what} transmits");
                let n = DVec3::new(f64::from(x), 0.0, (1.0 - f64::from(x).powi(2)).sqrt());
                let cosine = d.as_dvec3().dot(n);
                let exact = (1.0 - (f64::from(x) / sine).powi(2)).max(0.0).sqrt();
                let is_exact = (cosine - exact).abs() < 2e-3 * f64::from(index);
                assert!(cosine > -1e-6 && is_exact, "{what}: {cosine} for {exact}");
            } else {
                total += 1;
                assert!(beyond > -unsure, "{what} reflects all");
            }
        }
    }
    assert!(through > 100 && total > 100, "{isa}: {through}, {total}");
}

#[track_caller]
fn assert_unit(d: Vec3, what: &str) {
    let length2 = d.as_dvec3().length_squared();
    assert!((length2 - 1.0).abs() <= LENGTH2, "{what}: {d}, {length2}");
}

#[test]
fn critical_angle_conserves_light() {
    on_every_instruction_set(assert_light_is_conserved);
}

fn assert_lengths_are_one(by: &dyn Kernels, isa: &str) {
    let mut random = Random::new(1621);
    let mut batch = Box::new(Batch::new());
    let mut count = 0;
    for _ in 0..20_000 {
        let radius = 10_f64.powf(random.between(-4.0, 6.0));
        let index = 10_f64.powf(random.between(-1.0, 1.0)) as f32;
        let scene = prepared(&one_sphere(Vec3::ZERO, radius as f32, glass(index)));
        let at = [0.0, 0.5, 1.0, 2.0, 1e3][random.bits() as usize % 5];
        let o = (random.direction() * (radius * at)).as_vec3();
        let mut directions =
            [(); MAX_LANES].map(|()| unit(random.direction() * radius - o.as_dvec3()));
        // Towards the centre: rounding may make the cosine exceed 1.
        directions[0] = unit(if at == 0.0 { DVec3::ONE } else { -o.as_dvec3() });
        let rays = packet(o, &directions);
        let shaded = by.shaded(scene.world(), &Quality::EXHAUSTIVE, &rays, &mut batch);
        let used = shaded.iter().take(by.lanes());
        for (_, d, weight) in used.flat_map(|lane| lane.secondary).flatten() {
            assert_unit(d, isa);
            assert!(weight > 0.0 && weight < 1.0, "{isa}: {weight}");
            count += 1;
        }
    }
    assert!(count > 20_000, "{isa}: {count} rays");
}

#[test]
fn secondary_rays_have_length_one() {
    on_every_instruction_set(assert_lengths_are_one);
}
