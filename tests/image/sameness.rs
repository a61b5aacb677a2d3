//! The picture depends on the scene, the size, the quality and the instruction set, and on nothing else.

use crate::cpu;
use crate::drawn::{draw, draw_best, draw_by_all};
use crate::error::worst_channel;
use crate::threaded_renderer::{ThreadedRenderer, whole};
use eightfold::show;
use eightfold_oracle::frame::Frame;
use eightfold_tracer::scene::Scene;
use eightfold_tracer::{Band, Job, Memory, Quality, Renderer, Threads, Worker};

const QUALITIES: [Quality; 7] = [
    Quality::EXHAUSTIVE,
    Quality {
        antialias: true,
        ..Quality::EXHAUSTIVE
    },
    Quality::THESIS,
    Quality::DEFAULT,
    of_side(2),
    of_side(16),
    of_side(32),
];

/// The default quality with squares of another side.
const fn of_side(square: usize) -> Quality {
    Quality {
        square,
        ..Quality::DEFAULT
    }
}

/// The show's scene at a time in seconds.
fn of_the_show(time: f32) -> Scene {
    let mut scene = Scene::default();
    show::at(time, &mut scene);
    scene
}

#[test]
fn any_number_of_threads_gives_the_same_bits() {
    for scene in [show::model_scene(3.0), show::field(100, 3.0)] {
        for quality in QUALITIES {
            for isa in cpu::instruction_sets() {
                let one = draw(isa, 1, &scene, &quality, 301, 203);
                for threads in [2, 3, 7] {
                    let more = draw(isa, threads, &scene, &quality, 301, 203);
                    assert!(more.pixels == one.pixels, "{threads} threads, {}", isa.name);
                    let (a, b) = (more.counts, one.counts);
                    assert_eq!(
                        (a.points, a.rays, a.shadow_rays),
                        (b.points, b.rays, b.shadow_rays)
                    );
                }
            }
        }
    }
}

#[test]
fn any_order_of_bands_gives_the_same_bits() {
    let scene = show::model_scene(3.0);
    let level = cpu::best().level;
    for quality in QUALITIES {
        let forward = draw_best(&scene, &quality, 301, 203);
        let mut renderer = Renderer::with_memory(level, Box::new(Memory::new()));
        let mut threads = Backwards(std::iter::repeat_with(Worker::new).take(2).collect());
        let mut pixels = vec![0; 301 * 203];
        let frame = whole(301, &mut pixels);
        let counts = renderer.render(&scene, &quality, frame, &mut threads);
        let counts = counts.expect("all is valid");
        assert!(pixels == forward.pixels);
        assert_eq!(counts.points, forward.counts.points);
        assert_eq!(counts.rays, forward.counts.rays);
    }
}

/// Draws the last band first, now with one worker, now with the other.
struct Backwards(Vec<Worker>);

impl Threads for Backwards {
    fn run(&mut self, bands: &mut [Band<'_>], job: Job<'_>) {
        for (i, band) in bands.iter_mut().rev().enumerate() {
            job(&mut self.0[i % 3 / 2], band);
        }
    }
}

#[test]
#[ignore = "many frames"]
fn a_frame_does_not_depend_on_earlier_frames() {
    let level = cpu::best().level;
    let mut renderer = ThreadedRenderer::new(2);
    let mut others = vec![0; 500 * 400];
    // Every other one: antialiased, and with squares of several sides.
    for quality in QUALITIES.into_iter().skip(1).step_by(2) {
        // Scenes of spheres alone, and with boxes, cylinders and patterns: an object number may belong to a sphere in one frame
        // and to a box in another.
        let many = [
            show::model_scene(6.0),
            show::field(320, 0.0),
            of_the_show(50.0),
            of_the_show(65.0),
            of_the_show(76.0),
        ];
        let larger = Quality {
            square: 32,
            ..quality
        };
        for scene in &many {
            let draw = |renderer: &mut ThreadedRenderer| {
                let mut pixels = vec![0; 301 * 203];
                let counts = renderer.draw(level, scene, &quality, 301, &mut pixels);
                (pixels, counts.points)
            };
            let fresh = draw(&mut ThreadedRenderer::new(2));
            for before in &many {
                renderer.draw(level, before, &larger, 500, &mut others);
                assert!(draw(&mut renderer) == fresh);
            }
        }
    }
}

#[test]
fn instruction_sets_differ_by_one_step_at_most_but_on_silhouettes() {
    for (scene, width, height) in [
        (show::model_scene(0.0), 1024, 768),
        (show::model_scene(11.0), 640, 480),
        (show::field(64, 4.0), 400, 300),
    ] {
        let silhouettes = Frame::new(&scene, &Quality::EXHAUSTIVE, width, height).silhouettes();
        let drawn = draw_by_all(&scene, &Quality::EXHAUSTIVE, width, height);
        let (first, best) = &drawn[0];
        for (isa, other) in &drawn[1..] {
            for (i, &on) in silhouettes.iter().enumerate() {
                let off = worst_channel(best.pixels[i], other.pixels[i]);
                let (x, y) = (i % width, i / width);
                assert!(
                    off <= 1 || on,
                    "{} and {}: ({x}, {y}) differs by {off}",
                    first.name,
                    isa.name
                );
            }
        }
    }
}
