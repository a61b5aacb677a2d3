//! Outlines contain their objects and shadows, and little else.

extern crate std;

use super::*;
use crate::lanes::*;
use crate::prepare::Prepared;
use crate::scene::{Block, Camera, Light, List, Material, Plane, Scene, Shape, Sphere};
use crate::zero::Zero;
use glam::{DVec3, EulerRot, Mat3, Vec3, Vec3A};
use proptest::prelude::*;
use proptest::strategy::ValueTree;
use proptest::test_runner::TestRunner;
use std::prelude::v1::*;

const SIZE: [usize; 2] = [320, 240];

fn vector(across: f32, height: core::ops::Range<f32>) -> impl Strategy<Value = Vec3> {
    (-across..across, height, -across..across).prop_map(|(x, y, z)| Vec3::new(x, y, z))
}

fn block() -> impl Strategy<Value = Block> {
    (
        vector(4.0, 1.0..3.0),
        (0.01_f32..1.0, 0.01_f32..1.0, 0.01_f32..1.0),
        (0.0_f32..6.0, 0.0_f32..6.0, 0.0_f32..6.0),
        0..3_usize,
    )
        .prop_map(|(centre, (x, y, z), (a, b, c), shape)| {
            let shape = [Shape::Box, Shape::Cylinder, Shape::Capsule][shape];
            let half = match shape {
                Shape::Box => Vec3::new(x, y, z),
                Shape::Cylinder => Vec3::new(x, y, x),
                Shape::Capsule => Vec3::new(x, x + y, x),
            };
            let axes = Mat3::from_euler(EulerRot::XYZ, a, b, c);
            Block { axes, ..Block::new(shape, centre, half, Material::BLACK) }
        })
}

/// Random scenes of a sphere and a block between a floor and a light, seen from above the floor.
/// The light is up to `10^light` times as far away as usual, the camera up to `10^telescope` times.
fn scene(light: f32, telescope: f32) -> impl Strategy<Value = Scene> {
    (
        vector(8.0, 0.3..8.0),
        vector(4.0, 0.0..3.0),
        (vector(4.0, 1.0..3.0), 0.01_f32..1.0),
        block(),
        (vector(6.0, 4.5..9.0), 1.0_f32..8.0),
        [prop_oneof![Just(0.0), 0.0..=light], prop_oneof![Just(0.0), 0.0..=telescope]],
    )
        .prop_map(|(eye, look_at, (centre, radius), block, (light, far), decades)| {
            let floor = Material::matt(Vec3::ONE, 1.0);
            let [by_light, by_eye] = decades.map(|decades| libm::powf(10.0, decades));
            Scene {
                camera: Camera::new(eye * by_eye, look_at, 1.0 / by_eye),
                spheres: List::of(&[Sphere::new(centre, radius, Material::BLACK)]),
                blocks: List::of(&[block]),
                planes: List::of(&[Plane::new(Vec3::ZERO, 1e3, 1e3, floor)]),
                lights: List::of(&[Light {
                    position: light * Vec3::new(far, 1.0, far) * by_light,
                    ..Light::DARK
                }]),
                ..Scene::default()
            }
        })
}

fn draw<T>(strategy: &impl Strategy<Value = T>, runner: &mut TestRunner) -> T {
    strategy.new_tree(runner).expect("it has no filter").current()
}

/// Returns the point at `at`, in half extents from a block's centre. Points with coordinates from
/// -1 to 1 are inside.
fn within(block: &Block, at: DVec3) -> DVec3 {
    let half = block.half.as_dvec3();
    let across = DVec3::new(at.x, 0.0, at.z).clamp_length_max(1.0);
    let own = match block.shape {
        Shape::Box => at * half,
        Shape::Cylinder => (across + DVec3::Y * at.y) * half,
        Shape::Capsule => DVec3::Y * at.y * (half.y - half.x) + at.clamp_length_max(1.0) * half.x,
    };
    block.centre.as_dvec3() + (block.axes.as_dmat3() * own * 0.999)
}

struct Bounds {
    prepared: Box<Prepared>,
    coverage: Box<Coverage>,
}

