use crate::materials::{self, bright};
use crate::{Random, solids};
use eightfold_tracer::scene::{Block, Camera, Light, List, Material, Plane, Scene, Shape, Sphere};
use glam::{Vec3, vec3};

#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Things {
    Spheres,
    Blocks,
    /// Larger spheres and blocks with highlights.
    Shiny,
    Both,
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Host {
    Floor(Material),
    Balls(Material),
    Pane,
}

/// Forty small objects, their host and the light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hidden {
    pub things: Things,
    pub host: Host,
    pub light: Option<Light>,
}

const GREY: Material = Material::matt(Vec3::splat(0.8), 0.9);
const LIGHT: Light = Light::new(Vec3::ZERO, Vec3::ONE);

const COUNT: usize = 40;

const AREA: Light = Light {
    diameter: 0.5,
    ..LIGHT
};
const SUN: Light = Light {
    parallel: true,
    ..LIGHT
};
const SHINY: Material = Material {
    ks: 0.5,
    exponent: 100.0,
    ..GREY
};

impl Hidden {
    pub const POINT: Self = Self::new(Things::Spheres, Host::Floor(GREY), Some(LIGHT));
    pub const AREA: Self = Self::new(Things::Spheres, Host::Floor(GREY), Some(AREA));
    pub const SUN: Self = Self::new(Things::Spheres, Host::Floor(GREY), Some(SUN));
    pub const BLOCKS: Self = Self::new(Things::Blocks, Host::Floor(GREY), Some(LIGHT));
    pub const BALLS: Self = Self::new(Things::Spheres, Host::Balls(GREY), Some(LIGHT));
    pub const MIRROR: Self = Self::new(Things::Both, Host::Floor(Material::mirror(0.5)), None);
    pub const MIRRORS: Self = Self::new(Things::Spheres, Host::Balls(Material::mirror(0.8)), None);
    pub const GLASS: Self = Self::new(Things::Spheres, Host::Pane, None);
    pub const SHINY: Self = Self::new(Things::Shiny, Host::Floor(SHINY), Some(LIGHT));
    pub const ALL: [Self; 9] = [
        Self::POINT,
        Self::AREA,
        Self::SUN,
        Self::BLOCKS,
        Self::BALLS,
        Self::MIRROR,
        Self::MIRRORS,
        Self::GLASS,
        Self::SHINY,
    ];

    const fn new(things: Things, host: Host, light: Option<Light>) -> Self {
        Self {
            things,
            host,
            light,
        }
    }

    pub fn scene(&self, random: &mut Random) -> Scene {
        let mut scene = floor(random, GREY);
        scene.planes = List::default();
        for number in 0..COUNT {
            self.add_thing(&mut scene, random, number);
        }
        match self.host {
            Host::Floor(material) => scene.planes = floor(random, material).planes,
            Host::Balls(material) => {
                for _ in 0..20 {
                    let centre = random.vector(vec3(-6.0, -2.0, -6.0), vec3(6.0, -0.5, 6.0));
                    let radius = random.between(0.7, 1.5);
                    scene.spheres.push(Sphere::new(centre, radius, material));
                }
            }
            Host::Pane => {
                let glass = Material {
                    kt: 0.9,
                    index: 1.3,
                    ..Material::BLACK
                };
                let (centre, half) = (scene.camera.eye * 0.6, vec3(20.0, 20.0, 0.1));
                let pane = Block::new(Shape::Box, centre, half, glass);
                scene.blocks.push(pane);
            }
        }
        let position = light_place(random);
        if let Some(light) = self.light {
            scene.lights.push(Light { position, ..light });
        }
        scene
    }

    fn add_thing(&self, scene: &mut Scene, random: &mut Random, number: usize) {
        let centre = random.vector(vec3(-5.0, 0.5, -5.0), vec3(5.0, 3.0, 5.0));
        let is_odd = number % 2 == 1;
        let small = random.power(-2.0, -0.3);
        let (size, material, is_block) = match self.things {
            Things::Spheres => (small, bright(number), false),
            Things::Blocks => (small, bright(number), true),
            Things::Both => (small, bright(number), is_odd),
            Things::Shiny => (random.between(0.1, 0.8), materials::shiny(random), is_odd),
        };
        if is_block {
            let thin = random.vector(Vec3::splat(0.03), Vec3::splat(0.3));
            let half = 2.0 * size * thin.with_y(1.0);
            let block = solids::block(random, centre, half, material);
            scene.blocks.push(block);
        } else {
            let sphere = Sphere::new(centre, size, material);
            scene.spheres.push(sphere);
        }
    }
}

fn light_place(random: &mut Random) -> Vec3 {
    random.vector(vec3(-6.0, 5.0, -6.0), vec3(6.0, 9.0, 6.0))
}

fn floor(random: &mut Random, material: Material) -> Scene {
    let eye = random.vector(vec3(-6.0, 2.0, 11.0), vec3(6.0, 8.0, 11.0));
    Scene {
        camera: Camera::new(eye, Vec3::ZERO, random.between(0.6, 1.0)),
        background: Vec3::splat(0.1),
        ambient: Vec3::splat(0.2),
        planes: List::of(&[Plane::new(Vec3::ZERO, 20.0, 20.0, material)]),
        ..Scene::default()
    }
}

/// Returns a slit of light between the shadows of two spheres: mostly a few pixels wide, ending where the shadows meet.
pub fn slit(random: &mut Random) -> Scene {
    let mut scene = floor(random, GREY);
    let direction = random.vector(vec3(-1.0, 0.0, -1.0), vec3(1.0, 0.0, 1.0));
    let apart = direction.normalize_or(Vec3::X) * (1.0 + random.between(-0.02, 0.05));
    for side in [-1.0, 1.0] {
        let centre = Vec3::Y * 1.5 + side * apart;
        let sphere = Sphere::new(centre, 1.0, Material::BLACK);
        scene.spheres.push(sphere);
    }
    let light = Light::new(light_place(random), Vec3::ONE);
    scene.lights.push(light);
    scene
}
