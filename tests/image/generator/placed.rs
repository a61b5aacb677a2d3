//! Random scenes whose objects are placed by where they appear in the picture, each in its own colour.

use super::{fitting, materials, shape};
use crate::extremes::scaled;
use eightfold::show;
use eightfold_tracer::scene::{Block, Camera, Light, Material, Plane, Scene, Shape, Sphere};
use glam::{Mat3, Quat, Vec3, vec3};
use proptest::collection::vec;
use proptest::prelude::*;

/// Where a bounding sphere appears in the picture.
#[derive(Clone, Copy, Debug)]
struct Placement {
    /// The centre, as a share of the picture's width.
    x: f32,
    /// The centre, as a share of the picture's height.
    y: f32,
    /// The distance from the eye along the view direction, in scene units.
    distance: f32,
    /// The radius in pixels.
    radius: f32,
}

/// From a tenth of a pixel to half the picture, anywhere in it.
fn placement() -> impl Strategy<Value = Placement> {
    (0.0_f32..1.0, 0.0_f32..1.0, 0.5_f32..40.0, -1.0_f32..1.6).prop_map(
        |(x, y, distance, decades)| Placement {
            x,
            y,
            distance,
            radius: 10.0_f32.powf(decades),
        },
    )
}

/// A block inside a bounding sphere.
#[derive(Clone, Copy, Debug)]
struct PlacedBlock {
    placement: Placement,
    /// Half the extent along its own axes, as a share of the bounding sphere's radius.
    half: Vec3,
    rotation: Quat,
    shape: Shape,
}

/// Cubes, rods and slabs, aligned with the axes or not.
fn placed_block() -> impl Strategy<Value = PlacedBlock> {
    let share = || prop_oneof![Just(1.0_f32), 0.02_f32..1.0];
    let rotation = prop_oneof![
        1 => Just(Quat::IDENTITY),
        2 => ([-1.0_f32..1.0, -1.0..1.0, -1.0..1.0], 0.1_f32..1.0)
            .prop_map(|([x, y, z], w)| Quat::from_xyzw(x, y, z, w).normalize()),
    ];
    (placement(), (share(), share(), share()), rotation, shape()).prop_map(
        |(placement, (x, y, z), rotation, shape)| PlacedBlock {
            placement,
            half: fitting(shape, vec3(x, y, z)).normalize(),
            rotation,
            shape,
        },
    )
}

/// Blocks from half a pixel to far larger than the picture, some around the eye, some very thin.
fn extreme_block() -> impl Strategy<Value = PlacedBlock> {
    let thin = prop_oneof![2 => Just(1.0_f32), 1 => 1e-3_f32..0.1];
    (placed_block(), -0.3_f32..3.5, -1.5_f32..1.5, thin).prop_map(
        |(mut block, pixels, distance, thin)| {
            block.placement.radius = 10.0_f32.powf(pixels);
            block.placement.distance = 10.0_f32.powf(distance);
            block.half *= match block.shape {
                Shape::Box => vec3(1.0, thin, 1.0),
                Shape::Cylinder | Shape::Capsule => vec3(thin, 1.0, thin),
            };
            block
        },
    )
}

/// Rectangles of all sizes, below the eye and above.
fn plane() -> impl Strategy<Value = Plane> {
    let centre = (-6.0_f32..6.0, -3.0_f32..3.0, -6.0_f32..6.0);
    (centre, -1.5_f32..1.5, -1.5_f32..1.5).prop_map(|(centre, x, z)| Plane {
        centre: centre.into(),
        half_x: 10.0_f32.powf(x),
        half_z: 10.0_f32.powf(z),
        material: Material::default(),
    })
}

/// A camera among the objects, in any direction, sometimes along an axis.
fn camera() -> impl Strategy<Value = Camera> {
    let eye = (-3.0_f32..3.0, -2.0_f32..2.0, -3.0_f32..3.0);
    let direction = prop_oneof![
        3 => (-1.0_f32..1.0, -1.0_f32..1.0, -1.0_f32..1.0).prop_map(Vec3::from),
        1 => prop_oneof![Just(Vec3::X), Just(Vec3::NEG_Z), Just(vec3(0.0, -1.0, 1e-3))],
    ];
    (eye, direction, 0.2_f32..2.0).prop_map(|(eye, direction, field_of_view)| {
        let eye = Vec3::from(eye);
        Camera::new(eye, eye + direction + vec3(0.01, 0.0, 0.0), field_of_view)
    })
}

/// The colour that identifies the object of a number: colours differ by at least `step` of 255 in a channel.
fn colour(number: usize, step: usize) -> Vec3 {
    let digit = |unit: usize| (number / unit % 8 * step + 20) as f32 / 255.0;
    vec3(digit(1), digit(8), digit(64))
}

/// A material with that colour.
pub(super) fn material(number: usize, step: usize) -> Material {
    Material {
        colour: colour(number, step),
        ..Material::default()
    }
}

/// The scene with objects and lamps of distinct colours, see [`colour`], in ambient light alone.
fn coloured(mut scene: Scene, step: usize) -> Scene {
    let mut numbers = 1..;
    for (slot, number) in materials(&mut scene).into_iter().zip(&mut numbers) {
        *slot = material(number, step);
    }
    for (light, number) in scene.lights.iter_mut().zip(numbers) {
        light.colour = colour(number, step);
    }
    Scene {
        background: colour(0, step),
        ambient: Vec3::ONE,
        ..scene
    }
}

