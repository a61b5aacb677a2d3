//! Tests of what the guard looks for: outlines hold all that they are around, and little else.

use super::*;
use crate::lanes::*;
use crate::prepare::{Prepared, World, rectangle};
use crate::scene::{Block, Camera, Light, List, Material, Plane, Scene, Shape, Sphere};
use glam::{DVec3, EulerRot, Mat3, Vec2, Vec3};
use proptest::strategy::ValueTree;

const WIDTH: usize = 320;
const HEIGHT: usize = 240;

/// A vector with coordinates in a range, and heights in another one.
fn vector(across: f32, height: core::ops::Range<f32>) -> impl Strategy<Value = Vec3> {
    (-across..across, height, -across..across).prop_map(|(x, y, z)| Vec3::new(x, y, z))
}

/// A box, a cylinder or a capsule, turned in any way.
fn block() -> impl Strategy<Value = Block> {
    (
        vector(4.0, 1.0..3.0),
        (0.01_f32..1.0, 0.01_f32..1.0, 0.01_f32..1.0),
        (0.0_f32..6.0, 0.0_f32..6.0, 0.0_f32..6.0),
        0..3_usize,
    )
        .prop_map(|(centre, (x, y, z), (a, b, c), shape)| {
            let shape = [Shape::Box, Shape::Cylinder, Shape::Capsule][shape];
            Block {
                centre,
                half: match shape {
                    Shape::Box => Vec3::new(x, y, z),
                    Shape::Cylinder => Vec3::new(x, y, x),
                    Shape::Capsule => Vec3::new(x, x + y, x),
                },
                axes: Mat3::from_euler(EulerRot::XYZ, a, b, c),
                shape,
                material: Material::BLACK,
            }
        })
}

/// A sphere and a block above a floor, a lamp higher up, some of them far away, and a camera anywhere above the floor.
fn scene() -> impl Strategy<Value = Scene> {
    (
        vector(8.0, 0.3..8.0),
        vector(4.0, 0.0..3.0),
        (vector(4.0, 1.0..3.0), 0.01_f32..1.0),
        block(),
        (vector(6.0, 4.5..9.0), 1.0_f32..8.0),
    )
        .prop_map(
            |(eye, look_at, (centre, radius), block, (lamp, far))| Scene {
                camera: Camera::new(eye, look_at, 1.0),
                spheres: List::of(&[Sphere::new(centre, radius, Material::BLACK)]),
                blocks: List::of(&[block]),
                planes: List::of(&[Plane::new(Vec3::ZERO, 1e3, 1e3, Material::BLACK)]),
                lights: List::of(&[Light {
                    position: lamp * Vec3::new(far, 1.0, far),
                    ..Light::DARK
                }]),
                ..Scene::default()
            },
        )
}

/// A point within a block, some of its sides.
fn within(block: &Block, way: DVec3) -> DVec3 {
    let half = block.half.as_dvec3();
    let across = DVec3::new(way.x, 0.0, way.z).clamp_length_max(1.0);
    let own = match block.shape {
        Shape::Box => way * half,
        Shape::Cylinder => (across + DVec3::Y * way.y) * half,
        Shape::Capsule => DVec3::Y * way.y * (half.y - half.x) + way.clamp_length_max(1.0) * half.x,
    };
    block.centre.as_dvec3() + (block.axes.as_dmat3() * own * 0.999)
}

/// The scene, prepared.
fn prepared(scene: &Scene) -> Box<Prepared> {
    let mut prepared = Box::new(Prepared::new());
    prepared.prepare(scene, [WIDTH, HEIGHT], Vec2::ZERO);
    prepared
}

/// The place in the picture, in pixels, where a point is seen, if it is.
fn seen(scene: &Prepared, point: DVec3) -> Option<[usize; 2]> {
    let d = point - scene.eye.as_dvec3();
    let [x, y, z] = scene.axes.rows.map(|axis| axis.as_dvec3().dot(d));
    let pixel = f64::from(scene.axes.pixel);
    let place = [(x, WIDTH), (y, HEIGHT)].map(|(c, side)| {
        let place = c / z / pixel + 0.5 * (side as f64 - 1.0);
        (place >= 0.0 && place < side as f64 - 1.0).then_some(place as usize)
    });
    match place {
        [Some(x), Some(y)] if z > 0.0 => Some([x, y]),
        _ => None,
    }
}

/// Whether an outline reaches the pixels around a place.
fn has(world: World<'_>, number: usize, [x, y]: [usize; 2]) -> bool {
    let rect = world.axes.rect(rectangle(x, y, x + 1, y + 1));
    let rects = world.axes.rects(baseline(), [x, y], [1, 1]);
    let [from, to] = world.outline(number).narrow(rects);
    world.screen[number].meets(rect) && from.as_slice()[0] <= to.as_slice()[0]
}

proptest! {
    #[test]
    fn a_sphere_a_block_and_their_shadows_are_within_their_outlines(
        scene in scene(),
        ways in prop::collection::vec((-1.0..1.0, -1.0..1.0, -1.0..1.0), 64),
    ) {
        let prepared = &*prepared(&scene);
        let world = World { scene: &scene, prepared };
        let (sphere, block) = (&scene.spheres[0], &scene.blocks[0]);
        let lamp = scene.lights[0].position.as_dvec3();
        for (x, y, z) in ways {
            let way = DVec3::new(x, y, z);
            let in_sphere = way.clamp_length_max(0.999) * f64::from(sphere.radius);
            let points = [sphere.centre.as_dvec3() + in_sphere, within(block, way)];
            for (object, point) in points.into_iter().enumerate() {
                if let Some(place) = seen(prepared, point) {
                    prop_assert!(has(world, object, place));
                }
                let below = lamp + (point - lamp) * (lamp.y / (lamp.y - point.y));
                if let Some(place) = seen(prepared, below) {
                    let shadows = prepared.background() + 1..prepared.outlined;
                    let shadow = shadows.clone().find(|&shadow| prepared.shadow(shadow).object == object);
                    let shadow = shadow.expect("each of both has a shadow");
                    prop_assert!(has(world, shadow, place), "{object}, {place:?}");
                }
            }
        }
    }
}

/// Of the places in the picture, the bounds of small spheres' shadows have few.
#[test]
fn bounds_of_small_shadows_are_small() {
    let mut runner = proptest::test_runner::TestRunner::deterministic();
    let (mut met, mut tried) = (0, 0);
    for _ in 0..200 {
        let mut scene = scene()
            .new_tree(&mut runner)
            .expect("it has no filter")
            .current();
        scene.spheres[0].radius = 0.02;
        let prepared = prepared(&scene);
        let shadow = prepared.background() + 1;
        for y in (0..HEIGHT).step_by(8) {
            for x in (0..WIDTH).step_by(8) {
                let rect = prepared.axes.rect(rectangle(x, y, x + 8, y + 8));
                met += usize::from(prepared.screen[shadow].meets(rect));
                tried += 1;
            }
        }
    }
    assert!(met * 100 < tried, "{met} of {tried}");
}

/// Planes beyond the first one are looked for as objects, too, and no images in the first one.
#[test]
fn each_object_has_an_outline_of_its_own() {
    let scene = Scene {
        planes: List::of(&[Plane::default(); 2]),
        ..Scene::default()
    };
    let prepared = &*prepared(&scene);
    let world = World {
        scene: &scene,
        prepared,
    };
    for number in 0..=world.background() {
        assert_eq!(world.outline(number).shown_by.index(), number);
    }
}
