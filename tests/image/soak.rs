//! Any scene, size and quality draws the same bits on any number of threads, in any order, and
//! after any other frame, for bounded work, and never panics while glam asserts its conditions,
//! which `tests/scenes` enables for all tests.

use crate::cpu::{self, Isa};
use crate::drawn::{REFINEMENTS, Record, draw, isa_of, max_points, of_side, of_the_show};
use crate::error::Difference;
use crate::threaded_renderer::ThreadedRenderer;
use eightfold::show;
use eightfold_scenes::text::Text;
use eightfold_scenes::{Random, any, cases, presented};
use eightfold_tracer::presentation::{Method, Moment};
use eightfold_tracer::scene::{Camera, MAX_LENGTH, Scene};
use eightfold_tracer::{
    Band, Counts, Frame, Job, MAX_HEIGHT, MAX_WIDTH, Preset, Quality, Renderer, Threads, Worker,
};
use glam::{Vec3, vec3};
use std::env;
use std::panic::catch_unwind;
use std::time::{Duration, Instant};

const CASES: u64 = 150;
/// A mean error of the default quality, in steps of 1/255. Two of 5,521 pictures had more, 2.6 at
/// worst: thin things in unguarded light. There `finest` must leave at most
/// [`MAX_MEAN_ERROR_LEFT`]: it left 0.00007.
const MAX_MEAN_ERROR: f64 = 2.0;
const MAX_MEAN_ERROR_LEFT: f64 = 0.1;

fn quality(random: &mut Random) -> Quality {
    let any = Quality {
        square: 1 << random.below(6),
        tolerance_agreeing: random.one_of([0.0, 9.0, f32::INFINITY]),
        tolerance_differing: random.one_of([0.0, 4.0, f32::NAN]),
        tolerance_side: random.one_of([0.0, 9.0]),
        key_depth: random.below(9) as u32,
        key_weight: random.one_of([0.0, 0.3, f32::NAN]),
        crowds: random.below(2) == 0,
        unguarded_weight: random.one_of([0.0, 0.1, f32::INFINITY, f32::NAN]),
        state_depth: random.below(9) as u32,
        depth: random.below(Quality::MAX_DEPTH as usize + 1) as u32,
        least_contribution: random.one_of([0.0, 0.01, 0.2, f32::NAN]),
        antialias: random.below(2) == 0,
        edge: random.one_of([0, 9, 20]),
        ..Quality::DEFAULT
    };
    random.one_of([Quality::THESIS, Quality::DEFAULT, any])
}

/// Puts the eye and lights at, above, or in the middle of objects: directions and normals have no
/// length.
fn degenerate(random: &mut Random) -> Scene {
    let mut scene = any(random);
    let places = scene.spheres.iter().map(|sphere| sphere.centre);
    let places = places.chain(scene.blocks.iter().map(|block| block.centre));
    let places: Vec<Vec3> = places.chain([Vec3::ZERO]).collect();
    let place = places[random.below(places.len())];
    let above = [place, place + 3.0 * Vec3::Y, place + Vec3::splat(1e-22), Vec3::splat(MAX_LENGTH)];
    let eye = random.one_of(above);
    let look_at = random.one_of([place, eye + Vec3::Z, eye + Vec3::NEG_Y]);
    scene.camera = Camera { eye, look_at, up: vec3(0.3, 1.0, 0.2), ..scene.camera };
    let lights = scene.lights.iter_mut();
    lights.for_each(|light| light.position = random.one_of([eye, place, place + Vec3::Y]));
    if scene.validate().is_err() {
        scene.camera = Camera::default();
    }
    scene
}

/// Makes a number invalid. Returns whether that moves what a pixel shows.
fn corrupt(scene: &mut Moment, random: &mut Random) -> bool {
    let (nan, infinity) = (f32::NAN, f32::INFINITY);
    let wrong = random.one_of([nan, infinity, -infinity, f32::MAX, -1.0, 0.0, 1e-40, 1e20]);
    let text = Text::of(scene);
    let number = random.below(text.numbers.len());
    let (invalid, field) = text.value_with(number, wrong);
    *scene = invalid;
    matches!(field, "axes" | "sectors")
}

