//! Any scene, at any time, of any size, by any quality, on any instruction set: a seeded sample of them all.
//!
//! `tests/run --soak` draws cases for `SOAK_SECONDS` (600, ten minutes) and says how many there were; otherwise a fixed
//! number is drawn. The cases are the same in each run, one after the other; `SOAK_SEED` asks for others, and `SOAK_FIRST`
//! for another one to begin with.

use crate::cpu;
use crate::error::Difference;
use crate::studio::Studio;
use eightfold::scene::{
    Block, Camera, Light, Material, Pattern, Plane, Scene, Shape, Sphere, Spot,
};
use eightfold::{Counts, Quality, show};
use glam::{Mat3A, Quat, Vec3A, vec3a};
use std::env;
use std::time::{Duration, Instant};

/// Cases of a run that is no soak.
const CASES: u64 = 150;
/// Cases of seed 2008 that soaks have found something by: boxes, spheres and lamps of numbers that make no sense, in packets
/// whose other rays come near to them.
const FOUND: [u64; 6] = [139, 2402, 3245, 8120, 14_319, 23_323];
/// How often a soak says how far it is.
const PROGRESS: Duration = Duration::from_secs(5);
/// What the default quality may be off from every pixel on average, of 255: small spheres that no corner sees, at 3,000
/// pixels and more.
const FARTHEST: f64 = 8.0;
/// The widest and the tallest picture.
const SIDES: (usize, usize) = (160, 120);

/// Numbers that look random (Steele, Lea and Flood's SplitMix).
struct Random(u64);

