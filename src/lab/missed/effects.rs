//! The effects of each thing of a scene on a picture, by kind: itself, its shadows, its images.

use super::MAX_ERROR;
use crate::error::worst_channel;
use crate::threaded_renderer::ThreadedRenderer;
use eightfold_oracle::{Object, Oracle};
use eightfold_tracer::Quality;
use eightfold_tracer::glam::Vec3;
use eightfold_tracer::scene::{List, Material, Scene, Waves};
use eightfold_window::cpu;
use rayon::prelude::*;
use std::collections::BTreeMap;

/// The kind of effect by which a pixel shows a thing.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Kind {
    /// The thing itself.
    Object,
    /// Its shadow on a plane.
    PlaneShadow,
    /// Its shadow on a sphere, a box or a cylinder.
    SolidShadow,
    /// Its image in the first plane, without waves.
    PlaneImage,
    /// Its image in another mirror, in waves, or through glass.
    OtherImage,
}

impl Kind {
    /// All of them, as they stand in a table.
    pub const ALL: [(Self, &'static str); 5] = [
        (Self::Object, "objects"),
        (Self::PlaneShadow, "shadows on planes"),
        (Self::SolidShadow, "shadows on spheres and blocks"),
        (Self::PlaneImage, "images in the first plane"),
        (
            Self::OtherImage,
            "images in other mirrors, in waves, through glass",
        ),
    ];
}

/// The most pixels of what is small.
const SMALL: usize = 16;

/// How many small effects there are, and how many of them a picture misses: none of their pixels is right.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Count {
    pub small: usize,
    /// By the quality, and by the same one without the guard.
    pub missed: [usize; 2],
}

/// The counts by kind.
pub type Counts = BTreeMap<Kind, Count>;

/// Counts what frames of one size miss.
pub struct EffectCounter {
    renderer: ThreadedRenderer,
    width: usize,
    height: usize,
}

impl EffectCounter {
    pub fn new(threads: usize, width: usize, height: usize) -> Self {
        Self {
            renderer: ThreadedRenderer::new(threads),
            width,
            height,
        }
    }

    fn draw(&mut self, scene: &Scene, quality: Quality) -> Vec<u32> {
        let mut pixels = vec![0; self.width * self.height];
        let quality = Quality {
            antialias: false,
            ..quality
        };
        let level = cpu::best().level;
        self.renderer
            .draw(level, scene, &quality, self.width, &mut pixels);
        pixels
    }

    /// Counts the small effects of all things of a scene, and those that are missed.
    pub fn count(&mut self, scene: &Scene, quality: Quality, counts: &mut Counts) {
        let whole = self.draw(scene, Quality::EXHAUSTIVE);
        let drawn = [quality.guarded, false].map(|guarded| {
            let quality = Quality { guarded, ..quality };
            self.draw(scene, quality)
        });
        let unlit = self.draw(&without_lights(scene), Quality::EXHAUSTIVE);
        let oracle = Oracle::new(scene, &Quality::EXHAUSTIVE, self.width, self.height);
        let width = self.width;
        let at = |i: usize| oracle.object_at((i % width) as isize, (i / width) as isize);
        let hosts: Vec<Object> = (0..whole.len()).into_par_iter().map(at).collect();
        for thing in things(scene) {
            let rest = without(scene, thing);
            let without = self.draw(&rest, Quality::EXHAUSTIVE);
            let changed = |&i: &usize| hosts[i] == thing || differ(whole[i], without[i]);
            let changed: Vec<usize> = (0..whole.len()).filter(changed).collect();
            // Most pictures have no mirror at all there.
            let is_mirrored = changed
                .iter()
                .any(|&i| material(scene, hosts[i]).is_specular());
            let unlit_without =
                is_mirrored.then(|| self.draw(&without_lights(&rest), Quality::EXHAUSTIVE));
            let mut pixels: BTreeMap<Kind, Vec<usize>> = BTreeMap::new();
            for i in changed {
                let is_seen = unlit_without
                    .as_ref()
                    .is_some_and(|without| differ(unlit[i], without[i]));
                let kind = kind(scene, thing, hosts[i], is_seen);
                pixels.entry(kind).or_default().push(i);
            }
            pixels.retain(|_, pixels| pixels.len() <= SMALL);
            for (kind, pixels) in pixels {
                add(counts, kind, &pixels, &whole, &drawn);
            }
        }
    }
}

/// Counts a small effect that some pixels show, and the pictures that have none of them right.
fn add(counts: &mut Counts, kind: Kind, pixels: &[usize], whole: &[u32], drawn: &[Vec<u32>; 2]) {
    let count = counts.entry(kind).or_default();
    count.small += 1;
    for (missed, drawn) in count.missed.iter_mut().zip(drawn) {
        *missed += usize::from(pixels.iter().all(|&i| differ(whole[i], drawn[i])));
    }
}

fn differ(a: u32, b: u32) -> bool {
    worst_channel(a, b) > MAX_ERROR
}

/// The spheres, boxes and cylinders of a scene.
fn things(scene: &Scene) -> impl Iterator<Item = Object> {
    let spheres = (0..scene.spheres.len()).map(Object::Sphere);
    spheres.chain((0..scene.blocks.len()).map(Object::Block))
}

/// The scene without one of its things.
fn without(scene: &Scene, thing: Object) -> Scene {
    let mut scene = scene.clone();
    match thing {
        Object::Sphere(i) => scene.spheres = all_but(&scene.spheres, i),
        Object::Block(i) => scene.blocks = all_but(&scene.blocks, i),
        _ => {}
    }
    scene
}

/// The items of a list but one.
fn all_but<T: Copy + Default, const N: usize>(list: &[T], i: usize) -> List<T, N> {
    let others = list[..i].iter().chain(&list[i + 1..]);
    others.copied().collect()
}

/// The scene without lights, in even light: what changes in it is no shadow.
fn without_lights(scene: &Scene) -> Scene {
    let mut scene = scene.clone();
    scene.lights.clear();
    scene.ambient = Vec3::ONE;
    scene
}

/// Tells what a pixel that shows the object `host` shows of a thing that changes it, without lights, too, if `is_seen`.
fn kind(scene: &Scene, thing: Object, host: Object, is_seen: bool) -> Kind {
    let is_image = is_seen && material(scene, host).is_specular();
    match host {
        _ if host == thing => Kind::Object,
        Object::Plane(0) if is_image && scene.water == Waves::CALM => Kind::PlaneImage,
        _ if is_image => Kind::OtherImage,
        Object::Plane(_) => Kind::PlaneShadow,
        _ => Kind::SolidShadow,
    }
}

/// The material of an object; lights and the background have a black one.
fn material(scene: &Scene, object: Object) -> Material {
    object.material(scene).copied().unwrap_or(Material::BLACK)
}
