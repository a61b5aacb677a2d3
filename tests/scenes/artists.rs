//! Scenes as artists draw them first.

use crate::kinds::add;
use crate::solids::Bars;
use crate::{Draw, Random, lights, materials, solids};
use eightfold_tracer::scene::{
    Block, Camera, Light, Material, Pattern, Plane, Scene, Shape, Sphere, Waves,
};
use glam::{Mat3, Vec2, Vec3, vec3};
use std::f32::consts::{PI, TAU};

type Add = fn(&mut Scene, &mut Random);

/// A name, and functions that add objects to a scene with a camera, a floor and a light.
#[derive(Clone, Copy)]
pub struct Kind(pub &'static str, &'static [Add]);

/// The first [`ON_FLOORS`] kinds have bars on a floor and nothing else.
pub const KINDS: [Kind; 19] = [
    Kind("rods", &[rods]),
    Kind("words", &[words]),
    Kind("nets", &[nets]),
    Kind("spokes", &[spokes]),
    Kind("ropes", &[ropes]),
    Kind("pickets", &[pickets]),
    Kind("grass", &[grass]),
    Kind("windows", &[windows]),
    Kind("stairs", &[stairs]),
    Kind("shelves", &[shelves]),
    Kind("rods in water", &[water, some_bars]),
    Kind("mirror wall", &[some_bars, mirror_wall]),
    Kind("behind glass", &[some_bars, glass]),
    Kind("mirror balls", &[some_bars, |scene, random| add_balls(scene, random, mirror)]),
    Kind("nets in balls", &[nets, |scene, random| add_balls(scene, random, mirror)]),
    Kind("shadows on balls", &[some_bars, |scene, random| add_balls(scene, random, matt)]),
    Kind("shadows on boxes", &[some_bars, boxes]),
    Kind("shadows on a patterned wall", &[some_bars, wall]),
    Kind("strips of light on shelves", &[shelves, strips]),
];

pub const ON_FLOORS: usize = 8;

pub const LIGHTS: [(&str, Draw<Light>); 4] = [
    ("point", point),
    ("sun", |random| Light { parallel: true, ..point(random) }),
    ("spotlight", |random| {
        let (light, inner) = (point(random), random.between(0.2, 0.5));
        lights::spotlight(light, inner, random.between(0.5, 0.9))
    }),
    ("area light", |random| Light { diameter: random.between(0.1, 0.6), ..point(random) }),
];

pub const FLOORS: [(&str, Draw<Material>); 3] = [
    ("plain", matt),
    ("patterned", patterned),
    ("mirror", |random| Material {
        kr: random.between(0.3, 0.6),
        ..Material::matt(bright(random), 0.5)
    }),
];

impl Kind {
    /// Returns the scene of a seed, whose lights and floors take turns.
    pub fn seeded(&self, seed: u64) -> Scene {
        let (light, floor) = (seed as usize % LIGHTS.len(), seed as usize / LIGHTS.len());
        self.scene(&mut Random::new(seed), LIGHTS[light].1, FLOORS[floor % FLOORS.len()].1)
    }

    pub fn scene(&self, random: &mut Random, light: Draw<Light>, floor: Draw<Material>) -> Scene {
        let eye = random.vector(vec3(-2.0, 0.8, 3.5), vec3(2.0, 3.0, 8.0));
        let look_at = vec3(0.0, random.between(0.5, 1.0), 0.0);
        let field_of_view = random.one_of([0.8, 0.7, 0.6, 0.2]);
        let mut scene = Scene {
            camera: Camera::new(eye, look_at, field_of_view),
            background: vec3(0.35, 0.45, 0.6),
            ambient: Vec3::splat(random.zero_or(0.05, 0.2)),
            ..Scene::default()
        };
        scene.planes.push(Plane::new(Vec3::ZERO, 30.0, 30.0, floor(random)));
        scene.lights.push(light(random));
        self.1.iter().for_each(|add| add(&mut scene, random));
        scene
    }
}

