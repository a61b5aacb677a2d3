use crate::cpu;
use crate::drawn::{TILE, draw, draw_by_all, jagged};
use crate::error::Difference;
use crate::patches::compared;
use eightfold::show;
use eightfold_scenes::artists::LIGHTS;
use eightfold_scenes::{Random, cases, crowd};
use eightfold_tracer::Quality;
use eightfold_tracer::scene::Scene;
use std::collections::BTreeSet;

fn psnr(scene: &Scene, quality: Quality, size: [usize; 2]) -> f64 {
    compared(cpu::best(), scene, quality, size).0
}

#[test]
fn thesis_traces_an_eighth_of_points_at_44_db() {
    let scene = show::model_scene(0.0);
    for (isa, exhaustive) in draw_by_all(&scene, &Quality::EXHAUSTIVE, 1024, 768) {
        let thesis = draw(isa, 2, &scene, &Quality::THESIS, 1024, 768);
        let psnr = Difference::between(&exhaustive.pixels, &thesis.pixels).psnr;
        assert!(psnr >= 44.0, "{}: {psnr} dB", isa.name);
        let share = thesis.counts.points as f64 / (1024.0 * 768.0);
        assert!((0.09..=0.14).contains(&share), "{}: {share}", isa.name);
    }
}

#[test]
fn default_has_45_db_and_42_in_fields() {
    for (second, quality) in
        [(0.0, Quality::DEFAULT), (4.0, jagged(Quality::DEFAULT)), (8.0, Quality::DEFAULT)]
    {
        let psnr = psnr(&show::model_scene(second), quality, [1024, 768]);
        assert!(psnr >= 45.0, "{psnr} dB at {second} s by {quality:?}");
    }
    for (count, time) in [(100, 13.0), (320, 41.6)] {
        let psnr = psnr(&show::field(count, time), Quality::DEFAULT, [1024, 768]);
        assert!(psnr >= 42.0, "{psnr} dB of {count} spheres at {time} s");
    }
}

/// Returns the number of pixels, and of the corners that squares of each size may have outside.
pub fn max_points(square: usize, width: usize, height: usize) -> usize {
    let corners = |side: usize, tile: usize| -> usize {
        let parts = (0..side).step_by(tile).map(|start| (side - start).min(tile));
        let ends = |part: usize| (0..=square.ilog2()).map(move |i| part.next_multiple_of(1 << i));
        parts.map(|part| part + ends(part).collect::<BTreeSet<_>>().len()).sum()
    };
    if square == 1 { width * height } else { corners(width, TILE[0]) * corners(height, TILE[1]) }
}

/// Tests crowds of mirrors and glass, and matt crowds under all kinds of light. `CASES` sets the number of scenes of each kind (1).
#[test]
#[ignore = "many random scenes"]
fn random_crowds_have_42_db() {
    // The numbers of spheres and blocks, the shares of glass and mirrors, and the limit in dB.
    let counts = [[16, 32], [0, 64], [4, 4], [6, 2], [20, 64], [70, 64], [130, 64], [320, 64]];
    let shares = [[0.2, 0.2], [0.5, 0.2], [0.0, 0.6], [0.4, 0.4]];
    let shiny = (0..8).map(|i| (counts[i], shares[i % 4], 42.0));
    let matt = [4, 12, 24, 46, 64].map(|blocks| ([20, blocks], [0.0; 2], 42.0));
    let exceptions = [([8, 0], [0.8, 0.2], 40.0), ([2, 6], [0.5, 0.2], 37.0)];
    let kinds = shiny.chain(matt).chain(exceptions);
    let of_kind = |kind| cases(1).map(move |random| (random, kind));
    // These had 30 and 34 dB.
    let known = [(319, [4, 4], [0.0, 0.6]), (81, [6, 2], [0.4, 0.4])];
    let known = known.map(|(seed, count, shares)| (Random::new(seed), (count, shares, 42.0)));
    for (mut random, (count, shares, limit)) in kinds.flat_map(of_kind).chain(known) {
        let mut scene = crowd(&mut random, count, shares);
        if shares == [0.0; 2] {
            for light in scene.lights.iter_mut() {
                *light = LIGHTS[random.seed as usize % LIGHTS.len()].1(&mut random);
            }
        }
        let psnr = psnr(&scene, Quality::DEFAULT, [640, 480]);
        let what = format!("{count:?} of {shares:?}, case {}", random.seed);
        println!("{psnr:.1} dB: {what}");
        assert!(psnr >= limit, "{psnr} dB: {what}");
    }
}
