//! `lab truth`: pictures that are known in closed form, surfaces that keep energy, and files that are whole.

mod by_chance;
mod caustics;
mod closed_forms;
mod coverage;
mod effects;
mod files;
mod lamps;
mod lengths;
mod surfaces;

use eightfold_lab::arguments::Size;
use eightfold_lab::sampler::Sequence;
use eightfold_lab::truth::REPLICATIONS;
use eightfold_lab::truth::effects::Effects;
use eightfold_lab::truth::estimate::Estimate;
use eightfold_lab::truth::film::Sampling;
use eightfold_lab::truth::render::Picture;
use eightfold_tracer::glam::{DVec3, Vec3A};
use eightfold_tracer::scene::{Camera, List, Material, Plane, Scene};
use rayon::ThreadPoolBuilder;

/// A white surface that scatters all light diffusely.
const WHITE: Material = Material::matt(Vec3A::ONE, 1.0);

/// How far the numbers of a scene, of 32 bits, are off those that are known in closed form.
const ROUNDING: f64 = 1e-6;

/// A picture of one pixel: what is seen at the point that the camera looks at, by so many paths.
fn seen(scene: &Scene, effects: Effects, paths: usize) -> Estimate {
    let size = Size::new(1, 1);
    drawn(scene, size, effects, paths)[0]
}

/// A picture of the pixels' centres.
fn drawn(scene: &Scene, size: Size, effects: Effects, paths: usize) -> Vec<Estimate> {
    assert_eq!(scene.validate(), Ok(()));
    let picture = Picture {
        scene,
        size,
        effects,
        sampling: Sampling {
            count: paths / REPLICATIONS,
            sequence: Sequence::Sobol,
            seed: 1,
            is_antialiased: false,
        },
    };
    picture.draw(&ThreadPoolBuilder::new().build().expect("threads"))
}

/// Asserts that the mean is a known one: within 99.9 % of its distribution, which is narrower than `most`.
#[track_caller]
fn assert_near(estimate: Estimate, known: DVec3, most: f64) {
    // Student's t with 7 degrees of freedom: 5.41 standard errors, where the interval of 95 % has 2.365.
    let allowed = estimate.half_interval().max_element() * 5.41 / 2.365;
    let off = (estimate.mean - known).abs().max_element();
    assert!(allowed < most, "the interval is too wide: {allowed}");
    assert!(
        off <= allowed + ROUNDING,
        "{} is not {known}",
        estimate.mean
    );
}

/// A floor of a material at y = 0, of which the camera sees the origin from the side.
fn floor(material: Material) -> Scene {
    Scene {
        camera: Camera::new(Vec3A::new(4.0, 0.6, 0.0), Vec3A::ZERO, 0.01),
        planes: List::of(&[Plane::new(Vec3A::ZERO, 1e4, 1e4, material)]),
        ..Scene::default()
    }
}
