//! Named qualities show all objects, shadows and images of exhaustive pictures: at least one of
//! their pixels is right.

use crate::cpu::{self, Isa};
use crate::drawn::{bare, draw, draw_best, isa_of, named, of_side, of_the_show};
use crate::error::worst_channel;
use eightfold::show;
use eightfold_harness::patches::patches;
use eightfold_oracle::geometry::{PicturePlane, Shape};
use eightfold_scenes::artists::{FLOORS, KINDS, LIGHTS, ON_FLOORS};
use eightfold_scenes::{
    Draw, Kinds, Random, View, between_corners, cases, coloured, floor, hidden, known, lights,
    materials, materials_of, placed, placed_blocks, solids,
};
use eightfold_tracer::Quality;
use eightfold_tracer::scene::{Camera, Light, List, Material, Scene, Shape as BlockShape};
use glam::{DMat2, DVec2, DVec3, Vec3, dvec2};
use std::collections::{BTreeMap, BTreeSet};

pub fn pixels(isa: Isa, view: &View, quality: Quality) -> Vec<u32> {
    let quality = quality.jagged();
    draw(isa, 2, &view.scene, &quality, view.width, view.height).pixels
}

struct Effect {
    pixels: Vec<usize>,
    is_promised: bool,
}

fn promised(pixels: Vec<usize>) -> Effect {
    Effect { pixels, is_promised: true }
}

/// Counts of promised and of other effects: all, missed by a quality, and missed without the guard.
#[derive(Debug, Default)]
struct Tally {
    qualities: Vec<Quality>,
    shown: [usize; 2],
    missed: [usize; 2],
    bare: [usize; 2],
}

impl Tally {
    fn new(qualities: impl Iterator<Item = Quality>) -> Self {
        Self { qualities: qualities.collect(), ..Self::default() }
    }

    #[track_caller]
    fn add(
        &mut self,
        isa: Isa,
        view: &View,
        tolerance: u32,
        effects: impl FnOnce(&[u32]) -> Vec<Effect>,
    ) {
        let exhaustive = pixels(isa, view, Quality::EXHAUSTIVE);
        let effects = effects(&exhaustive);
        if effects.is_empty() {
            return;
        }
        let unguarded = pixels(isa, view, bare(Quality::DEFAULT));
        let drawn: Vec<_> = self.qualities.iter().map(|&it| (it, pixels(isa, view, it))).collect();
        for Effect { pixels, is_promised } in effects {
            let is_wrong =
                |drawn: &[u32], i: usize| worst_channel(exhaustive[i], drawn[i]) > tolerance;
            let is_missed = |drawn: &[u32]| pixels.iter().all(|&i| is_wrong(drawn, i));
            let missed = drawn.iter().find(|(_, drawn)| is_missed(drawn)).map(|(by, _)| by);
            let first = (pixels[0] % view.width, pixels[0] / view.width);
            let isa = isa.name;
            let is_right = !is_promised || missed.is_none();
            assert!(is_right, "{first:?} is missed by {isa} and {missed:?} in {view:?}");
            let kind = usize::from(!is_promised);
            self.shown[kind] += 1;
            self.missed[kind] += usize::from(missed.is_some());
            self.bare[kind] += usize::from(is_missed(&unguarded));
        }
    }

    #[track_caller]
    fn assert_counts(&self, shown: usize, bare: usize) {
        let Self { shown: all, missed, bare: without, .. } = self;
        println!("{all:?} shown, {missed:?} missed, {without:?} without the guard");
        assert!(all[0] >= shown && without[0] >= bare, "{without:?} of {all:?}");
    }
}

fn of_all_sides() -> impl Iterator<Item = Quality> {
    named().chain([16, 32].map(|side| of_side(side, Quality::DEFAULT)))
}

fn by_colour(pixels: &[u32]) -> BTreeMap<u32, Vec<usize>> {
    let mut colours: BTreeMap<u32, Vec<usize>> = BTreeMap::new();
    for (i, &pixel) in pixels.iter().enumerate() {
        colours.entry(pixel).or_default().push(i);
    }
    colours
}

/// Gaps between objects are not promised.
fn objects(view: &View, exhaustive: &[u32]) -> Vec<Effect> {
    let background = (255.0 * view.scene.background.x).round() as u32 * 0x01_0101;
    let mut colours = by_colour(exhaustive);
    colours.remove(&background);
    colours.into_values().map(promised).collect()
}

fn of_the_show_at_any_time(random: &mut Random) -> View {
    let scene = of_the_show(random.between(0.0, show::LENGTH));
    let Scene { camera, spheres, planes, blocks, .. } = scene;
    let objects = Scene { camera, spheres, planes, blocks, ..Scene::default() };
    let size = [160, 120].map(|side| 1 + random.below(side));
    View::new(coloured(&objects, 28), size)
}

