//! Patterns agree between the pixels of filled squares and traced points.

use super::scenes::rich;
use super::*;
use crate::prepare::ObjectId;
use crate::scene::Pattern;
use crate::trace::SeenPattern;
use glam::vec3;

const SIZE: [usize; 2] = [320, 180];

const CHECKERS: Pattern = Pattern {
    waves: Vec3::splat(2.0),
    depth: 0.7,
    edge: 20.0,
    ..Pattern::NONE
};

const MARBLE: Pattern = Pattern {
    waves: vec3(1.0, 0.0, 0.0),
    edge: 2.0,
    balance: 0.4,
    warp: 1.5,
    grain: 0.8,
    ..CHECKERS
};

/// Returns a scene in which everything is patterned, seen from an angle in radians.
fn patterned(angle: f32) -> Scene {
    let mut scene = rich();
    for sphere in scene.spheres.iter_mut() {
        sphere.material.pattern = CHECKERS;
    }
    for (block, pattern) in scene.blocks.iter_mut().zip([MARBLE, CHECKERS]) {
        block.material.pattern = pattern;
    }
    scene.planes[0].material.pattern = Pattern {
        waves: vec3(0.4, 0.0, 0.4),
        ..CHECKERS
    };
    scene.camera.eye = vec3(7.5 * angle.sin(), 2.2, -7.5 * angle.cos());
    scene
}

fn assert_patterns_agree(by: &dyn Kernels, isa: &str) {
    let mut memory = Box::new(Prepared::new());
    let level = Level::new();
    let (mut seen, mut far) = (0, 0);
    for turn in 0..6 {
        let scene = patterned(turn as f32);
        let world = memory.prepare(&scene, SIZE, Vec2::ZERO);
        for y in 0..SIZE[1] {
            for x in (0..SIZE[0]).step_by(by.lanes()) {
                for (lane, met) in by.pixels(world, x, y).iter().enumerate().take(by.lanes()) {
                    let object = ObjectId::new(met.object as usize);
                    let left = met.reflectance;
                    if left > 0.0 {
                        continue;
                    }
                    let left = -left;
                    // The pixel may be any of a square.
                    let side = [2, 4, 8][seen % 3];
                    let [column, row] = [x + lane, y].map(|it| it.min(it * 7 % side));
                    let start = [x + lane - column, y - row];
                    let shares =
                        SeenPattern::new(world, object).at(level, start, side, side * side);
                    let is_share = |left| (0.0..=1.0).contains(left);
                    assert!(shares.iter().all(is_share), "{isa}: {shares:?}");
                    seen += 1;
                    far += usize::from((shares[row * side + column] - left).abs() > 1e-3);
                }
            }
        }
    }
    std::println!("{isa}: {far} of {seen} farther apart than a thousandth");
    assert!(
        seen > 100_000 && far * 1000 < seen,
        "{isa}: {far} of {seen}"
    );
}

#[test]
fn patterns_agree_between_pixels_and_points() {
    on_every_instruction_set(assert_patterns_agree);
}
