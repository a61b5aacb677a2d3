//! Refracted and reflected rays have directions of length 1.

use super::*;

/// The largest error of a squared length: two roundings per component.
const LENGTH2: f64 = 4.0 * f32::EPSILON as f64;

const fn glass(index: f32) -> Material {
    Material { colour: Vec3::ONE, kr: 0.1, kt: 0.85, index, ..Material::BLACK }
}

#[track_caller]
fn assert_unit(d: Vec3, what: &str) {
    let length2 = d.as_dvec3().length_squared();
    assert!((length2 - 1.0).abs() <= LENGTH2, "{what}: {d}, {length2}");
}

fn assert_lengths_are_one(by: &dyn Kernels, isa: &str) {
    let mut random = Random(1621);
    let mut batch = Box::new(Batch::ZERO);
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
        // Along z, about the critical angle.
        let sine = radius / f64::from(index);
        let (o, directions) = match random.bits() % 4 {
            0 if at < 1.0 => (
                Vec3::X * (sine as f32) * (1.0 + random.between(-3e-6, 3e-6) as f32),
                [Vec3::Z; MAX_LANES],
            ),
            _ => (o, directions),
        };
        let rays = packet(o, &directions);
        let secondary = by.secondary(scene.world(), &rays, &mut batch);
        for &(_, d, weight) in secondary.iter().take(by.lanes()).flatten().flatten() {
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