fn sunk(random: &mut Random) -> View {
    let half = random.vector(Vec3::splat(0.3), Vec3::ONE);
    let large = solids::block(random, Vec3::ZERO, half, Material::BLACK);
    let eye = random.turn() * Vec3::X * random.between(2.0, 8.0);
    let mut scene = Scene { camera: Camera::new(eye, Vec3::ZERO, 1.5), ..Scene::default() };
    scene.blocks.push(large);
    for _ in 0..40 {
        let at = random.vector(Vec3::NEG_ONE, Vec3::ONE);
        let at = large.axes * (at / at.abs().max_element() * large.half);
        let half = random.vector(Vec3::splat(0.01), Vec3::splat(0.15));
        let centre = at * random.between(0.9, 1.05);
        scene.blocks.push(solids::block(random, centre, half, Material::BLACK));
    }
    View::new(coloured(&scene, 28), [160, 120])
}

#[track_caller]
fn assert_objects(views: impl Iterator<Item = View>, [shown, bare]: [usize; 2]) {
    let mut tally = Tally::new(of_all_sides());
    for (i, view) in views.enumerate() {
        tally.add(isa_of(i as u64), &view, 0, |exhaustive| objects(&view, exhaustive));
    }
    tally.assert_counts(shown, bare);
}

#[test]
fn objects_are_shown() {
    let known = known("slivers").into_iter().chain([between_corners()]);
    let by_all = cpu::instruction_sets().count();
    assert_objects(known.flat_map(|view| vec![view; by_all]), [600, 600]);
    let random = |draw: Draw<View>, count| cases(count).map(move |mut random| draw(&mut random));
    assert_objects(random(placed, 40), [400, 40]);
    assert_objects(random(placed_blocks, 48), [150, 20]);
    assert_objects(random(floor::contact, 36), [250, 45]);
    assert_objects(random(of_the_show_at_any_time, 40), [360, 40]);
    assert_objects(random(sunk, 30), [450, 45]);
}

/// The guard traces 1.11 times an unguarded frame's points among the chimes, 1.17 times among the
/// towers.
#[test]
fn hidden_objects_open_few_squares() {
    for (time, limit) in [(65.0, 1.13), (54.0, 1.19)] {
        let scene = of_the_show(time);
        let [guarded, unguarded] = [Quality::DEFAULT, bare(Quality::DEFAULT)].map(|quality| {
            let drawn = draw_best(&scene, &quality.jagged(), 1280, 720);
            drawn.counts.points as f64
        });
        assert!(guarded <= limit * unguarded, "{}", guarded / unguarded);
    }
}

/// Compares the traced points with a light a thousand units away.
#[test]
fn far_suns_and_telescopes_open_few_squares() {
    for kind in KINDS[..ON_FLOORS].iter().chain(&KINDS[ON_FLOORS + 6..]) {
        let scenes: Vec<Scene> =
            cases(2).map(|mut random| kind.scene(&mut random, LIGHTS[0].1, FLOORS[0].1)).collect();
        let points = |light: f32, eye: f32| {
            let points = scenes.iter().map(|scene| {
                let mut scene = scene.clone();
                let (camera, position) = (&mut scene.camera, &mut scene.lights[0].position);
                *position = position.normalize() * light;
                camera.eye = camera.look_at.lerp(camera.eye, eye);
                camera.field_of_view /= eye;
                draw_best(&scene, &Quality::DEFAULT.jagged(), 640, 360).counts.points as f64
            });
            points.sum::<f64>()
        };
        let usual = points(1e3, 1.0);
        let far = [(1e4, 1.0), (5e4, 1.0), (1e6, 1.0), (1e3, 10.0), (1e3, 100.0), (1e3, 1e3)];
        for ((light, eye), max) in far.into_iter().zip([1.05, 1.05, 1.2, 1.3, 1.3, 1.75]) {
            let share = points(light, eye) / usual;
            assert!(share < max, "{share} of {}, {light}, {eye}", kind.0);
        }
    }
}

/// Returns the shadow of the last sphere, unless it is darker than light by at most 1/255, which
/// can be rounding.
fn shadow(isa: Isa, view: &View, exhaustive: &[u32]) -> Vec<Effect> {
    let Some((_, others)) = view.scene.spheres.split_last() else { return Vec::new() };
    let mut lit = view.clone();
    lit.scene.spheres = others.iter().copied().collect();
    let lit = pixels(isa, &lit, Quality::EXHAUSTIVE);
    let is_shaded = |&i: &usize| exhaustive[i] == DARK && lit[i] != DARK;
    let shaded: Vec<usize> = (0..lit.len()).filter(is_shaded).collect();
    let is_visible = shaded.iter().any(|&i| worst_channel(lit[i], DARK) >= 2);
    is_visible.then(|| promised(shaded)).into_iter().collect()
}

/// The floor's pixel in a shadow: 0.1 of 0.7.
const DARK: u32 = 0x12_1212;

