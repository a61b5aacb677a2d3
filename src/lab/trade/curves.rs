//! Measures how speed depends on the size of the picture and on the number of objects.

use crate::arguments::{NamedQuality, Size};
use crate::measure::{Plan, Setting, Shot, Way};
use crate::scenes::SceneName;
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
        .map(|quality| Way {
            name: quality.name.to_owned(),
            quality: quality.antialiased(antialias).quality,
            hard_shadows: false,
        })
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

/// The plan of [`by_resolution`].
pub fn resolution_plan(of: &Plan, quick: bool, antialias: bool) -> Plan {
    let shot = &of.shots[0];
    let sizes = sizes(of.sizes[0], quick);
    plan(&[shot.scene], shot.times[0], sizes, of.isa, antialias)
}

/// The plan of [`by_objects`]. A single sphere comes first.
pub fn objects_plan(of: &Plan, quick: bool, antialias: bool) -> Plan {
    let fields: Vec<SceneName> = objects(quick)
        .iter()
        .map(|&n| SceneName::Field(n))
        .collect();
    let time = of.shots[0].times[0];
    plan(&fields, time, of.sizes.clone(), of.isa, antialias)
}

/// For each quality but the first, the speed-up relative to the first by the number of pixels.
pub fn by_resolution(plan: &Plan, settings: &[Setting]) -> Vec<Curve> {
    let of = |way: usize| {
        let point = |setting: &Setting| {
            let [exhaustive, own] = [0, way].map(|way| setting.runs[way].quartile());
            (setting.size.area() as f64, exhaustive / own)
        };
        settings.iter().map(point).collect()
    };
    let curves = (1..plan.ways.len()).map(|way| Curve {
        name: plan.ways[way].name.clone(),
        points: of(way),
    });
    curves.collect()
}

/// For each quality, the time of a frame by the number of spheres, as a multiple of that of an exhaustive frame with one sphere.
pub fn by_objects(plan: &Plan, settings: &[Setting]) -> Vec<Curve> {
    let unit = settings[0].runs[0].quartile();
    let of = |way: usize| {
        let point = |setting: &Setting| match plan.shots[setting.shot].scene {
            SceneName::Field(count) => Some((count as f64, setting.runs[way].quartile() / unit)),
            _ => None,
        };
        settings.iter().filter_map(point).collect()
    };
    let curves = (0..plan.ways.len()).map(|way| Curve {
        name: plan.ways[way].name.clone(),
        points: of(way),
    });
    curves.collect()
}
