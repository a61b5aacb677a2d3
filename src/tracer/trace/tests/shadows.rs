//! Rounding does not make a sphere cast a shadow on itself. Lights wholly inside illuminate its inside, others its outside.

use super::*;
use crate::scene::{Block, Light};

const SPHERES: usize = 20_000;

/// A white, diffuse material: its brightness is the cosine of the angle to the light.
const PAPER: Material = Material::matt(Vec3::ONE, 1.0);

fn assert_no_own_shadow(by: &dyn Kernels, isa: &str, is_inside: bool) {
    let mut random = Random::new(1968);
    let mut batch = Box::new(Batch::new());
    let (mut lit, mut dark) = (0, 0);
    for number in 0..SPHERES {
        let r = 10_f64.powf(random.between(-4.0, 4.0));
        let centre = random.vector(-4.0, 4.0);
        // Rounding keeps a sphere of this size.
        let centre = centre * (1e3 * r / centre.length()).min(1.0);
        let from = |d: DVec3, distance: f64| (centre + d * (distance * r)).as_vec3();
        let eye_at = 10_f64.powf(random.between(0.1, 3.0));
        let eye_at = if is_inside { 0.5 } else { eye_at };
        let eye = from(random.direction(), eye_at);
        let light_at = 10_f64.powf(random.between(-1.0, 2.0));
        let is_within = light_at < 1.0;
        if (light_at - 1.0).abs() < 0.05 {
            continue;
        }
        let light = from(random.direction(), light_at);
        let mut scene = one_sphere(centre.as_vec3(), r as f32, PAPER);
        scene.lights = List::of(&[Light::new(light, Vec3::ONE)]);
        if is_inside && number % 2 == 0 {
            // A box beyond the sphere and the diameter of a light wholly inside make no difference.
            scene.blocks = List::of(&[Block {
                centre: from(random.direction(), 3.0),
                half: Vec3::splat(r as f32),
                ..Block::default()
            }]);
            scene.lights[0].diameter = (1.9 * (1.0 - light_at).max(0.0) * r) as f32;
        }
        let scene = prepared(&scene);
        let directions = [(); MAX_LANES]
            .map(|()| unit(from(random.direction(), 0.99).as_dvec3() - eye.as_dvec3()));
        let rays = packet(eye, &directions);
        let shaded = by.shaded(scene.world(), &Quality::EXHAUSTIVE, &rays, &mut batch);
        for (d, shaded) in directions.iter().zip(shaded).take(by.lanes()) {
            if shaded.object != 0 {
                continue;
            }
            let t = f64::from(shaded.t);
            let p = eye.as_dvec3() + t * d.as_dvec3();
            let out = (p - centre).normalize();
            let p = centre + out * r;
            let to_light = (light.as_dvec3() - p).normalize();
            let n = if is_inside { -out } else { out };
            let cosine = n.dot(to_light);
            // The rounding of positions, and of the distance from the eye.
            let unsure = 3e-6 * (1e3 + eye_at);
            if cosine.abs() < unsure {
                continue;
            }
            let expected = cosine > 0.0 && is_inside == is_within;
            let is_lit = shaded.colour.x > 0.0;
            assert_eq!(
                is_lit, expected,
                "{isa}: radius {r} at {centre}, light at {light}, seen from {eye} along {d}, cosine {cosine}"
            );
            lit += usize::from(is_lit);
            dark += usize::from(!is_lit);
        }
    }
    assert!(lit > SPHERES / 10, "{isa}: {lit} lit");
    assert!(dark > SPHERES / 10, "{isa}: {dark} dark");
}

#[test]
fn sphere_casts_no_shadow_on_its_lit_side() {
    for is_inside in [false, true] {
        on_every_instruction_set(|by, isa| assert_no_own_shadow(by, isa, is_inside));
    }
}
