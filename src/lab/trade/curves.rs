//! Measures how the speed-up depends on the size of the picture and on the number of objects.

use crate::arguments::{NamedQuality, Size};
use crate::interrupt;
use crate::measure::{Plan, Setting, Shot, Technique};
use crate::row::quartile;
use crate::scenes::SceneName;
use eightfold_tracer::scene::MAX_SPHERES;
use eightfold_tracer::{MAX_HEIGHT, MAX_WIDTH};
use serde::Serialize;

/// The frames of each point of a curve.
const FRAMES: usize = 7;
/// The sides of the pictures, as multiples of `--size`.
const SCALES: [f64; 5] = [0.25, 0.5, 1.0, 2.0, 2.8];
/// The numbers of small spheres.
const SPHERES: [usize; 10] = [1, 2, 4, 8, 16, 32, 64, 128, 256, MAX_SPHERES];
/// The qualities with a curve, after the exhaustive one.
const NAMES: [&str; 4] = ["thesis", "finest", "default", "fastest"];

/// A curve of a plot.
#[derive(Serialize)]
pub struct Curve {
    /// The name of the quality.
    pub name: String,
    /// The speed-up over exhaustive frames by a number.
    pub points: Vec<(f64, f64)>,
}

/// Measures curves by the number of pixels.
pub fn by_resolution(of: &Plan) -> Vec<Curve> {
    let Size { width, height } = of.sizes[0];
    let scaled = |by: f64| Size {
        width: ((width as f64 * by) as usize).max(1),
        height: ((height as f64 * by) as usize).max(1),
    };
    let fits = |size: &Size| size.width <= MAX_WIDTH && size.height <= MAX_HEIGHT;
    let sizes = SCALES.into_iter().map(scaled).filter(fits).collect();
    curves(of, &[of.shots[0].scene], sizes, |setting| {
        setting.size.area()
    })
}

/// Measures curves by the number of spheres.
pub fn by_spheres(of: &Plan) -> Vec<Curve> {
    let fields = SPHERES.map(SceneName::Field);
    curves(of, &fields, of.sizes.clone(), |setting| {
        SPHERES[setting.shot]
    })
}

/// Measures frames of some scenes at their beginning, in some sizes. Returns curves with a point for each setting; none after Ctrl-C.
fn curves(
    of: &Plan,
    scenes: &[SceneName],
    sizes: Vec<Size>,
    x: impl Fn(&Setting) -> usize,
) -> Vec<Curve> {
    if interrupt::is_stopped() {
        return Vec::new();
    }
    let shots = scenes.iter().map(|&scene| Shot {
        scene,
        times: vec![0.0; FRAMES],
        views: Vec::new(),
    });
    let antialias = of.techniques[0].quality.antialias;
    let named = NamedQuality::all().filter(|named| NAMES.contains(&named.name));
    let all = [NamedQuality::EXHAUSTIVE].into_iter().chain(named);
    let plan = Plan {
        shots: shots.collect(),
        isa: of.isa,
        sizes,
        threads: vec![1],
        techniques: all
            .map(|named| Technique::named(named, antialias))
            .collect(),
    };
    let settings = plan.measure();
    let curve = |i: usize| {
        let speed_up = |setting: &Setting| quartile(&setting.runs[0]) / quartile(&setting.runs[i]);
        let points = settings
            .iter()
            .map(|setting| (x(setting) as f64, speed_up(setting)));
        Curve {
            name: plan.techniques[i].name.clone(),
            points: points.collect(),
        }
    };
    (1..plan.techniques.len()).map(curve).collect()
}