impl Bounds {
    fn of(scene: &Scene) -> Self {
        let (mut prepared, mut coverage) = (Box::new(Prepared::ZERO), Box::new(Coverage::ZERO));
        let world = prepared.prepare(scene, SIZE, Vec2::ZERO);
        coverage.set(world, SIZE, Vec2::ZERO);
        Self { prepared, coverage }
    }

    fn number(&self, is_asked: impl Fn(Outline) -> bool) -> Option<usize> {
        let listed = self.coverage.outlines[..self.coverage.outlined].iter();
        listed.copied().position(is_asked)
    }

    /// Returns whether a listed outline reaches the pixels around a place.
    fn have(&self, scene: &Scene, [x, y]: [usize; 2], is_asked: impl Fn(Outline) -> bool) -> bool {
        let (prepared, coverage) = (&*self.prepared, &*self.coverage);
        let Some(number) = self.number(is_asked) else { return false };
        let rect = coverage.axes.rect(rectangle(x, y, x + 1, y + 1));
        let rects = coverage.axes.rects(baseline(), [x, y], [1, 1]);
        let region = coverage.region(World { scene, prepared }, number);
        let [from, to] = region.clip(rects);
        coverage.screen[number].meets(rect) && from.as_slice()[0] <= to.as_slice()[0]
    }
}

fn is_shadow_of(solid: usize) -> impl Fn(Outline) -> bool {
    move |outline| matches!(outline, Outline::Shadow { object, .. } if object.index() == solid)
}

/// Returns the least distance of a segment from a block's centre, in units that put the block's
/// surface at 1.
fn nearest(block: &Block, from: DVec3, to: DVec3) -> f64 {
    let inward = block.axes.as_dmat3().transpose();
    let half = block.half.as_dvec3();
    let distance = |share: f64| {
        let own = inward * (from + (to - from) * share - block.centre.as_dvec3());
        let round = own.x.hypot(own.z) / half.x;
        let beyond = (own.y.abs() - (half.y - half.x)).max(0.0) / half.x;
        match block.shape {
            Shape::Box => (own / half).abs().max_element(),
            Shape::Cylinder => round.max(own.y.abs() / half.y),
            Shape::Capsule => round.hypot(beyond),
        }
    };
    // The distance is convex.
    let [mut low, mut high] = [0.0, 1.0];
    for _ in 0..100 {
        let [left, right] = [low + (high - low) / 3.0, high - (high - low) / 3.0];
        if distance(left) < distance(right) {
            high = right;
        } else {
            low = left;
        }
    }
    distance(low)
}

fn pixel_of(axes: &Axes, eye: Vec3, point: DVec3) -> Option<[usize; 2]> {
    let d = point - eye.as_dvec3();
    let [x, y, z] = axes.rows.map(|axis| axis.as_dvec3().dot(d));
    let pixel = f64::from(axes.pixel);
    let place = [(x, SIZE[0]), (y, SIZE[1])].map(|(c, side)| {
        let place = c / z / pixel + 0.5 * (side as f64 - 1.0);
        (place >= 0.0 && place < side as f64 - 1.0).then_some(place as usize)
    });
    match place {
        [Some(x), Some(y)] if z > 0.0 => Some([x, y]),
        _ => None,
    }
}

proptest! {
    #[test]
    fn outlines_contain_objects_and_shadows(
        scene in scene(6.0, 3.0),
        points in prop::collection::vec((-1.0..1.0, -1.0..1.0, -1.0..1.0), 64),
    ) {
        let bounds = Bounds::of(&scene);
        let axes = &bounds.coverage.axes;
        let (sphere, block) = (&scene.spheres[0], &scene.blocks[0]);
        let light = scene.lights[0].position.as_dvec3();
        for (x, y, z) in points {
            let at = DVec3::new(x, y, z);
            let in_sphere = at.clamp_length_max(0.999) * f64::from(sphere.radius);
            let points = [sphere.centre.as_dvec3() + in_sphere, within(block, at)];
            for (solid, point) in points.into_iter().enumerate() {
                if let Some(place) = pixel_of(axes, scene.camera.eye, point) {
                    let is_asked = |it| matches!(it, Outline::Object(id) if id.index() == solid);
                    prop_assert!(bounds.have(&scene, place, is_asked));
                }
                let below = light + (point - light) * (light.y / (light.y - point.y));
                if let Some(place) = pixel_of(axes, scene.camera.eye, below) {
                    let is_there = bounds.have(&scene, place, is_shadow_of(solid));
                    prop_assert!(is_there, "{solid}, {place:?}");
                }
            }
        }
    }
}

