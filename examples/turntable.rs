//! Draws a turntable as PNG files into a folder:
//!
//!     cargo run --release -p eightfold-examples --bin turntable target/turntable

use eightfold_tracer::glam::{Mat3, Vec3, vec3};
use eightfold_tracer::scene::{Block, Light, Material, Pattern, Plane, Scene, Shape, Sphere};
use eightfold_tracer::{Frame, Governor, Renderer, ScopedThreads};
use std::{env, error::Error, f32::consts::TAU, fs, path::PathBuf, time};

fn scene(turns: f32) -> Scene {
    let (mut scene, axes) = (Scene::default(), Mat3::from_rotation_y(turns * TAU));
    (scene.camera.eye, scene.camera.look_at) = (vec3(0.0, 3.0, -7.0), vec3(0.0, 0.6, 0.0));
    (scene.background, scene.ambient) = (vec3(0.5, 0.6, 0.8), Vec3::splat(0.2));
    let sun = Light::sun(vec3(-3.0, 6.0, -4.0), Vec3::splat(0.6));
    let light = Light::spotlight(vec3(0.0, 6.0, 0.0), Vec3::NEG_Y, 0.5, Vec3::splat(0.7));
    scene.lights.extend([sun, light]);
    let floor = Material::matt(Vec3::ONE, 0.6).with_pattern(Pattern::checkers(1.0, 0.7));
    scene.planes.push(Plane::new(Vec3::ZERO, 20.0, 20.0, floor));
    let gold = Material::metal(vec3(1.0, 0.75, 0.4));
    let disc = Block::new(Shape::Cylinder, Vec3::ZERO, vec3(2.0, 0.2, 2.0), gold);
    let (centre, half) = (axes * vec3(-1.0, 0.7, 0.0), Vec3::splat(0.5));
    let cube = Block::new(Shape::Box, centre, half, gold);
    scene.blocks.extend([disc, Block { axes, ..cube }]);
    let ball = Sphere::new(axes * vec3(0.9, 1.0, 0.0), 0.8, Material::glass(1.5));
    scene.spheres.push(ball);
    scene
}

fn main() -> Result<(), Box<dyn Error>> {
    let (mut renderer, mut threads) = (Renderer::detect(), ScopedThreads::new());
    let mut governor = Governor::new(time::Duration::from_secs(1) / 60);
    let mut pixels = vec![0; 640 * 360];
    let folder = env::args_os().nth(1).unwrap_or("target/turntable".into());
    fs::create_dir_all(&folder)?;
    for number in 0..36_u8 {
        let (start, scene) = (time::Instant::now(), scene(f32::from(number) / 36.0));
        let frame = Frame::new(640, 360, &mut pixels);
        renderer.render(&scene, governor.preset().quality(), frame, &mut threads)?;
        governor.frame(start.elapsed());
        let file = PathBuf::from(&folder).join(format!("turntable-{number:02}.png"));
        let file = fs::File::create(file)?;
        let mut encoder = png::Encoder::new(file, 640, 360);
        encoder.set_color(png::ColorType::Rgb);
        let channels = |pixel: &u32| pixel.to_be_bytes().into_iter().skip(1);
        let rgb: Vec<u8> = pixels.iter().flat_map(channels).collect();
        encoder.write_header()?.write_image_data(&rgb)?;
    }
    Ok(())
}