pub fn artists(random: &mut Random) -> Scene {
    let kind = random.one_of(KINDS);
    let ((_, light), (_, floor)) = (random.one_of(LIGHTS), random.one_of(FLOORS));
    kind.scene(random, light, floor)
}

fn point(random: &mut Random) -> Light {
    let position = random.vector(vec3(-3.0, 3.0, 1.0), vec3(3.0, 5.0, 4.5));
    Light::new(position, vec3(0.9, 0.86, 0.78) * random.between(0.7, 1.1))
}

fn bright(random: &mut Random) -> Vec3 {
    random.vector(Vec3::splat(0.3), Vec3::splat(0.9))
}

pub(crate) fn matt(random: &mut Random) -> Material {
    Material::matt(bright(random), 0.8)
}

fn patterned(random: &mut Random) -> Material {
    let checkers = Pattern::checkers(random.between(0.2, 1.0), random.between(0.3, 0.9));
    let pattern = [checkers, materials::pattern(random)][random.below(2)];
    matt(random).with_pattern(pattern)
}

fn add_box(scene: &mut Scene, centre: Vec3, half: Vec3, material: Material) {
    add(&mut scene.blocks, Block::new(Shape::Box, centre, half, material));
}

/// A vertical plane at a random place and angle, `x` to the right and `y` up.
fn upright(random: &mut Random) -> impl Fn(f32, f32) -> Vec3 + use<> {
    let at = random.vector(vec3(-0.7, 0.0, -1.5), vec3(0.7, 0.0, 1.0));
    let across = Mat3::from_rotation_y(random.between(-0.7, 0.7)) * Vec3::X;
    move |x, y| at + across * x + Vec3::Y * y
}

/// Adds bars from the floor, up to `deep` in front, that lean by up to `lean` and have heights from
/// `low` to `high`.
fn upright_bars(
    scene: &mut Scene,
    random: &mut Random,
    bars: &Bars,
    count: usize,
    [deep, lean, low, high]: [f32; 4],
) {
    for _ in 0..count {
        let foot = random.vector(vec3(-2.5, 0.0, -1.5), vec3(2.5, 0.0, deep));
        let up = random.vector(vec3(-lean, low, -lean), vec3(lean, high, lean));
        bars.add(scene, foot, foot + up);
    }
}

fn rods(scene: &mut Scene, random: &mut Random) {
    let (bars, count) = (Bars::any(random), random.one_of([1, 2, 5, 12]));
    upright_bars(scene, random, &bars, count, [1.5, 0.4, 1.8, 2.4]);
}

/// Letters of strokes between nine points.
fn words(scene: &mut Scene, random: &mut Random) {
    let (bars, at) = (Bars::any(random), upright(random));
    let (letters, low) = (3 + random.below(4), random.between(0.1, 1.0));
    for letter in 0..letters {
        let left = 0.7 * (letter as f32 - 0.5 * letters as f32);
        let mut share = || random.below(3) as f32;
        let nodes = (0..5).map(|_| at(left + 0.25 * share(), low + 0.5 * share()));
        bars.stroke(scene, nodes);
    }
}

fn nets(scene: &mut Scene, random: &mut Random) {
    let (bars, at) = (Bars::any(random), upright(random));
    let (wide, high) = (random.between(0.8, 2.0), random.between(0.8, 1.8));
    let (step, slope) = (random.between(0.12, 0.35), random.one_of([0.0, 0.5, 1.0]));
    for sign in [-1.0, 1.0] {
        let mut start = -wide - high;
        while start < wide + high {
            let ends = [start, start + sign * slope * high].map(|x| x.clamp(-wide, wide));
            if slope > 0.0 && ends[0] != ends[1] {
                let [from, to] = ends.map(|x| at(x, sign * (x - start) / slope));
                bars.add(scene, from, to);
            } else if start.abs() < wide && sign > 0.0 {
                bars.add(scene, at(start, 0.0), at(start, high));
            } else if (0.0..high).contains(&start) {
                bars.add(scene, at(-wide, start), at(wide, start));
            }
            start += step;
        }
    }
}

