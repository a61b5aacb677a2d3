//! Pictures match the reviewed ones in `tests/golden`, which the baseline instruction set drew. To
//! redraw those that differ:
//!
//!     UPDATE_GOLDEN=1 cargo test --test image golden

use crate::drawn::{draw_by_all, example};
use crate::error::{Difference, worst_channel};
use crate::picture::png;
use crate::threaded_renderer::MomentRef;
use eightfold::show;
use eightfold_scenes::between_corners;
use eightfold_stage::reader::read_png;
use eightfold_tracer::Quality;
use eightfold_tracer::scene::Scene;
use std::fs;
use std::path::{Path, PathBuf};

/// The largest mean error, in steps of 1/255: rounding decides a few squares differently on other
/// instruction sets.
const MEAN: f64 = 0.05;
/// Pixels in a thousand that may differ by more than 8/255.
const OVER_8: usize = 1;

pub type Named = (&'static str, Vec<u32>);

pub fn assert_golden_by_all<'a>(
    name: &str,
    moment: impl Into<MomentRef<'a>>,
    quality: &Quality,
    [width, height]: [usize; 2],
) {
    let drawn = draw_by_all(moment, quality, width, height).into_iter();
    let drawn: Vec<Named> = drawn.map(|(isa, drawn)| (isa.name, drawn.pixels)).collect();
    let (_, pixels) = drawn.last().expect("an instruction set");
    let there = fs::read(file(name)).map(|bytes| read_png(&bytes));
    let is_there = there.is_ok_and(|(_, there)| there == *pixels);
    if !is_there && std::env::var_os("UPDATE_GOLDEN").is_some() {
        fs::write(file(name), png(width, pixels).unwrap()).unwrap();
    }
    assert_golden(name, width, &drawn);
}

fn file(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("tests/golden/{name}.png"))
}

pub fn assert_golden(name: &str, width: usize, drawn: &[Named]) {
    let file = file(name);
    let (golden_width, golden) = read_png(&fs::read(&file).unwrap());
    assert_eq!(golden_width, width);
    for (by, pixels) in drawn {
        let difference = Difference::between(&golden, pixels);
        if difference.mean > MEAN || difference.over_8 > pixels.len() / 1000 * OVER_8 {
            let write = |kind: &str, pixels: &[u32]| {
                let name = format!("{name}-{by}{kind}.png");
                let file = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
                fs::write(&file, png(width, pixels).unwrap()).unwrap();
                file.display().to_string()
            };
            // White from a difference of 16 of 255 on.
            let off = golden.iter().zip(pixels).map(|(&a, &b)| worst_channel(a, b));
            let off: Vec<u32> = off.map(|off| (16 * off).min(255) * 0x01_0101).collect();
            let (drawn, off) = (write("", pixels), write("-difference", &off));
            panic!("{difference:?}: {drawn} is not {}, see {off}", file.display());
        }
    }
}

type Row = (&'static str, fn() -> Scene, Quality, [usize; 2]);

#[test]
fn scenes_match_golden_pictures() {
    let scenes: [Row; 6] = [
        ("model", || show::model_scene(2.0), Quality::EXHAUSTIVE, [640, 360]),
        ("squares", || show::model_scene(1.0), Quality::THESIS, [320, 240]),
        ("field", || show::field(64, 1.0), Quality::THESIS, [320, 240]),
        ("between", || between_corners().scene, Quality::DEFAULT, [320, 240]),
        // Thin rods, which were once dashed.
        ("fence", || example("fence"), Quality::DEFAULT, [640, 360]),
        ("bubbles", || example("bubbles"), Quality::DEFAULT, [640, 360]),
    ];
    for (name, scene, quality, size) in scenes {
        assert_golden_by_all(name, &scene(), &quality, size);
    }
}
