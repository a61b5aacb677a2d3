//! The result for a ray depends neither on its lane nor on the rays in the other lanes.

use super::scenes::{model, rich, rows};
use super::*;
use crate::quality::Quality;
use crate::scene::Spot;
use crate::trace::shade::shade;
use crate::trace::{Batch, Tracer};

/// The number of packets.
const PACKETS: usize = 20_000;

/// The bits of a ray's result: distance, object, contribution to its point, and secondary rays by path.
type Outcome = [u32; 2 + 4 + 2 * 7];

/// A ray: origin, direction and weight.
type Ray = (Vec3, Vec3, f32);

/// The results for the rays of a packet.
#[inline(always)]
fn outcomes<S: Isa>(
    simd: S,
    world: World<'_>,
    packet: &[Ray],
    batch: &mut Batch,
) -> [Outcome; MAX_LANES] {
    let row = |number: fn(&Ray) -> f32| F::<S>::from_fn(simd, |i| number(&packet[i]));
    let rays = Rays {
        o: Vec3x {
            x: row(|ray| ray.0.x),
            y: row(|ray| ray.0.y),
            z: row(|ray| ray.0.z),
        },
        d: Vec3x {
            x: row(|ray| ray.1.x),
            y: row(|ray| ray.1.y),
            z: row(|ray| ray.1.z),
        },
        weight: row(|ray| ray.2),
        slot_path: Rays::slot_paths(simd, 0),
    };
    let n = lanes::<S>();
    let hit = hits(simd, world, &rays);
    let tracer = Tracer {
        isa: simd,
        world,
        quality: &Quality::THESIS,
    };
    let node = shade(tracer, &rays, &hit, first(simd, n), batch);
    let mut sums = [[0; 4]; MAX_LANES];
    node.store(simd, &mut sums.as_flattened_mut()[..4 * n]);
    let mut all = [[0; 20]; MAX_LANES];
    for i in 0..n {
        all[i][0] = hit.t.as_slice()[i].to_bits();
        all[i][1] = hit.object.as_slice()[i];
        for (to, from) in all[i][2..6].iter_mut().zip(sums[i]) {
            *to = from as u32;
        }
    }
    while batch.stack.len() > 0 {
        let (rays, count) = batch.stack.pop(simd);
        let (paths, slots) = (rays.paths(), rays.slots());
        for i in 0..count {
            let start = 6 + 7 * (paths.as_slice()[i] as usize - 2);
            let (o, d) = (lane(rays.o, i), lane(rays.d, i));
            let numbers = [o.x, o.y, o.z, d.x, d.y, d.z, rays.weight.as_slice()[i]];
            let slot = slots.as_slice()[i] as usize;
            for (to, from) in all[slot][start..start + 7].iter_mut().zip(numbers) {
                *to = from.to_bits();
            }
        }
    }
    all
}

/// A random ray from around the scene towards a point in it.
fn ray(random: &mut Random) -> Ray {
    let mut place = |side: f64| {
        let mut number = || random.between(-side, side);
        DVec3::new(number(), number().abs(), number())
    };
    let (from, to) = (place(9.0), place(3.0));
    (
        from.as_vec3(),
        unit(to - from),
        random.between(0.005, 1.0) as f32,
    )
}

/// A random ray with invalid components.
fn nonsense(random: &mut Random) -> Ray {
    let mut bad = ray(random);
    let number = [
        f32::NAN,
        f32::INFINITY,
        f32::NEG_INFINITY,
        0.0,
        f32::MAX,
        1e-42,
    ][random.bits() as usize % 6];
    match random.bits() % 8 {
        0 => bad.0 = Vec3::splat(number),
        1 => bad.1 = Vec3::splat(number),
        2 => bad.2 = number,
        i => bad.0[i as usize % 3] = number,
    }
    if random.bits().is_multiple_of(2) {
        bad.1[random.bits() as usize % 3] = number;
    }
    bad
}

struct Neighbours {
    scene: Scene,
    packets: usize,
}

impl Property for Neighbours {
    #[inline(always)]
    fn hold<S: Isa>(&self, simd: S, isa: &str) {
        let mut random = Random::new(1966);
        let scene = prepared(&self.scene);
        let mut batch = Box::new(Batch::new());
        for _ in 0..self.packets / lanes::<S>() {
            let rays = [(); MAX_LANES].map(|()| ray(&mut random));
            let together = outcomes(simd, scene.world(), &rays[..lanes::<S>()], &mut batch);
            for (i, &one) in rays.iter().enumerate().take(lanes::<S>()) {
                let at = random.bits() as usize % lanes::<S>();
                let mut beside = [one; MAX_LANES];
                for other in &mut beside {
                    *other = match random.bits() % 3 {
                        0 => nonsense(&mut random),
                        1 => ray(&mut random),
                        _ => one,
                    };
                }
                beside[at] = one;
                let beside = outcomes(simd, scene.world(), &beside[..lanes::<S>()], &mut batch);
                assert_eq!(
                    together[i], beside[at],
                    "{isa}: {one:?} in lane {i} and in lane {at}"
                );
            }
        }
    }
}

#[test]
fn ray_depends_on_no_neighbour() {
    for scene in [model(), rows(300), rich()] {
        on_every_instruction_set(&Neighbours {
            scene,
            packets: PACKETS,
        });
    }
}

#[test]
fn ray_depends_on_no_neighbour_in_an_invalid_scene() {
    fn spot(scene: &mut Scene) -> &mut Spot {
        scene.lights[1].spot.get_or_insert_default()
    }
    let places: [fn(&mut Scene) -> &mut f32; 16] = [
        |scene| &mut scene.spheres[0].centre.x,
        |scene| &mut scene.spheres[1].radius,
        |scene| &mut scene.blocks[0].centre.y,
        |scene| &mut scene.blocks[0].half.x,
        |scene| &mut scene.blocks[1].half.x,
        |scene| &mut scene.blocks[0].axes.x_axis.x,
        |scene| &mut scene.blocks[1].axes.y_axis.y,
        |scene| &mut scene.planes[0].material.pattern.waves.x,
        |scene| &mut scene.water.slope,
        |scene| &mut scene.water.phase,
        |scene| &mut scene.lights[0].position.z,
        |scene| &mut scene.lights[0].diameter,
        |scene| &mut spot(scene).aim.y,
        |scene| &mut spot(scene).outer_angle,
        |scene| &mut spot(scene).inner_angle,
        |scene| &mut scene.haze,
    ];
    let numbers = [f32::NAN, f32::INFINITY, f32::NEG_INFINITY, f32::MAX];
    for place in places {
        for number in numbers.into_iter().chain([1e20, 1e-40, 0.0, -1.0]) {
            let mut scene = rich();
            *place(&mut scene) = number;
            on_every_instruction_set(&Neighbours {
                scene,
                packets: PACKETS / 20,
            });
        }
    }
}
