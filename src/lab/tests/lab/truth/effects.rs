//! With all effects off, the path tracer draws the real-time model.

use super::drawn;
use eightfold_lab::arguments::Size;
use eightfold_lab::scenes::SceneName;
use eightfold_lab::truth::effects::Effects;
use eightfold_lab::truth::{estimate::Estimate, undress};
use eightfold_oracle::Oracle;
use eightfold_tracer::Quality;
use eightfold_tracer::glam::DVec3;
use eightfold_tracer::scene::{Material, Scene};

const SIZE: Size = Size::new(40, 30);

/// The same scene without the effects that the oracle and the path tracer have each in its own way: penumbrae and tints.
fn with_points(mut scene: Scene) -> Scene {
    scene.captions.clear();
    for light in scene.lights.iter_mut() {
        light.diameter = 0.0;
    }
    scene
}

fn materials(scene: &mut Scene) -> impl Iterator<Item = &mut Material> {
    let Scene {
        spheres,
        planes,
        blocks,
        ..
    } = scene;
    let spheres = spheres.iter_mut().map(|it| &mut it.material);
    let planes = planes.iter_mut().map(|it| &mut it.material);
    let blocks = blocks.iter_mut().map(|it| &mut it.material);
    spheres.chain(planes).chain(blocks)
}

/// The colours by the oracle, without limits on secondary rays.
fn by_the_oracle(scene: &Scene) -> Vec<DVec3> {
    let quality = Quality {
        depth: Quality::MAX_DEPTH,
        least_contribution: 0.0,
        ..Quality::EXHAUSTIVE
    };
    let oracle = Oracle::new(scene, &quality, SIZE.width, SIZE.height);
    let pixels = (0..SIZE.area()).map(|i| (i % SIZE.width, i / SIZE.width));
    pixels
        .map(|(x, y)| oracle.trace(x as isize, y as isize).colour)
        .collect()
}

fn scenes() -> impl Iterator<Item = (String, Scene)> {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/scenes");
    let files = ["first", "blocks", "patterns", "air", "lights", "water"];
    let files = files.map(|name| format!("{folder}/{name}.ron"));
    let names = ["model", "field:40", "show:machine", "show:colonnade"].map(str::to_owned);
    names.into_iter().chain(files).map(|name| {
        let scene: SceneName = name.parse().expect("a scene");
        let mut scene = scene.without_overlay(3.1);
        undress(&mut scene);
        (name, with_points(scene))
    })
}

#[test]
fn without_effects_surfaces_are_those_of_the_model_to_the_last_digits() {
    for (name, mut scene) in scenes() {
        for material in materials(&mut scene) {
            (material.kr, material.kt, material.fresnel) = (0.0, 0.0, 0.0);
        }
        let pairs = drawn(&scene, SIZE, Effects::NONE, 8)
            .into_iter()
            .zip(by_the_oracle(&scene));
        // The oracle's film shows nothing brighter than white.
        let shown = |(ours, known): (Estimate, DVec3)| (ours.mean.min(DVec3::ONE) - known).abs();
        let off = pairs.map(|pair| shown(pair).max_element());
        // A ray that passes an edge within rounding may see either side.
        let wrong = off.filter(|&off| off > 1e-6).count();
        assert!(wrong <= 1, "{name}: {wrong} pixels");
    }
}

#[test]
fn without_effects_mirrors_and_glass_are_those_of_the_model() {
    for (name, mut scene) in scenes() {
        // The oracle shows nothing brighter than white; the mean of paths is, as they end by chance and so share the rest of the
        // light among each other.
        for material in materials(&mut scene) {
            material.ks = material.ks.min(0.5);
            material.kr = material.kr.min(0.7);
            material.kt = material.kt.min(0.7);
        }
        let ours = drawn(&scene, SIZE, Effects::NONE, 256);
        let known = by_the_oracle(&scene);
        let mut outside = 0;
        let (mut sum, mut variance) = (DVec3::ZERO, DVec3::ZERO);
        for (ours, known) in ours.iter().zip(&known) {
            let off = ours.mean - known;
            // The oracle stops after seven reflections.
            let allowed = ours.half_interval() + 0.7_f64.powi(7);
            outside += usize::from(off.abs().cmpgt(allowed).any());
            sum += off;
            variance += ours.variance;
        }
        // Five in a hundred are outside of a channel's interval by chance, and there are three.
        let share = outside as f64 / known.len() as f64;
        assert!(share < 0.15, "{name}: {share} of the pixels");
        let mean = sum / known.len() as f64;
        let error = variance.map(f64::sqrt) / known.len() as f64;
        let allowed = 4.0 * error + 0.002;
        assert!(mean.abs().cmple(allowed).all(), "{name}: {mean}, {error}");
    }
}