#[test]
fn shadows_on_a_floor_are_shown() {
    let [mut lone, mut among_others] = [Tally::new(named()), Tally::new(named())];
    let known = (0..3).flat_map(|kind| known("thin shadows").into_iter().map(move |it| (kind, it)));
    let random = cases(160).map(|mut random| (random.seed % 3, floor::shadow(&mut random)));
    for (i, (kind, view)) in known.chain(random).enumerate() {
        let isa = isa_of(i as u64);
        let view = match kind {
            0 => view,
            1 => view.glaring(),
            _ => view.glaring().with_box(),
        };
        let is_lone = view.scene.spheres.len() < 2;
        let tally = if is_lone { &mut lone } else { &mut among_others };
        tally.add(isa, &view, 0, |exhaustive| shadow(isa, &view, exhaustive));
    }
    lone.assert_counts(60, 15);
    among_others.assert_counts(30, 4);
}

/// Returns a black mirror that halves its images: their channels are below 128, the objects' are
/// 128 or more.
fn mirror(random: &mut Random) -> View {
    let view = hidden(random, [20, 20], Material::mirror(0.5));
    let (background, lights) = (Vec3::ZERO, List::default());
    View { scene: Scene { ambient: Vec3::ONE, background, lights, ..view.scene }, ..view }
}

/// Images of spheres and boxes in 2x2 pixels are promised, images of round blocks are not.
fn images(view: &View, exhaustive: &[u32]) -> Vec<Effect> {
    let is_image = |pixel: u32| pixel != 0 && pixel.to_be_bytes().iter().all(|&c| c < 128);
    let width = view.width;
    let mut effects = Vec::new();
    for (image, pixels) in by_colour(exhaustive) {
        let all: BTreeSet<usize> = pixels.iter().copied().collect();
        let mut corners = pixels.iter().filter(|&&i| i % width + 1 < width);
        let steps = [1, width, width + 1];
        let is_wide = corners.any(|i| steps.iter().all(|step| all.contains(&(i + step))));
        if is_image(image) && is_wide {
            let digit = |shift: u32| ((image >> shift & 0xff) as usize - 64) / 15;
            let number = digit(16) + 4 * digit(8) + 16 * digit(0);
            // The floor's number is between the spheres' and the blocks'.
            let block = number.checked_sub(view.scene.spheres.len() + 1);
            let is_promised =
                block.is_none_or(|block| view.scene.blocks[block].shape == BlockShape::Box);
            effects.push(Effect { pixels, is_promised });
        }
    }
    effects
}

#[test]
fn images_in_a_floor_are_shown() {
    let mut tally = Tally::new(of_all_sides());
    for mut random in cases(40) {
        let view = mirror(&mut random);
        tally.add(isa_of(random.seed), &view, 1, |exhaustive| images(&view, exhaustive));
    }
    tally.assert_counts(250, 150);
    assert!(tally.shown[1] > 150 && tally.missed[1] <= 2, "{tally:?}");
}

fn image(exhaustive: &[u32]) -> Vec<Effect> {
    let is_image = |&i: &usize| (0x7f_664c..=0x80_664d).contains(&exhaustive[i]);
    let pixels: Vec<usize> = (0..exhaustive.len()).filter(is_image).collect();
    (!pixels.is_empty()).then(|| promised(pixels)).into_iter().collect()
}

#[test]
fn thin_and_near_images_are_shown() {
    let mut tally = Tally::new(named());
    for isa in cpu::instruction_sets() {
        tally.add(isa, &known("wide image")[0], 1, image);
    }
    for mut random in cases(150) {
        let isa = isa_of(random.seed);
        tally.add(isa, &floor::image(&mut random), 1, image);
    }
    tally.assert_counts(60, 18);
}

/// The step of numerical derivatives, in pixels.
const NEAR: f64 = 1e-4;

/// Returns whether one of the pixels, or a neighbour, shows a point that mirrors a light to the
/// eye.
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

/// Highlights of five pixels are promised if one of them, or a neighbour, shows the point that
/// mirrors the light.
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
        let (spheres, blocks) = if are_blocks { (0, 18) } else { (14, 0) };
        let (planes, material) = (1, materials::shiny as fn(&mut _) -> _);
        let light =
            |random: &mut Random| Light { parallel: random.below(7) == 0, ..lights::point(random) };
        let radius = [[-1.3, 0.2], [0.0; 2]];
        let kinds = Kinds { spheres, blocks, planes, material, light, radius, ..Kinds::SPHERES };
        let mut tally = Tally::new(named());
        let known = (0..3).flat_map(|_| known("thin highlights")).filter(|_| are_blocks);
        let random = cases(32).map(|mut random| kinds.view(&mut random));
        for (seed, view) in (0..).zip(known.chain(random)) {
            let isa = isa_of(seed);
            tally.add(isa, &view, 8, |exhaustive| highlights(isa, &view, exhaustive));
        }
        tally.assert_counts(40, tally.shown[0] / 30);
        assert!(tally.missed[1] <= tally.shown[1] / 400, "{tally:?}");
    }
}
