//! Measures how speed depends on the size of the picture and on the number of objects.

use crate::arguments::{NamedQuality, Size};
use crate::measure::{Plan, Setting, Shot};
use crate::scenes::SceneName;
use crate::way::Way;
use eightfold_tracer::scene::MAX_SPHERES;
use eightfold_tracer::{MAX_HEIGHT, MAX_WIDTH};
use eightfold_window::cpu::Isa;
use serde::Serialize;

/// The number of frames measured for each point of a curve.
const ROUNDS: usize = 7;

/// A curve of a plot.
#[derive(Clone, Serialize)]
pub struct Curve {
    /// The quality's name.
    pub name: String,
    /// The points, sorted by x.
    pub points: Vec<(f64, f64)>,
}

/// The sizes of a curve: those with a quarter, half, one and two times the sides, and the largest of the same aspect ratio.
fn sizes(size: Size, quick: bool) -> Vec<Size> {
    let Size { width, height } = size;
    let scaled = |by: f64| Size {
        width: ((width as f64 * by) as usize).max(1),
        height: ((height as f64 * by) as usize).max(1),
    };
    let most = (MAX_WIDTH as f64 / width as f64).min(MAX_HEIGHT as f64 / height as f64);
    let mut scales: Vec<f64> = [0.25, 0.5, 1.0, 2.0]
        .into_iter()
        .filter(|&by| by < most)
        .collect();
    if !quick || scales.is_empty() {
        scales.push(most);
    }
    scales.into_iter().map(scaled).collect()
}

/// The numbers of small spheres of a curve.
fn objects(quick: bool) -> &'static [usize] {
    if quick {
        &[1, 8, 64, MAX_SPHERES]
    } else {
        &[1, 2, 4, 8, 16, 32, 64, 128, 256, MAX_SPHERES]
    }
}

/// The qualities with a curve: the two that serve for comparison, and the ends and the middle of the ladder. All are antialiased,
/// or none is.
fn ways(antialias: bool) -> Vec<Way> {
    let has_curve = ["exhaustive", "thesis", "finest", "default", "fastest"];
    NamedQuality::all()
        .filter(|quality| has_curve.contains(&quality.name))
        .map(|quality| Way::new(quality.name, quality.antialiased(antialias).quality))
        .collect()
}

/// The plan of frames of some scenes at one time, in some sizes.
fn plan(scenes: &[SceneName], time: f32, sizes: Vec<Size>, isa: Isa, antialias: bool) -> Plan {
    let shots = scenes.iter().map(|&scene| Shot {
        scene,
        times: vec![time; ROUNDS],
        views: Vec::new(),
    });
    Plan {
        shots: shots.collect(),
        isa,
        sizes,
        threads: vec![1],
        ways: ways(antialias),
        is_on_processor: true,
        has_samples: false,
        has_missed: false,
    }
}

/// For each quality but the exhaustive one, the speed-up relative to that by the number of pixels.
pub fn by_resolution(of: &Plan, quick: bool, antialias: bool) -> Vec<Curve> {
    let shot = &of.shots[0];
    let sizes = sizes(of.sizes[0], quick);
    let plan = plan(&[shot.scene], shot.times[0], sizes, of.isa, antialias);
    let settings = plan.measure();
    let curve = |way: usize| {
        curve(&plan, way, &settings, |setting| {
            let [exhaustive, own] = [0, way].map(|way| setting.runs[way].quartile());
            (setting.size.area() as f64, exhaustive / own)
        })
    };
    (1..plan.ways.len()).map(curve).collect()
}

/// For each quality, the time of a frame by the number of spheres, as a multiple of that of an exhaustive frame with one sphere.
pub fn by_objects(of: &Plan, quick: bool, antialias: bool) -> Vec<Curve> {
    // A single sphere comes first.
    let counts = objects(quick);
    let fields: Vec<SceneName> = counts.iter().map(|&n| SceneName::Field(n)).collect();
    let time = of.shots[0].times[0];
    let plan = plan(&fields, time, of.sizes.clone(), of.isa, antialias);
    let settings = plan.measure();
    let unit = settings[0].runs[0].quartile();
    let curve = |way: usize| {
        curve(&plan, way, &settings, |setting| {
            let count = counts[setting.shot] as f64;
            (count, setting.runs[way].quartile() / unit)
        })
    };
    (0..plan.ways.len()).map(curve).collect()
}

/// The curve of a way through a point for each setting.
fn curve(
    plan: &Plan,
    way: usize,
    settings: &[Setting],
    point: impl Fn(&Setting) -> (f64, f64),
) -> Curve {
    Curve {
        name: plan.ways[way].name.clone(),
        points: settings.iter().map(point).collect(),
    }
}
