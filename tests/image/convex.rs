use crate::cpu;
use crate::drawn::{draw, draw_by_all};
use eightfold_scenes::{Random, cases, known, solids};
use eightfold_tracer::Quality;
use eightfold_tracer::glam::Vec3;
use eightfold_tracer::scene::{Camera, Material, Scene, Sphere};

const MIRROR: Material = Material { kr: 0.8, ..Material::BLACK };
const CLEAR: Material = Material { kt: 1.0, index: 1.0, ..Material::BLACK };

/// Returns a scene of one solid: a block near the origin, or a sphere at up to 1,000 radii from the
/// origin. The distance enlarges rounding errors.
fn lone(random: &mut Random, material: Material) -> Scene {
    let scale = random.power(-4.0, 4.0);
    let (far, half) = (random.power(0.0, 3.0), Vec3::ONE.map(|_| random.power(-1.5, 0.0)));
    let centre = scale * random.vector(Vec3::splat(-8.0), Vec3::splat(8.0));
    let block = solids::block(random, centre, scale * half, material);
    let away = random.turn() * Vec3::Z * scale;
    let mut scene = Scene { background: Vec3::ONE, ..Scene::default() };
    if random.below(2) == 0 {
        let (centre, away) = (centre.normalize() * scale * far, away * random.between(1.01, 30.0));
        let angle = (2.5 * scale / away.length()).min(2.0);
        scene.camera = Camera::new(centre + away, centre, angle);
        scene.spheres.push(Sphere::new(centre, scale, material));
    } else {
        let away = away * random.between(3.0, 30.0);
        scene.camera = Camera::new(centre + away, centre, block.half.length() / away.length());
        scene.blocks.push(block);
    }
    scene
}

#[test]
fn mirrors_never_show_themselves() {
    let known = known("mirror box").into_iter().map(|view| view.scene);
    let mut shown = 0;
    for scene in known.chain(cases(50).map(|mut random| lone(&mut random, MIRROR))) {
        for (isa, drawn) in draw_by_all(&scene, &Quality::EXHAUSTIVE, 320, 180) {
            for (i, pixel) in drawn.pixels.into_iter().enumerate() {
                let is_mirror = pixel == 0xcc_cccc;
                let what = format_args!("pixel {i} is {pixel:06x}: {scene:?}");
                assert!(is_mirror || pixel == 0xff_ffff, "{}: {what}", isa.name);
                shown += usize::from(is_mirror);
            }
        }
    }
    println!("{shown} pixels");
    let isas = cpu::instruction_sets().count();
    assert!(shown >= 600_000 * isas, "{shown}");
}

/// Without a least contribution, each hit traces a reflected and a transmitted ray. One of them is
/// inside the solid and hits it again, the other misses it; so each depth adds as many rays.
#[test]
fn clear_solid_is_entered_and_left_once() {
    for mut random in cases(30) {
        let clear = Scene { black_beyond: true, ..lone(&mut random, CLEAR) };
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
