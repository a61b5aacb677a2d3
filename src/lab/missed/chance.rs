//! Random scenes, in each of which small things show in one way.

use crate::random::Random;
use eightfold_tracer::glam::{EulerRot, Mat3, Vec3, vec3};
use eightfold_tracer::scene::{Block, Camera, Light, List, Material, Plane, Scene, Shape, Sphere};

/// The setting of a scene, beside small, matt things and a camera.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Setting {
    /// A matt floor, and a point of light.
    Point,
    /// A matt floor, and a lamp with a size.
    SizedLamp,
    /// A matt floor, and a sun.
    Sun,
    /// A matt floor and a point of light; the small things are boxes and cylinders.
    Blocks,
    /// Large matt spheres and a point of light.
    Spheres,
    /// A floor that is a mirror.
    Mirror,
    /// Large spheres that are mirrors.
    Mirrors,
    /// Large panes of glass.
    Glass,
    /// A shiny floor and a point of light; the small things are shiny spheres and cylinders.
    Shiny,
}

/// All of them.
pub const SETTINGS: [Setting; 9] = [
    Setting::Point,
    Setting::SizedLamp,
    Setting::Sun,
    Setting::Blocks,
    Setting::Spheres,
    Setting::Mirror,
    Setting::Mirrors,
    Setting::Glass,
    Setting::Shiny,
];

/// How many small things a scene has.
const THINGS: usize = 40;

/// A number from `low` to `high`.
fn between(random: &mut Random, low: f32, high: f32) -> f32 {
    low + (high - low) * random.next_1d() as f32
}

/// A point of the box from `low` to `high`.
fn point(random: &mut Random, low: Vec3, high: Vec3) -> Vec3 {
    let shares = [0; 3].map(|_| between(random, 0.0, 1.0));
    low + (high - low) * Vec3::from_array(shares)
}

/// A scene of a setting: the same for the same seed.
pub fn scene(setting: Setting, seed: u32) -> Scene {
    let random = &mut Random::new(seed, 0);
    let mut scene = Scene {
        camera: Camera {
            eye: point(random, vec3(-6.0, 2.0, 11.0), vec3(6.0, 7.0, 11.0)),
            look_at: Vec3::ZERO,
            up: Vec3::Y,
            field_of_view: between(random, 0.6, 1.0),
        },
        background: Vec3::splat(0.1),
        ambient: Vec3::splat(0.4),
        ..Scene::default()
    };
    add_things(setting, random, &mut scene);
    add_hosts(setting, random, &mut scene);
    scene
}

/// Adds the small things: spheres, or boxes and cylinders.
fn add_things(setting: Setting, random: &mut Random, scene: &mut Scene) {
    for number in 0..THINGS {
        let centre = point(random, vec3(-5.0, 0.5, -5.0), vec3(5.0, 3.0, 5.0));
        let is_shiny = setting == Setting::Shiny;
        let size = if is_shiny {
            between(random, 0.1, 0.8)
        } else {
            10.0_f32.powf(between(random, -2.0, -0.7))
        };
        let mut material = matt(point(random, Vec3::splat(0.3), Vec3::ONE));
        if is_shiny {
            material = shiny(material, random);
        }
        if setting != Setting::Blocks && !(is_shiny && number % 2 == 1) {
            scene.spheres.push(Sphere::new(centre, size, material));
            continue;
        }
        let [a, b, c] = [0; 3].map(|_| between(random, 0.0, 6.0));
        scene.blocks.push(Block {
            centre,
            half: point(random, Vec3::splat(0.5), Vec3::splat(2.0)) * size,
            axes: Mat3::from_euler(EulerRot::XYZ, a, b, c),
            shape: Shape::Box,
            material,
        });
        if number % 2 == 1
            && let Some(block) = scene.blocks.last_mut()
        {
            block.half.z = block.half.x;
            block.shape = Shape::Cylinder;
        }
    }
}

/// Adds what the things show on, in or through, and a lamp.
fn add_hosts(setting: Setting, random: &mut Random, scene: &mut Scene) {
    let mirror = Material::mirror(0.8);
    let white = matt(Vec3::splat(0.8));
    match setting {
        Setting::Point | Setting::SizedLamp | Setting::Sun | Setting::Blocks => {
            scene.planes = floor(white)
        }
        Setting::Mirror => scene.planes = floor(mirror),
        Setting::Shiny => scene.planes = floor(shiny(white, random)),
        Setting::Spheres | Setting::Mirrors => {
            let material = if setting == Setting::Spheres {
                white
            } else {
                mirror
            };
            for _ in 0..20 {
                scene.spheres.push(Sphere {
                    centre: point(random, vec3(-6.0, -2.0, -6.0), vec3(6.0, -0.5, 6.0)),
                    radius: between(random, 0.7, 1.5),
                    material,
                });
            }
        }
        Setting::Glass => {
            scene.blocks.push(Block {
                centre: scene.camera.eye * 0.6,
                half: vec3(20.0, 20.0, 0.1),
                axes: Mat3::IDENTITY,
                shape: Shape::Box,
                material: Material {
                    kt: 0.9,
                    index: 1.3,
                    ..Material::BLACK
                },
            });
        }
    }
    let position = point(random, vec3(-6.0, 5.0, -6.0), vec3(6.0, 9.0, 6.0));
    let light = Light::new(position, Vec3::splat(0.9));
    match setting {
        Setting::SizedLamp => scene.lights.push(Light {
            diameter: 0.5,
            ..light
        }),
        Setting::Sun => scene.lights.push(Light {
            parallel: true,
            ..light
        }),
        Setting::Mirror | Setting::Mirrors | Setting::Glass => {}
        _ => scene.lights.push(light),
    }
}

/// A matt material.
fn matt(colour: Vec3) -> Material {
    Material::matt(colour, 0.8)
}

/// A material with highlights of any size.
fn shiny(material: Material, random: &mut Random) -> Material {
    Material {
        ks: between(random, 0.2, 1.0),
        exponent: 10.0_f32.powf(between(random, 1.0, 3.0)),
        kd: 0.5,
        ..material
    }
}

/// A floor.
fn floor<const N: usize>(material: Material) -> List<Plane, N> {
    List::of(&[Plane::new(Vec3::ZERO, 20.0, 20.0, material)])
}
