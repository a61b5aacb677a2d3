//! Prints speed and error of each preset for a scene: `cargo run --release -p eightfold-examples --bin trade`

use eightfold_tracer::glam::{Vec3, vec3};
use eightfold_tracer::scene::{Light, List, Material, Plane, Scene, Sphere};
use eightfold_tracer::{Error, Frame, Quality, Renderer, Worker};
use std::time::Instant;

const WIDTH: usize = 640;
const HEIGHT: usize = 360;
const FRAMES: usize = 20;

/// Returns a field of spheres, with the camera at z.
fn scene(z: f32) -> Scene {
    let material = Material::matt(vec3(0.9, 0.6, 0.3), 0.8);
    let mut scene = Scene::default();
    scene.camera.eye = vec3(0.0, 2.0, z - 4.0);
    scene.camera.look_at = vec3(0.0, 0.5, z);
    scene.spheres = List::of(&std::array::from_fn::<_, 40, _>(|i| {
        let centre = vec3((i % 4) as f32 - 1.5, 0.3, (i / 4) as f32);
        Sphere::new(centre, 0.3, material)
    }));
    let floor = Plane::new(Vec3::ZERO, 30.0, 30.0, material);
    scene.planes.push(floor);
    let light = Light::new(vec3(-4.0, 5.0, -6.0), Vec3::splat(0.9));
    scene.lights.push(light);
    scene
}

/// Renders frames. Returns the number of frames per second.
fn film(quality: &Quality, frames: &mut [u32]) -> Result<f64, Error> {
    let mut renderer = Renderer::detect();
    let mut worker = Worker::new();
    let start = Instant::now();
    for (i, pixels) in frames.chunks_mut(WIDTH * HEIGHT).enumerate() {
        let frame = Frame::new(WIDTH, HEIGHT, pixels);
        renderer.render(&scene(0.2 * i as f32), quality, frame, &mut worker)?;
    }
    Ok(FRAMES as f64 / start.elapsed().as_secs_f64())
}

/// Returns the PSNR in dB: 40 is visible, 50 hardly.
fn psnr(frames: &[u32], others: &[u32]) -> f64 {
    let channels = |&pixel: &u32| [16, 8, 0].map(|shift| f64::from(pixel >> shift & 0xff));
    let pairs = frames
        .iter()
        .flat_map(channels)
        .zip(others.iter().flat_map(channels));
    let squares: f64 = pairs.map(|(a, b)| (a - b).powi(2)).sum();
    10.0 * (255.0 * 255.0 * 3.0 * frames.len() as f64 / squares).log10()
}

fn main() -> Result<(), Error> {
    let mut exact = vec![0; FRAMES * WIDTH * HEIGHT];
    let mut frames = exact.clone();
    println!("quality     fps  speed-up  dB to exhaustive");
    for (name, quality) in Quality::NAMES.iter().zip(Quality::LADDER) {
        let slowest = film(&quality.reference(), &mut exact)?;
        let fps = film(quality, &mut frames)?;
        let psnr = psnr(&frames, &exact);
        println!("{name:8} {fps:6.1}  {:8.2}  {psnr:4.1}", fps / slowest);
    }
    Ok(())
}
