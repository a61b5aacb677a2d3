//! Rays that leave a surface of any size and position do not hit it again (after
//! `TestReintersectConvex` of pbrt).

use super::*;
use crate::scene::{Block, Shape};
use crate::trace::rays::INWARD;
use glam::{Mat3, Quat, Vec3};

const SHAPES: usize = 4000;
const BLOCKS: usize = 2000;
const RAYS: usize = 1000;

fn met(by: &dyn Kernels, world: World<'_>, o: Vec3, d: Vec3) -> Option<Met> {
    let [met, ..] = by.meets(world, &packet(o, &[d]));
    (met.object == 0).then_some(met)
}

fn each_ray(
    by: &dyn Kernels,
    world: World<'_>,
    (from, departure): (Vec3, u32),
    count: usize,
    mut direction: impl FnMut() -> Vec3,
    mut check: impl FnMut(Vec3, Option<f64>),
) {
    for _ in 0..count / by.lanes() {
        let directions = [(); MAX_LANES].map(|()| direction());
        let hits = by.hits(world, &packet(from, &directions), departure);
        for (&d, (t, object)) in directions.iter().zip(hits).take(by.lanes()) {
            check(d, (object == 0).then(|| f64::from(t)));
        }
    }
}

fn share(random: &mut Random) -> DVec3 {
    let mut part = || random.between(-1.0, 1.0);
    DVec3::new(part(), part(), part())
}

/// `max` is the decimal logarithm of the largest coordinate; `None` for the origin.
fn assert_spheres_are_left(by: &dyn Kernels, isa: &str, max: Option<f64>) {
    let mut random = Random(2008);
    let (mut count, mut left, mut entered) = (0, 0, 0);
    while count < SHAPES {
        let radius = 10_f64.powf(random.between(-4.0, 4.0));
        let centre = max.map_or(DVec3::ZERO, |max| random.vector(-4.0, max));
        let centre = centre.as_vec3();
        let o = random.vector(-8.0, 8.0);
        let aim = centre.as_dvec3() + radius * share(&mut random);
        let (o, d) = (o.as_vec3(), unit(aim - o));
        let scene = prepared(&one_sphere(centre, radius as f32, Material::default()));
        let world = scene.world();
        let Some(met) = met(by, world, o, d) else {
            count += usize::from(random.bits().is_multiple_of(8));
            continue;
        };
        count += 1;
        let p = met.p;
        let outward = if met.is_inside { -met.n } else { met.n }.as_dvec3();
        let what = std::format!("{isa}: radius {radius} at {centre}, from {o} along {d}");
        // Two roundings of the largest coordinate: about the error of the hit.
        let largest = f64::from(centre.abs().max_element()) + radius;
        let off = f64::from(f32::EPSILON) * largest;
        let direction = || random.direction().as_vec3();
        each_ray(by, world, (p, 0), RAYS, direction, |d, t| {
            let cosine = d.as_dvec3().dot(outward);
            let chord = -2.0 * cosine * radius;
            if cosine >= 0.0 {
                assert!(t.is_none(), "{what}: {p} is hit again along {d}");
                left += 1;
            } else if chord * chord > 64.0 * off * radius {
                // The chord is longer than rounding errors.
                let max = 4.0 * off * (1.0 + 2.0 * radius / chord);
                let is_right = t.is_some_and(|t| (t - chord).abs() < max);
                assert!(is_right, "{what}: {d} from {p} goes {t:?} of {chord}");
                entered += 1;
            }
        });
    }
    assert!(left > SHAPES * RAYS / 8, "{isa}: {left} rays");
    assert!(entered > SHAPES * RAYS / 32, "{isa}: {entered} rays");
}

#[test]
fn sphere_is_not_hit_by_leaving_rays() {
    for max in [None, Some(4.0)] {
        on_every_instruction_set(|by, isa| assert_spheres_are_left(by, isa, max));
    }
}

fn fitting(shape: Shape, half: DVec3) -> Vec3 {
    let Vec3 { x, y, .. } = half.as_vec3();
    match shape {
        Shape::Box => half.as_vec3(),
        Shape::Cylinder => Vec3::new(x, y, x),
        Shape::Capsule => Vec3::new(x, y.max(x), x),
    }
}

