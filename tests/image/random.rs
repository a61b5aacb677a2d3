//! Properties of whatever scene: the tracer against the oracle on scenes by chance.
//!
//! Chance is seeded, so that a run repeats; `PROPTEST_CASES` asks for more cases.

use crate::accuracy::assert_as_traced;
use crate::cpu;
use crate::drawn::draw;
use crate::refinement::{assert_as_refined, bare};
use eightfold::scene::{
    Block, Camera, Light, List, Material, Pattern, Plane, Scene, Shape, Sphere, Spot,
};
use eightfold::{Quality, show};
use eightfold_oracle::frame::Frame;
use eightfold_oracle::squares::Squares;
use glam::{Mat3A, Quat, Vec3A, vec3a};
use proptest::collection::vec;
use proptest::prelude::*;
use proptest::test_runner::RngSeed;

/// Seeded; `PROPTEST_CASES` cases, or this many.
pub fn config(cases: u32) -> ProptestConfig {
    let asked = std::env::var("PROPTEST_CASES").ok();
    ProptestConfig {
        cases: asked.and_then(|n| n.parse().ok()).unwrap_or(cases),
        rng_seed: RngSeed::Fixed(2008),
        failure_persistence: None,
        max_shrink_iters: 200,
        ..ProptestConfig::default()
    }
}

fn colour() -> impl Strategy<Value = Vec3A> {
    [0.0_f32..1.0, 0.0..1.0, 0.0..1.0].prop_map(Vec3A::from)
}

/// A point in a box about the origin, above the ground.
fn place(half: f32, height: f32) -> impl Strategy<Value = Vec3A> {
    (-half..half, 0.2..height, -half..half).prop_map(|(x, y, z)| vec3a(x, y, z))
}

/// Plastic, mirror or glass; what it sends on is at most what it gets.
fn material() -> impl Strategy<Value = Material> {
    let glass = prop_oneof![Just(0.0_f32), 0.2_f32..0.9];
    let index = prop_oneof![1.05_f32..2.4, 0.5_f32..0.95];
    (
        colour(),
        0.0_f32..1.0,
        prop_oneof![Just(0.0_f32), 0.1_f32..1.0],
        1.0_f32..200.0,
        0.0_f32..1.0,
        (glass, index),
    )
        .prop_map(|(colour, kd, ks, exponent, kr, (kt, index))| Material {
            colour,
            kd,
            ks,
            exponent,
            kr: kr * (1.0 - kt),
            kt,
            index,
            ..Material::BLACK
        })
}

pub fn sphere() -> impl Strategy<Value = Sphere> {
    (place(4.0, 3.0), 0.2_f32..1.5, material()).prop_map(|(centre, radius, material)| Sphere {
        centre,
        radius,
        material,
    })
}

fn plane() -> impl Strategy<Value = Plane> {
    ((-2.0_f32..0.0, 1.0_f32..20.0, 1.0_f32..20.0), material()).prop_map(
        |((y, half_x, half_z), material)| Plane {
            centre: vec3a(0.3, y, -0.2),
            half_x,
            half_z,
            material,
        },
    )
}

fn light() -> impl Strategy<Value = Light> {
    (place(8.0, 9.0), colour(), 0.05_f32..0.4).prop_map(|(position, colour, radius)| Light {
        position,
        colour,
        radius,
        ..Light::DARK
    })
}

fn camera() -> impl Strategy<Value = Camera> {
    (
        (0.0_f32..6.3, 7.0_f32..14.0, 0.5_f32..6.0),
        place(1.0, 1.0),
        0.3_f32..1.6,
    )
        .prop_map(
            |((angle, distance, height), look_at, field_of_view)| Camera {
                eye: vec3a(distance * angle.sin(), height, distance * angle.cos()),
                look_at,
                up: Vec3A::Y,
                field_of_view,
            },
        )
}

/// A scene in few words, for the message about a failure.
#[derive(Clone, Debug)]
pub struct Sketch {
    camera: Camera,
    background: Vec3A,
    ambient: Vec3A,
    spheres: Vec<Sphere>,
    planes: Vec<Plane>,
    lights: Vec<Light>,
}

impl Sketch {
    pub fn scene(&self) -> Scene {
        Scene {
            camera: self.camera,
            background: self.background,
            ambient: self.ambient,
            spheres: List::of(&self.spheres),
            planes: List::of(&self.planes),
            lights: List::of(&self.lights),
            ..Scene::default()
        }
    }
}

/// Some spheres, which may pass through each other, planes and lights.
pub fn sketch(
    spheres: impl Strategy<Value = Vec<Sphere>>,
    planes: usize,
) -> impl Strategy<Value = Sketch> {
    (
        camera(),
        (colour(), colour()),
        spheres,
        vec(plane(), 0..=planes),
        vec(light(), 0..=4),
    )
        .prop_map(
            |(camera, (background, ambient), spheres, planes, lights)| Sketch {
                camera,
                background,
                ambient: 0.2 * ambient,
                spheres,
                planes,
                lights,
            },
        )
}

/// Stripes, checkers, marble or an even colour.
fn pattern() -> impl Strategy<Value = Pattern> {
    let waves = || prop_oneof![Just(0.0_f32), 0.2_f32..2.0];
    (
        (waves(), waves(), waves()),
        (0.2_f32..1.0, 0.5_f32..50.0),
        (0.0_f32..1.5, 0.2_f32..2.0),
    )
        .prop_map(|((x, y, z), (depth, edge), (warp, grain))| Pattern {
            waves: vec3a(x, y, z),
            depth: if x + y + z > 0.0 { depth } else { 0.0 },
            edge,
            warp,
            grain,
        })
}

