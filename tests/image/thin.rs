use crate::drawn::{draw, isa_of, named};
use crate::error::worst_channel;
use eightfold_harness::patches::largest_of;
use eightfold_scenes::solids::Bars;
use eightfold_scenes::{BarView, Random, cases};
use eightfold_tracer::Quality;
use eightfold_tracer::scene::{Camera, Material, Scene};
use glam::{Mat3, Vec3, vec3};
use std::collections::HashMap;

/// The least difference, of 255, that shows a bar or a wrong pixel.
const VISIBLE: u32 = 24;

#[test]
fn thin_bars_have_no_holes() {
    let mut shown = 0;
    for (mut random, bar_view) in
        cases(5).flat_map(|case| BarView::ALL.map(|bar_view| (case.clone(), bar_view)))
    {
        let isa = isa_of(random.seed);
        let [view, without] = bar_view.view(&mut random);
        let (width, height) = (view.width, view.height);
        // Presets above the default antialias fainter edges.
        let mut references = HashMap::new();
        for antialias in [false, true] {
            for quality in named() {
                let quality = Quality { antialias, ..quality };
                let edge = antialias.then_some(quality.edge);
                let [exhaustive, without] = references.entry(edge).or_insert_with(|| {
                    [&view, &without].map(|view| {
                        draw(isa, 2, &view.scene, &quality.reference(), width, height).pixels
                    })
                });
                let is_bar = |i: usize| worst_channel(exhaustive[i], without[i]) > VISIBLE;
                shown += (0..exhaustive.len()).filter(|&i| is_bar(i)).count();
                let drawn = draw(isa, 2, &view.scene, &quality, width, height).pixels;
                let is_wrong =
                    |i: &usize| is_bar(*i) && worst_channel(exhaustive[*i], drawn[*i]) > VISIBLE;
                let wrong: Vec<usize> = (0..drawn.len()).filter(is_wrong).collect();
                let (hole, seed) = (largest_of(&wrong, width), random.seed);
                let by = format!("{bar_view:?} by {} and {quality:?}", isa.name);
                assert!(hole < 4, "case {seed}: a hole of {hole} pixels, {by}");
            }
        }
    }
    assert!(shown > 300_000, "{shown}");
}

/// A black fence against the sky.
fn fence(random: &mut Random) -> Scene {
    let turn = Mat3::from_rotation_z(random.between(-1.6, 1.6));
    // In pixels of 1/100 unit.
    let (bar, slit) = (random.between(4.0, 20.0), random.between(0.6, 3.0));
    let mut scene = Scene {
        camera: Camera::new(vec3(0.0, 0.0, 10.0), Vec3::ZERO, 0.12),
        background: Vec3::ONE,
        ..Scene::default()
    };
    let bars = Bars { radius: 0.005 * bar, material: Material::BLACK, ..Bars::any(random) };
    for i in -15..15_i8 {
        let x = 0.01 * (bar + slit) * f32::from(i);
        bars.add(&mut scene, turn * vec3(x, -2.0, 0.0), turn * vec3(x, 2.0, 0.0));
    }
    scene
}

#[test]
fn slits_in_black_fences_are_shown() {
    let mut shown = 0;
    for mut random in cases(15) {
        let scene = fence(&mut random);
        let isa = isa_of(random.seed);
        let exhaustive = draw(isa, 1, &scene, &Quality::EXHAUSTIVE, 160, 120).pixels;
        shown += exhaustive.iter().filter(|&&pixel| pixel != 0).count();
        for quality in named() {
            let drawn = draw(isa, 1, &scene, &quality.jagged(), 160, 120).pixels;
            assert!(drawn == exhaustive, "case {} by {quality:?}", random.seed);
        }
    }
    assert!(shown > 20_000, "{shown}");
}
