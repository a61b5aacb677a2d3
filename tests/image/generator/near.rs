//! Scenes of things that touch, or rise by little out of what they stand in: thin ones, grazing views, huge things beside tiny ones,
//! scenes far from the origin. Some are known to have been missed, others random.

use super::config;
use super::placed::material;
use super::seeded::Random;
use eightfold_tracer::scene::{
    Block, Camera, List, MIN_LENGTH, Material, Plane, Scene, Shape, Sphere,
};
use glam::{EulerRot, Mat3, Quat, Vec3, vec3};

/// A scene, and the size of its picture.
#[derive(Clone)]
pub struct Near {
    pub scene: Scene,
    pub width: usize,
    pub height: usize,
}

/// Random numbers for so many scenes, or for as many as `PROPTEST_CASES` says.
pub fn seeds(count: u32) -> impl Iterator<Item = Random> {
    (0..u64::from(config(count).cases)).map(|seed| Random(7919 * seed + 13))
}

/// 10 to a power between two.
pub fn power(random: &mut Random, low: f32, high: f32) -> f32 {
    10_f32.powf(random.between(low, high))
}

/// One of some numbers.
pub(super) fn one_of<const N: usize>(random: &mut Random, numbers: [f32; N]) -> f32 {
    numbers[random.below(N)]
}

/// A colour of its own for each number, in steps that are far from rounding.
fn paint(number: usize) -> Material {
    material(number, 28)
}

/// A turn about no axis of the scene.
pub(super) fn tilt(random: &mut Random) -> Quat {
    let (first, last) = (random.between(0.0, 3.0), random.between(0.0, 3.0));
    Quat::from_euler(EulerRot::XYZ, first, 1.0, last)
}

/// A size of a picture, wide ones and narrow ones too.
fn size(random: &mut Random) -> [usize; 2] {
    [[200, 160], [320, 240], [517, 61], [640, 40], [97, 203]][random.below(5)]
}

/// Where something that is `size` in pixels or so is seen on the floor of height `floor`: the place and its size in scene units.
pub(super) fn place(
    random: &mut Random,
    near: &Near,
    floor: f32,
    pixels: f32,
) -> Option<(Vec3, f32)> {
    let raster = near.scene.camera.raster(near.width, near.height);
    let (x, y) = (
        random.between(0.0, near.width as f32),
        random.between(0.0, near.height as f32),
    );
    let eye = near.scene.camera.eye;
    let d = raster.corner + raster.dx * x + raster.dy * y;
    let t = (floor - eye.y) / d.y;
    (t > 0.0 && t * d.length() < 1e6).then(|| (eye + d * t, pixels * raster.dx.length() * t))
}

/// A camera at some distance above a floor or below it, which looks at it steeply or along it.
fn camera(random: &mut Random, floor: f32, distance: f32) -> Camera {
    let side = one_of(random, [1.0, 1.0, -1.0]);
    let steep = one_of(random, [1.0, 0.3, 0.03]);
    let across = random.vector(vec3(-1.0, 0.0, -1.0), vec3(1.0, 0.0, 1.0));
    let away = one_of(random, [0.0, 0.0, 30.0, 1000.0]) * distance;
    let eye = vec3(away, floor + side * distance, 0.0);
    Camera::new(
        eye,
        eye + across + vec3(0.01, -side * steep, 0.0),
        one_of(random, [0.2, 0.6, 1.2, 2.6]),
    )
}

/// A picture of a floor with nothing on it.
pub(super) fn empty(random: &mut Random) -> (Near, f32) {
    let floor = one_of(random, [0.0, 0.0, 1.0, 37.3, -512.7]);
    let distance = power(random, -1.0, 3.0);
    let [width, height] = size(random);
    let scene = Scene {
        camera: camera(random, floor, distance),
        background: Vec3::splat(10.0 / 255.0),
        ambient: Vec3::ONE,
        planes: List::of(&[Plane::new(vec3(0.0, floor, 0.0), 1e5, 1e5, paint(0))]),
        ..Scene::default()
    };
    (
        Near {
            scene,
            width,
            height,
        },
        floor,
    )
}

