//! Nothing that can be seen in a pixel is missed: every object that tracing every pixel shows is shown by every quality.
//!
//! Objects shine by ambient light alone, each in a colour of its own, so that a pixel tells what it shows.

use crate::cpu::{self, Isa};
use crate::drawn::draw;
use crate::extremes::scaled;
use crate::random::config;
use crate::refinement::bare;
use crate::studio::Studio;
use eightfold::scene::{Block, Camera, Light, List, Material, Plane, Scene, Shape, Sphere};
use eightfold::{Quality, show};
use glam::{Mat3A, Quat, Vec3A, vec3a};
use proptest::collection::vec;
use proptest::prelude::*;
use std::collections::HashSet;

/// Where a sphere is in the picture, and how large: shares of its width and height, distance, radius in pixels.
#[derive(Clone, Copy, Debug)]
struct Spot {
    x: f32,
    y: f32,
    distance: f32,
    radius: f32,
}

/// Spheres of a tenth of a pixel to half the picture, anywhere in it; the near ones hide others.
fn spot() -> impl Strategy<Value = Spot> {
    (0.0_f32..1.0, 0.0_f32..1.0, 0.5_f32..40.0, -1.0_f32..1.6).prop_map(
        |(x, y, distance, decades)| Spot {
            x,
            y,
            distance,
            radius: 10.0_f32.powf(decades),
        },
    )
}

/// A box or a cylinder in the sphere of a spot: shares of its radius along the axes, how it is turned, whether it is round.
#[derive(Clone, Copy, Debug)]
struct Body {
    spot: Spot,
    half: Vec3A,
    turned: Quat,
    shape: Shape,
}

/// Cubes, rods and slabs, upright or not.
fn body() -> impl Strategy<Value = Body> {
    let share = || prop_oneof![Just(1.0_f32), 0.02_f32..1.0];
    let turned = prop_oneof![
        1 => Just(Quat::IDENTITY),
        2 => ([-1.0_f32..1.0, -1.0..1.0, -1.0..1.0], 0.1_f32..1.0)
            .prop_map(|([x, y, z], w)| Quat::from_xyzw(x, y, z, w).normalize()),
    ];
    (
        spot(),
        (share(), share(), share()),
        turned,
        super::random::shape(),
    )
        .prop_map(|(spot, (x, y, z), turned, shape)| Body {
            spot,
            half: vec3a(x, y, if shape == Shape::Cylinder { x } else { z }).normalize(),
            turned,
            shape,
        })
}

/// Bodies of half a pixel to far more than the picture, near the eye and around it too: some are as thin as a hair.
fn bold_body() -> impl Strategy<Value = Body> {
    let thin = prop_oneof![2 => Just(1.0_f32), 1 => 1e-3_f32..0.1];
    (body(), -0.3_f32..3.5, -1.5_f32..1.5, thin).prop_map(|(mut body, pixels, distance, thin)| {
        body.spot.radius = 10.0_f32.powf(pixels);
        body.spot.distance = 10.0_f32.powf(distance);
        body.half *= if body.shape == Shape::Cylinder {
            vec3a(thin, 1.0, thin)
        } else {
            vec3a(1.0, thin, 1.0)
        };
        body
    })
}

/// Rectangles below and above, as large as a hand or a field.
fn plane() -> impl Strategy<Value = Plane> {
    let place = (-6.0_f32..6.0, -3.0_f32..3.0, -6.0_f32..6.0);
    (place, -1.5_f32..1.5, -1.5_f32..1.5).prop_map(|(place, x, z)| Plane {
        centre: place.into(),
        half_x: 10.0_f32.powf(x),
        half_z: 10.0_f32.powf(z),
        material: Material::default(),
    })
}

/// A camera among the objects, looking anywhere; sometimes straight along an axis.
fn camera() -> impl Strategy<Value = Camera> {
    let place = (-3.0_f32..3.0, -2.0_f32..2.0, -3.0_f32..3.0);
    let direction = prop_oneof![
        3 => (-1.0_f32..1.0, -1.0_f32..1.0, -1.0_f32..1.0).prop_map(Vec3A::from),
        1 => prop_oneof![Just(Vec3A::X), Just(Vec3A::NEG_Z), Just(vec3a(0.0, -1.0, 1e-3))],
    ];
    (place, direction, 0.2_f32..2.0).prop_map(|(place, direction, field_of_view)| {
        let eye = Vec3A::from(place);
        Camera {
            eye,
            look_at: eye + direction + vec3a(0.01, 0.0, 0.0),
            up: Vec3A::Y,
            field_of_view,
        }
    })
}

/// The colour of an object by its number; `step` of 255 apart from the next one in a channel.
fn colour(number: usize, step: usize) -> Vec3A {
    let digit = |place: usize| (number / place % 8 * step + 20) as f32 / 255.0;
    vec3a(digit(1), digit(8), digit(64))
}