fn spokes(scene: &mut Scene, random: &mut Random) {
    for _ in 0..1 + random.below(3) {
        let (bars, at) = (Bars::any(random), upright(random));
        let count = 6 + random.below(18);
        let (x, radius) = (random.between(-1.5, 1.5), random.between(0.4, 1.1));
        let rim = |i: usize| {
            let end = Vec2::from_angle(TAU * i as f32 / count as f32) * radius;
            at(x + end.x, radius + end.y)
        };
        for i in 0..count {
            bars.stroke(scene, [at(x, radius), rim(i), rim(i + 1)]);
        }
    }
}

/// Sagging ropes of short bars, between posts.
fn ropes(scene: &mut Scene, random: &mut Random) {
    for _ in 0..1 + random.below(4) {
        let (bars, at) = (Bars::any(random), upright(random));
        let (high, sag) = (random.between(0.6, 2.0), random.between(0.1, 0.5));
        let (wide, count) = (random.between(0.5, 2.5), 6 + random.below(18));
        let shares = (0..=count).map(|i| 2.0 * i as f32 / count as f32 - 1.0);
        bars.stroke(scene, shares.map(|x| at(wide * x, high - sag * (1.0 - x * x))));
        bars.grid(scene, &at, &[-wide, wide], &[], [wide, high]);
    }
}

fn pickets(scene: &mut Scene, random: &mut Random) {
    let (bars, at) = (Bars::any(random), upright(random));
    let (high, step) = (random.between(0.5, 1.6), random.between(0.08, 0.3));
    let wide = (20.0 * step).min(2.5);
    let columns = (0..(2.0 * wide / step) as usize).map(|i| step * i as f32 - wide);
    let columns: Vec<f32> = columns.collect();
    bars.grid(scene, at, &columns, &[0.3 * high, 0.8 * high], [wide, high]);
}

fn grass(scene: &mut Scene, random: &mut Random) {
    let mut bars = Bars::any(random);
    bars.radius = random.one_of([0.004, 0.008, 0.015]);
    let count = random.one_of([20, 60, 120]);
    upright_bars(scene, random, &bars, count, [2.0, 0.3, 0.3, 1.0]);
}

fn windows(scene: &mut Scene, random: &mut Random) {
    let (bars, at) = (Bars::any(random), upright(random));
    let [columns, rows] = [0; 2].map(|_| 2 + random.below(6));
    let (wide, high) = (random.between(0.2, 0.6), random.between(0.2, 0.5));
    let [right, top] = [wide * columns as f32, high * rows as f32];
    let columns: Vec<f32> = (0..=columns).map(|i| wide * i as f32 - 0.5 * right).collect();
    let rows: Vec<f32> = (0..=rows).map(|i| high * i as f32).collect();
    bars.grid(scene, at, &columns, &rows, [0.5 * right, top]);
}

fn stairs(scene: &mut Scene, random: &mut Random) {
    let (bars, material) = (Bars::any(random), matt(random));
    let (deep, high) = (random.between(0.15, 0.35), random.between(0.1, 0.25));
    let wide = random.between(0.4, 1.5);
    let thick = random.one_of([0.02, 0.5 * high]);
    for i in 0..4 + random.below(6) {
        let at = vec3(0.0, high * i as f32 + high, 0.8 - deep * i as f32);
        let half = vec3(wide, thick, 0.5 * deep);
        add_box(scene, at - Vec3::Y * thick, half, material);
        let rail = Vec3::Y * 0.7;
        let next = at + vec3(0.0, high, -deep) + rail;
        for foot in [-wide, wide].map(|x| Vec3::X * x) {
            bars.stroke(scene, [foot + at, foot + at + rail, foot + next]);
        }
    }
}