/// A point may wrongly count as certainly dark: its shadow ray may pass up to 1.087 radii from a
/// cylinder's axis. This happens at the rim of an end, where the bound changes from the circle of
/// the side to the hexagon inside the end.
#[test]
fn certain_points_are_in_shadow() {
    let mut runner = TestRunner::deterministic();
    let points = vector(1.5, -1.5..1.5);
    let points: Vec<_> = (0..200).map(|_| draw(&points, &mut runner).as_dvec3()).collect();
    let mut certain = 0;
    for _ in 0..400 {
        let scene = draw(&scene(3.0, 1.0), &mut runner);
        let bounds = Bounds::of(&scene);
        let (coverage, axes) = (&bounds.coverage, &bounds.coverage.axes);
        let (eye, block) = (scene.camera.eye.as_dvec3(), &scene.blocks[0]);
        let light = scene.lights[0].position.as_dvec3();
        let Some(number) = bounds.number(is_shadow_of(1)) else { continue };
        let (scene, prepared) = (&scene, &bounds.prepared);
        let region = coverage.region(World { scene, prepared }, number);
        for &at in &points {
            let point = within(block, at);
            let below = light + (point - light) * (light.y / (light.y - point.y));
            let Some([x, y]) = pixel_of(axes, scene.camera.eye, below) else { continue };
            let rect = axes.rect(rectangle(x, y, x + 1, y + 1));
            if region.corners(rect) & 1 != 0 {
                let [right, down, ahead] = axes.rows.map(Vec3A::as_dvec3);
                let d = right * f64::from(rect.x) + down * f64::from(rect.y) + ahead;
                let off = nearest(block, eye - d * (eye.y / d.y), light);
                let max = [1.087, 1.0][usize::from(block.shape == Shape::Box)];
                assert!(off < max + 1e-3, "{off} of {block:?}");
                certain += 1;
            }
        }
    }
    assert!(certain > 4000, "{certain}");
}

/// If a sphere's greater part is above a mirror, all visible points inside the outline of its image
/// show the image.
#[test]
fn images_of_sunk_spheres_have_certain_points() {
    let mut runner = TestRunner::deterministic();
    let (mut certain, mut visible) = ([0; 2], [0; 2]);
    for _ in 0..200 {
        let mut scene = draw(&scene(0.0, 0.0), &mut runner);
        let height = draw(&(-0.9_f32..0.9), &mut runner);
        scene.spheres[0].centre.y = height * scene.spheres[0].radius;
        scene.planes[0].material.kr = 0.5;
        let bounds = Bounds::of(&scene);
        let (coverage, axes) = (&bounds.coverage, &bounds.coverage.axes);
        let number = bounds.number(|it| matches!(it, Outline::Image(id) if id.index() == 0));
        let Some(number) = number else { continue };
        let region = coverage.region(World { scene: &scene, prepared: &bounds.prepared }, number);
        let (eye, sphere) = (scene.camera.eye.as_dvec3(), &scene.spheres[0]);
        let is_met = |from: DVec3, ray: DVec3, length: f64| {
            let to = sphere.centre.as_dvec3() - from;
            let t = (to.dot(ray) / ray.length_squared()).clamp(0.0, length);
            (to - ray * t).length() < f64::from(sphere.radius)
        };
        for place in (0..SIZE[0] * SIZE[1]).step_by(7) {
            let (x, y) = (place % SIZE[0], place / SIZE[0]);
            let rect = axes.rect(rectangle(x, y, x + 1, y + 1));
            let [right, down, ahead] = axes.rows.map(Vec3A::as_dvec3);
            let d = right * f64::from(rect.x) + down * f64::from(rect.y) + ahead;
            let length = -eye.y / d.y;
            if length < 0.0 || is_met(eye, d, length) {
                continue;
            }
            let shows_image = is_met(eye + d * length, d.with_y(-d.y), f64::INFINITY);
            let is_certain = region.corners(rect) & 1 != 0;
            assert!(shows_image || !is_certain, "{sphere:?}");
            certain[usize::from(height > 0.0)] += usize::from(is_certain);
            visible[usize::from(height > 0.0)] += usize::from(shows_image);
        }
    }
    assert!(certain[1] * 100 > visible[1] * 99 && visible[1] > 1000, "{certain:?} of {visible:?}");
}

