//! Boxes, cylinders and capsules of any size and position are hit where they are, and rays that leave them do not hit them again.

use super::*;
use crate::scene::{Block, Shape};
use glam::{Mat3, Quat, Vec3};

const BLOCKS: usize = 2000;
/// The number of rays that leave each hit.
const RAYS: usize = 64;

/// A random block, and its largest coordinate, which determines rounding errors.
fn block(random: &mut Random) -> (Block, f64) {
    // Not so thin or so far away that rounding moves a point from one side to another.
    let scale = 10_f64.powf(random.between(-3.0, 3.0));
    let mut length = || (scale * 10_f64.powf(random.between(-1.0, 1.0))) as f32;
    let (x, y, z) = (length(), length(), length());
    let shape = [Shape::Box, Shape::Cylinder, Shape::Capsule][random.bits() as usize % 3];
    let centre = (scale * random.vector(-3.0, 1.5)).as_vec3();
    let [a, b, c] = random.direction().as_vec3().to_array();
    let turn = Quat::from_xyzw(a, b, c, random.between(-1.0, 1.0) as f32);
    let block = Block {
        centre,
        half: fitting(shape, Vec3::new(x, y, z)),
        axes: Mat3::from_quat(turn.normalize()),
        shape,
        ..Block::default()
    };
    let largest = (centre.abs() + block.half).max_element();
    (block, f64::from(largest))
}

/// A block's extent that fits its shape.
fn fitting(shape: Shape, half: Vec3) -> Vec3 {
    match shape {
        Shape::Box => half,
        Shape::Cylinder => half.with_z(half.x),
        Shape::Capsule => Vec3::new(half.x, half.y.max(half.x), half.x),
    }
}

/// The distance of a point from the nearest side; negative inside.
fn outside(block: &Block, p: Vec3) -> f64 {
    let axes = block.axes.as_dmat3();
    let own = axes.transpose() * (p.as_dvec3() - block.centre.as_dvec3());
    let half = block.half.as_dvec3();
    let mut out = own.abs() - half;
    match block.shape {
        Shape::Box => {}
        Shape::Cylinder => {
            out.x = own.x.hypot(own.z) - half.x;
            out.z = out.x;
        }
        Shape::Capsule => {
            let core = half.y - half.x;
            let way = own.with_y(own.y - own.y.clamp(-core, core));
            out = DVec3::splat(way.length() - half.x);
        }
    }
    out.max_element()
}

struct Blocks;

impl Property for Blocks {
    #[inline(always)]
    fn hold<S: Isa>(&self, simd: S, isa: &str) {
        let mut random = Random::new(1998);
        let (mut hits, mut left, mut crossed) = (0, 0, 0);
        for _ in 0..BLOCKS {
            let (block, largest) = block(&mut random);
            let scene = Scene {
                blocks: List::of(&[block]),
                ..Scene::default()
            };
            let scene = prepared(&scene);
            let half = block.half.as_dvec3();
            let mut part = || random.between(-1.0, 1.0);
            let within = DVec3::new(part(), part(), part()) * half;
            let aim = block.centre.as_dvec3() + block.axes.as_dmat3() * within;
            let o = (aim + random.direction() * (2.0 * half.length())).as_vec3();
            let d = unit(aim - o.as_dvec3());
            let rays = packet(simd, o, &[d]);
            let hit = super::hits(simd, scene.world(), &rays);
            if hit.object.as_slice()[0] != 0 {
                continue;
            }
            let point = shading_point(simd, scene.world(), &rays, &hit);
            hits += 1;
            let what = std::format!("{isa}: {block:?} from {o} along {d}");
            let (p, n) = (lane(point.p, 0), lane(point.n, 0));
            let hit_error = point.hit_error.as_slice()[0];
            let error = f64::from(hit_error);
            let off = outside(&block, p) - error;
            assert!(
                off.abs() < 0.5 * error,
                "{what}: {p} is {off} off, {largest}"
            );
            assert!((n.length() - 1.0).abs() < 1e-5, "{what}: {n}");
            // Those that leave, and those that go on inside from as far below the surface.
            for is_leaving in [true, false] {
                let from = if is_leaving {
                    p
                } else {
                    p - 2.0 * hit_error * n
                };
                for _ in 0..RAYS / lanes::<S>() {
                    let side = if is_leaving { n } else { -n };
                    let ways = [(); MAX_LANES].map(|()| random.direction_from(side));
                    let next = super::hits(simd, scene.world(), &packet(simd, from, &ways));
                    for (i, way) in ways.iter().enumerate().take(lanes::<S>()) {
                        let is_hit = next.object.as_slice()[i] == 0;
                        if is_leaving {
                            assert!(!is_hit, "{what}: {p} is hit again along {way}");
                            left += 1;
                        } else if outside(&block, from) < -0.5 * error {
                            assert!(is_hit, "{what}: {way} from {from} leaks");
                            crossed += 1;
                        }
                    }
                }
            }
        }
        assert!(hits > BLOCKS / 2, "{isa}: {hits} hits");
        assert!(
            left > hits * RAYS / 2 && crossed > hits * RAYS / 4,
            "{isa}: {crossed}"
        );
    }
}

