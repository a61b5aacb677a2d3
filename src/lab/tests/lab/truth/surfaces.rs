//! Surfaces give back no more light than they get.

use eightfold_lab::sampler::{Sampler, Sequence};
use eightfold_lab::truth::surface::{Bsdf, fresnel_reflectance};
use eightfold_tracer::glam::{DVec3, Vec3A, dvec2};
use eightfold_tracer::scene::Material;
use std::f64::consts::TAU;

/// The direction of the grooves of brushed surfaces.
const GROOVE: DVec3 = DVec3::new(0.6, 0.0, 0.8);

/// The direction of sight at an angle of a cosine with the normal, which is y.
fn sight(cosine: f64) -> DVec3 {
    DVec3::new((1.0 - cosine * cosine).sqrt(), -cosine, 0.0)
}

/// A physical surface seen from above.
fn surface(material: Material, cosine: f64) -> Bsdf {
    Bsdf::new(
        &material,
        material.colour.as_dvec3(),
        sight(cosine),
        DVec3::Y,
        GROOVE,
        false,
        true,
    )
}

fn shiny(ks: f32, exponent: f32) -> Material {
    Material {
        ks,
        exponent,
        ..Material::BLACK
    }
}

/// The integral of a function over the hemisphere, by rings of equal solid angle.
fn integral(of: impl Fn(DVec3) -> f64) -> f64 {
    const RINGS: usize = 1000;
    let mut sum = 0.0;
    for i in 0..RINGS * RINGS {
        let height = ((i / RINGS) as f64 + 0.5) / RINGS as f64;
        let angle = TAU * ((i % RINGS) as f64 + 0.5) / RINGS as f64;
        let radius = (1.0 - height * height).sqrt();
        sum += of(DVec3::new(
            radius * angle.cos(),
            height,
            radius * angle.sin(),
        ));
    }
    sum * TAU / (RINGS * RINGS) as f64
}

#[test]
fn a_lobe_gives_back_its_share_at_most_across_grooves_too() {
    for exponent in [1.0, 8.0, 100.0] {
        for cosine in [1.0, 0.6, 0.1] {
            for anisotropy in [0.0, 0.1, 0.9, 1.0] {
                let material = Material {
                    anisotropy,
                    ..shiny(0.5, exponent)
                };
                let bsdf = surface(material, cosine);
                let share = integral(|d| bsdf.of(d).x) / bsdf.glossy;
                let what = format!("{share}: {exponent} {cosine} {anisotropy}");
                assert!(share <= 1.001 && bsdf.glossy < 1.0, "{what}");
                // Seen along the normal, all of it; of one that is spread wide, if it is sharp.
                let is_all = anisotropy == 0.0 || anisotropy == 1.0 && exponent == 100.0;
                if cosine == 1.0 && is_all {
                    let most = if anisotropy == 0.0 { 1e-3 } else { 0.01 };
                    assert!((share - 1.0).abs() < most, "{what}");
                }
            }
        }
    }
}

#[test]
fn the_lobe_of_a_metal_has_its_colour() {
    let colour = Vec3A::new(0.9, 0.6, 0.3);
    let seen = |metallic| {
        let material = Material {
            colour,
            metallic,
            ..shiny(0.8, 20.0)
        };
        surface(material, 0.6).of(sight(0.6) * DVec3::new(1.0, -1.0, 1.0))
    };
    let ratio = seen(1.0) / seen(0.0);
    assert!(
        (ratio - colour.as_dvec3()).abs().max_element() < 1e-6,
        "{ratio}"
    );
}

#[test]
fn a_surface_that_would_give_back_too_much_is_scaled() {
    let material = Material {
        colour: Vec3A::ONE,
        kd: 0.9,
        kr: 0.6,
        ..shiny(0.5, 4.0)
    };
    let bsdf = surface(material, 0.7);
    let shares = bsdf.diffuse.max_element() + bsdf.glossy + bsdf.reflected + bsdf.transmitted;
    assert!((shares - 1.0).abs() < 1e-12);
    assert!((bsdf.diffuse.x / bsdf.reflected - 1.5).abs() < 1e-6);
}