#[test]
fn small_shadows_have_small_bounds() {
    let mut runner = TestRunner::deterministic();
    let (mut met, mut tried) = (0, 0);
    for _ in 0..200 {
        let mut scene = draw(&scene(0.0, 0.0), &mut runner);
        scene.spheres[0].radius = 0.02;
        let bounds = Bounds::of(&scene);
        let (coverage, shadow) = (&bounds.coverage, bounds.number(is_shadow_of(0)));
        for y in (0..SIZE[1]).step_by(8) {
            for x in (0..SIZE[0]).step_by(8) {
                let rect = coverage.axes.rect(rectangle(x, y, x + 8, y + 8));
                met += usize::from(shadow.is_some_and(|i| coverage.screen[i].meets(rect)));
                tried += 1;
            }
        }
    }
    assert!(met * 100 < tried, "{met} of {tried}");
}

#[test]
fn planes_have_outlines_but_no_images() {
    let scene = Scene { planes: List::of(&[Plane::default(); 2]), ..Scene::default() };
    let coverage = Bounds::of(&scene).coverage;
    let outlines = &coverage.outlines[..coverage.outlined];
    for (number, outline) in outlines.iter().enumerate() {
        assert!(matches!(outline, Outline::Object(id) if id.index() == number));
    }
    assert_eq!(outlines.len(), 2);
}

/// A shadow is unseen in three cases: the plane is black; the solid is clear and the light has a
/// diameter; or the spotlight does not shine on the floor.
#[test]
fn unseen_shadows_are_not_listed() {
    let plain = draw(&scene(0.0, 0.0), &mut TestRunner::deterministic());
    let assert_listed = |is_listed: bool, what: &str, change: &dyn Fn(&mut Scene)| {
        let mut scene = plain.clone();
        change(&mut scene);
        assert_eq!(Bounds::of(&scene).number(is_shadow_of(0)).is_some(), is_listed, "{what}");
    };
    for (ks, is_listed) in [(0.0, false), (0.1, true)] {
        assert_listed(is_listed, "a black plane", &|scene| {
            scene.planes[0].material = Material { kr: 0.5, ks, ..Material::BLACK };
        });
    }
    for (tint, diameter, is_listed) in
        [(1.0, 0.5, false), (1.0, 0.0, true), (0.99, 0.5, true), (f32::NAN, 0.5, true)]
    {
        assert_listed(is_listed, "a clear solid", &|scene| {
            scene.spheres[0].material.tint = Vec3::new(1.0, tint, 1.0);
            scene.lights[0].diameter = diameter;
        });
    }
    let right_angle = core::f32::consts::FRAC_PI_2;
    for (aim, angle, is_listed) in [
        (Vec3::Y, right_angle - 0.01, false),
        (Vec3::Y, right_angle + 0.01, true),
        (Vec3::ONE, 0.6, false),
        (Vec3::ONE, 0.7, true),
        (Vec3::NEG_Y, 0.9, true),
        (Vec3::new(1.0, 2.5e-4, 0.0), 2.6e-4, true),
        (Vec3::new(1.0, 2.7e-4, 0.0), 2.6e-4, false),
    ] {
        assert_listed(is_listed, "a spotlight", &|scene| {
            let Light { position, colour, .. } = scene.lights[0];
            scene.lights[0] = Light::spotlight(position, aim, angle, colour);
        });
    }
}
