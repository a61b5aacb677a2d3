//! A ray does not hit the convex solid that it leaves, at any scale: a lone mirror in a bright scene has no dark pixel, and a clear
//! solid is entered and left once.

use crate::cpu;
use crate::drawn::{draw, draw_by_all};
use eightfold_scenes::{Random, cases, known, solids};
use eightfold_tracer::Quality;
use eightfold_tracer::glam::Vec3;
use eightfold_tracer::scene::{Camera, List, Material, Scene, Sphere};

const MIRROR: Material = Material { kr: 0.8, ..Material::BLACK };
const CLEAR: Material = Material { kt: 1.0, index: 1.0, ..Material::BLACK };

/// Returns a block, or in a quarter of the scenes a sphere.
fn lone(random: &mut Random, decades: f32, material: Material) -> Scene {
    let half = Vec3::splat(1.0).map(|_| random.power(-1.5, 0.0));
    let scale = random.power(-decades, decades);
    let centre = scale * random.vector(Vec3::splat(-8.0), Vec3::splat(8.0));
    let block = solids::block(random, centre, scale * half, material);
    let away = random.turn() * Vec3::Z * scale * random.between(3.0, 30.0);
    let eye = centre + away;
    let angle = block.half.length() / away.length();
    let mut scene = Scene {
        camera: Camera::new(eye, centre, angle),
        background: Vec3::ONE,
        ..Scene::default()
    };
    if random.below(4) == 0 {
        scene.spheres.push(Sphere::new(centre, block.half.length(), material));
    } else {
        scene.blocks.push(block);
    }
    scene
}

/// Returns a mirror whose points have the rounding errors of a place up to 1,000 radii from the origin.
fn far_ball(random: &mut Random) -> Scene {
    let radius = random.power(-4.0, 4.0);
    let centre = random.turn() * Vec3::X * (radius * random.power(0.0, 3.0));
    let away = random.turn() * Vec3::Z * (radius * random.between(1.01, 30.0));
    Scene {
        camera: Camera::new(centre + away, centre, (2.5 * radius / away.length()).min(2.0)),
        background: Vec3::ONE,
        spheres: List::of(&[Sphere::new(centre, radius, MIRROR)]),
        ..Scene::default()
    }
}

#[test]
fn mirrors_never_show_themselves() {
    let known = known("mirror box").into_iter().map(|view| view.scene);
    let mut shown = 0;
    for scene in known
        .chain(cases(30).map(|mut random| lone(&mut random, 4.0, MIRROR)))
        .chain(cases(15).map(|mut random| far_ball(&mut random)))
    {
        for (isa, drawn) in draw_by_all(&scene, &Quality::EXHAUSTIVE, 640, 360) {
            for (i, pixel) in drawn.pixels.into_iter().enumerate() {
                let is_mirror = pixel == 0xcc_cccc;
                assert!(
                    is_mirror || pixel == 0xff_ffff,
                    "{}: pixel {i} is {pixel:06x}: {scene:?}",
                    isa.name
                );
                shown += usize::from(is_mirror);
            }
        }
    }
    println!("{shown} pixels");
    let isas = cpu::instruction_sets().count();
    assert!(shown >= 5_000_000 * isas, "{shown}");
}

/// Without a least contribution, each hit traces a reflected and a transmitted ray. All rays inside hit the solid, and no other.
#[test]
fn clear_solid_is_entered_and_left_once() {
    for mut random in cases(50) {
        let clear = Scene { black_beyond: true, ..lone(&mut random, 4.0, CLEAR) };
        for isa in cpu::instruction_sets() {
            let [first, all] = [1, Quality::MAX_DEPTH].map(|depth| {
                let quality = Quality { depth, least_contribution: 0.0, ..Quality::EXHAUSTIVE };
                draw(isa, 2, &clear, &quality, 160, 90)
            });
            let [once, always] = [&first, &all].map(|it| it.counts.rays - it.counts.points);
            let what = format!("case {} by {}", random.seed, isa.name);
            assert_eq!(always, u64::from(Quality::MAX_DEPTH) * once, "{what}");
            assert!(once > 1000 && all.pixels.iter().all(|&pixel| pixel == 0xff_ffff), "{what}");
        }
    }
}