#[test]
fn a_lobe_is_the_same_both_ways() {
    for anisotropy in [0.0, 0.7] {
        let material = Material {
            anisotropy,
            ..shiny(0.8, 20.0)
        };
        let reflectance = |from: DVec3, to: DVec3| {
            let bsdf = Bsdf::new(&material, DVec3::ZERO, -from, DVec3::Y, GROOVE, false, true);
            bsdf.of(to).x / to.y
        };
        let (a, b) = (DVec3::new(0.5, 0.7, 0.1), DVec3::new(-0.6, 0.4, 0.2));
        let (a, b) = (a.normalize(), b.normalize());
        assert!((reflectance(a, b) / reflectance(b, a) - 1.0).abs() < 1e-9);
    }
}

#[test]
fn directions_are_chosen_with_their_density_and_weighed_by_it() {
    for anisotropy in [0.0, 0.8] {
        let material = Material {
            colour: Vec3A::new(0.2, 0.5, 0.8),
            kd: 0.6,
            metallic: 0.5,
            anisotropy,
            ..shiny(0.9, 6.0)
        };
        let bsdf = surface(material, 0.5);
        let (mut sum, mut below, count) = (DVec3::ZERO, 0, 1 << 14);
        for i in 0..count {
            let mut sampler = Sampler::new(Sequence::Sobol, i, 3);
            match bsdf.sample(sampler.next_1d(), sampler.next_2d()) {
                Some(next) => sum += next.weight,
                None => below += 1,
            }
        }
        let mean = sum / count as f64;
        for channel in 0..3 {
            let known = integral(|d| bsdf.of(d)[channel]);
            assert!((mean[channel] / known - 1.0).abs() < 2e-3, "{mean}");
        }
        let above = integral(|d| bsdf.density(d));
        assert!((above + f64::from(below) / count as f64 - 1.0).abs() < 2e-3);
    }
}

#[test]
fn glass_divides_all_light_between_reflection_and_refraction() {
    let glass = Material {
        kr: 0.1,
        kt: 0.9,
        index: 1.5,
        ..Material::BLACK
    };
    let normal = surface(glass, 1.0);
    // ((n - 1) / (n + 1))^2
    assert!((normal.reflected - 0.04).abs() < 1e-6);
    for step in 1..=1000 {
        let cosine = f64::from(step) / 1000.0;
        let bsdf = surface(glass, cosine);
        assert!((bsdf.reflected + bsdf.transmitted - 1.0).abs() < 1e-6);
        assert!(bsdf.reflected >= 0.04 - 1e-6 && bsdf.transmitted >= 0.0);
    }
    assert!(surface(glass, 0.001).reflected > 0.98);
    // Light that is polarised in the plane of incidence is not reflected at Brewster's angle, tan = n: half of what the other
    // reflects is left.
    let cosine = 1.0 / (1.0 + 1.5_f64 * 1.5).sqrt();
    let behind = 1.5 * cosine;
    let other = ((1.0 - 2.25) / (1.0 + 2.25_f64)).powi(2);
    // cos behind is the sine before.
    let behind_known = (1.0 - (1.0 - cosine * cosine) / 2.25).sqrt();
    assert!((behind - behind_known).abs() < 1e-12);
    assert!((fresnel_reflectance(cosine, behind, 1.0 / 1.5) - 0.5 * other).abs() < 1e-12);
}

#[test]
fn glass_bends_light_by_snells_law_both_ways_and_reflects_all_beyond_the_critical_angle() {
    let glass = Material {
        kt: 1.0,
        index: 1.5,
        ..Material::BLACK
    };
    let through = |cosine: f64, is_inside| {
        let bsdf = Bsdf::new(
            &glass,
            DVec3::ZERO,
            sight(cosine),
            DVec3::Y,
            GROOVE,
            is_inside,
            true,
        );
        // The last of the shares is the transmitted one.
        let next = bsdf.sample(1.0 - 1e-12, dvec2(0.5, 0.5));
        (bsdf.transmitted, next.expect("light goes on").d)
    };
    for cosine in [1.0, 0.9, 0.5, 0.05] {
        let sine = f64::sqrt(1.0 - cosine * cosine);
        let (_, d) = through(cosine, false);
        assert!(d.y < 0.0 && (d.x - sine / 1.5).abs() < 1e-12);
        let (share, back) = through(cosine, true);
        if sine * 1.5 < 1.0 {
            assert!(back.y < 0.0 && (back.x - sine * 1.5).abs() < 1e-12);
        } else {
            assert!(share == 0.0 && back.y > 0.0 && (back.x - sine).abs() < 1e-12);
        }
    }
}
