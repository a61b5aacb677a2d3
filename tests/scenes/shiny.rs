use crate::{Random, materials, solids};
use eightfold_tracer::scene::{Block, Camera, Light, Plane, Scene, Shape, Sphere};
use glam::{Mat3, Vec3, vec3};

pub fn shiny(random: &mut Random, are_blocks: bool) -> Scene {
    let [x, z] = [random.between(-6.0, 6.0), random.between(5.0, 12.0)];
    let eye = vec3(x, random.power(-1.5, 1.0), z);
    let look_at = random.vector(vec3(-2.0, -0.6, -2.0), vec3(2.0, 0.6, 2.0));
    let mut scene = Scene {
        camera: Camera::new(eye, look_at, random.between(0.4, 1.4)),
        background: Vec3::splat(random.between(0.0, 0.3)),
        ambient: Vec3::splat(0.3),
        ..Scene::default()
    };
    for _ in 0..1 + random.below(14) {
        let at = random.vector(vec3(-5.0, 0.0, -5.0), vec3(5.0, 4.0, 5.0));
        let (radius, material) = (random.power(-1.3, 0.4), materials::shiny(random));
        if are_blocks {
            let half = vec3(radius, random.power(-1.5, 0.7), radius);
            let shape = random.one_of([Shape::Cylinder, Shape::Capsule]);
            let turn = random.turn();
            scene.blocks.push(Block {
                axes: random.one_of([turn, turn, Mat3::IDENTITY]),
                ..Block::new(shape, at + Vec3::Y, solids::fitting(shape, half), material)
            });
        } else {
            let above = random.one_of([0.0, at.y]) + radius;
            scene.spheres.push(Sphere::new(at.with_y(above), radius, material));
        }
    }
    if random.below(2) == 0 {
        let [x, z] = [0; 2].map(|_| random.power(0.3, 2.0));
        scene.planes.push(Plane::new(Vec3::ZERO, x, z, materials::shiny(random)));
    }
    for _ in 0..1 + random.below(3) {
        let wide = random.one_of([8.0, 8.0, 40.0]);
        let [x, z] = [0; 2].map(|_| random.between(-wide, wide));
        let position = vec3(x, random.power(-1.5, 1.2), z);
        let colour = Vec3::splat(random.between(0.2, 1.5));
        scene.lights.push(Light { parallel: random.below(7) == 0, ..Light::new(position, colour) });
    }
    scene
}
