use crate::interrupt;
use crate::measure::{Measurement, Setting, Shot, Technique};
use crate::row::quartile;
use crate::scenes::SceneName;
use eightfold_harness::Size;
use eightfold_tracer::scene::MAX_SPHERES;
use eightfold_tracer::{MAX_HEIGHT, MAX_WIDTH, Preset};
use serde::Serialize;

/// Repetitions of a frame.
const FRAMES: usize = 7;
/// Relative to `--size`.
const SCALES: [f64; 5] = [0.25, 0.5, 1.0, 2.0, 2.8];
const SPHERES: [usize; 10] = [1, 2, 4, 8, 16, 32, 64, 128, 256, MAX_SPHERES];
/// The reference first.
const PRESETS: [Preset; 5] =
    [Preset::Exhaustive, Preset::Thesis, Preset::Finest, Preset::Default, Preset::Fastest];

#[derive(Serialize)]
pub struct Curve {
    pub name: String,
    /// Number of pixels or spheres, and speed-up.
    pub points: Vec<(f64, f64)>,
}

pub fn by_resolution(of: &Measurement) -> Vec<Curve> {
    let sizes = SCALES.into_iter().map(|scale| of.sizes[0].scaled(scale));
    let fits = |size: &Size| size.width <= MAX_WIDTH && size.height <= MAX_HEIGHT;
    let sizes = sizes.filter(fits).collect();
    curves(of, &[of.shots[0].scene], sizes, |setting| setting.size.area())
}

pub fn by_spheres(of: &Measurement) -> Vec<Curve> {
    let fields = SPHERES.map(SceneName::Field);
    curves(of, &fields, of.sizes.clone(), |setting| SPHERES[setting.shot])
}

/// Measures the first frame of each scene. Returns no curves after Ctrl-C.
fn curves(
    of: &Measurement,
    scenes: &[SceneName],
    sizes: Vec<Size>,
    x: impl Fn(&Setting) -> usize,
) -> Vec<Curve> {
    if interrupt::is_stopped() {
        return Vec::new();
    }
    let shots =
        scenes.iter().map(|&scene| Shot { scene, times: vec![0.0; FRAMES], views: Vec::new() });
    let measurement = Measurement {
        shots: shots.collect(),
        isa: of.isa,
        sizes,
        threads: vec![1],
        techniques: PRESETS.map(|preset| Technique::named(preset, false)).to_vec(),
    };
    let settings = measurement.run();
    let curve = |i: usize| {
        let speed_up = |setting: &Setting| quartile(&setting.runs[0]) / quartile(&setting.runs[i]);
        let point = |setting| (x(setting) as f64, speed_up(setting));
        Curve { name: PRESETS[i].to_string(), points: settings.iter().map(point).collect() }
    };
    (1..PRESETS.len()).map(curve).collect()
}