fn max_traced(quality: &Quality, width: usize, height: usize) -> u64 {
    // Antialiasing traces the midpoints to the right of a pixel and below it; between stretches and
    // between bands twice. Bisection adds up to two points on each side of a midpoint, three if
    // `edge` is below 20.
    let of_pixel = if quality.edge < 20 { 15 } else { 11 };
    let middles = usize::from(quality.antialias) * of_pixel * width * height;
    (max_points(quality.square, width, height) + middles) as u64
}

struct Case {
    what: String,
    isa: Isa,
    moment: Moment,
    size: [usize; 2],
}

impl Case {
    fn draw(&self, renderer: &mut ThreadedRenderer, quality: &Quality) -> (Vec<u32>, Counts) {
        let [width, height] = self.size;
        let mut pixels = vec![u32::MAX; width * height];
        let counts = renderer.draw(self.isa.level, &self.moment, quality, width, &mut pixels);
        let is_drawn = pixels.iter().all(|pixel| pixel >> 24 == 0);
        assert!(is_drawn, "{}: a pixel was left out", self.what);
        (pixels, counts)
    }

    fn assert_same_bits(
        &self,
        [one, two]: &mut [ThreadedRenderer; 2],
        quality: &Quality,
    ) -> Vec<u32> {
        let (what, [width, height]) = (&self.what, self.size);
        let (pixels, counts) = self.draw(one, quality);
        let (others, again) = self.draw(two, quality);
        assert!(pixels == others, "{what}: another picture by two threads");
        assert_eq!(work(counts), work(again), "{what}");

        let is_bounded = counts.points <= max_traced(quality, width, height)
            && counts.rays <= counts.points * ((2 << quality.depth) - 1)
            && counts.shadow_rays <= counts.rays * self.moment.scene.lights.len() as u64;
        assert!(is_bounded, "{what}: {counts:?}");
        pixels
    }

    fn assert_corners(&self, pixels: &[u32], traced: &[u32], square: usize) {
        let [width, height] = self.size;
        for y in (0..height).step_by(square) {
            for x in (0..width).step_by(square) {
                let i = y * width + x;
                assert_eq!(pixels[i], traced[i], "{}: ({x}, {y})", self.what);
            }
        }
    }

    fn assert_near(&self, renderer: &mut ThreadedRenderer, pixels: &[u32], traced: &[u32]) -> f64 {
        let off = Difference::between(traced, pixels).mean;
        if off > MAX_MEAN_ERROR {
            let quality = Preset::Finest.quality();
            let [exact, finest] =
                [&quality.reference(), quality].map(|by| self.draw(renderer, by).0);
            let left = Difference::between(&exact, &finest).mean;
            let what = &self.what;
            assert!(left <= MAX_MEAN_ERROR_LEFT, "{what}: {off} by default, {left} by finest");
        }
        off
    }
}

fn assert_any(renderers: &mut [ThreadedRenderer; 2], random: &mut Random) -> Option<f64> {
    let what = format!("case {}", random.seed);
    let time = random.between(-100.0, 100.0) * 10_f32.powi(random.below(5) as i32);
    let kind = random.below(8);
    let mut scene = match kind {
        0 => {
            let mut scene = show::model_scene(time);
            // A light level with the floor, which must not hide it only among some rays of a
            // packet.
            scene.lights[0].position.y *= random.one_of([1.0, 1e-40, 1e-9, 1e-7]);
            scene.into()
        }
        1 => show::field(random.below(321), time).into(),
        2 | 3 => degenerate(random).into(),
        _ => presented(any(random), random),
    };
    assert_eq!(scene.validate(), Ok(()), "{what}");
    let is_corrupt = random.below(4) == 0;
    let is_moved = is_corrupt && corrupt(&mut scene, random);
    let (width, height) = match random.below(12) {
        0 => (1, 1 + random.below(300)),
        1 => (1 + random.below(300), 1),
        2 => (MAX_WIDTH - random.below(9), 1 + random.below(9)),
        3 => (1 + random.below(9), MAX_HEIGHT - random.below(9)),
        _ => (1 + random.below(160), 1 + random.below(120)),
    };
    let any = quality(random);
    // The errors of far tiles are measured.
    let quality = if width + height < 1000 { any } else { random.one_of([any, Quality::DEFAULT]) };
    let case = Case { what, isa: isa_of(random.seed), moment: scene, size: [width, height] };
    if random.seed.is_multiple_of(8) {
        renderers[1] = ThreadedRenderer::new(2);
    }
    let pixels = case.assert_same_bits(renderers, &quality);

    // The corners of the largest squares are always traced. But antialiasing and marks change their
    // pixels, culling by wrong axes depends on the squares, and folds copy pixels to corners.
    let every = Quality { square: 1, ..quality };
    let (traced, _) = case.draw(&mut renderers[0], &every);
    let Moment { scene, presentation } = &case.moment;
    if !quality.antialias && presentation.method == Method::PLAIN && !is_moved {
        case.assert_corners(&pixels, &traced, quality.square);
    }
    let is_clear = !is_corrupt && !matches!(kind, 2 | 3) && scene.haze == 0.0;
    (is_clear && quality == Quality::DEFAULT && pixels.len() > 5000)
        .then(|| case.assert_near(&mut renderers[0], &pixels, &traced))
}