/// The parts of a scene of objects with distinct colours in ambient light alone, so that each pixel tells what it shows.
#[derive(Clone, Debug)]
pub struct Placed {
    camera: Camera,
    spheres: Vec<Placement>,
    /// Spheres around the eye or next to it: the radius, and the distance of the centre from the eye as a share of it.
    around: Vec<(f32, f32)>,
    planes: Vec<Plane>,
    blocks: Vec<PlacedBlock>,
    /// The number of spheres that are lights instead.
    lights: usize,
    /// The factor on all lengths.
    scale: f32,
    /// The smallest difference of two objects' colours, see [`colour`].
    step: usize,
    pub width: usize,
    pub height: usize,
}

impl Placed {
    /// The centre and the radius of a bounding sphere.
    fn ball(&self, placement: &Placement) -> (Vec3, f32) {
        let raster = self.camera.raster(self.width, self.height);
        // On the ray through a pixel's centre, so that even small objects are hit by a ray.
        let pixel = |share: f32, size: usize| (share * size as f32).floor();
        let (x, y) = (
            pixel(placement.x, self.width),
            pixel(placement.y, self.height),
        );
        let d = raster.corner + raster.dx * x + raster.dy * y;
        let centre = self.camera.eye + d * placement.distance;
        (
            centre,
            placement.radius * raster.dx.length() * placement.distance,
        )
    }

    /// The scene.
    pub fn scene(&self) -> Scene {
        let mut balls: Vec<(Vec3, f32)> = self
            .spheres
            .iter()
            .map(|sphere| self.ball(sphere))
            .collect();
        for &(radius, share) in &self.around {
            let centre = self.camera.eye + vec3(0.6, 0.0, 0.8) * (radius * share);
            balls.push((centre, radius));
        }
        let plain = Material::default();
        let lights = balls.split_off(balls.len() - self.lights.min(balls.len()));
        let spheres: Vec<Sphere> = balls
            .iter()
            .map(|&(centre, radius)| Sphere::new(centre, radius, plain))
            .collect();
        let lights: Vec<Light> = lights
            .iter()
            .map(|&(position, radius)| Light {
                drawn_radius: radius,
                ..Light::new(position, Vec3::ZERO)
            })
            .collect();
        let block = |block: &PlacedBlock| {
            let (centre, radius) = self.ball(&block.placement);
            Block {
                axes: Mat3::from_quat(block.rotation),
                ..Block::new(block.shape, centre, block.half * radius, plain)
            }
        };
        let blocks: Vec<Block> = self.blocks.iter().map(block).collect();
        let scene = Scene {
            camera: self.camera,
            spheres: spheres.iter().copied().collect(),
            planes: self.planes.iter().copied().collect(),
            blocks: blocks.iter().copied().collect(),
            lights: lights.iter().copied().collect(),
            ..Scene::default()
        };
        let scene = coloured(scene, self.step);
        scaled(&scene, self.scale)
    }
}

/// Spheres, planes, blocks and lights around the camera.
pub fn placed() -> impl Strategy<Value = Placed> {
    let around = (
        0.05_f32..20.0,
        prop_oneof![0.0_f32..0.99, 1.001_f32..2.0, Just(1.0_f32)],
    );
    (
        camera(),
        vec(placement(), 1..64),
        prop_oneof![3 => Just(vec![]), 1 => vec(around, 1..3)],
        vec(plane(), 0..3),
        prop_oneof![2 => Just(vec![]), 1 => vec(placed_block(), 1..12)],
        0_usize..3,
        (
            prop_oneof![Just(1_usize), Just(28)],
            prop_oneof![Just(0.0_f32), -4.0_f32..4.0],
        ),
        (1_usize..160, 1_usize..120),
    )
        .prop_map(
            |(
                camera,
                spheres,
                around,
                planes,
                blocks,
                lights,
                (step, decades),
                (width, height),
            )| {
                Placed {
                    scale: 10.0_f32.powf(decades),
                    camera,
                    spheres,
                    around,
                    planes,
                    blocks,
                    lights,
                    step,
                    width,
                    height,
                }
            },
        )
}

/// Blocks of extreme sizes, with few or no spheres.
pub fn extreme_blocks() -> impl Strategy<Value = Placed> {
    let spheres = prop_oneof![Just(vec![]), vec(placement(), 1..8)];
    (placed(), spheres, vec(extreme_block(), 1..32)).prop_map(|(scene, spheres, blocks)| Placed {
        spheres,
        blocks,
        ..scene
    })
}

/// Small spheres, each between the corners of a square of 8 pixels, for a picture of 320 by 240.
pub fn between_corners() -> Scene {
    let sphere = |(column, row): (usize, usize)| Placement {
        x: (16 * column + 4) as f32 / 320.0 + 1e-3,
        y: (16 * row + 4) as f32 / 240.0 + 1e-3,
        distance: 10.0,
        radius: 0.3 + 0.15 * column as f32,
    };
    let positions = (0..15).flat_map(|row| (0..20).map(move |column| (column, row)));
    let scene = Placed {
        camera: Camera::default(),
        spheres: positions.map(sphere).collect(),
        around: Vec::new(),
        planes: Vec::new(),
        blocks: Vec::new(),
        lights: 0,
        scale: 1.0,
        step: 28,
        width: 320,
        height: 240,
    };
    scene.scene()
}

/// The show at a time in seconds, with objects of distinct colours in ambient light alone.
pub fn of_the_show(time: f32) -> Scene {
    let mut scene = Scene::default();
    show::at(time, &mut scene);
    let objects = Scene {
        camera: scene.camera,
        spheres: scene.spheres,
        planes: scene.planes,
        blocks: scene.blocks,
        ..Scene::default()
    };
    coloured(objects, 28)
}
