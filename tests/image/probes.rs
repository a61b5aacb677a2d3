//! A frame tells its own error: the probes' estimate is what comparing every pixel finds.

use crate::cpu::{self, Isa};
use crate::drawn::{draw_best, jagged};
use crate::error::Difference;
use crate::threaded_renderer::ThreadedRenderer;
use eightfold::show;
use eightfold_tracer::scene::{Method, Scene};
use eightfold_tracer::{Frame, Probes, Quality};

const SIZE: (usize, usize) = (200, 149);

/// Of the show: spheres alone, marble, blocks, and waves, most of it dithered and with a film.
fn scenes() -> impl Iterator<Item = Scene> {
    [20.0, 50.0, 62.0, 110.0].into_iter().map(|time| {
        let mut scene = Scene::default();
        show::at(time, &mut scene);
        // What is drawn over a picture is not probed, but every pixel is compared here.
        scene.captions.clear();
        scene
    })
}

/// The default quality, antialiased and not, and the fastest, whose errors are the largest.
const QUALITIES: [Quality; 3] = [
    Quality::DEFAULT,
    jagged(Quality::DEFAULT),
    Quality::LADDER[6],
];

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
        let level = self.isa.level;
        let pixels = &mut self.pixels;
        self.renderer
            .draw(level, scene, quality, SIZE.0, pixels)
            .probes
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
fn the_mean_over_frames_is_the_true_error() {
    // More than a frame needs: so fewer frames tell as much.
    const COUNT: u16 = 5 * Frame::PROBES;
    for (number, scene) in scenes().enumerate() {
        for quality in QUALITIES {
            let error = error(&scene, &quality);
            let mut probing = Probing::new(cpu::best(), 2);
            let mut sum = Probes::NONE;
            for seed in 0..100 {
                let probes = probing.draw(&scene, &quality, COUNT, seed);
                assert_eq!(probes.pixels, u64::from(COUNT));
                sum += probes;
            }
            let (off, margin) = (off(sum, error), sum.margin());
            println!(
                "scene {number}: {:.2} dB, ±{margin:.2}, off by {off:.3}",
                sum.psnr()
            );
            assert!(
                off < margin && margin < 2.0,
                "scene {number}: {off} of {margin}"
            );
        }
    }
}

#[test]
#[ignore = "many frames"]
fn the_interval_holds_the_true_error_as_often_as_it_says() {
    const GROUPS: u32 = 60;
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
    assert!(
        (90 * groups..=99 * groups).contains(&(100 * inside)),
        "{inside} of {groups}"
    );
}

#[test]
fn every_pixel_is_probed_by_some_seed_and_none_is_off_if_all_are_traced() {
    for scene in scenes() {
        for antialias in [false, true] {
            let quality = Quality {
                antialias,
                ..Quality::EXHAUSTIVE
            };
            for isa in cpu::instruction_sets() {
                // As many as there are pixels on edges and at the picture's rim, several times.
                let probes = Probing::new(isa, 2).draw(&scene, &quality, u16::MAX, 7);
                assert_eq!(probes.pixels, u64::from(u16::MAX));
                assert_eq!((probes.squares, probes.fourths), (0, 0), "{}", isa.name);
                assert_eq!(probes.psnr(), f32::INFINITY);
            }
        }
    }
}

#[test]
fn probes_leave_the_picture_and_its_counts_as_they_are_on_any_number_of_threads() {
    for scene in scenes() {
        for quality in QUALITIES {
            let plain = draw_best(&scene, &quality, SIZE.0, SIZE.1);
            assert_eq!(plain.counts.probes, Probes::NONE);
            let mut found = None;
            for threads in [1, 2, 5] {
                let mut probing = Probing::new(cpu::best(), threads);
                probing.renderer.set_probes(3000, 11);
                let level = probing.isa.level;
                let pixels = &mut probing.pixels;
                let mut counts = probing
                    .renderer
                    .draw(level, &scene, &quality, SIZE.0, pixels);
                let probes = std::mem::take(&mut counts.probes);
                assert!(*pixels == plain.pixels, "{threads} threads");
                assert_eq!(
                    (counts.points, counts.rays),
                    (plain.counts.points, plain.counts.rays)
                );
                assert_eq!(*found.get_or_insert(probes), probes, "{threads} threads");
            }
        }
    }
}

#[test]
fn overlays_and_what_is_coarse_on_purpose_are_not_probed() {
    let mut scene = show::model_scene(2.0);
    let mut probing = Probing::new(cpu::best(), 2);
    let mut count = |method| {
        scene.method = method;
        let probes = probing.draw(&scene, &Quality::EXHAUSTIVE, 1000, 3);
        assert_eq!(probes.squares, 0);
        probes.pixels
    };
    let marked = Method {
        points: 0.5,
        ..Method::PLAIN
    };
    assert_eq!(count(marked), 0);
    assert_eq!(
        count(Method {
            front: 0.4,
            ..marked
        }),
        1000,
        "all behind the front"
    );
    assert_eq!(
        count(Method {
            coarse: 16.0,
            front: 1.0,
            ..Method::PLAIN
        }),
        0
    );
}
