use crate::cpu::Isa;
use crate::drawn::{isa_of, named};
use crate::error::worst_channel;
use crate::shown::{Effect, Tally, pixels, sized};
use eightfold_harness::patches::patches;
use eightfold_oracle::geometry::{PicturePlane, Shape};
use eightfold_scenes::{Kinds, Random, View, cases, known, lights, materials, materials_of};
use eightfold_tracer::Quality;
use eightfold_tracer::scene::Light;
use glam::{DMat2, DVec2, DVec3, dvec2};

/// The step of numerical derivatives, in pixels.
const NEAR: f64 = 1e-4;

/// Returns whether one of the pixels, or a neighbour, shows a point that mirrors a light to the eye.
fn show_mirror_point(view: &View, shape: Shape, pixels: &[usize]) -> bool {
    let plane = PicturePlane::new(&view.scene.camera, view.width, view.height);
    // The difference between the mirrored ray and the direction to the light.
    let apart = |at: DVec2, light: DVec3| {
        let ray = plane.ray(at.x, at.y);
        let met = shape.meet(ray, f64::INFINITY)?;
        let mirrored = ray.d - 2.0 * ray.d.dot(met.normal) * met.normal;
        Some(mirrored - (light - ray.at(met.t)).normalize())
    };
    // Newton's step from a pixel to where the difference is 0.
    let step = |at: DVec2, light: DVec3| {
        let here = apart(at, light)?;
        let right = (apart(at + NEAR * DVec2::X, light)? - here) / NEAR;
        let down = (apart(at + NEAR * DVec2::Y, light)? - here) / NEAR;
        let across = right.dot(down);
        let square = DMat2::from_cols_array(&[right.dot(right), across, across, down.dot(down)]);
        Some(-square.inverse() * dvec2(right.dot(here), down.dot(here)))
    };
    view.scene.lights.iter().any(|light| {
        let far = if light.parallel { Light::FAR } else { 1.0 };
        let light = (light.position * far).as_dvec3();
        let is_near = |step: DVec2| step.abs().max_element() <= 1.0;
        let place = |i: &usize| dvec2((i % view.width) as f64, (i / view.width) as f64);
        let mut places = pixels.iter().map(place);
        places.any(|at| step(at, light).is_some_and(is_near))
    })
}

/// Highlights of five pixels are promised if one of them, or a neighbour, shows the point that mirrors the light.
fn highlights(isa: Isa, view: &View, exhaustive: &[u32]) -> Vec<Effect> {
    let scene = &view.scene;
    let spheres = scene.spheres.iter().map(Shape::from);
    let planes = scene.planes.iter().map(Shape::from);
    let blocks = scene.blocks.iter().map(Shape::from);
    let mut effects = Vec::new();
    for (i, shape) in spheres.chain(planes).chain(blocks).enumerate() {
        let mut matt = view.clone();
        materials_of(&mut matt.scene)[i].ks = 0.0;
        let matt = pixels(isa, &matt, Quality::EXHAUSTIVE);
        let is_changed = |&i: &usize| worst_channel(exhaustive[i], matt[i]) > 8;
        let changed: Vec<usize> = (0..matt.len()).filter(is_changed).collect();
        let patches = patches(&changed, view.width).into_iter().filter(|it| it.len() >= 5);
        effects.extend(patches.map(|pixels| {
            let is_promised = show_mirror_point(view, shape, &pixels);
            Effect { pixels, is_promised }
        }));
    }
    effects
}

#[test]
fn highlights_of_five_pixels_are_shown() {
    for are_blocks in [false, true] {
        let (spheres, blocks) = if are_blocks { (0, 14) } else { (14, 0) };
        let (planes, material) = (1, materials::shiny as fn(&mut _) -> _);
        let light =
            |random: &mut Random| Light { parallel: random.below(7) == 0, ..lights::point(random) };
        let kinds =
            Kinds { spheres, blocks, planes, material, light, smallest: -1.3, ..Kinds::SPHERES };
        let mut tally = Tally::new(named());
        let known = (0..3).flat_map(|_| known("thin highlights")).filter(|_| are_blocks);
        let random = cases(24).map(|mut random| sized(kinds.scene(&mut random)));
        for (seed, view) in (0..).zip(known.chain(random)) {
            let isa = isa_of(seed);
            tally.add(isa, &view, 8, |exhaustive| highlights(isa, &view, exhaustive));
        }
        tally.assert_counts(40, tally.shown[0] / 30);
        assert!(tally.missed[1] <= tally.shown[1] / 400, "{tally:?}");
    }
}