/// Negative inside.
fn outside(block: &Block, p: Vec3) -> f64 {
    let axes = block.axes.as_dmat3();
    let own = axes.transpose() * (p.as_dvec3() - block.centre.as_dvec3());
    let half = block.half.as_dvec3();
    let out = own.abs() - half;
    match block.shape {
        Shape::Box => out.max_element(),
        Shape::Cylinder => out.y.max(own.x.hypot(own.z) - half.x),
        Shape::Capsule => {
            let core = half.y - half.x;
            let from_core = own.with_y(own.y - own.y.clamp(-core, core));
            from_core.length() - half.x
        }
    }
}

/// Tests compact blocks anywhere, hit from nearby, or any blocks at the origin, hit from any
/// distance.
fn assert_blocks_are_left(by: &dyn Kernels, isa: &str, is_far: bool) {
    let mut random = Random(1998);
    // Aligned boxes, turned boxes, cylinders and capsules.
    let (mut left, mut crossed) = ([0; 4], 0);
    for i in 0..BLOCKS {
        let kind = i % 4;
        // Rounding must not move a point from one side to another.
        let scale = 10_f64.powf(random.between(-3.0, 3.0));
        let (decades, scale, centre) = match is_far {
            true => (4.0, 1.0, DVec3::ZERO),
            false => (1.0, scale, scale * random.vector(-3.0, 1.5)),
        };
        let half = share(&mut random).map(|share| scale * 10_f64.powf(decades * share));
        let shape = [Shape::Box, Shape::Box, Shape::Cylinder, Shape::Capsule][kind];
        let [a, b, c] = random.direction().as_vec3().to_array();
        let turn = Quat::from_xyzw(a, b, c, random.between(-1.0, 1.0) as f32);
        let turn = [Quat::IDENTITY, turn.normalize()][usize::from(kind > 0)];
        let block = Block {
            centre: centre.as_vec3(),
            half: fitting(shape, half),
            axes: Mat3::from_quat(turn),
            shape,
            ..Block::default()
        };
        let scene = prepared(&Scene { blocks: List::of(&[block]), ..Scene::default() });
        let world = scene.world();
        let half = block.half.as_dvec3();
        let within = block.axes.as_dmat3() * (share(&mut random) * half);
        let aim = block.centre.as_dvec3() + within;
        let o = match is_far {
            true => random.vector(-8.0, 8.0),
            false => aim + random.direction() * (2.0 * half.length()),
        };
        let (o, d) = (o.as_vec3(), unit(aim - o));
        let Some(met) = met(by, world, o, d).filter(|met| !met.is_inside) else { continue };
        let (p, n, error, departure) = (met.p, met.n, met.error, met.departure);
        let what = std::format!("{isa}: {block:?} from {o} along {d}");
        let direction = || random.direction_from(n);
        each_ray(by, world, (p, departure), RAYS, direction, |d, t| {
            assert!(t.is_none(), "{what}: {p} is hit again along {d}");
            left[kind] += 1;
        });
        if is_far {
            continue;
        }
        for (point, errors) in [(o + met.t * d, 0.0), (p, 1.0)] {
            let off = outside(&block, point) / f64::from(error);
            let is_near = (off - errors).abs() < 0.5;
            assert!(is_near, "{what}: {point} is {off} errors off");
        }
        assert!((n.length() - 1.0).abs() < 1e-5, "{what}: {n}");
        let direction = || random.direction_from(-n);
        let from = (p - 2.0 * error * n, departure | INWARD);
        each_ray(by, world, from, RAYS / 16, direction, |d, t| {
            assert!(t.is_some(), "{what}: {d} from {p} leaks");
            crossed += 1;
        });
    }
    let fewest = BLOCKS / 4 * RAYS / 8;
    assert!(left.iter().all(|&left| left > fewest), "{isa}: {left:?}");
    assert!(is_far || crossed > BLOCKS * RAYS / 128, "{isa}: {crossed}");
}

#[test]
fn block_is_not_hit_by_leaving_rays_and_never_leaks() {
    for is_far in [false, true] {
        on_every_instruction_set(|by, isa| assert_blocks_are_left(by, isa, is_far));
    }
}
