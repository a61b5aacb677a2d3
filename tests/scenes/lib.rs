//! The crate of random scenes, by seed, for tests.
//!
//! | kind | scenes |
//! | --- | --- |
//! | [`Kinds`] | all shapes, materials and lights, scattered around the origin |
//! | [`placed`] | objects in their own colours, placed and sized by pixels |
//! | [`floor`] | a single shadow or image in a floor, or objects that rise from it |
//! | [`hidden()`] | forty small objects that are easily missed |
//! | [`artists`] | bars in the order of words, nets, fences and shelves |
//! | [`crowd()`] | hundreds of mirrors, glass and plastic of all shapes |
//! | [`BarView`] | bars of one to five pixels, as objects, shadows and images |
//! | [`known()`] | scenes that once failed |
//!
//! A new kind is a function from a [`Random`] to a scene, of parts from [`materials`], [`lights`] and [`solids`].

pub mod artists;
mod bars;
mod crowd;
pub mod floor;
mod hidden;
mod kinds;
mod known;
pub mod lights;
pub mod materials;
mod placed;
mod random;
pub mod solids;
pub mod text;
mod thin;

pub use crowd::crowd;
pub use hidden::{GREY, hidden};
pub use kinds::{Kinds, presented};
pub use known::known;
pub use placed::{between_corners, placed, placed_blocks};
pub use random::{Random, cases};
pub use thin::BarView;

use eightfold_tracer::scene::{MIN_LENGTH, Material, Scene};
use glam::Vec3;

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

    /// Returns the direction through a point of the picture, at a depth of 1, and the length of a pixel there.
    fn ray(&self, x: f32, y: f32) -> (Vec3, f32) {
        let raster = self.scene.camera.raster(self.width, self.height);
        (raster.corner + raster.dx * x + raster.dy * y, raster.dx.length())
    }
}

pub fn any(random: &mut Random) -> Scene {
    let shiny_blocks = Kinds { material: materials::shiny, ..Kinds::RICH };
    match random.below(7) {
        0 => hidden(random, [true; 2], GREY),
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
    let mut scene = scene.clone();
    scene.haze = (scene.haze / factor).min(1e3);
    scene.haze_fall = (scene.haze_fall / factor).min(1e3);
    scene.camera.eye *= factor;
    scene.camera.look_at *= factor;
    scene.water.length *= factor;
    for sphere in scene.spheres.iter_mut() {
        sphere.centre *= factor;
        sphere.radius = (sphere.radius * factor).max(MIN_LENGTH);
    }
    for plane in scene.planes.iter_mut() {
        plane.centre *= factor;
        plane.half_x *= factor;
        plane.half_z *= factor;
    }
    for block in scene.blocks.iter_mut() {
        block.centre *= factor;
        block.half = (block.half * factor).max(Vec3::splat(MIN_LENGTH));
    }
    for light in scene.lights.iter_mut() {
        light.position *= factor;
        if light.drawn_radius > 0.0 {
            light.drawn_radius = (light.drawn_radius * factor).max(MIN_LENGTH);
        }
        light.diameter *= factor;
        light.glow *= factor;
        light.core *= factor;
    }
    for material in materials_of(&mut scene) {
        let pattern = &mut material.pattern;
        pattern.waves = (pattern.waves / factor).min(Vec3::splat(1e3));
        pattern.grain = (pattern.grain / factor).min(1e3);
    }
    scene
}
