//! Tests of what the guard looks for: outlines hold all that they are around, and little else.

use super::*;
use crate::lanes::*;
use crate::prepare::{Prepared, rectangle};
use crate::scene::{Camera, Light, List, Material, Plane, Scene, Sphere};
use glam::{DVec3, Vec2, Vec3A};
use proptest::strategy::ValueTree;

const WIDTH: usize = 320;
const HEIGHT: usize = 240;

/// A vector with coordinates in a range, and heights in another one.
fn vector(across: f32, height: core::ops::Range<f32>) -> impl Strategy<Value = Vec3A> {
    (-across..across, height, -across..across).prop_map(|(x, y, z)| Vec3A::new(x, y, z))
}

/// A sphere above a floor, a lamp higher up, some of them far away, and a camera anywhere above the floor.
fn scene() -> impl Strategy<Value = Scene> {
    (
        vector(8.0, 0.3..8.0),
        vector(4.0, 0.0..3.0),
        (vector(4.0, 1.0..3.0), 0.01_f32..1.0),
        (vector(6.0, 4.5..9.0), 1.0_f32..8.0),
    )
        .prop_map(|(eye, look_at, (centre, radius), (lamp, far))| Scene {
            camera: Camera::new(eye, look_at, 1.0),
            spheres: List::of(&[Sphere::new(centre, radius, Material::BLACK)]),
            planes: List::of(&[Plane::new(Vec3A::ZERO, 1e3, 1e3, Material::BLACK)]),
            lights: List::of(&[Light {
                position: lamp * Vec3A::new(far, 1.0, far),
                ..Light::DARK
            }]),
            ..Scene::default()
        })
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
fn has(scene: &Prepared, number: usize, [x, y]: [usize; 2]) -> bool {
    let rect = scene.axes.rect(rectangle(x, y, x + 1, y + 1));
    let rects = scene.axes.rects(baseline(), [x, y], [1, 1]);
    let [from, to] = scene.outline(number).narrow(rects);
    scene.screen[number].meets(rect) && from.as_slice()[0] <= to.as_slice()[0]
}

proptest! {
    #[test]
    fn a_sphere_and_its_shadow_are_within_their_outlines(
        scene in scene(),
        ways in prop::collection::vec((-1.0..1.0, -1.0..1.0, -1.0..1.0), 64),
    ) {
        let prepared = prepared(&scene);
        let (sphere, lamp) = (&scene.spheres[0], scene.lights[0].position.as_dvec3());
        let shadow = prepared.background() + 1;
        for (x, y, z) in ways {
            let within = DVec3::new(x, y, z).clamp_length_max(0.999);
            let point = sphere.centre.as_dvec3() + within * f64::from(sphere.radius);
            if let Some(place) = seen(&prepared, point) {
                prop_assert!(has(&prepared, 0, place));
            }
            let below = lamp + (point - lamp) * (lamp.y / (lamp.y - point.y));
            if let Some(place) = seen(&prepared, below) {
                prop_assert!(has(&prepared, shadow, place), "{place:?}");
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
    let prepared = prepared(&scene);
    for number in 0..=prepared.background() {
        assert_eq!(prepared.outlined_object(number).index(), number);
    }
}