fn material(number: usize, step: usize) -> Material {
    Material {
        colour: colour(number, step),
        ..Material::default()
    }
}

#[derive(Clone, Debug)]
struct Sketch {
    camera: Camera,
    spots: Vec<Spot>,
    /// Spheres around the eye, or near to it: how far their surface is from it, as a share of the radius.
    around: Vec<(f32, f32)>,
    planes: Vec<Plane>,
    bodies: Vec<Body>,
    lights: usize,
    /// How many times as large all is.
    scale: f32,
    step: usize,
    width: usize,
    height: usize,
}

impl Sketch {
    /// Centre and radius of a spot.
    fn ball(&self, spot: &Spot) -> (Vec3A, f32) {
        let raster = self.camera.raster(self.width, self.height);
        // On the way through a pixel's centre, so that hardly a small one is missed by all.
        let pixel = |share: f32, size: usize| (share * size as f32).floor();
        let (x, y) = (pixel(spot.x, self.width), pixel(spot.y, self.height));
        let d = raster.corner + raster.dx * x + raster.dy * y;
        let centre = self.camera.eye + d * spot.distance;
        (centre, spot.radius * raster.dx.length() * spot.distance)
    }

    fn scene(&self) -> Scene {
        let mut balls: Vec<(Vec3A, f32)> = self.spots.iter().map(|s| self.ball(s)).collect();
        for &(radius, share) in &self.around {
            let centre = self.camera.eye + vec3a(0.6, 0.0, 0.8) * (radius * share);
            balls.push((centre, radius));
        }
        let mut number = 1..;
        let mut next = || number.next().unwrap();
        let lights = balls.split_off(balls.len() - self.lights.min(balls.len()));
        let spheres: Vec<Sphere> = balls
            .iter()
            .map(|&(centre, radius)| Sphere {
                centre,
                radius,
                material: material(next(), self.step),
            })
            .collect();
        let lights: Vec<Light> = lights
            .iter()
            .map(|&(position, radius)| Light {
                position,
                radius,
                colour: colour(next(), self.step),
                ..Light::DARK
            })
            .collect();
        let planes: Vec<Plane> = self
            .planes
            .iter()
            .map(|plane| Plane {
                material: material(next(), self.step),
                ..*plane
            })
            .collect();
        let blocks: Vec<Block> = self
            .bodies
            .iter()
            .map(|body| {
                let (centre, radius) = self.ball(&body.spot);
                Block {
                    centre,
                    half: body.half * radius,
                    axes: Mat3A::from_quat(body.turned),
                    shape: body.shape,
                    material: material(next(), self.step),
                }
            })
            .collect();
        let scene = Scene {
            camera: self.camera,
            background: colour(0, self.step),
            ambient: Vec3A::ONE,
            spheres: List::of(&spheres),
            planes: List::of(&planes),
            blocks: List::of(&blocks),
            lights: List::of(&lights),
            ..Scene::default()
        };
        scaled(&scene, self.scale)
    }
}

fn sketch() -> impl Strategy<Value = Sketch> {
    let around = (
        0.05_f32..20.0,
        prop_oneof![0.0_f32..0.99, 1.001_f32..2.0, Just(1.0_f32)],
    );
    (
        camera(),
        vec(spot(), 1..64),
        prop_oneof![3 => Just(vec![]), 1 => vec(around, 1..3)],
        vec(plane(), 0..3),
        prop_oneof![2 => Just(vec![]), 1 => vec(body(), 1..12)],
        0_usize..3,
        (
            prop_oneof![Just(1_usize), Just(28)],
            prop_oneof![Just(0.0_f32), -4.0_f32..4.0],
        ),
        (1_usize..160, 1_usize..120),
    )
        .prop_map(
            |(camera, spots, around, planes, bodies, lights, (step, decades), (width, height))| {
                Sketch {
                    scale: 10.0_f32.powf(decades),
                    camera,
                    spots,
                    around,
                    planes,
                    bodies,
                    lights,
                    step,
                    width,
                    height,
                }
            },
        )
}

/// Boxes and cylinders of any size, with few or no spheres.
fn bold_sketch() -> impl Strategy<Value = Sketch> {
    let spots = prop_oneof![Just(vec![]), vec(spot(), 1..8)];
    (sketch(), spots, vec(bold_body(), 1..32)).prop_map(|(sketch, spots, bodies)| Sketch {
        spots,
        bodies,
        ..sketch
    })
}

/// All named qualities that do not trace every pixel, and the default one by squares of other sides than powers of two.
fn qualities() -> impl Iterator<Item = Quality> {
    let of_side = |square| Quality {
        square,
        ..Quality::DEFAULT
    };
    let named = Quality::LADDER.iter().copied().chain([Quality::THESIS]);
    named.chain([3, 5, 12, 17].map(of_side))
}

