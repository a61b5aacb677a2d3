//! A still of a scene of one's own, as a PNG file: `cargo run --release -p eightfold-examples --bin still still.png`

use eightfold_tracer::glam::{Vec3, vec3};
use eightfold_tracer::scene::{Camera, Light, List, Material, Plane, Scene, Sphere};
use eightfold_tracer::{Frame, Quality, Renderer, ScopedThreads};
use std::{env, error::Error, fs::File};

const WIDTH: usize = 640;
const HEIGHT: usize = 360;

fn scene() -> Scene {
    let plastic = Material {
        colour: vec3(0.9, 0.2, 0.1),
        kd: 0.8,
        ks: 0.4,
        exponent: 40.0,
        kr: 0.15,
        ..Material::BLACK
    };
    let glass = Material {
        kd: 0.05,
        kt: 0.9,
        index: 1.5,
        tint: vec3(0.6, 0.8, 0.9),
        ..plastic
    };
    let sphere = |x, z, material| Sphere::new(vec3(x, 1.0, z), 1.0, material);
    Scene {
        camera: Camera {
            eye: vec3(-2.0, 2.5, -7.0),
            look_at: vec3(0.0, 0.8, 0.0),
            ..Camera::default()
        },
        background: vec3(0.5, 0.6, 0.8),
        ambient: Vec3::splat(0.15),
        spheres: List::of(&[sphere(-1.2, 0.5, plastic), sphere(1.2, -0.5, glass)]),
        planes: List::of(&[Plane {
            half_x: 20.0,
            half_z: 20.0,
            material: Material {
                colour: Vec3::splat(0.7),
                ..plastic
            },
            ..Plane::default()
        }]),
        lights: List::of(&[Light {
            position: vec3(-5.0, 8.0, -5.0),
            colour: Vec3::splat(0.9),
            diameter: 1.0,
            ..Light::DARK
        }]),
        ..Scene::default()
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    let mut pixels = vec![0; WIDTH * HEIGHT];
    let frame = Frame::new(WIDTH, HEIGHT, &mut pixels);
    let mut threads = ScopedThreads::new();
    let counts = Renderer::detect().render(&scene(), &Quality::DEFAULT, frame, &mut threads)?;
    println!("{} pixels by {} points", WIDTH * HEIGHT, counts.points);

    let rgb = |pixel: &u32| [16, 8, 0].map(|shift| (pixel >> shift) as u8);
    let bytes: Vec<u8> = pixels.iter().flat_map(rgb).collect();
    let file = File::create(env::args().nth(1).unwrap_or("still.png".into()))?;
    let mut encoder = png::Encoder::new(file, WIDTH as u32, HEIGHT as u32);
    encoder.set_color(png::ColorType::Rgb);
    encoder.write_header()?.write_image_data(&bytes)?;
    Ok(())
}