#[test]
fn any_case_has_same_bits_for_bounded_work() {
    let seconds = env::var("SOAK_SECONDS").ok();
    let limit = seconds.map(|text| Duration::from_secs(text.parse().expect("seconds")));
    let start = Instant::now();
    let mut renderers = [1, 2].map(ThreadedRenderer::new);
    let (mut count, mut measured, mut worst) = (0, 0, 0.0_f64);
    let is_on = |_: &Random| limit.is_none_or(|limit| start.elapsed() < limit);
    let all = cases(limit.map_or(CASES, |_| u64::MAX));
    for mut random in all.take_while(is_on) {
        if let Some(off) = assert_any(&mut renderers, &mut random) {
            measured += 1;
            worst = worst.max(off);
        }
        count += 1;
    }
    println!("{count} cases; the default quality was off by {worst:.2} of 255 in {measured}");
}

#[test]
fn largest_pictures_in_squares_have_same_bits() {
    let mut renderers = [1, 2].map(ThreadedRenderer::new);
    for (size, side) in
        [[MAX_WIDTH, 40], [40, MAX_HEIGHT]].into_iter().flat_map(|size| [(size, 32), (size, 8)])
    {
        let what = format!("{size:?} in squares of {side}");
        let case = Case { what, isa: cpu::best(), moment: show::model_scene(0.5).into(), size };
        let quality = of_side(side, Quality::THESIS);
        let pixels = case.assert_same_bits(&mut renderers, &quality);
        let (traced, _) = case.draw(&mut renderers[0], &of_side(1, quality));
        case.assert_corners(&pixels, &traced, side);
        let wrong = Difference::between(&traced, &pixels).over_8;
        // 2.1 % of the narrow picture at side 32.
        assert!(wrong < pixels.len() / 40, "{}: {wrong}", case.what);
    }
}

#[test]
fn glam_asserts_its_conditions() {
    assert!(catch_unwind(|| Vec3::ZERO.normalize()).is_err());
}

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
    const STRIDE: usize = 600;
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
                let seven = draw(isa, 7, &scene, &quality, width, height);
                assert_same(&seven.pixels, seven.counts, "7 threads");
                // A part of a larger picture, whose other pixels stay.
                let mut larger = vec![1 << 24; STRIDE * height];
                let part = &mut larger[..STRIDE * (height - 1) + width];
                let frame = Frame::new(width, height, part).with_stride(STRIDE);
                let mut backwards = Renderer::new(isa.level);
                let counts = backwards.render(&scene, &quality, frame, &mut threads);
                let (inside, outside): (Vec<_>, Vec<_>) =
                    larger.chunks(STRIDE).map(|row| row.split_at(width)).unzip();
                assert!(outside.concat().iter().all(|&pixel| pixel == 1 << 24));
                assert_same(&inside.concat(), counts.expect("a valid scene"), "backwards");
                let mut pixels = vec![1; width * height];
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
