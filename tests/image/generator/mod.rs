//! Random scenes for all tests of pictures.
//!
//! The functions of this file make proptest's strategies, which shrink a failing scene; [`placed`] makes strategies for scenes
//! whose objects are placed by where they are in the picture, [`seeded`] makes scenes from a number, for long runs, [`near`]
//! and [`alone`] those in which things are easily missed, and [`crowded`] crowds. All are seeded (see `.cargo/config.toml`), so that a run repeats.

pub mod alone;
pub mod crowded;
pub mod near;
pub mod placed;
pub mod seeded;

use eightfold_tracer::scene::{
    Block, Camera, Film, Light, Material, Pattern, Plane, Scene, Shape, Sphere, Spot, Waves,
};
use glam::{Mat3, Quat, Vec3, vec3};
use proptest::collection::vec;
use proptest::prelude::*;

/// A configuration with the given number of cases, or with `PROPTEST_CASES` of them if that is set.
pub fn config(cases: u32) -> ProptestConfig {
    let asked = std::env::var("PROPTEST_CASES").ok();
    ProptestConfig {
        cases: asked.and_then(|n| n.parse().ok()).unwrap_or(cases),
        failure_persistence: None,
        max_shrink_iters: 200,
        ..ProptestConfig::default()
    }
}

/// The materials of all objects of a scene.
pub fn materials(scene: &mut Scene) -> Vec<&mut Material> {
    let spheres = scene.spheres.iter_mut().map(|s| &mut s.material);
    let planes = scene.planes.iter_mut().map(|p| &mut p.material);
    let blocks = scene.blocks.iter_mut().map(|b| &mut b.material);
    spheres.chain(planes).chain(blocks).collect()
}

/// A colour.
fn colour() -> impl Strategy<Value = Vec3> {
    [0.0_f32..1.0, 0.0..1.0, 0.0..1.0].prop_map(Vec3::from)
}

/// A point in a box about the origin, above the ground.
fn point(half: f32, height: f32) -> impl Strategy<Value = Vec3> {
    (-half..half, 0.2..height, -half..half).prop_map(|(x, y, z)| vec3(x, y, z))
}

/// Plastic, mirror or glass; `kr + kt` is at most 1.
fn material() -> impl Strategy<Value = Material> {
    let glass = prop_oneof![Just(0.0_f32), 0.2_f32..0.9];
    let index = prop_oneof![1.05_f32..2.4, 0.5_f32..0.95];
    let anisotropy = prop_oneof![Just(0.0_f32), 0.0_f32..1.0];
    (
        colour(),
        0.0_f32..1.0,
        prop_oneof![Just(0.0_f32), 0.1_f32..1.0],
        (1.0_f32..200.0, 0.0_f32..1.0, anisotropy),
        (0.0_f32..1.0, 0.0_f32..1.0),
        (glass, index),
    )
        .prop_map(
            |(colour, kd, ks, (exponent, metallic, anisotropy), (kr, fresnel), (kt, index))| {
                Material {
                    colour,
                    kd,
                    ks,
                    exponent,
                    metallic,
                    anisotropy,
                    kr: kr * (1.0 - kt),
                    fresnel,
                    kt,
                    index,
                    ..Material::BLACK
                }
            },
        )
}

/// A sphere near the origin.
pub fn sphere() -> impl Strategy<Value = Sphere> {
    (point(4.0, 3.0), 0.2_f32..1.5, material())
        .prop_map(|(centre, radius, material)| Sphere::new(centre, radius, material))
}

/// A rectangle below the origin.
fn plane() -> impl Strategy<Value = Plane> {
    ((-2.0_f32..0.0, 1.0_f32..20.0, 1.0_f32..20.0), material()).prop_map(
        |((y, half_x, half_z), material)| Plane::new(vec3(0.3, y, -0.2), half_x, half_z, material),
    )
}

/// A point light.
fn light() -> impl Strategy<Value = Light> {
    (point(8.0, 9.0), colour(), 0.05_f32..0.4).prop_map(|(position, colour, radius)| Light {
        drawn_radius: radius,
        ..Light::new(position, colour)
    })
}

/// A camera that looks at the origin from outside.
fn camera() -> impl Strategy<Value = Camera> {
    (
        (0.0_f32..6.3, 7.0_f32..14.0, 0.5_f32..6.0),
        point(1.0, 1.0),
        0.3_f32..1.6,
    )
        .prop_map(|((angle, distance, height), look_at, field_of_view)| {
            Camera::new(
                vec3(distance * angle.sin(), height, distance * angle.cos()),
                look_at,
                field_of_view,
            )
        })
}

/// Spheres, which may intersect, planes and point lights.
pub fn sketch(
    spheres: impl Strategy<Value = Vec<Sphere>>,
    planes: usize,
) -> impl Strategy<Value = Scene> {
    (
        camera(),
        (colour(), colour()),
        spheres,
        vec(plane(), 0..=planes),
        vec(light(), 0..=4),
    )
        .prop_map(
            |(camera, (background, ambient), spheres, planes, lights)| Scene {
                camera,
                background,
                ambient: 0.2 * ambient,
                spheres: spheres.iter().copied().collect(),
                planes: planes.iter().copied().collect(),
                lights: lights.iter().copied().collect(),
                ..Scene::default()
            },
        )
}