/// What has a pattern, and lets some light pass.
fn painted() -> impl Strategy<Value = Material> {
    (material(), pattern(), colour()).prop_map(|(material, pattern, tint)| Material {
        tint: if material.kt > 0.0 { tint } else { Vec3A::ZERO },
        pattern,
        ..material
    })
}

pub fn shape() -> impl Strategy<Value = Shape> {
    any::<bool>().prop_map(|is_round| {
        if is_round {
            Shape::Cylinder
        } else {
            Shape::Box
        }
    })
}

fn block() -> impl Strategy<Value = Block> {
    (
        place(4.0, 3.0),
        [0.2_f32..1.5, 0.2..1.5, 0.2..1.5],
        ([-1.0_f32..1.0, -1.0..1.0, -1.0..1.0], 0.1_f32..1.0),
        shape(),
        painted(),
    )
        .prop_map(|(centre, half, ([x, y, z], w), shape, material)| {
            let half = Vec3A::from(half);
            Block {
                centre,
                half: if shape == Shape::Cylinder {
                    half.with_z(half.x)
                } else {
                    half
                },
                axes: Mat3A::from_quat(Quat::from_xyzw(x, y, z, w).normalize()),
                shape,
                material,
            }
        })
}

/// A point, a ball, parallel rays; a cone of any of them. It is above everything.
fn lamp() -> impl Strategy<Value = Light> {
    let spot = (0.3_f32..0.8, 0.05_f32..0.2);
    (
        ([-9.0_f32..9.0, 6.0..12.0, -9.0..9.0], colour()),
        (0.0_f32..0.4, any::<bool>()),
        prop_oneof![Just(0.0_f32), 0.1_f32..2.0],
        proptest::option::of(spot),
    )
        .prop_map(|((position, colour), (radius, parallel), size, spot)| {
            let position = Vec3A::from(position);
            Light {
                position,
                colour,
                radius,
                parallel,
                size,
                spot: spot.map(|(dark, soft)| Spot {
                    aim: -position.normalize(),
                    dark,
                    bright: dark + soft,
                }),
            }
        })
}

/// Everything a scene can have.
#[derive(Clone, Debug)]
struct Rich {
    sketch: Sketch,
    blocks: Vec<Block>,
    lamps: Vec<Light>,
    floor: Material,
    sky: Vec3A,
    air: (f32, f32),
}

impl Rich {
    fn scene(&self) -> Scene {
        let mut scene = self.sketch.scene();
        if let Some(plane) = scene.planes.first_mut() {
            plane.material = self.floor;
        }
        Scene {
            blocks: List::of(&self.blocks),
            lights: List::of(&self.lamps),
            sky: self.sky - scene.background,
            haze: self.air.0,
            fade: self.air.1,
            ..scene
        }
    }
}

fn rich() -> impl Strategy<Value = Rich> {
    (
        sketch(vec(painted_sphere(), 0..6), 2),
        vec(block(), 0..8),
        vec(lamp(), 0..=3),
        (painted(), colour()),
        (prop_oneof![Just(0.0_f32), 0.01_f32..0.1], -0.2_f32..0.9),
    )
        .prop_map(|(sketch, blocks, lamps, (floor, sky), air)| Rich {
            sketch,
            blocks,
            lamps,
            floor,
            sky,
            air,
        })
}

fn painted_sphere() -> impl Strategy<Value = Sphere> {
    (sphere(), painted()).prop_map(|(sphere, material)| Sphere { material, ..sphere })
}

proptest! {
    #![proptest_config(config(48))]

    #[test]
    fn any_scene_is_as_the_oracle_sees_it(sketch in sketch(vec(sphere(), 0..12), 2)) {
        let scene = sketch.scene();
        let frame = Frame::new(&scene, &Quality::EXHAUSTIVE, 96, 72);
        for isa in cpu::instruction_sets() {
            let drawn = draw(isa, 1, &scene, &Quality::EXHAUSTIVE, 96, 72);
            assert_as_traced(&drawn, &frame, isa.name);
        }
    }

    #[test]
    fn any_rich_scene_is_as_the_oracle_sees_it(rich in rich()) {
        let scene = rich.scene();
        scene.validate().unwrap();
        let frame = Frame::new(&scene, &Quality::EXHAUSTIVE, 96, 72);
        for isa in cpu::instruction_sets() {
            let drawn = draw(isa, 1, &scene, &Quality::EXHAUSTIVE, 96, 72);
            assert_as_traced(&drawn, &frame, isa.name);
        }
    }

    #[test]
    fn any_scene_is_refined_by_the_rules(sketch in sketch(vec(sphere(), 0..12), 2)) {
        let scene = sketch.scene();
        for quality in [Quality::THESIS, Quality::DEFAULT].map(bare) {
            let squares = Squares::new(&scene, &quality, 96, 72);
            for isa in cpu::instruction_sets() {
                let drawn = draw(isa, 1, &scene, &quality, 96, 72);
                assert_as_refined(&drawn, &squares, isa.name);
            }
        }
    }

    #[test]
    fn the_model_scene_is_right_at_any_time_and_size(
        time in 0.0..show::MODEL_LENGTH,
        width in 1_usize..200,
        height in 1_usize..200,
    ) {
        let scene = show::scene(time);
        let frame = Frame::new(&scene, &Quality::EXHAUSTIVE, width, height);
        let thesis = bare(Quality::THESIS);
        let squares = Squares::new(&scene, &thesis, width, height);
        for isa in cpu::instruction_sets() {
            let drawn = draw(isa, 2, &scene, &Quality::EXHAUSTIVE, width, height);
            assert_as_traced(&drawn, &frame, isa.name);
            let drawn = draw(isa, 2, &scene, &thesis, width, height);
            assert_as_refined(&drawn, &squares, isa.name);
        }
    }
}
