//! Caustics, pixel by pixel, against rays from the lamp. Photons blur them: intervals hold the truth nonetheless, near the edges of
//! what is lit, too.

use super::caustics::{GLASS, HALF, MIRROR, OF_LAMPS, plate};
use eightfold_lab::arguments::{Part, Size};
use eightfold_lab::sampler::{MAX_POINTS, Sampler, Sequence, around, disc, seed_of};
use eightfold_lab::truth::REPLICATIONS;
use eightfold_lab::truth::estimate::mean_and_variance;
use eightfold_lab::truth::film::{Film, Sampling};
use eightfold_lab::truth::render::Picture;
use eightfold_lab::truth::surface::Bounce;
use eightfold_lab::truth::world::World;
use eightfold_oracle::geometry::{Ray, width};
use eightfold_tracer::glam::{DVec2, DVec3, EulerRot, Mat3A, Vec3A, dvec2, dvec3, vec3a};
use eightfold_tracer::scene::{Block, List, Material, Scene, Shape, Sphere, Waves};
use rayon::prelude::*;
use std::f64::consts::TAU;

/// The side of the pictures, in pixels.
const SIDE: usize = 64;
/// Pixels as near as this to a side of the plate are its edges, and those near to two sides are its corners.
const RIM: usize = 4;
/// Directions from the lamp are divided into so many parts both ways.
const PARTS: usize = 512;
/// Rays that tell whether light comes by a part: those of a narrow mirror come by few of them.
const TRIED: usize = 16;
/// Rays of a picture, from the lamp by all parts that light comes by. The noise of four is nothing beside the intervals.
const RAYS: usize = 1 << 18;
/// Rays where most go past two narrow mirrors.
const RAYS_BY_TWO_MIRRORS: usize = 1 << 21;
/// Ways of light by more mirrors and glass, or with a smaller share of it, are left out.
const MOST_BOUNCES: usize = 12;
const LEAST_SHARE: f64 = 1e-3;
/// Samples of a pixel where they are few: two of each replication.
const FEW: usize = 16;
/// The least share of intervals that hold the light, at each place.
const LEAST_HELD: f64 = 0.93;

/// The light that a lamp, a point, sends towards a sphere.
struct Beam {
    world: World,
    o: DVec3,
    axis: DVec3,
    /// One minus the cosine of its half angle.
    width: f64,
}

impl Beam {
    fn new(scene: &Scene, centre: DVec3, radius: f64) -> Self {
        let o = scene.lights[0].position.as_dvec3();
        Self {
            world: World::new(scene, SIDE, SIDE, false),
            o,
            axis: (centre - o).normalize(),
            width: width(radius, centre.distance(o)),
        }
    }

    /// Follows the light in a direction, by numbers from 0 to 1. Calls `lit` with each pixel of the plate to which it comes by way of
    /// mirrors and glass, and with the irradiance that a solid angle of 1 would give an area of 1.
    fn follow(&self, u: DVec2, lit: &mut impl FnMut(usize, f64)) {
        let p = disc(u);
        let cosine = 1.0 - self.width * p.length_squared();
        let start = around(self.axis, cosine, p.to_angle() / TAU);
        let mut ways = vec![(Ray::new(self.o, start), 0.0, 1.0, 0)];
        while let Some((ray, travelled, share, bounces)) = ways.pop() {
            let Some((body, met)) = self.world.nearest(ray) else {
                continue;
            };
            let travelled = travelled + met.t;
            let bsdf = self.world.surface(body, ray, &met, true);
            for bounce in [Bounce::Mirrored, Bounce::Through] {
                if let Some((d, part)) = bsdf.bounced(bounce)
                    && share * part > LEAST_SHARE
                    && bounces < MOST_BOUNCES
                {
                    let next = ray.moved(met.t).turned(d);
                    ways.push((next, travelled, share * part, bounces + 1));
                }
            }
            if bounces > 0 && bsdf.is_rough() && met.normal.y < -0.9 {
                let at = ray.at(met.t) / HALF * dvec3(1.0, 1.0, -1.0) + 1.0;
                let [x, y] = [at.x, at.z].map(|at| (0.5 * at * SIDE as f64) as usize);
                lit(
                    y.min(SIDE - 1) * SIDE + x.min(SIDE - 1),
                    share * travelled * travelled,
                );
            }
        }
    }

    /// The parts of the directions by which light comes to the plate, and those around them: some rays in each part tell.
    fn lit_parts(&self) -> Vec<usize> {
        let is_lit = |part: usize| {
            (0..TRIED).any(|i| {
                let mut is_lit = false;
                let mut sampler = Sampler::new(Sequence::Sobol, i, seed_of(!0, part as u64));
                let u = within(part, sampler.next_2d());
                self.follow(u, &mut |_, _| is_lit = true);
                is_lit
            })
        };
        let parts = (0..PARTS * PARTS).into_par_iter();
        let lit: Vec<bool> = parts.map(is_lit).collect();
        let is_near = |part: &usize| {
            (0..9).any(|i| {
                let [x, y] = [part % PARTS + i % 3, part / PARTS + i / 3];
                let is_inside = |at: usize| (1..=PARTS).contains(&at);
                is_inside(x) && is_inside(y) && lit[(y - 1) * PARTS + x - 1]
            })
        };
        (0..PARTS * PARTS).filter(is_near).collect()
    }

