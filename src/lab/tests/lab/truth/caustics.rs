//! Light by way of mirrors and glass: what it gives is known in closed form, or by all directions one after another.

use super::{ROUNDING, WHITE, assert_near, drawn, seen};
use eightfold_lab::arguments::Size;
use eightfold_lab::truth::effects::Effects;
use eightfold_lab::truth::estimate::Estimate;
use eightfold_tracer::glam::{DVec3, Mat3A, Vec3A, dvec3, vec3a};
use eightfold_tracer::scene::{Block, Camera, Light, List, Material, Plane, Scene, Shape, Sphere};
use std::f64::consts::{PI, TAU};

/// Light that comes to a surface from lamps, and no other.
pub const OF_LAMPS: Effects = Effects {
    indirect: false,
    ..Effects::TRUTH
};
const SIZE: Size = Size::new(21, 21);
pub const MIRROR: Material = Material::mirror(0.9);
const LAMP: DVec3 = dvec3(2.0, 2.0, 0.3);

fn lamp(size: f32) -> Light {
    Light {
        diameter: size,
        ..Light::new(LAMP.as_vec3a(), Vec3A::ONE)
    }
}

/// The half side of a plate, and the height of its lower side, above a mirror at 0.
pub const HALF: f64 = 0.15;
const HEIGHT: f64 = 0.6;

/// A plate above a mirror, seen from below to its edges.
pub fn plate(mirror: Material, size: f32) -> Scene {
    let half = vec3a(HALF as f32, 0.01, HALF as f32);
    Scene {
        camera: Camera {
            eye: vec3a(0.0, 0.05, 0.0),
            look_at: vec3a(0.0, HEIGHT as f32, 0.0),
            up: Vec3A::Z,
            field_of_view: 2.0 * (HALF as f32 / (HEIGHT as f32 - 0.05)).atan(),
        },
        planes: List::of(&[Plane::new(Vec3A::ZERO, 2.5, 2.5, mirror)]),
        blocks: List::of(&[Block::new(
            Shape::Box,
            vec3a(0.0, HEIGHT as f32 + half.y, 0.0),
            half,
            Material { kd: 0.5, ..WHITE },
        )]),
        lights: List::of(&[lamp(size)]),
        ..Scene::default()
    }
}

/// The place of the plate that a pixel shows.
fn place(i: usize) -> DVec3 {
    let at = |i: usize| HALF * ((2 * i + 1) as f64 / SIZE.width as f64 - 1.0);
    dvec3(at(i % SIZE.width), HEIGHT, -at(i / SIZE.width))
}

/// Asserts that the intervals of pixels hold what is known of them as often as they say, and that means over the middle, the edges
/// and the corners are right.
#[track_caller]
fn assert_covers(all: &[Estimate], known: impl Fn(usize) -> f64) {
    let last = SIZE.width - 1;
    let is_at_edge = |at: usize| usize::from(at == 0 || at == last);
    let (mut held, mut sums) = (0, [[0.0; 3]; 3]);
    for (i, estimate) in all.iter().enumerate() {
        let off = (estimate.mean.x - known(i)).abs();
        held += usize::from(off <= estimate.half_interval().x + ROUNDING);
        let edges = is_at_edge(i % SIZE.width) + is_at_edge(i / SIZE.width);
        let [mean, right, variance] = &mut sums[edges];
        *mean += estimate.mean.x;
        *right += known(i);
        *variance += estimate.variance.x;
    }
    let share = held as f64 / all.len() as f64;
    assert!(share > 0.9, "{share} of the intervals hold the truth");
    for [mean, right, variance] in sums {
        let error = variance.sqrt() / right;
        let off = mean / right - 1.0;
        assert!(error < 0.01, "{error} is too much noise");
        assert!(off.abs() <= 4.0 * error + ROUNDING, "{off}, {error}");
    }
}

#[test]
fn a_plate_above_a_mirror_is_lit_by_the_lamp_below_to_its_corners() {
    let image = LAMP * dvec3(1.0, -1.0, 1.0);
    let known = |i: usize| {
        let to_image = image - place(i);
        0.5 * 0.9 * -to_image.y / to_image.length()
    };
    for size in [0.0, 0.2, 1.0] {
        assert_covers(&drawn(&plate(MIRROR, size), SIZE, OF_LAMPS, 64), known);
    }
    // What is mirrored more at grazing angles is a mirror, too.
    let grazing = Material {
        fresnel: 0.8,
        ..Material::BLACK
    };
    let shares = |i: usize| {
        let to_image = (image - place(i)).normalize();
        0.5 * 0.8 * (1.0 + to_image.y).powi(5) * -to_image.y
    };
    assert_covers(&drawn(&plate(grazing, 0.0), SIZE, OF_LAMPS, 64), shares);
}

