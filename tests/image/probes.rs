//! A frame tells its own error: the probes' estimate is what comparing every pixel finds.

use crate::cpu::{self, Isa};
use crate::drawn::{REFINEMENTS, draw_best, jagged, of_the_show};
use crate::error::Difference;
use crate::threaded_renderer::ThreadedRenderer;
use eightfold::show;
use eightfold_tracer::scene::{Method, Scene};
use eightfold_tracer::{Frame, Probes, Quality};

const SIZE: (usize, usize) = (200, 149);

/// Of the show: spheres alone, marble, blocks, and waves, most of it dithered and with a film.
fn scenes() -> impl Iterator<Item = Scene> {
    [20.0, 50.0, 62.0, 110.0].into_iter().map(|time| {
        let mut scene = of_the_show(time);
        // An overlay is not probed, but every pixel is compared here.
        scene.captions.clear();
        scene
    })
}

/// Draws frames with probes.
struct Probing {
    renderer: ThreadedRenderer,
    isa: Isa,
    pixels: Vec<u32>,
}

impl Probing {
    fn new(isa: Isa, threads: usize) -> Self {
        Self {
            renderer: ThreadedRenderer::new(threads),
            isa,
            pixels: vec![0; SIZE.0 * SIZE.1],
        }
    }

    /// Draws a frame, and returns what so many probes find.
    fn draw(&mut self, scene: &Scene, quality: &Quality, count: u16, seed: u32) -> Probes {
        self.renderer.set_probes(count, seed);
        let (level, pixels) = (self.isa.level, &mut self.pixels);
        let counts = self.renderer.draw(level, scene, quality, SIZE.0, pixels);
        counts.probes
    }
}

/// The mean squared error of all pixels, in 255ths.
fn error(scene: &Scene, quality: &Quality) -> f64 {
    let picture = |quality: &Quality| draw_best(scene, quality, SIZE.0, SIZE.1).pixels;
    let psnr = Difference::between(&picture(&quality.reference()), &picture(quality)).psnr;
    255.0 * 255.0 / 10_f64.powf(psnr / 10.0)
}

/// By how many dB an estimate is off.
fn off(probes: Probes, error: f64) -> f32 {
    (10.0 * (probes.mean_squared_error() / error).log10()).abs() as f32
}

#[test]
#[ignore = "many frames"]
fn mean_over_frames_is_the_true_error() {
    // More than a frame needs: so fewer frames tell as much.
    const COUNT: u16 = 5 * Frame::PROBES;
    for (number, scene) in scenes().enumerate() {
        // The fastest quality has the largest errors.
        for quality in [Quality::DEFAULT, Quality::LADDER[6]] {
            let error = error(&scene, &quality);
            let mut probing = Probing::new(cpu::best(), 2);
            let mut sum = Probes::NONE;
            for seed in 0..100 {
                let probes = probing.draw(&scene, &quality, COUNT, seed);
                assert_eq!(probes.pixels, u64::from(COUNT));
                sum += probes;
            }
            let (off, margin) = (off(sum, error), sum.margin());
            println!("scene {number}: ±{margin:.2} dB, off by {off:.3}");
            let what = format!("scene {number}: {off} of {margin}");
            assert!(off < margin && margin < 2.0, "{what}");
        }
    }
}

#[test]
#[ignore = "many frames"]
fn interval_holds_the_true_error_as_often_as_it_says() {
    const GROUPS: u32 = 30;
    // Without edges a probe is a single point.
    let quality = jagged(Quality::DEFAULT);
    let (mut inside, mut groups) = (0, 0);
    for scene in scenes() {
        let error = error(&scene, &quality);
        let mut probing = Probing::new(cpu::best(), 2);
        for group in 0..GROUPS {
            let mut sum = Probes::NONE;
            // Seeds that have nothing to do with each other: those that follow each other are nearer to the truth than chance.
            for frame in 0..10 {
                let seed = (10 * group + frame + 1).wrapping_mul(0x2545_f491);
                sum += probing.draw(&scene, &quality, 3000, seed ^ seed >> 15);
            }
            inside += u32::from(off(sum, error) < sum.margin());
            groups += 1;
        }
    }
    println!("{inside} of {groups} intervals");
    let share = 90 * groups..=99 * groups;
    assert!(share.contains(&(100 * inside)), "{inside} of {groups}");
}

/// With as many probes as there are pixels on edges and at the picture's rim, several times.
#[test]
fn no_probe_of_an_exhaustive_frame_is_off() {
    for scene in scenes() {
        for quality in &REFINEMENTS[..2] {
            for isa in cpu::instruction_sets() {
                let probes = Probing::new(isa, 2).draw(&scene, quality, 9999, 7);
                assert_eq!(probes.pixels, 9999);
                assert_eq!((probes.squares, probes.fourths), (0, 0), "{}", isa.name);
                assert_eq!(probes.psnr(), f32::INFINITY);
            }
        }
    }
}

#[test]
fn probes_are_the_same_on_any_number_of_threads() {
    for scene in scenes() {
        let found = [1, 2, 5].map(|threads| {
            let mut probing = Probing::new(cpu::best(), threads);
            probing.draw(&scene, &Quality::DEFAULT, 3000, 11)
        });
        assert!(found.iter().all(|probes| *probes == found[0]), "{found:?}");
        assert!(found[0].squares > 0);
    }
}

#[test]
fn overlays_and_coarse_pictures_are_not_probed() {
    let marked = Method {
        points: 0.5,
        ..Method::PLAIN
    };
    let coarse = Method {
        coarse: 16.0,
        front: 1.0,
        ..Method::PLAIN
    };
    let behind_the_front = Method {
        front: 0.4,
        ..marked
    };
    for (method, expected) in [(marked, 0), (coarse, 0), (behind_the_front, 1000)] {
        let scene = Scene {
            method,
            ..show::model_scene(2.0)
        };
        let mut probing = Probing::new(cpu::best(), 2);
        let probes = probing.draw(&scene, &Quality::EXHAUSTIVE, 1000, 3);
        assert_eq!((probes.pixels, probes.squares), (expected, 0), "{method:?}");
    }
}