/// Shelves with narrow gaps between things.
fn shelves(scene: &mut Scene, random: &mut Random) {
    let material = matt(random);
    let (wide, high) = (random.between(0.6, 1.6), random.between(0.4, 0.7));
    let (deep, back) = (random.between(0.15, 0.4), random.between(-1.2, 0.0));
    for i in 0..2 + random.below(3) {
        let board = vec3(0.0, high * i as f32 + 0.3, back);
        add_box(scene, board, vec3(wide, 0.015, deep), material);
        let mut left = random.between(0.02, 0.2) - wide;
        while left < wide - 0.2 {
            let half = random.vector(vec3(0.01, 0.1, 0.05), vec3(0.08, 0.45 * high, deep));
            let shape = random.one_of(solids::SHAPES);
            let half = solids::fitting(shape, half.with_z(half.z.min(deep)));
            let centre = board + vec3(wide.min(left + half.x), 0.015 + half.y, 0.0);
            add(&mut scene.blocks, Block::new(shape, centre, half, matt(random)));
            left += 2.0 * half.x + random.between(0.002, 0.2);
        }
    }
    for x in [-wide, wide] {
        let half = vec3(0.015, high, deep);
        add_box(scene, vec3(x, high, back), half, material);
    }
}

fn some_bars(scene: &mut Scene, random: &mut Random) {
    let kinds: [Add; 6] = [rods, rods, nets, words, pickets, windows];
    random.one_of(kinds)(scene, random);
}

fn water(scene: &mut Scene, random: &mut Random) {
    let colour = bright(random);
    scene.planes[0].material =
        Material { kr: random.between(0.4, 0.8), ..Material::matt(colour, 0.2) };
    scene.water = Waves {
        slope: random.between(0.003, 0.04),
        length: random.between(0.3, 2.0),
        phase: random.between(-9.0, 9.0),
    };
}

fn mirror(random: &mut Random) -> Material {
    Material::mirror(random.between(0.5, 0.9))
}

fn mirror_wall(scene: &mut Scene, random: &mut Random) {
    let half = vec3(3.0, 1.5, 0.05);
    add_box(scene, vec3(0.0, 1.5, -2.0), half, mirror(random));
}

fn glass(scene: &mut Scene, random: &mut Random) {
    let glass = Material::glass(random.one_of([1.0, 1.1, 1.3, 1.5]));
    let centre = random.vector(vec3(-0.5, 0.8, 1.0), vec3(0.5, 1.2, 2.0));
    if random.below(3) == 0 {
        let radius = random.between(0.3, 0.6);
        scene.spheres.push(Sphere::new(centre, radius, glass));
    } else {
        let half = random.vector(vec3(0.3, 0.4, 0.05), vec3(1.5, 0.8, 0.3));
        let block = solids::block(random, centre, half, glass);
        let axes = [block.axes, Mat3::from_rotation_y(random.between(-0.6, 0.6))];
        add(&mut scene.blocks, Block { axes: random.one_of(axes), ..block });
    }
}

fn add_balls(scene: &mut Scene, random: &mut Random, material: Draw<Material>) {
    let material = material(random);
    for _ in 0..1 + random.below(4) {
        let radius = random.between(0.25, 0.8);
        let at = random.vector(vec3(-2.0, 0.0, -2.5), vec3(2.0, 0.3, -0.2));
        scene.spheres.push(Sphere::new(at + Vec3::Y * radius, radius, material));
    }
}

fn boxes(scene: &mut Scene, random: &mut Random) {
    let matt = matt(random);
    for _ in 0..1 + random.below(4) {
        let half = random.vector(Vec3::splat(0.2), Vec3::splat(0.8));
        let at = random.vector(vec3(-2.0, 0.0, -2.5), vec3(2.0, 0.0, -0.5));
        let axes = Mat3::from_rotation_y(random.between(0.0, PI));
        let solid = Block::new(Shape::Box, at + Vec3::Y * half.y, half, matt);
        add(&mut scene.blocks, Block { axes, ..solid });
    }
}

fn wall(scene: &mut Scene, random: &mut Random) {
    let half = vec3(3.0, 2.2, 0.1);
    add_box(scene, vec3(0.0, 2.2, -2.5), half, patterned(random));
}

fn strips(scene: &mut Scene, random: &mut Random) {
    let bars = Bars::any(random);
    let step = 2.0 * bars.radius + random.power(-2.0, -0.7);
    for i in -6..=6 {
        let x = step * i as f32;
        bars.add(scene, vec3(x, 0.0, 1.0), vec3(x, 2.5, 1.0));
    }
}
