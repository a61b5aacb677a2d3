//! A reflected ray does not hit the convex solid that it leaves: a lone mirror in a bright scene has no dark pixel.

use crate::cpu;
use crate::drawn::draw_by_all;
use eightfold_scenes::known::mirror_box;
use eightfold_scenes::{Random, cases, solids};
use eightfold_tracer::Quality;
use eightfold_tracer::glam::Vec3;
use eightfold_tracer::scene::{Camera, List, Material, Scene};

const MIRROR: Material = Material { kr: 0.8, ..Material::BLACK };

fn mirror(random: &mut Random) -> Scene {
    let half = Vec3::splat(1.0).map(|_| random.power(-1.5, 0.0));
    let scale = random.power(-2.0, 2.0);
    let centre = scale * random.vector(Vec3::splat(-8.0), Vec3::splat(8.0));
    let block = solids::block(random, centre, scale * half, MIRROR);
    let away = random.turn() * Vec3::Z * scale * random.between(3.0, 30.0);
    let eye = centre + away;
    let angle = block.half.length() / away.length();
    Scene {
        camera: Camera::new(eye, centre, angle),
        background: Vec3::ONE,
        blocks: List::of(&[block]),
        ..Scene::default()
    }
}

#[test]
fn mirrors_never_show_themselves() {
    let known = [mirror_box(MIRROR)].into_iter();
    let mut shown = 0;
    for scene in known.chain(cases(45).map(|mut random| mirror(&mut random))) {
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