/// Things that rise out of a floor or a slab, stand on it or in it, by from a tenth of their size to a rounding error, each in a
/// colour of its own in ambient light.
pub fn contact(random: &mut Random) -> Near {
    let (mut near, mut floor) = empty(random);
    let side = (near.scene.camera.eye.y - floor).signum();
    if random.below(3) == 0 {
        // On a slab.
        let half = vec3(1e5, one_of(random, [0.01, 1.0, 100.0]), 1e5);
        near.scene.blocks.push(Block {
            centre: vec3(0.0, floor, 0.0),
            half,
            material: paint(0),
            ..Block::default()
        });
        near.scene.planes = List::of(&[]);
        floor += side * half.y;
        near.scene.camera.eye.y += side * half.y;
        near.scene.camera.look_at.y += side * half.y;
    }
    for number in 1..2 + random.below(40) {
        let pixels = power(random, -0.2, 1.5);
        let Some((at, size)) = place(random, &near, floor, pixels) else {
            continue;
        };
        // By how much it rises.
        let rise =
            size * one_of(random, [0.1, 1e-2, 1e-3, 1e-4, 1e-5, 0.0]) * random.between(0.2, 1.0);
        let material = paint(number);
        match random.below(4) {
            0 => {
                let radius = (size * size + rise * rise) / (2.0 * rise.max(1e-6 * size));
                let centre = at + Vec3::Y * (side * (rise - radius));
                near.scene
                    .spheres
                    .push(Sphere::new(centre, radius, material));
            }
            1 => {
                let centre = at + Vec3::Y * (side * (size - rise));
                near.scene.spheres.push(Sphere::new(centre, size, material));
            }
            kind => {
                let shape = [Shape::Box, Shape::Cylinder, Shape::Capsule][random.below(3)];
                // A capsule is never lower than wide: this one is a ball.
                let flat = kind == 2 && shape != Shape::Capsule;
                let half = if flat {
                    vec3(size, 0.5 * rise, size)
                } else {
                    vec3(size, size, size)
                };
                let turn = [
                    Quat::IDENTITY,
                    Quat::from_rotation_y(random.between(0.0, 3.0)),
                    tilt(random),
                ][random.below(if flat { 2 } else { 3 })];
                let axes = Mat3::from_quat(turn);
                let up = axes.transpose() * Vec3::Y;
                near.scene.blocks.push(Block {
                    centre: at + Vec3::Y * (side * (rise - up.abs().dot(half))),
                    half: half.max(Vec3::splat(MIN_LENGTH)),
                    axes,
                    shape,
                    material,
                });
            }
        }
    }
    near
}

/// A camera that looks down from some height.
fn above(height: f32, field_of_view: f32) -> Camera {
    Camera {
        up: Vec3::NEG_Z,
        ..Camera::new(Vec3::Y * height, Vec3::ZERO, field_of_view)
    }
}

/// A floor, and what rises out of it.
fn risen(
    camera: Camera,
    spheres: &[Sphere],
    blocks: &[Block],
    [width, height]: [usize; 2],
) -> Near {
    Near {
        scene: Scene {
            camera,
            ambient: Vec3::ONE,
            planes: List::of(&[Plane::new(Vec3::ZERO, 500.0, 500.0, paint(0))]),
            spheres: spheres.iter().copied().collect(),
            blocks: blocks.iter().copied().collect(),
            ..Scene::default()
        },
        width,
        height,
    }
}

/// Things that rise out of a floor by little: marks of 6 pixels by 2e-6 of the height from which they are seen, the tip of a ball,
/// and a rod.
pub fn slivers() -> [Near; 3] {
    let place = |i: usize| -52.600_563 + 28.289_38 * i as f32;
    let marks: Vec<Block> = (0..25)
        .map(|i| Block {
            centre: vec3(place(i / 5), 0.0005, place(i % 5)),
            half: vec3(2.652_129_2, 0.0005, 2.652_129_2),
            material: paint(1 + i),
            ..Block::default()
        })
        .collect();
    let centre = vec3(-32.237_984, -999.999_44, -32.237_984);
    let ball = Sphere::new(centre, 1000.0, paint(1));
    let rod = Block {
        centre: vec3(-2.462_177, -7.497_565_3, -1.566_425),
        half: vec3(0.009_698_613, 7.497_571_5, 0.009_698_613),
        material: paint(1),
        ..Block::default()
    };
    let low = Camera {
        look_at: vec3(0.351_313, 0.002_777_457_2, -2.0),
        up: Vec3::Y,
        ..above(0.824_372_23, 0.585_265_76)
    };
    [
        risen(above(600.0, 0.35), &[], &marks, [320, 240]),
        risen(above(100.0, 0.8), &[ball], &[], [320, 240]),
        risen(low, &[], &[rod], [517, 61]),
    ]
}