/// Stripes, checkers, marble or a uniform colour.
fn pattern() -> impl Strategy<Value = Pattern> {
    let waves = || prop_oneof![Just(0.0_f32), 0.2_f32..2.0];
    (
        (waves(), waves(), waves()),
        (0.2_f32..1.0, 0.5_f32..20.0, -1.0_f32..1.0),
        (0.0_f32..1.5, 0.2_f32..2.0),
    )
        .prop_map(
            |((x, y, z), (depth, edge, balance), (warp, grain))| Pattern {
                waves: vec3(x, y, z),
                depth: if x + y + z > 0.0 { depth } else { 0.0 },
                edge,
                balance,
                warp,
                grain,
            },
        )
}

/// A material with a pattern and, if it is transparent, a tint.
fn painted() -> impl Strategy<Value = Material> {
    (material(), pattern(), colour()).prop_map(|(material, pattern, tint)| Material {
        tint: if material.kt > 0.0 { tint } else { Vec3::ZERO },
        pattern,
        // A curved mirror at a grazing angle shows patterns finer than f32 can tell.
        fresnel: 0.05 * material.fresnel,
        ..material
    })
}

/// A box, a cylinder or a capsule.
pub fn shape() -> impl Strategy<Value = Shape> {
    proptest::sample::select(&[Shape::Box, Shape::Cylinder, Shape::Capsule][..])
}

/// A block's extent that fits its shape.
pub fn fitting(shape: Shape, half: Vec3) -> Vec3 {
    match shape {
        Shape::Box => half,
        Shape::Cylinder => half.with_z(half.x),
        Shape::Capsule => Vec3::new(half.x, half.y.max(half.x), half.x),
    }
}

/// A block near the origin.
fn block() -> impl Strategy<Value = Block> {
    (
        point(4.0, 3.0),
        [0.2_f32..1.5, 0.2..1.5, 0.2..1.5],
        ([-1.0_f32..1.0, -1.0..1.0, -1.0..1.0], 0.1_f32..1.0),
        shape(),
        painted(),
    )
        .prop_map(|(centre, half, ([x, y, z], w), shape, material)| Block {
            axes: Mat3::from_quat(Quat::from_xyzw(x, y, z, w).normalize()),
            ..Block::new(shape, centre, fitting(shape, Vec3::from(half)), material)
        })
}

/// A light of any kind: a point or one with a size, near or with parallel rays, a spotlight or not. It is above everything.
fn any_light() -> impl Strategy<Value = Light> {
    let spot = (0.3_f32..0.8, 0.05_f32..0.2);
    (
        ([-9.0_f32..9.0, 6.0..12.0, -9.0..9.0], colour()),
        (0.0_f32..0.4, any::<bool>()),
        [0.1_f32, 0.1].map(|least| prop_oneof![Just(0.0), least..2.0]),
        proptest::option::of(spot),
    )
        .prop_map(
            |((position, colour), (radius, parallel), [size, glow], spot)| {
                let position = Vec3::from(position);
                Light {
                    drawn_radius: radius,
                    parallel,
                    diameter: size,
                    glow,
                    spot: spot.map(|(dark, soft)| Spot {
                        aim: -position.normalize(),
                        inner_angle: (dark + soft).acos(),
                        outer_angle: dark.acos(),
                    }),
                    ..Light::new(position, colour)
                }
            },
        )
}

/// Any film, the plain one too.
fn film() -> impl Strategy<Value = Film> {
    let any = (0.0_f32..1.0, 0.0_f32..0.5, 0.0_f32..1.0, 0.0_f32..1.0);
    let any = any.prop_map(|(shoulder, vignette, dither, tolerance)| Film {
        shoulder,
        vignette,
        dither,
        tolerance,
    });
    prop_oneof![Just(Film::PLAIN), any]
}

/// Calm water, or waves.
fn water() -> impl Strategy<Value = Waves> {
    let any = (0.001_f32..0.1, 0.5_f32..10.0, -9.0_f32..9.0);
    let any = any.prop_map(|(slope, length, phase)| Waves {
        slope,
        length,
        phase,
    });
    prop_oneof![Just(Waves::CALM), any]
}

/// Objects, materials and lights of all kinds.
pub fn rich() -> impl Strategy<Value = Scene> {
    (
        sketch(vec(painted_sphere(), 0..6), 2),
        vec(block(), 0..8),
        vec(any_light(), 0..=3),
        (painted(), colour()),
        (prop_oneof![Just(0.0_f32), 0.01_f32..0.1], 0.1_f32..1.2),
        (film(), water()),
    )
        .prop_map(
            |(mut scene, blocks, lights, (floor, sky), (haze, exposure), (film, water))| {
                if let Some(plane) = scene.planes.first_mut() {
                    plane.material = floor;
                }
                Scene {
                    blocks: blocks.iter().copied().collect(),
                    lights: lights.iter().copied().collect(),
                    sky: sky - scene.background,
                    haze,
                    exposure,
                    film,
                    water,
                    ..scene
                }
            },
        )
}

/// A sphere with a pattern.
fn painted_sphere() -> impl Strategy<Value = Sphere> {
    (sphere(), painted()).prop_map(|(sphere, material)| Sphere { material, ..sphere })
}
