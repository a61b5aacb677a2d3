//! The effects of each thing of a scene on a picture, by kind: itself, its shadows, its images.

use super::MAX_ERROR;
use crate::error::worst_channel;
use crate::threaded_renderer::ThreadedRenderer;
use eightfold_oracle::{Object, Oracle};
use eightfold_tracer::Quality;
use eightfold_tracer::glam::Vec3;
use eightfold_tracer::scene::{Light, List, Material, Scene, Waves};
use eightfold_window::cpu;
use rayon::prelude::*;
use std::collections::{BTreeMap, BTreeSet};
use std::ops::RangeInclusive;

/// The kind of effect by which a pixel shows a thing.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Kind {
    /// The thing itself.
    Object,
    /// The shadow of a sphere on a plane, where all lamps of the scene are points.
    PointShadow,
    /// The same where none is a sun or a spotlight, and some have a size.
    SizedShadow,
    /// The same where some lamp is a sun or a spotlight.
    SunShadow,
    /// The shadow of a box or a cylinder on a plane.
    BlockShadow,
    /// A shadow on a sphere, a box or a cylinder.
    SolidShadow,
    /// An image in the first plane, without waves.
    PlaneImage,
    /// An image in another mirror, or in waves.
    OtherImage,
    /// The thing through glass.
    Glass,
    /// A highlight, in the eye's own sight.
    Highlight,
    /// A highlight, in a mirror or through glass.
    MirroredHighlight,
}

impl Kind {
    /// All of them, as they stand in a table.
    pub const ALL: [(Self, &'static str); 11] = [
        (Self::Object, "objects"),
        (Self::PointShadow, "shadows of spheres on planes, by points"),
        (Self::SizedShadow, "... by lamps with a size"),
        (Self::SunShadow, "... by suns and spotlights"),
        (Self::BlockShadow, "shadows of blocks on planes"),
        (Self::SolidShadow, "shadows on spheres and blocks"),
        (Self::PlaneImage, "images in the first plane"),
        (Self::OtherImage, "images in other mirrors, in waves"),
        (Self::Glass, "through glass"),
        (Self::Highlight, "highlights"),
        (Self::MirroredHighlight, "... in mirrors"),
    ];
}

/// The most pixels of what is small.
const SMALL: usize = 16;

/// The fewest and the most pixels of a small highlight, which is less sharp than other things.
const SMALL_HIGHLIGHT: RangeInclusive<usize> = 5..=64;

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
        let unlit = self.draw(&without_lamps(scene), Quality::EXHAUSTIVE);
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
                is_mirrored.then(|| self.draw(&without_lamps(&rest), Quality::EXHAUSTIVE));
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
        for thing in shiny(scene) {
            let matt = self.draw(&made_matt(scene, thing), Quality::EXHAUSTIVE);
            let (own, mirrored): (Vec<usize>, Vec<usize>) = (0..whole.len())
                .filter(|&i| differ(whole[i], matt[i]))
                .partition(|&i| hosts[i] == thing);
            for (kind, pixels) in [(Kind::Highlight, own), (Kind::MirroredHighlight, mirrored)] {
                for patch in patches(&pixels, self.width) {
                    if SMALL_HIGHLIGHT.contains(&patch.len()) {
                        add(counts, kind, &patch, &whole, &drawn);
                    }
                }
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

/// Pixels, given by ascending index, by patches of neighbours, corners included.
pub fn patches(pixels: &[usize], width: usize) -> Vec<Vec<usize>> {
    let mut rest: BTreeSet<usize> = pixels.iter().copied().collect();
    let mut patches = Vec::new();
    while let Some(first) = rest.pop_first() {
        let mut patch = vec![first];
        let mut next = 0;
        while let Some(&pixel) = patch.get(next) {
            let (x, y) = (pixel % width, pixel / width);
            for y in y.saturating_sub(1)..=y + 1 {
                for x in x.saturating_sub(1)..=(x + 1).min(width - 1) {
                    patch.extend(rest.take(&(y * width + x)));
                }
            }
            next += 1;
        }
        patches.push(patch);
    }
    patches
}

fn differ(a: u32, b: u32) -> bool {
    worst_channel(a, b) > MAX_ERROR
}

/// The spheres, boxes and cylinders of a scene.
fn things(scene: &Scene) -> impl Iterator<Item = Object> {
    let spheres = (0..scene.spheres.len()).map(Object::Sphere);
    spheres.chain((0..scene.blocks.len()).map(Object::Block))
}

/// The objects of a scene that have highlights.
fn shiny(scene: &Scene) -> impl Iterator<Item = Object> {
    let planes = (0..scene.planes.len()).map(Object::Plane);
    things(scene)
        .chain(planes)
        .filter(|&thing| material(scene, thing).ks > 0.0)
}

/// The scene with an object that has no highlights.
fn made_matt(scene: &Scene, thing: Object) -> Scene {
    let mut scene = scene.clone();
    match thing {
        Object::Sphere(i) => scene.spheres[i].material.ks = 0.0,
        Object::Block(i) => scene.blocks[i].material.ks = 0.0,
        Object::Plane(i) => scene.planes[i].material.ks = 0.0,
        Object::Light(_) | Object::Background => {}
    }
    scene
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

/// The scene without lamps, in even light: what changes in it is no shadow.
fn without_lamps(scene: &Scene) -> Scene {
    let mut scene = scene.clone();
    scene.lights.clear();
    scene.ambient = Vec3::ONE;
    scene
}

/// Tells what a pixel that shows the object `host` shows of a thing that changes it, without lamps, too, if `is_seen`.
fn kind(scene: &Scene, thing: Object, host: Object, is_seen: bool) -> Kind {
    let is_image = is_seen && material(scene, host).is_specular();
    match host {
        _ if host == thing => Kind::Object,
        _ if is_image && material(scene, host).kt > 0.0 => Kind::Glass,
        Object::Plane(0) if is_image && scene.water == Waves::CALM => Kind::PlaneImage,
        _ if is_image => Kind::OtherImage,
        Object::Plane(_) => match thing {
            Object::Block(_) => Kind::BlockShadow,
            _ => shadow_by(&scene.lights),
        },
        _ => Kind::SolidShadow,
    }
}

/// The kind of a sphere's shadow on a plane by lamps.
fn shadow_by(lamps: &[Light]) -> Kind {
    if lamps
        .iter()
        .any(|lamp| lamp.parallel || lamp.spot.is_some())
    {
        Kind::SunShadow
    } else if lamps.iter().any(|lamp| lamp.diameter > 0.0) {
        Kind::SizedShadow
    } else {
        Kind::PointShadow
    }
}

/// The material of an object; lamps and the background have a black one.
fn material(scene: &Scene, object: Object) -> Material {
    object.material(scene).copied().unwrap_or(Material::BLACK)
}
