use super::{MAX_ERROR, visible_objects};
use crate::arguments::Size;
use crate::error::worst_channel;
use crate::threaded_renderer::ThreadedRenderer;
use eightfold_oracle::Object;
use eightfold_tracer::Quality;
use eightfold_tracer::glam::Vec3;
use eightfold_tracer::scene::{List, Material, Scene, Waves};
use eightfold_window::cpu;
use std::collections::BTreeMap;

#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Kind {
    Object,
    PlaneShadow,
    /// On a sphere or a block.
    SolidShadow,
    /// In the first plane, without waves.
    PlaneImage,
    /// In another mirror, in waves, or through glass.
    OtherImage,
}

impl Kind {
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

/// In pixels.
const SMALL: usize = 16;

/// Small effects; missed if every pixel is wrong.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Count {
    pub small: usize,
    /// With and without the guard.
    pub missed: [usize; 2],
}

pub type Counts = BTreeMap<Kind, Count>;

pub struct EffectCounter {
    renderer: ThreadedRenderer,
    size: Size,
}

impl EffectCounter {
    pub fn new(threads: usize, size: Size) -> Self {
        let renderer = ThreadedRenderer::new(threads);
        Self { renderer, size }
    }

    fn draw(&mut self, scene: &Scene, quality: Quality) -> Vec<u32> {
        let mut pixels = vec![0; self.size.area()];
        let quality = Quality {
            antialias: false,
            ..quality
        };
        let (level, width) = (cpu::best().level, self.size.width);
        self.renderer
            .draw(level, scene, &quality, width, &mut pixels);
        pixels
    }

    pub fn count(&mut self, scene: &Scene, quality: Quality, counts: &mut Counts) {
        let whole = self.draw(scene, Quality::EXHAUSTIVE);
        let drawn = [quality.guarded, false].map(|guarded| {
            let quality = Quality { guarded, ..quality };
            self.draw(scene, quality)
        });
        let unlit = self.draw(&without_lights(scene), Quality::EXHAUSTIVE);
        let hosts = visible_objects(scene, self.size);
        for object in objects(scene) {
            let rest = without(scene, object);
            let without = self.draw(&rest, Quality::EXHAUSTIVE);
            let changed = |&i: &usize| hosts[i] == object || differ(whole[i], without[i]);
            let changed: Vec<usize> = (0..whole.len()).filter(changed).collect();
            // Skip this picture if no mirror shows the object.
            let is_mirror = |&i: &usize| material(scene, hosts[i]).is_specular();
            let is_mirrored = changed.iter().any(is_mirror);
            let rest = without_lights(&rest);
            let unlit_without = is_mirrored.then(|| self.draw(&rest, Quality::EXHAUSTIVE));
            let mut pixels: BTreeMap<Kind, Vec<usize>> = BTreeMap::new();
            for i in changed {
                let without = unlit_without.as_ref();
                let is_seen = without.is_some_and(|without| differ(unlit[i], without[i]));
                let kind = kind(scene, object, hosts[i], is_seen);
                pixels.entry(kind).or_default().push(i);
            }
            pixels.retain(|_, pixels| pixels.len() <= SMALL);
            for (kind, pixels) in pixels {
                let count = counts.entry(kind).or_default();
                count.small += 1;
                for (missed, drawn) in count.missed.iter_mut().zip(&drawn) {
                    let is_wrong = |&i: &usize| differ(whole[i], drawn[i]);
                    *missed += usize::from(pixels.iter().all(is_wrong));
                }
            }
        }
    }
}

fn differ(a: u32, b: u32) -> bool {
    worst_channel(a, b) > MAX_ERROR
}

pub fn objects(scene: &Scene) -> impl Iterator<Item = Object> {
    let spheres = (0..scene.spheres.len()).map(Object::Sphere);
    spheres.chain((0..scene.blocks.len()).map(Object::Block))
}

pub fn without(scene: &Scene, object: Object) -> Scene {
    let mut scene = scene.clone();
    match object {
        Object::Sphere(i) => scene.spheres = all_but(&scene.spheres, i),
        Object::Block(i) => scene.blocks = all_but(&scene.blocks, i),
        _ => {}
    }
    scene
}

fn all_but<T: Copy + Default, const N: usize>(list: &[T], i: usize) -> List<T, N> {
    let others = list[..i].iter().chain(&list[i + 1..]);
    others.copied().collect()
}

/// Lights the scene evenly, so no change is a shadow.
fn without_lights(scene: &Scene) -> Scene {
    let mut scene = scene.clone();
    scene.lights.clear();
    scene.ambient = Vec3::ONE;
    scene
}

/// Returns the effect of `object` on a pixel of `host`. `is_seen`: the object changes the pixel even without lights.
fn kind(scene: &Scene, object: Object, host: Object, is_seen: bool) -> Kind {
    let is_image = is_seen && material(scene, host).is_specular();
    match host {
        _ if host == object => Kind::Object,
        Object::Plane(0) if is_image && scene.water == Waves::CALM => Kind::PlaneImage,
        _ if is_image => Kind::OtherImage,
        Object::Plane(_) => Kind::PlaneShadow,
        _ => Kind::SolidShadow,
    }
}

/// Returns black for lights and the background.
fn material(scene: &Scene, object: Object) -> Material {
    object.material(scene).copied().unwrap_or(Material::BLACK)
}