    /// The light that the plate sends from each pixel's square, by so many rays in these parts of the directions.
    fn picture(&self, parts: &[usize], rays: usize, seed: u32) -> Vec<f64> {
        let rays = (rays / parts.len()).min(MAX_POINTS);
        let solid_angle = TAU * self.width / (rays * PARTS * PARTS) as f64;
        let area = (2.0 * HALF / SIDE as f64).powi(2);
        let mut sums = vec![0.0; SIDE * SIDE];
        for &part in parts {
            for i in 0..rays {
                let mut sampler = Sampler::new(Sequence::Sobol, i, seed_of(seed, part as u64));
                let u = within(part, sampler.next_2d());
                self.follow(u, &mut |pixel, light| {
                    // The plate's albedo is a half.
                    sums[pixel] += 0.5 * solid_angle / area * light;
                });
            }
        }
        sums
    }
}

/// Numbers from 0 to 1 in a part, as numbers from 0 to 1 of all directions.
fn within(part: usize, u: DVec2) -> DVec2 {
    (dvec2((part % PARTS) as f64, (part / PARTS) as f64) + u) / PARTS as f64
}

/// A place of the plate: sums over its pixels.
#[derive(Default)]
struct Place {
    count: f64,
    /// How many intervals hold the truth.
    held: f64,
    /// Half the widths of the intervals.
    halves: f64,
    /// The standard deviations of the truth.
    noise: f64,
    /// The light that is found, and the truth.
    found: f64,
    known: f64,
}

/// Compares a film with pictures of the light that the plate sends, whose differences tell their noise: its middle, its edges and its corners.
fn places(film: &Film, known: &[Vec<f64>]) -> [Place; 3] {
    let is_near = |at: usize| usize::from(!(RIM..SIDE - RIM).contains(&at));
    let mut places = <[Place; 3]>::default();
    for (i, found) in film.estimates().iter().enumerate() {
        let known = known.iter().map(|known| DVec3::splat(known[i]));
        let (known, variance) = mean_and_variance(known);
        let (known, noise) = (known.x, variance.x.sqrt());
        let place = &mut places[is_near(i % SIDE) + is_near(i / SIDE)];
        let half = found.half_interval().x;
        place.count += 1.0;
        place.held += f64::from((found.mean.x - known).abs() <= half + 2.0 * noise);
        place.halves += half;
        place.noise += noise;
        place.found += found.mean.x;
        place.known += known;
    }
    places
}

/// The plate with [`FEW`] samples a pixel, and with the most that are asked for.
fn films(scene: &Scene, most: usize) -> Vec<Film> {
    assert_eq!(scene.validate(), Ok(()));
    let size = Size::new(SIDE, SIDE);
    let count = most / REPLICATIONS;
    let picture = Picture {
        scene,
        size,
        effects: OF_LAMPS,
        sampling: Sampling {
            count,
            sequence: Sequence::Sobol,
            seed: 1,
            is_antialiased: true,
        },
    };
    let subject = picture.subject();
    let mut film = Film::new(size, Part::WHOLE);
    let mut films = Vec::new();
    for drawn in 1..=count {
        film.expose(&subject, drawn, &|| {});
        if [FEW / REPLICATIONS, count].contains(&drawn) {
            films.push(film.clone());
        }
    }
    films
}

/// Asserts that the intervals hold the light of photons, and are not so wide that this is nothing. The light comes to the plate by way
/// of what is in a sphere.
#[track_caller]
fn assert_covers(case: &Case, most: usize) {
    let Case { name, scene, .. } = case;
    let beam = Beam::new(scene, case.centre, case.radius);
    let parts = beam.lit_parts();
    let seeds = (0..4).into_par_iter();
    let pictures = seeds.map(|seed| beam.picture(&parts, case.rays, seed));
    let known: Vec<Vec<f64>> = pictures.collect();
    for film in films(scene, most) {
        let samples = film.count() * REPLICATIONS;
        for (place, called) in places(&film, &known)
            .iter()
            .zip(["middle", "edges", "corners"])
        {
            let (share, wide) = (place.held / place.count, place.halves / place.known);
            let noise = place.noise / place.halves;
            let what = format!("{name}, {called}, {samples} samples");
            println!(
                "{what}: {share:.4} of the intervals, {wide:.3} of the light, {noise:.3} noise"
            );
            assert!(share > LEAST_HELD, "{what}: {share} of the intervals");
            assert!(wide < 1.0, "{what}: {wide} of the light");
            assert!(noise < 0.25, "{what}: {noise} of half an interval");
        }
    }
}

