//! Random scenes and qualities made from a seed, without a framework, for long runs.

use super::{fitting, materials};
use crate::text::Text;
use eightfold_lab::random::split_mix;
use eightfold_tracer::Quality;
use eightfold_tracer::scene::{
    Block, Camera, Film, Light, List, Material, Pattern, Plane, Scene, Shape, Sphere, Spot, Waves,
};
use glam::{Mat3, Quat, Vec3, vec3};

/// A generator of pseudorandom numbers with its state.
pub struct Random(pub u64);

impl Random {
    /// 64 random bits.
    pub fn bits(&mut self) -> u64 {
        split_mix(&mut self.0)
    }

    /// A whole number below `end`.
    pub fn below(&mut self, end: usize) -> usize {
        (self.bits() % end as u64) as usize
    }

    /// A number from `low` to `high`.
    pub fn between(&mut self, low: f32, high: f32) -> f32 {
        low + (high - low) * ((self.bits() >> 40) as f32 / (1 << 24) as f32)
    }

    /// A vector in a box.
    pub fn vector(&mut self, low: Vec3, high: Vec3) -> Vec3 {
        let mut number = || self.between(0.0, 1.0);
        low + (high - low) * vec3(number(), number(), number())
    }
}

/// A floor with nothing on it, and a camera some way above it.
pub fn floor(random: &mut Random, look_at: Vec3, material: Material) -> Scene {
    Scene {
        camera: Camera {
            eye: vec3(random.between(-6.0, 6.0), random.between(2.0, 8.0), 11.0),
            look_at,
            up: Vec3::Y,
            field_of_view: random.between(0.6, 1.0),
        },
        planes: List::of(&[Plane::new(Vec3::ZERO, 20.0, 20.0, material)]),
        ..Scene::default()
    }
}

/// Plastic, mirror or glass; `kr + kt` is at most 1.
fn material(random: &mut Random) -> Material {
    let kt = [0.0, 0.0, random.between(0.1, 1.0)][random.below(3)];
    Material {
        colour: random.vector(Vec3::ZERO, Vec3::ONE),
        kd: random.between(0.0, 1.0),
        ks: random.between(0.0, 1.0),
        exponent: 10_f32.powf(random.between(0.0, 3.0)),
        kr: (1.0 - kt) * random.between(0.0, 1.0),
        kt,
        index: [random.between(0.5, 0.99), random.between(1.01, 3.0)][random.below(2)],
        ..Material::BLACK
    }
}

/// A valid scene, from an empty one to one with as many objects as a scene can hold.
pub fn scene(random: &mut Random) -> Scene {
    let scale = 10_f32.powf(random.between(-3.0, 3.0));
    let mut scene = Scene {
        background: random.vector(Vec3::ZERO, Vec3::ONE),
        ambient: random.vector(Vec3::ZERO, Vec3::splat(0.3)),
        ..Scene::default()
    };
    let most = [4, 12, 40, 320][random.below(4)];
    let smallest = [-0.5, -3.0][random.below(2)];
    for _ in 0..random.below(most + 1) {
        scene.spheres.push(Sphere::new(
            scale * random.vector(vec3(-5.0, -1.0, -5.0), vec3(5.0, 4.0, 5.0)),
            scale * 10_f32.powf(random.between(smallest, 0.2)),
            material(random),
        ));
    }
    for _ in 0..random.below(4) {
        scene.planes.push(Plane::new(
            scale * vec3(0.0, random.between(-3.0, 1.0), 0.0),
            scale * random.between(0.5, 20.0),
            scale * random.between(0.5, 20.0),
            material(random),
        ));
    }
    for _ in 0..random.below(5) {
        scene.lights.push(Light {
            position: scale * random.vector(vec3(-8.0, -1.0, -8.0), vec3(8.0, 9.0, 8.0)),
            colour: random.vector(Vec3::ZERO, Vec3::splat(1.5)),
            drawn_radius: scale * random.between(0.01, 0.5),
            ..Light::DARK
        });
    }
    scene.camera = Camera::new(
        scale * random.vector(vec3(-9.0, -1.0, -9.0), vec3(9.0, 7.0, 9.0)),
        scale * random.vector(Vec3::splat(-1.0), Vec3::ONE),
        random.between(0.1, 2.5),
    );
    if random.below(3) == 0 {
        enrich(&mut scene, random, scale);
    }
    scene
}