/// Asserts that each colour of the exhaustive picture but the background's is shown at one of its pixels: a gap between
/// objects may be missed.
fn assert_nothing_is_missed(scene: &Scene, width: usize, height: usize) {
    let mut studio = Studio::new(1);
    let mut draw = |isa: Isa, scene: &Scene, quality: &Quality| {
        let mut pixels = vec![0; width * height];
        studio.draw(isa.level, scene, quality, width, &mut pixels);
        pixels
    };
    let empty = Scene {
        background: scene.background,
        ..Scene::default()
    };
    for isa in cpu::instruction_sets() {
        let nothing = draw(isa, &empty, &Quality::EXHAUSTIVE)[0];
        // As if the background were shown in any case.
        let mut exhaustive = draw(isa, scene, &Quality::EXHAUSTIVE);
        exhaustive.push(nothing);
        for quality in qualities() {
            let mut drawn = draw(isa, scene, &quality);
            drawn.push(nothing);
            let missed = missed(&exhaustive, &drawn);
            assert_eq!(missed, 0, "by {} with {quality:?}", isa.name);
        }
    }
}

/// Spheres smaller than a square of 8 pixels, each between the corners of one, in a picture of 320 by 240.
pub fn between_corners() -> Scene {
    let sphere = |(column, row): (usize, usize)| Spot {
        x: (16 * column + 4) as f32 / 320.0 + 1e-3,
        y: (16 * row + 4) as f32 / 240.0 + 1e-3,
        distance: 10.0,
        radius: 0.3 + 0.15 * column as f32,
    };
    let places = (0..15).flat_map(|row| (0..20).map(move |column| (column, row)));
    let sketch = Sketch {
        camera: Camera::default(),
        spots: places.map(sphere).collect(),
        around: Vec::new(),
        planes: Vec::new(),
        bodies: Vec::new(),
        lights: 0,
        scale: 1.0,
        step: 28,
        width: 320,
        height: 240,
    };
    sketch.scene()
}

/// Colours of the exhaustive picture that a quality's has at none of the same pixels.
fn missed(exhaustive: &[u32], drawn: &[u32]) -> usize {
    let pairs = exhaustive.iter().zip(drawn);
    let shown: HashSet<u32> = pairs.filter(|(a, b)| a == b).map(|(&a, _)| a).collect();
    let all: HashSet<u32> = exhaustive.iter().copied().collect();
    all.difference(&shown).count()
}

#[test]
fn spheres_between_corners_are_shown_and_the_bare_rules_miss_them() {
    let scene = between_corners();
    let draw = |quality| draw(cpu::best(), 2, &scene, &quality, 320, 240).pixels;
    let exhaustive = draw(Quality::EXHAUSTIVE);
    for quality in qualities() {
        assert_eq!(missed(&exhaustive, &draw(quality)), 0, "{quality:?}");
        // They lie between the corners of squares of 8.
        if quality.square == 8 {
            let bare = missed(&exhaustive, &draw(bare(quality)));
            assert!(bare > 200, "{bare} missed by the bare {quality:?}");
        }
    }
}

/// A moment of the show, each object in a colour of its own.
fn moment(time: f32) -> Scene {
    let mut scene = Scene::default();
    show::at(time, &mut scene);
    let mut materials: Vec<&mut Material> = Vec::new();
    materials.extend(scene.spheres.iter_mut().map(|sphere| &mut sphere.material));
    materials.extend(scene.planes.iter_mut().map(|plane| &mut plane.material));
    materials.extend(scene.blocks.iter_mut().map(|block| &mut block.material));
    for (i, place) in materials.into_iter().enumerate() {
        *place = material(1 + i, 28);
    }
    Scene {
        camera: scene.camera,
        background: colour(0, 28),
        ambient: Vec3A::ONE,
        spheres: scene.spheres,
        planes: scene.planes,
        blocks: scene.blocks,
        ..Scene::default()
    }
}

proptest! {
    #![proptest_config(config(200))]

    #[test]
    fn every_object_of_the_show_is_shown_at_any_time_and_size(
        time in 0.0..show::grid::SHOW_LENGTH,
        width in 1_usize..160,
        height in 1_usize..120,
    ) {
        assert_nothing_is_missed(&moment(time), width, height);
    }

    #[test]
    fn every_object_that_a_pixel_can_show_is_shown(sketch in sketch()) {
        assert_nothing_is_missed(&sketch.scene(), sketch.width, sketch.height);
    }

    #[test]
    fn boxes_and_cylinders_of_any_size_are_shown(sketch in bold_sketch()) {
        assert_nothing_is_missed(&sketch.scene(), sketch.width, sketch.height);
    }
}
