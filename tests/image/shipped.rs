//! The program that ships draws, with `--still`, the same bits as the library under test, and the same pictures as the oracle.

use crate::accuracy::assert_as_traced;
use crate::cpu::{self, Isa};
use crate::drawn::{Drawn, draw};
use crate::error::{Difference, worst_channel};
use eightfold::show;
use eightfold_lab::arguments::NamedQuality;
use eightfold_oracle::frame::Frame;
use eightfold_stage::{linked_intro, reader::read_ppm};
use eightfold_tracer::scene::{Method, Scene};
use eightfold_tracer::{Counts, MAX_HEIGHT, MAX_WIDTH, Quality};
use std::process::Command;

/// A frame of the show, and how the program that ships draws it.
#[derive(Clone, Copy)]
pub struct Still {
    /// The time in the show, in milliseconds.
    pub time: u32,
    pub quality: NamedQuality,
    pub width: usize,
    pub height: usize,
}

impl Still {
    fn exhaustive(time: u32, width: usize, height: usize) -> Self {
        Self {
            time,
            quality: NamedQuality::EXHAUSTIVE,
            width,
            height,
        }
    }

    /// The scene of the frame.
    pub fn scene(&self) -> Scene {
        let mut scene = Scene::default();
        show::at((f64::from(self.time) / 1000.0) as f32, &mut scene);
        scene
    }

    /// The frame, drawn by the program that ships.
    pub fn shipped(&self, isa: Isa, threads: usize) -> Vec<u32> {
        let (seconds, milliseconds) = (self.time / 1000, self.time % 1000);
        let output = Command::new(linked_intro())
            .args(["--still", &format!("{seconds}.{milliseconds:03}")])
            .args(["--size", &format!("{}x{}", self.width, self.height)])
            .args(["--quality", self.quality.name, "--isa", isa.name])
            .args(["--threads", &threads.to_string()])
            .output()
            .expect("the intro starts");
        let errors = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.success() && errors.is_empty(), "{errors}");
        let (width, pixels) = read_ppm(&output.stdout);
        assert_eq!(
            (width, pixels.len()),
            (self.width, self.width * self.height)
        );
        pixels
    }

    /// The frame, drawn by the library under test.
    pub fn drawn(&self, isa: Isa) -> Vec<u32> {
        let quality = &self.quality.quality;
        draw(isa, 2, &self.scene(), quality, self.width, self.height).pixels
    }

    /// Asserts that both are the same for every instruction set, and for one thread and several.
    fn assert_same(&self) {
        let several = cpu::shipped().map(|isa| (isa, 3));
        for (isa, threads) in several.chain([(cpu::best(), 1)]) {
            let what = format!(
                "{} ms, {}x{}, {} by {}, {threads} threads",
                self.time, self.width, self.height, self.quality, isa.name
            );
            assert!(self.shipped(isa, threads) == self.drawn(isa), "{what}");
        }
    }
}

/// Times in milliseconds, at least two in each scene but the method's, without captions, copper bars and coarse squares, which the
/// oracle does not draw.
const TIMES: [u32; 18] = [
    2_300, 5_500, 13_300, 18_700, 21_500, 41_300, 45_200, 54_700, 57_400, 62_500, 69_900, 78_300,
    83_600, 90_700, 94_300, 102_800, 108_500, 112_000,
];

/// The smallest PSNR, in decibels, of the default quality in small pictures, in which edges take up a large share.
const LEAST_PSNR: f64 = 33.0;

#[test]
#[ignore = "the intro is started many times"]
fn what_ships_is_as_the_oracle_sees_it_in_every_scene() {
    let (width, height) = (320, 180);
    for time in TIMES {
        let still = Still::exhaustive(time, width, height);
        let mut scene = still.scene();
        let captions = scene.captions.iter().map(|caption| caption.brightness);
        let bars = scene.copper_bars.iter().map(|bar| bar.brightness);
        assert_eq!(
            captions.chain(bars).sum::<f32>(),
            0.0,
            "no overlay at {time} ms"
        );
        scene.captions.clear();
        scene.copper_bars.clear();
        let frame = Frame::new(&scene, &Quality::EXHAUSTIVE, width, height);
        let mut exhaustive = Vec::new();
        for isa in cpu::shipped() {
            let what = format!("{time} ms by {}", isa.name);
            let pixels = still.shipped(isa, 2);
            let counts = Counts::default();
            let drawn = Drawn { pixels, counts };
            assert_as_traced(&drawn, &frame, &what);
            exhaustive.push(drawn.pixels);
            // The overlay differs between qualities.
            if scene.method == Method::default() {
                let named: NamedQuality = "default".parse().expect("a quality");
                let pixels = Still {
                    quality: named,
                    ..still
                }
                .shipped(isa, 2);
                // Antialiased as this is.
                let reference = named.quality.reference();
                let reference = draw(isa, 2, &scene, &reference, width, height);
                let psnr = Difference::between(&reference.pixels, &pixels).psnr;
                assert!(psnr >= LEAST_PSNR, "{what}: {psnr} dB");
            }
        }
        assert_alike_but_on_silhouettes(&exhaustive, &frame, &format!("{time} ms"));
    }
}

/// Asserts that pictures by several instruction sets differ by at most 1/255 except on the oracle's silhouettes.
fn assert_alike_but_on_silhouettes(pictures: &[Vec<u32>], frame: &Frame, what: &str) {
    let silhouettes = frame.silhouettes();
    for other in &pictures[1..] {
        let pairs = pictures[0].iter().zip(other).zip(&silhouettes);
        let off = pairs
            .filter(|(_, on)| !**on)
            .map(|((&a, &b), _)| worst_channel(a, b));
        assert!(off.max() <= Some(1), "{what}");
    }
}

#[test]
#[ignore = "the intro is started many times"]
fn what_ships_draws_the_bits_of_the_library_under_test_by_every_quality() {
    for (i, quality) in NamedQuality::all().enumerate() {
        // Two times for each quality, in different scenes.
        for time in [TIMES[i], TIMES[i + 7]] {
            let still = Still {
                time,
                quality,
                width: 331,
                height: 217,
            };
            still.assert_same();
        }
    }
}

#[test]
fn what_ships_draws_the_bits_of_the_library_under_test_at_every_size() {
    for (width, height) in [(1, 1), (7, 3), (1, 100), (MAX_WIDTH, 9), (9, MAX_HEIGHT)] {
        Still::exhaustive(17_300, width, height).assert_same();
    }
    let quality = "default".parse().expect("a quality");
    let largest = Still {
        time: 33_500,
        quality,
        width: MAX_WIDTH,
        height: MAX_HEIGHT,
    };
    let isa = cpu::best();
    assert!(largest.shipped(isa, 2) == largest.drawn(isa));
}