/// Adds blocks, patterns, haze and lights of all kinds to a scene of a given scale.
fn enrich(scene: &mut Scene, random: &mut Random, scale: f32) {
    for _ in 0..random.below(9) {
        let half = scale * random.vector(Vec3::splat(0.05), Vec3::splat(1.5));
        let shape = [Shape::Cylinder, Shape::Box, Shape::Capsule][random.below(3)];
        let turn = random.vector(Vec3::splat(-3.0), Vec3::splat(3.0));
        scene.blocks.push(Block {
            centre: scale * random.vector(vec3(-5.0, -1.0, -5.0), vec3(5.0, 4.0, 5.0)),
            half: fitting(shape, half),
            axes: Mat3::from_quat(Quat::from_scaled_axis(turn)),
            shape,
            material: material(random),
        });
    }
    for material in materials(scene).into_iter().step_by(3) {
        material.tint = random.vector(Vec3::ZERO, Vec3::ONE);
        material.pattern = Pattern {
            waves: (random.vector(Vec3::ZERO, Vec3::splat(3.0)) / scale).min(Vec3::splat(1e3)),
            depth: random.between(0.1, 1.0),
            edge: random.between(0.5, 40.0),
            balance: random.between(-1.0, 1.0),
            warp: random.between(0.0, 2.0),
            grain: (random.between(0.1, 3.0) / scale).min(1e3),
        };
    }
    scene.sky = random.vector(Vec3::ZERO, Vec3::splat(0.5));
    scene.haze = random.between(0.0, 0.2) / scale;
    scene.exposure = random.between(0.0, 1.5);
    scene.film = Film {
        shoulder: random.between(0.0, 1.0),
        vignette: random.between(0.0, 1.0),
        dither: random.between(0.0, 1.0),
        tolerance: random.between(0.0, 1.0),
    };
    scene.water = Waves {
        slope: [0.0, random.between(0.0, 0.1)][random.below(2)],
        length: scale * random.between(0.1, 5.0),
        phase: random.between(-9.0, 9.0),
    };
    for light in scene.lights.iter_mut() {
        light.diameter = scale * [0.0, random.between(0.0, 2.0)][random.below(2)];
        light.glow = scale * [0.0, random.between(0.0, 2.0)][random.below(2)];
        light.parallel = random.below(3) == 0;
        light.spot = (random.below(2) == 0).then(|| Spot {
            aim: -light.position.normalize_or(Vec3::Y),
            outer_angle: 0.9273,
            inner_angle: random.between(0.15, 0.9),
        });
    }
}

/// Replaces a random number of a scene by an invalid one. Returns its name.
pub fn corrupt(scene: &mut Scene, random: &mut Random) -> String {
    let invalid = [
        f32::NAN,
        f32::INFINITY,
        f32::NEG_INFINITY,
        f32::MAX,
        -1.0,
        0.0,
        1e-40,
        1e20,
    ];
    let text = Text::of(scene);
    let i = random.below(text.numbers.len());
    let (corrupted, name) = text.scene_with(i, invalid[random.below(invalid.len())]);
    *scene = corrupted;
    name.to_owned()
}

/// A named quality, or any valid one.
pub fn quality(random: &mut Random) -> Quality {
    let named = [Quality::THESIS, Quality::DEFAULT];
    let any = Quality {
        square: 1 << random.below(6),
        tolerance_agreeing: [0.0, 9.0, f32::INFINITY][random.below(3)],
        tolerance_differing: [0.0, 4.0, f32::NAN][random.below(3)],
        tolerance_side: [0.0, 9.0][random.below(2)],
        key_depth: random.below(9) as u32,
        key_weight: [0.0, 0.3, f32::NAN][random.below(3)],
        state_depth: random.below(9) as u32,
        depth: random.below(Quality::MAX_DEPTH as usize + 1) as u32,
        least_contribution: [0.0, 0.01, 0.2, f32::NAN][random.below(4)],
        antialias: random.below(2) == 0,
        ..Quality::DEFAULT
    };
    [named[0], named[1], any][random.below(3)]
}
