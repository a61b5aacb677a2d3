//! Pictures that were looked at, kept in `tests/golden`.
//!
//! After a change that is meant to be seen: `UPDATE_GOLDEN=1 cargo test --release --test image golden`, and look.

use crate::drawn::{Drawn, draw_by_all};
use crate::error::Difference;
use crate::picture::png;
use crate::reader::read_png;
use crate::unseen::between_corners;
use eightfold::Quality;
use eightfold::scene::{Method, Scene};
use eightfold::show::{self, grid};
use std::fs;
use std::path::Path;

/// How much a picture may be off: rounding decides differently about a few squares on other instruction sets.
const MEAN: f64 = 0.05;
/// Pixels over 8 of 255, in a thousand.
const OVER_8: usize = 1;

fn hold(name: &str, scene: &Scene, quality: &Quality, width: usize, height: usize) {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("tests/golden/{name}.png"));
    let drawn = draw_by_all(scene, quality, width, height);
    if std::env::var_os("UPDATE_GOLDEN").is_some() {
        fs::write(&file, png(width, &drawn[0].1.pixels).unwrap()).unwrap();
    }
    let (golden_width, golden) = read_png(&fs::read(&file).unwrap());
    assert_eq!((golden_width, golden.len()), (width, width * height));
    for (isa, Drawn { pixels, .. }) in drawn {
        let difference = Difference::between(&golden, &pixels);
        if difference.mean > MEAN || difference.over_8 > pixels.len() / 1000 * OVER_8 {
            let folder = Path::new(env!("CARGO_TARGET_TMPDIR"));
            let drawn = folder.join(format!("{name}-{}.png", isa.name));
            let differs = folder.join(format!("{name}-{}-difference.png", isa.name));
            fs::write(&drawn, png(width, &pixels).unwrap()).unwrap();
            fs::write(&differs, png(width, &contrast(&golden, &pixels)).unwrap()).unwrap();
            panic!(
                "{difference:?}: {} is not {}, see {}",
                drawn.display(),
                file.display(),
                differs.display()
            );
        }
    }
}

/// The difference of two pictures, sixteen times as bright.
fn contrast(a: &[u32], b: &[u32]) -> Vec<u32> {
    let channel = |a: u32, b: u32| (a & 0xff).abs_diff(b & 0xff).saturating_mul(16).min(255);
    let pixels = a.iter().zip(b);
    pixels
        .map(|(&a, &b)| {
            channel(a >> 16, b >> 16) << 16 | channel(a >> 8, b >> 8) << 8 | channel(a, b)
        })
        .collect()
}

#[test]
fn golden_model_scene() {
    hold("model", &show::scene(2.0), &Quality::EXHAUSTIVE, 640, 360);
}

#[test]
fn golden_squares() {
    hold("squares", &show::scene(1.0), &Quality::THESIS, 320, 240);
}

#[test]
fn golden_field() {
    hold("field", &show::field(64, 1.0), &Quality::THESIS, 320, 240);
}

#[test]
fn golden_spheres_between_corners() {
    let scene = between_corners();
    hold("between", &scene, &Quality::DEFAULT, 320, 240);
}

#[test]
fn golden_show() {
    // Bars that show each scene, and each caption's place.
    for (name, bar) in [
        ("title", 4.5),
        ("model-close", 11.5),
        ("method", 19.0),
        ("colonnade", 25.5),
        ("colonnade-close", 29.0),
        ("machine", 32.3),
        ("machine-close", 33.6),
        ("waves", 37.0),
        ("ball", 39.2),
        ("eight", 41.3),
        ("finale", 45.3),
    ] {
        let mut scene = Scene::default();
        show::at(bar * grid::BAR, &mut scene);
        scene.method = Method::default();
        hold(
            &format!("show-{name}"),
            &scene,
            &Quality::EXHAUSTIVE,
            320,
            180,
        );
    }
}
