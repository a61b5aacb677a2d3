//! Caustics, pixel by pixel, against rays from the lamp. Photons blur them: intervals hold the truth nonetheless, near the edges of
//! what is lit, too.

use super::caustics::{GLASS, HALF, MIRROR, OF_LAMPS, plate};
use super::sphere;
use eightfold_lab::arguments::Size;
use eightfold_lab::sampler::{Sampler, Sequence, around, disc, seed_of};
use eightfold_lab::truth::film::Sampling;
use eightfold_lab::truth::render::Picture;
use eightfold_lab::truth::surface::Bounce;
use eightfold_lab::truth::world::World;
use eightfold_oracle::geometry::{Ray, width};
use eightfold_tracer::glam::{DVec2, DVec3, EulerRot, Mat3A, Vec3A, dvec2, dvec3, vec3a};
use eightfold_tracer::scene::{Block, List, Material, Scene, Shape, Waves};
use rayon::ThreadPoolBuilder;
use std::f64::consts::TAU;

/// The side of the pictures, in pixels.
const SIDE: usize = 64;
/// Pixels as near as this to a side of the plate are its edges, and those near to two sides are its corners.
const RIM: usize = 4;
/// Directions from the lamp are divided into so many parts both ways.
const PARTS: usize = 256;
/// Rays from the lamp: some hundreds for each pixel.
const RAYS: usize = 1 << 19;
/// Ways of light by more mirrors and glass, or with a smaller share of it, are left out.
const MOST_BOUNCES: usize = 12;
const LEAST_SHARE: f64 = 1e-3;

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

    /// The light that the plate sends from each pixel's square: a ray in each part of the directions tells from where it is lit, and
    /// from there come all others.
    fn picture(&self) -> Vec<f64> {
        let within = |part: usize, u: DVec2| {
            (dvec2((part % PARTS) as f64, (part / PARTS) as f64) + u) / PARTS as f64
        };
        let is_lit = |part: usize| {
            let mut is_lit = false;
            self.follow(within(part, DVec2::splat(0.5)), &mut |_, _| is_lit = true);
            is_lit
        };
        let lit: Vec<bool> = (0..PARTS * PARTS).map(is_lit).collect();
        let is_near = |part: &usize| {
            (0..9).any(|i| {
                let [x, y] = [part % PARTS + i % 3, part / PARTS + i / 3];
                let is_inside = |at: usize| (1..=PARTS).contains(&at);
                is_inside(x) && is_inside(y) && lit[(y - 1) * PARTS + x - 1]
            })
        };
        let parts: Vec<usize> = (0..PARTS * PARTS).filter(is_near).collect();
        let rays = RAYS / parts.len();
        let solid_angle = TAU * self.width / (rays * PARTS * PARTS) as f64;
        let area = (2.0 * HALF / SIDE as f64).powi(2);
        let mut sums = vec![0.0; SIDE * SIDE];
        for &part in &parts {
            for i in 0..rays {
                let mut sampler = Sampler::new(Sequence::Sobol, i, seed_of(0, part as u64));
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

/// A part of the plate: sums over its pixels.
#[derive(Default)]
struct Part {
    count: f64,
    /// How many intervals hold the truth.
    held: f64,
    /// Half the widths of the intervals.
    halves: f64,
    /// The light that is found, and the truth.
    found: f64,
    known: f64,
}

/// The middle of the plate, its edges and its corners, by the light that comes there by way of a sphere.
fn parts(scene: &Scene, centre: DVec3, radius: f64) -> [Part; 3] {
    assert_eq!(scene.validate(), Ok(()));
    let picture = Picture {
        scene,
        size: Size {
            width: SIDE,
            height: SIDE,
        },
        effects: OF_LAMPS,
        sampling: Sampling {
            count: 2,
            sequence: Sequence::Sobol,
            seed: 1,
            is_antialiased: true,
        },
    };
    let found = picture.draw(&ThreadPoolBuilder::new().build().expect("threads"));
    let known = Beam::new(scene, centre, radius).picture();
    let is_near = |at: usize| usize::from(!(RIM..SIDE - RIM).contains(&at));
    let mut parts = <[Part; 3]>::default();
    for (i, (found, known)) in found.iter().zip(known).enumerate() {
        let part = &mut parts[is_near(i % SIDE) + is_near(i / SIDE)];
        let half = found.half_interval().x;
        part.count += 1.0;
        part.held += f64::from((found.mean.x - known).abs() <= half);
        part.halves += half;
        part.found += found.mean.x;
        part.known += known;
    }
    parts
}

/// Asserts that the intervals hold the light of photons, and are not so wide that this is nothing.
#[track_caller]
fn assert_covers(name: &str, scene: &Scene, centre: DVec3, radius: f64) {
    let parts = parts(scene, centre, radius);
    for (part, place) in parts.iter().zip(["middle", "edges", "corners"]) {
        let (share, wide) = (part.held / part.count, part.halves / part.known);
        assert!(share > 0.93, "{name}, {place}: {share} of the intervals");
        assert!(wide < 1.0, "{name}, {place}: {wide} of the light");
    }
}

/// A plate with a block below, turned, and no other mirror.
fn above_block(centre: Vec3A, half: Vec3A, turn: f32, shape: Shape, material: Material) -> Scene {
    Scene {
        planes: List::default(),
        blocks: List::of(&[
            plate(MIRROR, 0.0).blocks[0],
            Block {
                centre,
                half,
                axes: Mat3A::from_euler(EulerRot::XYZ, turn, 0.4 * turn, 0.3 * turn),
                shape,
                material,
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

#[test]
fn intervals_hold_what_photons_blur() {
    let half = vec3a(0.4, 0.5, 0.4);
    let mut glass = above_block(vec3a(0.1, -0.6, 0.0), half, 0.5, Shape::Box, GLASS);
    glass.lights[0].position = vec3a(0.3, -4.0, 0.2);
    assert_covers("a box of glass", &glass, dvec3(0.1, -0.6, 0.0), 0.76);

    let mut water = above_mirror(vec3a(0.3, 0.0, 0.0), 0.8);
    water.water = Waves {
        slope: 0.1,
        length: 0.4,
        phase: 0.0,
    };
    assert_covers("waves", &water, dvec3(0.3, 0.0, 0.0), 1.14);

    let mut two = above_mirror(vec3a(0.45, 0.0, 0.0), 0.5);
    two.spheres = List::of(&[sphere(vec3a(1.2, 1.0, 0.18), 0.35, GLASS)]);
    assert_covers("a ball and a mirror", &two, dvec3(0.8, 0.5, 0.1), 1.0);
}

#[test]
fn cylinders_and_capsules_mirror_a_lamp_without_blur() {
    for shape in [Shape::Cylinder, Shape::Capsule] {
        let half = vec3a(0.15, 0.25, 0.15);
        let scene = above_block(-0.2 * Vec3A::Y, half, 1.3, shape, MIRROR);
        for part in parts(&scene, -0.2 * DVec3::Y, 0.31) {
            let off = part.found / part.known - 1.0;
            assert!(off.abs() < 0.01, "{shape:?}: {off}");
            assert!(part.halves < 0.1 * part.known, "{shape:?}");
        }
    }
}