#[test]
fn two_mirrors_show_a_lamp_as_their_images_do() {
    // A second mirror, upright, at x = -2: by either, and by both.
    let mut scene = plate(MIRROR, 0.3);
    scene.blocks.push(Block::new(
        Shape::Box,
        vec3a(-2.5, 0.0, 0.0),
        vec3a(0.5, 9.0, 9.0),
        Material::mirror(0.6),
    ));
    let known = |i: usize| {
        let by = |image: DVec3, share: f64| {
            let to_image = image - place(i);
            share * 0.5 * (-to_image.y / to_image.length()).max(0.0)
        };
        let aside = -4.0 - LAMP.x;
        by(LAMP * dvec3(1.0, -1.0, 1.0), 0.9)
            + by(LAMP.with_x(aside), 0.6)
            + by(dvec3(aside, -LAMP.y, LAMP.z), 0.9 * 0.6)
    };
    assert_covers(&drawn(&scene, SIZE, OF_LAMPS, 128), known);
}

/// A sphere at the origin between the lamp and a small black plate's place, which is seen from beside the sphere.
fn ball(material: Material, size: f32, p: DVec3, n: DVec3) -> Scene {
    let (p, n) = (p.as_vec3a(), n.as_vec3a());
    Scene {
        camera: Camera {
            up: n.any_orthonormal_vector(),
            ..Camera::new(p + 0.001 * n, p, 0.001)
        },
        spheres: List::of(&[Sphere::new(Vec3A::ZERO, 0.5, material)]),
        blocks: List::of(&[Block {
            axes: Mat3A::from_cols(n, n.any_orthonormal_pair().0, n.any_orthonormal_pair().1),
            ..Block::new(Shape::Box, p - 0.002 * n, Vec3A::splat(0.002), WHITE)
        }]),
        lights: List::of(&[lamp(size)]),
        ..Scene::default()
    }
}

pub const GLASS: Material = Material {
    kr: 0.05,
    kt: 0.85,
    index: 1.5,
    ..Material::BLACK
};

/// The light of the lamp by way of the ball, by a grid of directions about the ball.
fn by_directions(material: &Material, size: f64, p: DVec3, n: DVec3) -> f64 {
    const RINGS: usize = 1000;
    let (axis, radius, lamp_radius) = (-p.normalize(), 0.5, 0.5 * size);
    let (u, v) = axis.any_orthonormal_pair();
    let least = (1.0 - (radius / p.length()).powi(2)).sqrt();
    let index = f64::from(material.index);
    let mut sum = 0.0;
    for i in 0..RINGS * RINGS {
        let cosine = 1.0 - (1.0 - least) * ((i / RINGS) as f64 + 0.5) / RINGS as f64;
        let angle = TAU * ((i % RINGS) as f64 + 0.5) / RINGS as f64;
        let sine = (1.0 - cosine * cosine).sqrt();
        let d = cosine * axis + sine * (angle.cos() * u + angle.sin() * v);
        if d.dot(n) <= 0.0 {
            continue;
        }
        let middle = -p.dot(d);
        let first = middle - (radius * radius - (p + middle * d).length_squared()).sqrt();
        let normal = (p + first * d) / radius;
        let incident = -d.dot(normal);
        let mut share = f64::from(material.kr);
        let (mut o, mut along, mut way) = (p + first * d, d.reflect(normal), first);
        if material.kt > 0.0 {
            // Unpolarised light at both surfaces, at equal angles.
            let refracted = d.refract(normal, 1.0 / index);
            let behind = -refracted.dot(normal);
            let across = (incident - index * behind) / (incident + index * behind);
            let within = (index * incident - behind) / (index * incident + behind);
            let through = 1.0 - 0.5 * (across * across + within * within);
            share = (share + f64::from(material.kt)) * through;
            share *= share;
            let chord = 2.0 * radius * behind;
            o += chord * refracted;
            along = refracted.refract(-o / radius, index);
            way += chord;
        }
        let to_lamp = LAMP - o;
        let nearest = to_lamp.dot(along);
        let off = (to_lamp - nearest * along).length();
        if nearest > 0.0 && off < lamp_radius {
            // From where the point would be if the way were straight.
            let distance = (to_lamp + way * along).length();
            sum += share * d.dot(n) * (distance / lamp_radius).powi(2);
        }
    }
    sum * TAU * (1.0 - least) / (RINGS * RINGS) as f64 / PI
}

#[test]
fn a_ball_lights_a_point_as_all_directions_to_it_do() {
    // By a mirror, in front of the lamp; by glass, behind which nothing else of the lamp is seen.
    let behind = -LAMP.normalize();
    for (material, p) in [
        (MIRROR, dvec3(0.8, 0.2, -0.4)),
        (MIRROR, dvec3(0.9, 0.7, 0.3)),
        (MIRROR, dvec3(0.2, 1.1, -0.5)),
        (GLASS, behind),
        (GLASS, 1.5 * behind + dvec3(0.02, 0.1, 0.1)),
    ] {
        let n = -p.normalize();
        let known = by_directions(&material, 1.4, p, n);
        assert!(known > 0.005, "{known}");
        // Glass has photons, too, which take longer.
        let (paths, most) = if material.kt > 0.0 {
            (256, 0.15)
        } else {
            (4096, 0.02)
        };
        let found = seen(&ball(material, 1.4, p, n), OF_LAMPS, paths);
        assert_near(found, DVec3::splat(known), most * known);
    }
}
