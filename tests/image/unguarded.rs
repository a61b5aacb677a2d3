//! Thin things in mirrors, glass and waves, their shadows on balls, boxes and walls, and strips of light: `finest` loses none.

use crate::drawn::{draw_best, jagged};
use crate::error::Difference;
use eightfold_harness::patches::largest;
use eightfold_scenes::artists::{KINDS, ON_FLOORS};
use eightfold_scenes::cases;
use eightfold_tracer::scene::{Light, List, Material, Plane, Scene, Sphere};
use eightfold_tracer::{Preset, Quality};
use glam::{Vec3, vec3};

const FINEST: Quality = *Preset::Finest.quality();

/// The size of a patch that counts.
const PATCH: usize = 20;

const SMALL: [usize; 2] = [640, 360];
const LARGE: [usize; 2] = [1280, 720];

/// A picture, and its largest patch.
type Drawn = (Vec<u32>, Vec<usize>);

/// Draws a scene's every pixel, and its largest patch of lost pixels by each quality.
fn draw<const N: usize>(
    scene: &Scene,
    [width, height]: [usize; 2],
    qualities: [Quality; N],
) -> (Vec<u32>, [Drawn; N]) {
    let draw = |quality| draw_best(scene, &jagged(quality), width, height).pixels;
    let exact = draw(Quality::EXHAUSTIVE);
    let drawn = qualities.map(|quality| {
        let drawn = draw(quality);
        let patch = largest(&exact, &drawn, width);
        (drawn, patch)
    });
    (exact, drawn)
}

/// Asserts that `finest` has no patch in scenes of each kind. Prints the patches of `default`.
fn hold(seeds: impl Iterator<Item = u64> + Clone, size: [usize; 2]) {
    let mut lost = Vec::new();
    for kind in &KINDS[ON_FLOORS..] {
        let (mut patches, mut least) = (Vec::new(), f64::INFINITY);
        for seed in seeds.clone() {
            let scene = kind.seeded(seed);
            let (exact, [(_, finest), (drawn, default)]) =
                draw(&scene, size, [FINEST, Quality::DEFAULT]);
            if finest.len() >= PATCH {
                lost.push((kind.0, seed, finest.len()));
            }
            patches.push(default.len());
            least = least.min(Difference::between(&exact, &drawn).psnr);
        }
        let most = patches.iter().max().unwrap_or(&0);
        let (all, patched) = (patches.len(), patches.iter().filter(|&&it| it >= PATCH));
        let (name, patched) = (kind.0, patched.count());
        println!("{name} by default: {patched} of {all}, up to {most} pixels, {least:.1} dB");
    }
    assert!(lost.is_empty(), "{lost:?}");
}

/// At least one of these seeds has a patch in stairs, shelves, water, mirrors, glass, nets in balls and strips of light without
/// `unguarded_weight`.
#[test]
fn finest_shows_thin_things_without_bounds() {
    hold([0, 2, 7].into_iter(), SMALL);
}

#[test]
#[ignore = "2,640 scenes"]
fn long_finest_shows_thin_things_without_bounds() {
    for (count, size) in [(200, SMALL), (40, LARGE)] {
        let seeds: Vec<u64> = cases(count).map(|random| random.seed).collect();
        hold(seeds.into_iter(), size);
    }
}

/// A ball casts its shadow on a floor only, and no two objects have one colour.
#[test]
fn finest_traces_no_more_where_all_is_guarded() {
    let matt = Material::matt(vec3(0.8, 0.6, 0.4), 0.7);
    let floor = Material::matt(vec3(0.3, 0.5, 0.6), 0.7);
    let scene = Scene {
        background: Vec3::Z,
        ambient: Vec3::splat(0.2),
        planes: List::of(&[Plane::new(Vec3::ZERO, 9.0, 9.0, floor)]),
        spheres: List::of(&[Sphere::new(Vec3::Y, 1.0, matt)]),
        lights: List::of(&[Light::new(vec3(3.0, 5.0, -4.0), Vec3::ONE)]),
        ..Scene::default()
    };
    let plain = Quality { unguarded_weight: f32::INFINITY, ..FINEST };
    let [finest, plain] = [FINEST, plain].map(|quality| draw_best(&scene, &quality, 640, 360));
    assert_eq!(finest.counts, plain.counts);
    assert!(finest.pixels == plain.pixels);
}
