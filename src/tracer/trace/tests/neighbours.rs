//! The result of a ray depends neither on its lane nor on the other rays of its packet.

use super::scenes::{model, rich, rows};
use super::*;

const PACKETS: usize = 20_000;

/// The bits of a ray's result: distance, object, contribution to its point, and secondary rays.
type Outcome = (u32, u32, Sum, [Option<[u32; 7]>; 2]);

fn outcomes(
    by: &dyn Kernels,
    world: World<'_>,
    packet: &Packet,
    batch: &mut Batch,
) -> [Outcome; MAX_LANES] {
    let bits = |(o, d, weight): Ray| [o.x, o.y, o.z, d.x, d.y, d.z, weight].map(f32::to_bits);
    let shaded = by.shaded(world, &Quality::THESIS, packet, batch);
    shaded.map(|lane| {
        let secondary = lane.secondary.map(|ray| ray.map(bits));
        (lane.t.to_bits(), lane.object, lane.sum, secondary)
    })
}

/// Returns a random ray from around the scene towards a point in it.
fn ray(random: &mut Random) -> Ray {
    let mut place = |side: f64| {
        let mut number = || random.between(-side, side);
        DVec3::new(number(), number().abs(), number())
    };
    let (from, to) = (place(9.0), place(3.0));
    let weight = random.between(0.005, 1.0) as f32;
    (from.as_vec3(), unit(to - from), weight)
}

fn nonsense(random: &mut Random) -> Ray {
    let mut bad = ray(random);
    let (nan, infinity) = (f32::NAN, f32::INFINITY);
    let numbers = [nan, infinity, -infinity, 0.0, f32::MAX, 1e-42];
    let number = numbers[random.bits() as usize % 6];
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

fn assert_independent(by: &dyn Kernels, isa: &str, scene: &Scene) {
    let mut random = Random::new(1966);
    let scene = prepared(scene);
    let mut batch = Box::new(Batch::new());
    for _ in 0..PACKETS / by.lanes() {
        let rays = [(); MAX_LANES].map(|()| ray(&mut random));
        let together = outcomes(by, scene.world(), &rays, &mut batch);
        for (i, &one) in rays.iter().enumerate().take(by.lanes()) {
            let at = random.bits() as usize % by.lanes();
            let mut others = [one; MAX_LANES];
            for other in &mut others {
                *other = match random.bits() % 3 {
                    0 => nonsense(&mut random),
                    1 => ray(&mut random),
                    _ => one,
                };
            }
            others[at] = one;
            let others = outcomes(by, scene.world(), &others, &mut batch);
            assert_eq!(together[i], others[at], "{isa}: {one:?} in lane {i} and in lane {at}");
        }
    }
}

/// `tests/image/soak.rs` corrupts the other numbers of scenes.
#[test]
fn ray_is_independent_of_its_packet() {
    let wrong = [f32::NAN, f32::INFINITY, f32::MAX, 1e-40].map(|number| {
        let mut scene = rich();
        scene.blocks[0].axes.x_axis.x = number;
        scene.blocks[1].axes.y_axis.y = number;
        scene
    });
    for scene in [model(), rows(300), rich()].iter().chain(&wrong) {
        on_every_instruction_set(|by, isa| assert_independent(by, isa, scene));
    }
}