impl Random {
    fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut h = self.0;
        h = (h ^ (h >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        h = (h ^ (h >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        h ^ (h >> 31)
    }

    fn below(&mut self, end: usize) -> usize {
        (self.bits() % end as u64) as usize
    }

    fn between(&mut self, low: f32, high: f32) -> f32 {
        low + (high - low) * ((self.bits() >> 40) as f32 / (1 << 24) as f32)
    }

    fn vector(&mut self, low: Vec3A, high: Vec3A) -> Vec3A {
        let mut number = || self.between(0.0, 1.0);
        low + (high - low) * vec3a(number(), number(), number())
    }
}

fn material(random: &mut Random) -> Material {
    let kt = [0.0, 0.0, random.between(0.1, 1.0)][random.below(3)];
    Material {
        colour: random.vector(Vec3A::ZERO, Vec3A::ONE),
        kd: random.between(0.0, 1.0),
        ks: random.between(0.0, 1.0),
        exponent: 10_f32.powf(random.between(0.0, 3.0)),
        kr: (1.0 - kt) * random.between(0.0, 1.0),
        kt,
        index: [random.between(0.5, 0.99), random.between(1.01, 3.0)][random.below(2)],
        ..Material::BLACK
    }
}

/// A valid scene, from nothing at all to as much as there is room for.
fn valid(random: &mut Random) -> Scene {
    let scale = 10_f32.powf(random.between(-3.0, 3.0));
    let mut scene = Scene {
        background: random.vector(Vec3A::ZERO, Vec3A::ONE),
        ambient: random.vector(Vec3A::ZERO, Vec3A::splat(0.3)),
        ..Scene::default()
    };
    let most = [4, 12, 40, 320][random.below(4)];
    let smallest = [-0.5, -3.0][random.below(2)];
    for _ in 0..random.below(most + 1) {
        scene.spheres.push(Sphere {
            centre: scale * random.vector(vec3a(-5.0, -1.0, -5.0), vec3a(5.0, 4.0, 5.0)),
            radius: scale * 10_f32.powf(random.between(smallest, 0.2)),
            material: material(random),
        });
    }
    for _ in 0..random.below(4) {
        scene.planes.push(Plane {
            centre: scale * vec3a(0.0, random.between(-3.0, 1.0), 0.0),
            half_x: scale * random.between(0.5, 20.0),
            half_z: scale * random.between(0.5, 20.0),
            material: material(random),
        });
    }
    for _ in 0..random.below(5) {
        scene.lights.push(Light {
            position: scale * random.vector(vec3a(-8.0, -1.0, -8.0), vec3a(8.0, 9.0, 8.0)),
            colour: random.vector(Vec3A::ZERO, Vec3A::splat(1.5)),
            radius: scale * random.between(0.01, 0.5),
            ..Light::DARK
        });
    }
    scene.camera = Camera {
        eye: scale * random.vector(vec3a(-9.0, -1.0, -9.0), vec3a(9.0, 7.0, 9.0)),
        look_at: scale * random.vector(Vec3A::splat(-1.0), Vec3A::ONE),
        up: Vec3A::Y,
        field_of_view: random.between(0.1, 2.5),
    };
    if random.below(3) == 0 {
        enrich(&mut scene, random, scale);
    }
    scene
}

/// Gives a scene of that scale what only some scenes have: boxes and cylinders, patterns, air, lamps of all kinds.
fn enrich(scene: &mut Scene, random: &mut Random, scale: f32) {
    for _ in 0..random.below(9) {
        let half = scale * random.vector(Vec3A::splat(0.05), Vec3A::splat(1.5));
        let shape = if random.below(2) == 0 {
            Shape::Cylinder
        } else {
            Shape::Box
        };
        let turn = random.vector(Vec3A::splat(-3.0), Vec3A::splat(3.0));
        scene.blocks.push(Block {
            centre: scale * random.vector(vec3a(-5.0, -1.0, -5.0), vec3a(5.0, 4.0, 5.0)),
            half: if shape == Shape::Cylinder {
                half.with_z(half.x)
            } else {
                half
            },
            axes: Mat3A::from_quat(Quat::from_scaled_axis(turn.into())),
            shape,
            material: material(random),
        });
    }
    let mut materials: Vec<&mut Material> = Vec::new();
    materials.extend(scene.spheres.iter_mut().map(|s| &mut s.material));
    materials.extend(scene.planes.iter_mut().map(|p| &mut p.material));
    materials.extend(scene.blocks.iter_mut().map(|b| &mut b.material));
    for material in materials.into_iter().step_by(3) {
        material.tint = random.vector(Vec3A::ZERO, Vec3A::ONE);
        material.pattern = Pattern {
            waves: (random.vector(Vec3A::ZERO, Vec3A::splat(3.0)) / scale).min(Vec3A::splat(1e3)),
            depth: random.between(0.1, 1.0),
            edge: random.between(0.5, 40.0),
            warp: random.between(0.0, 2.0),
            grain: (random.between(0.1, 3.0) / scale).min(1e3),
        };
    }
    scene.sky = random.vector(Vec3A::ZERO, Vec3A::splat(0.5));
    scene.haze = random.between(0.0, 0.2) / scale;
    scene.fade = random.between(-0.5, 1.0);
    for light in scene.lights.iter_mut() {
        light.size = scale * [0.0, random.between(0.0, 2.0)][random.below(2)];
        light.parallel = random.below(3) == 0;
        light.spot = (random.below(2) == 0).then(|| Spot {
            aim: -light.position.normalize_or(Vec3A::Y),
            dark: 0.6,
            bright: random.between(0.61, 0.99),
        });
    }
}

/// Puts a number that makes no sense somewhere.
fn spoil(scene: &mut Scene, random: &mut Random) {
    let numbers = [
        f32::NAN,
        f32::INFINITY,
        f32::NEG_INFINITY,
        f32::MAX,
        -1.0,
        0.0,
        1e-40,
        1e20,
    ];
    let number = numbers[random.below(numbers.len())];
    let Scene {
        camera,
        spheres,
        planes,
        blocks,
        lights,
        sky,
        haze,
        fade,
        ..
    } = scene;
    let (a, b, c) = (
        random.bits() as usize,
        random.bits() as usize,
        random.bits() as usize,
    );
    let mut places: Vec<&mut f32> = vec![
        &mut camera.eye[a % 3],
        &mut camera.look_at[b % 3],
        &mut camera.up[c % 3],
        &mut camera.field_of_view,
        &mut sky[a % 3],
        haze,
        fade,
    ];
    for block in blocks.iter_mut() {
        let m = &mut block.material;
        places.extend([&mut block.centre[a % 3], &mut block.half[b % 3]]);
        places.extend([&mut block.axes.x_axis[c % 3], &mut m.tint[a % 3]]);
        places.extend([&mut m.pattern.waves[b % 3], &mut m.pattern.edge]);
        places.extend([&mut m.pattern.warp, &mut m.pattern.grain]);
    }
    for sphere in spheres.iter_mut() {
        let m = &mut sphere.material;
        places.extend([&mut sphere.centre[a % 3], &mut sphere.radius]);
        places.extend([&mut m.colour[b % 3], &mut m.kd, &mut m.ks, &mut m.exponent]);
        places.extend([&mut m.kr, &mut m.kt, &mut m.index]);
    }
    for plane in planes.iter_mut() {
        places.extend([&mut plane.centre[a % 3], &mut plane.half_x]);
        places.extend([&mut plane.half_z, &mut plane.material.kr]);
    }
    for light in lights.iter_mut() {
        places.extend([&mut light.position[a % 3], &mut light.colour[b % 3]]);
        places.extend([&mut light.radius, &mut light.size]);
        if let Some(spot) = &mut light.spot {
            places.extend([&mut spot.aim[c % 3], &mut spot.dark, &mut spot.bright]);
        }
    }
    let place = random.below(places.len());
    *places[place] = number;
}

fn quality(random: &mut Random) -> Quality {
    let named = [Quality::THESIS, Quality::DEFAULT];
    let any = Quality {
        square: 1 + random.below(Quality::MAX_SQUARE),
        tolerance_agreeing: [0.0, 9.0, f32::INFINITY][random.below(3)],
        tolerance_differing: [0.0, 4.0, f32::NAN][random.below(3)],
        tolerance_side: [0.0, 9.0][random.below(2)],
        key_depth: random.below(9) as u32,
        state_depth: random.below(9) as u32,
        depth: random.below(Quality::MAX_DEPTH as usize + 1) as u32,
        least_contribution: [0.0, 0.01, 0.2, f32::NAN][random.below(4)],
        ..Quality::DEFAULT
    };
    [named[0], named[1], any][random.below(3)]
}

/// What a run draws in.
struct Room {
    one: Studio,
    two: Studio,
    exhaustive: Studio,
}

/// Draws case number `case` and asserts what holds for any; the error of the default quality, where the case is one to
/// measure it by.
fn hold(room: &mut Room, seed: u64, case: u64) -> Option<Difference> {
    let what = format!("case {case} of seed {seed}");
    let mut random = Random(seed ^ case.wrapping_mul(0xd134_2543_de82_ef95));
    let time = random.between(-100.0, 100.0) * 10_f32.powi(random.below(5) as i32);
    let mut scene = match random.below(8) {
        0 => show::scene(time),
        1 => show::field(random.below(321), time),
        _ => valid(&mut random),
    };
    let is_valid = scene.validate().is_ok();
    assert!(is_valid, "{what}: {:?}", scene.validate());
    let is_spoilt = random.below(4) == 0;
    if is_spoilt {
        spoil(&mut scene, &mut random);
    }
    let quality = quality(&mut random);
    let (width, height) = match random.below(8) {
        0 => (1, 1 + random.below(300)),
        1 => (1 + random.below(300), 1),
        _ => (1 + random.below(SIDES.0), 1 + random.below(SIDES.1)),
    };
    let sets: Vec<_> = cpu::instruction_sets().collect();
    let level = sets[random.below(sets.len())].level;

    let mut pixels = vec![u32::MAX; width * height];
    let mut others = pixels.clone();
    let counts = room.one.draw(level, &scene, &quality, width, &mut pixels);
    let again = room.two.draw(level, &scene, &quality, width, &mut others);
    let is_drawn = pixels.iter().all(|pixel| pixel >> 24 == 0);
    assert!(is_drawn, "{what}: a pixel was left out");
    assert!(pixels == others, "{what}: another picture by two threads");
    let bare = |counts: Counts| Counts { lanes: 0, ..counts };
    assert_eq!(bare(counts), bare(again), "{what}");

    let corners = |side: usize| (side.next_multiple_of(quality.square) + 1) as u64;
    assert!(
        counts.points <= corners(width) * corners(height),
        "{what}: {counts:?}"
    );
    let tree = (2 << quality.depth) - 1;
    assert!(counts.rays <= counts.points * tree, "{what}: {counts:?}");
    let lights = scene.lights.len() as u64;
    assert!(
        counts.shadow_rays <= counts.rays * lights,
        "{what}: {counts:?}"
    );

    // Corners of the first squares are traced whatever the quality.
    let every = Quality {
        square: 1,
        ..quality
    };
    room.exhaustive
        .draw(level, &scene, &every, width, &mut others);
    for y in (0..height).step_by(quality.square) {
        for x in (0..width).step_by(quality.square) {
            let i = y * width + x;
            assert_eq!(pixels[i], others[i], "{what}: ({x}, {y})");
        }
    }
    // Patterns finer than squares are another matter.
    let is_plain = !is_spoilt && scene.haze == 0.0;
    let is_measured = quality == Quality::DEFAULT && is_plain && pixels.len() > 5000;
    is_measured.then(|| Difference::between(&others, &pixels))
}

#[test]
fn any_case_is_drawn_by_the_same_bits_for_bounded_work() {
    let number = |name| {
        env::var(name)
            .ok()
            .and_then(|text| text.parse::<u64>().ok())
    };
    let seed = number("SOAK_SEED").unwrap_or(2008);
    let limit = number("SOAK_SECONDS").map(Duration::from_secs);
    let start = Instant::now();
    let mut room = Room {
        one: Studio::new(1),
        two: Studio::new(2),
        exhaustive: Studio::new(1),
    };
    if limit.is_none() {
        for case in FOUND {
            hold(&mut room, 2008, case);
        }
    }
    let first = number("SOAK_FIRST").unwrap_or(0);
    let (mut cases, mut measured, mut worst) = (0, 0, 0.0_f64);
    let mut told = Duration::ZERO;
    while limit.map_or(cases < CASES, |limit| start.elapsed() < limit) {
        let since = start.elapsed();
        if let Some(limit) = limit
            && since - told >= PROGRESS
        {
            told = since;
            eprintln!(
                "{} s of {}: {cases} cases held",
                since.as_secs(),
                limit.as_secs()
            );
        }
        if let Some(difference) = hold(&mut room, seed, first + cases) {
            measured += 1;
            worst = worst.max(difference.mean);
        }
        cases += 1;
    }
    assert!(
        worst <= FARTHEST,
        "the default quality is off by {worst} of 255"
    );
    println!(
        "{cases} cases held; the default quality, measured in {measured}, was off by {worst:.2} of 255 at worst"
    );
}
