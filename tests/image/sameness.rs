use crate::cpu;
use crate::drawn::{REFINEMENTS, Record, draw, of_side, of_the_show};
use crate::threaded_renderer::{ThreadedRenderer, whole};
use eightfold::show;
use eightfold_tracer::{Band, Counts, Job, Quality, Renderer, Threads, Worker};

struct Backwards(Vec<Worker>);

impl Threads for Backwards {
    fn run(&mut self, bands: &mut [Band<'_>], job: Job<'_>) {
        for (i, band) in bands.iter_mut().rev().enumerate() {
            job(&mut self.0[i % 3 / 2], band);
        }
    }
}

/// Returns the work of a frame without probes and idle lanes, which depend on the order of bands.
pub fn work(counts: Counts) -> [u64; 3] {
    [counts.points, counts.rays, counts.shadow_rays]
}

#[test]
fn threads_order_observers_and_probes_change_no_bit() {
    // Two tiles and three bands.
    let (width, height) = (531, 70);
    let others = [2, 32].map(|side| of_side(side, Quality::DEFAULT));
    let mut threads = Backwards(Worker::several(2));
    let mut probing = ThreadedRenderer::new(2);
    probing.set_probes(3000, 11);
    for scene in [show::field(100, 3.0), of_the_show(50.0)] {
        for quality in REFINEMENTS.into_iter().chain(others) {
            for isa in cpu::instruction_sets() {
                let one = draw(isa, 1, &scene, &quality, width, height);
                let assert_same = |pixels: &[u32], counts: Counts, what: &str| {
                    assert!(pixels == one.pixels, "{what}, {quality:?} by {}", isa.name);
                    assert_eq!(work(counts), work(one.counts), "{what}, {quality:?}");
                };
                for threads in [2, 7] {
                    let more = draw(isa, threads, &scene, &quality, width, height);
                    assert_same(&more.pixels, more.counts, &format!("{threads} threads"));
                }
                let mut pixels = vec![1; width * height];
                let frame = whole(width, &mut pixels);
                let mut backwards = Renderer::new(isa.level);
                let counts = backwards.render(&scene, &quality, frame, &mut threads);
                assert_same(&pixels, counts.expect("a valid scene"), "backwards");
                let record = Record::default();
                let counts =
                    probing.draw_observed(isa.level, &scene, &quality, width, &mut pixels, &record);
                assert_same(&pixels, counts, "observed and probed");
                // Observers receive no points of antialiasing.
                let heard = record.counts.into_inner().unwrap();
                assert!(quality.antialias || work(heard) == work(counts));
            }
        }
    }
}

/// Whether a floor hides a light in its plane must not depend on the packet's other rays.
#[test]
fn lights_level_with_a_floor_change_no_corner() {
    let (width, height) = (320, 240);
    for low in [1e-40, 1e-9, 1e-7] {
        let mut scene = show::model_scene(7.4);
        scene.lights[0].position.y = low;
        let [filled, exact] = [8, 1].map(|square| {
            let quality = Quality { square, ..Quality::THESIS };
            draw(cpu::best(), 2, &scene, &quality, width, height).pixels
        });
        for i in (0..width * height).filter(|i| i % 8 == 0 && i / width % 8 == 0) {
            assert_eq!(filled[i], exact[i], "{low}, pixel {i}");
        }
    }
}
