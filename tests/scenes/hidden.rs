use crate::materials::bright;
use crate::{Random, solids};
use eightfold_tracer::scene::{Camera, Light, List, Material, Plane, Scene, Sphere};
use glam::{Vec3, vec3};

#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hidden {
    /// Whether even and odd ones are blocks instead of spheres.
    pub are_blocks: [bool; 2],
    pub floor: Material,
    pub light: Option<Light>,
}

const GREY: Material = Material::matt(Vec3::splat(0.8), 0.9);
const LIGHT: Light = Light::new(Vec3::ZERO, Vec3::ONE);

const COUNT: usize = 40;

impl Hidden {
    pub const POINT: Self = Self { are_blocks: [false, false], floor: GREY, light: Some(LIGHT) };
    pub const BLOCKS: Self = Self { are_blocks: [true, true], ..Self::POINT };
    pub const MIRROR: Self =
        Self { are_blocks: [false, true], floor: Material::mirror(0.5), light: None };

    pub fn scene(&self, random: &mut Random) -> Scene {
        let mut scene = floor(random, GREY);
        scene.planes = List::default();
        for number in 0..COUNT {
            self.add_thing(&mut scene, random, number);
        }
        scene.planes = floor(random, self.floor).planes;
        let position = light_place(random);
        if let Some(light) = self.light {
            scene.lights.push(Light { position, ..light });
        }
        scene
    }

    fn add_thing(&self, scene: &mut Scene, random: &mut Random, number: usize) {
        let centre = random.vector(vec3(-5.0, 0.5, -5.0), vec3(5.0, 3.0, 5.0));
        let small = random.power(-2.0, -0.3);
        let material = bright(number);
        if self.are_blocks[number % 2] {
            let thin = random.vector(Vec3::splat(0.03), Vec3::splat(0.3)).with_y(1.0);
            let half = 2.0 * small * thin;
            let block = solids::block(random, centre, half, material);
            scene.blocks.push(block);
        } else {
            let sphere = Sphere::new(centre, small, material);
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
