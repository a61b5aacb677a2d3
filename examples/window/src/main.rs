//! Opens a window with a scene, on all threads:
//! `cargo run --release --manifest-path examples/window/Cargo.toml`

use eightfold_tracer::glam::{Vec3, vec3};
use eightfold_tracer::scene::{Light, Material, Plane, Scene, Sphere};
use eightfold_tracer::{Frame, Quality, Renderer, ScopedThreads};
use minifb::{Key, Window, WindowOptions};
use std::{error::Error, f32::consts::TAU, time::Instant};

/// Returns a turning ring of spheres over a mirror floor.
fn scene(time: f32) -> Scene {
    let material = Material { colour: Vec3::splat(0.6), kd: 0.8, kr: 0.2, ..Material::BLACK };
    let mut scene = Scene::default();
    scene.camera.eye = vec3(0.0, 3.0, -9.0);
    scene.background = vec3(0.1, 0.12, 0.2);
    let floor = Plane::new(Vec3::ZERO, 10.0, 10.0, material);
    scene.planes.push(floor);
    let light = Light::new(vec3(-4.0, 7.0, -5.0), Vec3::splat(0.9));
    scene.lights.push(light);
    for i in 0..12 {
        let angle = i as f32 * TAU / 12.0 + 0.5 * time;
        let (sin, cos) = angle.sin_cos();
        let colour = vec3(0.9, 0.08 * i as f32, 0.2);
        scene.spheres.push(Sphere {
            centre: vec3(3.0 * cos, 0.9 + 0.4 * (3.0 * angle + time).sin(), 3.0 * sin),
            radius: 0.5,
            material: Material { colour, ..material },
        });
    }
    scene
}

fn main() -> Result<(), Box<dyn Error>> {
    let mut window = Window::new("Ring", 800, 450, WindowOptions::default())?;
    window.set_target_fps(60);
    let mut pixels = Vec::new();
    let mut renderer = Renderer::detect();
    let mut threads = ScopedThreads::new();
    let start = Instant::now();
    while window.is_open() && !window.is_key_down(Key::Escape) {
        let time = start.elapsed().as_secs_f32();
        let (width, height) = window.get_size();
        pixels.resize(width * height, 0);
        let frame = Frame::new(width, height, &mut pixels);
        renderer.render(&scene(time), &Quality::DEFAULT, frame, &mut threads)?;
        window.update_with_buffer(&pixels, width, height)?;
    }
    Ok(())
}
