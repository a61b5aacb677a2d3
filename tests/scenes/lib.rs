//! The crate of random scenes, by seed, for tests.
//!
//! | kind | scenes |
//! | --- | --- |
//! | [`Kinds`] | all shapes, materials and lights, scattered in ranges |
//! | [`placed`] | ... in their own colours, placed and sized by pixels |
//! | [`hidden()`] | ... small, easily missed |
//! | [`crowd()`] | ... hundreds of mirrors, glass and plastic |
//! | [`floor`] | a single shadow or image in a floor, or objects that rise from it |
//! | [`artists`] | bars in the order of words, nets, fences and shelves |
//! | [`BarView`] | bars of one to five pixels, as objects, shadows and images |
//! | [`known()`] | scenes that once failed |
//!
//! A new kind has its numbers, places, sizes, materials and lights in a [`Kinds`].

pub mod artists;
pub mod floor;
mod kinds;
pub mod lights;
pub mod materials;
mod random;
mod scattered;
pub mod solids;
pub mod text;
mod thin;

pub use kinds::{Draw, Kinds, presented};
pub use random::{Random, cases};
pub use scattered::{GREY, between_corners, crowd, hidden, placed, placed_blocks};
pub use thin::BarView;

use eightfold_tracer::scene::{MIN_LENGTH, Material, Scene};
use glam::Vec3;
use std::collections::HashMap;
use text::Text;

#[derive(Clone, Debug)]
pub struct View {
    pub scene: Scene,
    pub width: usize,
    pub height: usize,
}

impl View {
    pub const fn new(scene: Scene, [width, height]: [usize; 2]) -> Self {
        Self { scene, width, height }
    }

    /// Returns the direction through a point of the picture, at a depth of 1, and the length of a
    /// pixel there.
    fn ray(&self, x: f32, y: f32) -> (Vec3, f32) {
        let raster = self.scene.camera.raster(self.width, self.height);
        (raster.corner + raster.dx * x + raster.dy * y, raster.dx.length())
    }

    /// Returns the point that a pixel shows at a distance, and the length of `pixels` there.
    fn at(&self, [x, y]: [f32; 2], distance: f32, pixels: f32) -> (Vec3, f32) {
        let (d, pixel) = self.ray(x, y);
        (self.scene.camera.eye + d * distance, pixels * pixel * distance)
    }
}

pub fn any(random: &mut Random) -> Scene {
    let shiny_blocks = Kinds { material: materials::shiny, ..Kinds::RICH };
    match random.below(7) {
        0 => hidden(random, [20, 20], GREY).scene,
        1 => random.one_of(BarView::ALL).view(random)[0].scene.clone(),
        2 => crowd(random, [8, 8], [0.3, 0.3]),
        3 => shiny_blocks.scene(random),
        4 => artists::artists(random),
        _ => Kinds::EXTREME.scene(random),
    }
}

pub fn materials_of(scene: &mut Scene) -> Vec<&mut Material> {
    let spheres = scene.spheres.iter_mut().map(|sphere| &mut sphere.material);
    let planes = scene.planes.iter_mut().map(|plane| &mut plane.material);
    let blocks = scene.blocks.iter_mut().map(|block| &mut block.material);
    spheres.chain(planes).chain(blocks).collect()
}

/// Gives objects and lights distinct ambient colours, at least `step` of 255 apart in a channel.
pub fn coloured(scene: &Scene, step: usize) -> Scene {
    let mut scene = scene.clone();
    let mut numbers = 1..;
    for (material, number) in materials_of(&mut scene).into_iter().zip(&mut numbers) {
        *material = materials::numbered(number, step);
    }
    for (light, number) in scene.lights.iter_mut().zip(numbers) {
        light.colour = materials::numbered(number, step).colour;
    }
    Scene { background: materials::numbered(0, step).colour, ambient: Vec3::ONE, ..scene }
}

/// Scales a scene, within the ranges of [`Scene::validate`] for haze, patterns and extents.
pub fn scaled(scene: &Scene, factor: f32) -> Scene {
    let scale = |field: &str, number: f32| match field {
        "haze" | "haze_fall" | "waves" | "grain" => (number / factor).min(1e3),
        "radius" | "half" | "drawn_radius" if number > 0.0 => (number * factor).max(MIN_LENGTH),
        "centre" | "half_x" | "half_z" | "eye" | "look_at" | "position" | "diameter" | "glow"
        | "core" | "length" => number * factor,
        _ => number,
    };
    if factor == 1.0 { scene.clone() } else { Text::of(scene).map(scale) }
}

pub fn known(name: &str) -> Vec<View> {
    let mut all: HashMap<String, Vec<(Scene, [usize; 2])>> =
        ron::from_str(include_str!("known.ron")).expect("scenes");
    let scenes = all.remove(name).expect("a name in known.ron");
    scenes.into_iter().map(|(scene, size)| View::new(scene, size)).collect()
}