/// A plate with a block below, turned, and no other mirror.
fn above_block(centre: Vec3A, half: Vec3A, turn: f32, shape: Shape, material: Material) -> Scene {
    Scene {
        planes: List::default(),
        blocks: List::of(&[
            plate(MIRROR, 0.0).blocks[0],
            Block {
                axes: Mat3A::from_euler(EulerRot::XYZ, turn, 0.4 * turn, 0.3 * turn),
                ..Block::new(shape, centre, half, material)
            },
        ]),
        ..plate(MIRROR, 0.0)
    }
}

/// A plate above a small mirror.
fn above_mirror(centre: Vec3A, half: f32) -> Scene {
    let mut scene = plate(MIRROR, 0.0);
    let mirror = &mut scene.planes[0];
    (mirror.centre, mirror.half_x, mirror.half_z) = (centre, half, half);
    scene
}

/// Light that comes to the plate by way of what is in a sphere.
struct Case {
    name: String,
    scene: Scene,
    centre: DVec3,
    radius: f64,
    /// Rays of a picture of the truth.
    rays: usize,
}

/// What blocks of glass gather, which stand below the plate, turned, with the lamp below them.
fn by_glass(shape: Shape, turn: f32) -> Case {
    let centre = vec3a(0.1, -0.6, 0.0);
    let mut scene = above_block(centre, vec3a(0.4, 0.5, 0.4), turn, shape, GLASS);
    scene.lights[0].position = vec3a(0.3, -4.0, 0.2);
    Case {
        name: format!("{shape:?} of glass"),
        scene,
        centre: centre.as_dvec3(),
        radius: 0.95,
        rays: RAYS,
    }
}

/// What comes by way of a small mirror, and of a narrow one that is bent: a small part of the light towards either.
fn by_two_mirrors(shape: Shape) -> Case {
    let half = vec3a(0.12, 0.2, 0.12);
    let mut scene = above_block(vec3a(0.55, 0.3, 0.15), half, 0.98, shape, MIRROR);
    scene.planes = above_mirror(vec3a(0.9, 0.0, 0.2), 0.3).planes;
    Case {
        name: format!("{shape:?} and a mirror"),
        scene,
        centre: dvec3(0.75, 0.1, 0.15),
        radius: 0.6,
        rays: RAYS_BY_TWO_MIRRORS,
    }
}

fn by_waves() -> Case {
    let mut scene = above_mirror(vec3a(0.3, 0.0, 0.0), 0.8);
    scene.water = Waves {
        slope: 0.1,
        length: 0.4,
        phase: 0.0,
    };
    Case {
        name: "waves".into(),
        scene,
        centre: dvec3(0.3, 0.0, 0.0),
        radius: 1.14,
        rays: RAYS,
    }
}

fn by_ball_and_mirror() -> Case {
    let mut scene = above_mirror(vec3a(0.45, 0.0, 0.0), 0.5);
    scene.spheres = List::of(&[Sphere::new(vec3a(1.2, 1.0, 0.18), 0.35, GLASS)]);
    Case {
        name: "a ball and a mirror".into(),
        scene,
        centre: dvec3(0.8, 0.5, 0.1),
        radius: 1.0,
        rays: RAYS,
    }
}

#[test]
#[ignore = "many paths of light"]
fn intervals_hold_what_photons_blur_by_glass_waves_and_a_mirror() {
    let glass = [
        (Shape::Box, 0.5),
        (Shape::Cylinder, 0.9),
        (Shape::Capsule, 0.9),
    ];
    let glass = glass.map(|(shape, turn)| by_glass(shape, turn));
    let others = [by_waves(), by_ball_and_mirror()];
    for case in glass.iter().chain(&others) {
        assert_covers(case, 32);
    }
}

#[test]
#[ignore = "many paths of light"]
fn intervals_hold_what_photons_blur_by_two_mirrors() {
    for shape in [Shape::Cylinder, Shape::Capsule] {
        assert_covers(&by_two_mirrors(shape), 128);
    }
}

#[test]
fn cylinders_and_capsules_mirror_a_lamp_without_blur() {
    for shape in [Shape::Cylinder, Shape::Capsule] {
        let half = vec3a(0.15, 0.25, 0.15);
        let scene = above_block(-0.2 * Vec3A::Y, half, 1.3, shape, MIRROR);
        let beam = Beam::new(&scene, -0.2 * DVec3::Y, 0.31);
        let known = [beam.picture(&beam.lit_parts(), RAYS, 0)];
        for place in places(&films(&scene, FEW)[0], &known) {
            let off = place.found / place.known - 1.0;
            assert!(off.abs() < 0.01, "{shape:?}: {off}");
            assert!(place.halves < 0.1 * place.known, "{shape:?}");
        }
    }
}