#[test]
fn rays_that_leave_a_block_do_not_hit_it_again_and_those_inside_do_not_leak() {
    on_every_instruction_set(&Blocks);
}

/// The number of rays that leave each hit of rays from far away.
const MANY_RAYS: usize = 1000;

/// Aligned boxes, rotated boxes, cylinders and capsules at the origin, hit by rays from any distance.
struct FarBlocks;

impl Property for FarBlocks {
    #[inline(always)]
    fn hold<S: Isa>(&self, simd: S, isa: &str) {
        let mut random = Random::new(2008);
        let mut left = [0; 4];
        for i in 0..BLOCKS {
            let kind = i % 4;
            let (any, _) = block(&mut random);
            let mut length = || 10_f64.powf(random.between(-4.0, 4.0)) as f32;
            let half = Vec3::new(length(), length(), length());
            let shape = [Shape::Box, Shape::Box, Shape::Cylinder, Shape::Capsule][kind];
            let block = Block {
                centre: Vec3::ZERO,
                half: fitting(shape, half),
                axes: if kind == 0 { Mat3::IDENTITY } else { any.axes },
                shape,
                ..any
            };
            let scene = prepared(&Scene {
                blocks: List::of(&[block]),
                ..Scene::default()
            });
            let mut part = || random.between(-1.0, 1.0);
            let within = DVec3::new(part(), part(), part()) * block.half.as_dvec3();
            let aim = block.axes.as_dmat3() * within;
            let o = random.vector(-8.0, 8.0).as_vec3();
            let d = unit(aim - o.as_dvec3());
            let rays = packet(simd, o, &[d]);
            let hit = hits(simd, scene.world(), &rays);
            let point = shading_point(simd, scene.world(), &rays, &hit);
            let (p, n) = (lane(point.p, 0), lane(point.n, 0));
            if hit.object.as_slice()[0] != 0 || point.inside.to_bitmask() & 1 == 1 {
                continue;
            }
            for _ in 0..MANY_RAYS / lanes::<S>() {
                let ways = [(); MAX_LANES].map(|()| random.direction_from(n));
                let next = hits(simd, scene.world(), &packet(simd, p, &ways));
                for (i, way) in ways.iter().enumerate().take(lanes::<S>()) {
                    let is_hit = next.object.as_slice()[i] == 0;
                    assert!(
                        !is_hit,
                        "{isa}: {block:?} from {o} along {d}: {p} is hit again along {way}"
                    );
                    left[kind] += 1;
                }
            }
        }
        let fewest = BLOCKS / 4 * MANY_RAYS / 8;
        assert!(left.iter().all(|&left| left > fewest), "{isa}: {left:?}");
    }
}

#[test]
fn rays_that_leave_a_block_do_not_hit_it_again_however_far_they_came() {
    on_every_instruction_set(&FarBlocks);
}

#[test]
fn what_is_round_is_its_end_seen_along_its_axis() {
    struct End<'a>(World<'a>, [(f32, f32); 4]);
    impl Property for End<'_> {
        #[inline(always)]
        fn hold<S: Isa>(&self, simd: S, isa: &str) {
            for (x, t) in self.1 {
                let rays = packet(simd, Vec3::new(x, 0.0, -3.0), &[Vec3::Z]);
                let hit = hits(simd, self.0, &rays);
                assert!((hit.t.as_slice()[0] - t).abs() <= 1e-5 * t, "{isa}: {x}");
            }
        }
    }
    for (shape, ends) in [
        (
            Shape::Cylinder,
            [(0.0, 1.0), (0.9, 1.0), (-0.999, 1.0), (1.001, 1e30)],
        ),
        (
            Shape::Capsule,
            [(0.0, 1.0), (0.6, 1.2), (-0.8, 1.4), (1.001, 1e30)],
        ),
    ] {
        let scene = prepared(&Scene {
            blocks: List::of(&[Block {
                half: Vec3::new(1.0, 2.0, 1.0),
                axes: Mat3::from_cols(Vec3::X, Vec3::Z, Vec3::NEG_Y),
                shape,
                ..Block::default()
            }]),
            ..Scene::default()
        });
        on_every_instruction_set(&End(scene.world(), ends));
    }
}
