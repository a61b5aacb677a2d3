//! Kaleidoscopes, see `Presentation::sectors`.

use crate::cpu;
use crate::drawn::{REFINEMENTS, draw_best, of_the_show};
use crate::error::Difference;
use crate::soak::work;
use crate::threaded_renderer::ThreadedRenderer;
use eightfold_tracer::{Quality, presentation::Moment};

const SIZES: [[usize; 2]; 7] =
    [[240, 136], [103, 207], [133, 131], [1100, 40], [65, 33], [7, 9], [1, 1]];
const SECTORS: [f32; 5] = [1.0, 2.0, 4.0, 5.5, 8.0];

/// Returns the centre of a kaleidoscope, in pixels; the show's cameras have a `min_aspect` of 4:3.
fn centre([width, height]: [usize; 2]) -> [f32; 2] {
    let [width, height] = [width, height].map(|side| side as f32);
    [0.5 * width, (0.5 - 0.04 / f32::max(4.0 / 3.0 * height / width, 1.0)) * height]
}

fn source(sectors: f32, [width, height]: [usize; 2], [x, y]: [usize; 2]) -> [usize; 2] {
    let [mut left, mut top] = centre([width, height]).map(|at| at as usize / 8 * 8);
    if sectors < 4.0 {
        top = 0;
    }
    if sectors < 2.0 {
        left = 0;
    }
    let mirrored = |at: usize, middle: usize| {
        (2 * (at as i32 - middle as i32) + 1).unsigned_abs() as usize / 2
    };
    let [a, b] = [mirrored(x, left), mirrored(y, top)];
    let is_wide = width - left >= height - top;
    match (sectors >= 8.0, is_wide) {
        (false, _) => [left + a, top + b],
        (true, true) => [left + a.max(b), top + a.min(b)],
        (true, false) => [left + a.min(b), top + a.max(b)],
    }
}

fn scene(time: f32, sectors: f32) -> Moment {
    let mut moment = Moment::from(of_the_show(time));
    moment.presentation.sectors = sectors;
    moment
}

/// Draws over other pixels with 1 and 3 threads, and asserts that both agree, and that probes find
/// no error in exhaustive pictures.
fn draw(
    renderers: &mut [ThreadedRenderer; 2],
    scene: &Moment,
    quality: &Quality,
    [width, height]: [usize; 2],
) -> Vec<u32> {
    let mut old = 0;
    let [one, three] = renderers.each_mut().map(|renderer| {
        let mut pixels: Vec<u32> = vec![old; width * height];
        pixels.iter_mut().for_each(|pixel| {
            old = old.wrapping_mul(0x9e_3779) % 0xff_ffff + 1;
            *pixel = old;
        });
        renderer.set_probes(200, old);
        let counts = renderer.draw(cpu::best().level, scene, quality, width, &mut pixels);
        assert!(quality.square > 1 || counts.probes.psnr() == f32::INFINITY, "{:?}", counts.probes);
        (pixels, work(counts))
    });
    assert!(one == three, "{width}x{height} depends on threads or old pixels");
    one.0
}

#[test]
fn folded_picture_equals_its_reflections() {
    let mut renderers = [1, 3].map(ThreadedRenderer::new);
    for size in SIZES {
        let coarse = Quality { square: 32, ..Quality::DEFAULT };
        for quality in REFINEMENTS.into_iter().chain([coarse]) {
            for sectors in SECTORS {
                let [x, y] = centre(size).map(|at| at % 8.0);
                let (x, y) =
                    (if sectors < 2.0 { 0.0 } else { x }, if sectors < 4.0 { 0.0 } else { y });
                renderers.iter_mut().for_each(|it| it.set_offset(x, y));
                let whole = draw(&mut renderers, &scene(51.0, 1.0), &quality, size);
                renderers.iter_mut().for_each(|it| it.set_offset(0.0, 0.0));
                let what = format!("{size:?}, {sectors} sectors, {quality:?}");
                let folded = draw(&mut renderers, &scene(51.0, sectors), &quality, size);
                let from = (0..folded.len()).map(|i| {
                    let [x, y] = source(sectors, size, [i % size[0], i / size[0]]);
                    y * size[0] + x
                });
                let copied = |of: &[u32]| from.clone().map(|i| of[i]).collect::<Vec<_>>();
                assert!(folded == copied(&folded), "{what}");
                // Squares at the wedge's border decide a few squares in it.
                let difference = Difference::between(&copied(&whole), &folded);
                let is_near =
                    difference.mean == 0.0 || quality.square > 1 && difference.psnr > 45.0;
                assert!(is_near, "{what}: {difference:?}");
            }
        }
    }
}

#[test]
fn eight_sectors_trace_a_quarter_of_the_picture() {
    let points =
        |sectors| draw_best(&scene(51.0, sectors), &Quality::EXHAUSTIVE, 320, 180).counts.points;
    assert!(points(8.0) < points(1.0) / 4, "{} of {}", points(8.0), points(1.0));
}

/// The lamp is as high in a folded picture as in the whole one: no mirror cuts or doubles a part of
/// it.
#[test]
fn lamp_is_the_centre_of_folds_at_all_aspects() {
    for [width, height] in [[180, 320], [240, 240], [320, 240], [320, 180], [420, 180]] {
        let [whole, folded] = [1.0, 8.0].map(|sectors| {
            let mut shown = scene(98.0, sectors);
            // Gems and floor are as bright.
            shown.scene.spheres.clear();
            shown.scene.planes.clear();
            let drawn = draw_best(&shown, &Quality::EXHAUSTIVE, width, height);
            let column = drawn.pixels.chunks(width).map(|row| row[width / 2]);
            column.filter(|pixel| pixel & 255 > 215).count()
        });
        // The lamp's bright middle is an eighth of the height.
        let is_lamp = whole > width.min(height) / 9;
        assert!(is_lamp && whole.abs_diff(folded) <= 1, "{width}x{height}: {whole}, {folded}");
    }
}
