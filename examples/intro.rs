//! An intro of ten seconds, a ball that jumps to a kick:
//! `cargo run --release -p eightfold-examples --bin intro`

use eightfold_tracer::glam::{Vec3, vec3};
use eightfold_tracer::scene::{Light, Material, Plane, Scene, Sphere};
use eightfold_tracer::{Frame, Quality, Renderer, ScopedThreads};
use eightfold_window::render_target::{InnerSize, Next, RenderTarget};
use eightfold_window::sound::{Player, RATE, Source};
use eightfold_window::{clock::SECOND, static_cell::StaticCell, window::Window};
use std::{error::Error, process::ExitCode};

const LENGTH: f32 = 10.0;
const BEAT: f32 = 0.5;

/// The soundtrack: the index of the next sample, and the last block.
struct Kick(u32, [[f32; 2]; 48]);

static KICK: StaticCell<Kick> = StaticCell::new(Kick(0, [[0.0; 2]; 48]));

impl Source for Kick {
    fn chunk(&mut self) -> &[[f32; 2]] {
        for sample in &mut self.1 {
            let time = self.0 as f32 / RATE as f32 % BEAT;
            // A sine that falls from 250 Hz to 50 Hz within 0.1 s.
            let turns = 50.0 * time + 5.0 * (1.0 - (-40.0 * time).exp());
            *sample = [0.7 * (-8.0 * time).exp() * (std::f32::consts::TAU * turns).sin(); 2];
            self.0 += 1;
        }
        &self.1
    }
}

fn scene(time: f32) -> Scene {
    let beat = time % BEAT / BEAT;
    let material = Material { colour: vec3(1.0, 0.5, 0.1), kd: 0.7, kr: 0.2, ..Material::BLACK };
    let mut scene = Scene::default();
    scene.camera.eye = vec3(4.0 - 0.8 * time, 2.0, -6.0);
    scene.background = vec3(0.1, 0.12, 0.2);
    scene.exposure = (LENGTH - time).clamp(0.0, 1.0);
    let ball = vec3(0.0, 0.7 + 3.0 * beat * (1.0 - beat), 0.0);
    scene.spheres.push(Sphere::new(ball, 0.7, material));
    let floor = Plane::new(Vec3::ZERO, 12.0, 12.0, material);
    scene.planes.push(floor);
    let light = Light::new(vec3(4.0, 7.0, -4.0), Vec3::splat(1.2 - 0.6 * beat));
    scene.lights.push(light);
    scene
}

fn main() -> ExitCode {
    let Err(error) = play() else {
        return ExitCode::SUCCESS;
    };
    eprintln!("intro: {error}");
    ExitCode::FAILURE
}

fn play() -> Result<(), Box<dyn Error>> {
    let mut window = Window::open(c"Ten seconds", InnerSize::Exactly(640, 360))?;
    let mut renderer = Renderer::detect();
    let mut threads = ScopedThreads::new();
    let mut player = Player::start(KICK.take());
    loop {
        let time = player.time() as f32 / SECOND as f32;
        let (width, height) = window.size();
        let frame = Frame::new(width, height, window.canvas(width, height));
        renderer.render(&scene(time), &Quality::DEFAULT, frame, &mut threads)?;
        if window.show() != Next::GoOn || time >= LENGTH {
            return Ok(());
        }
    }
}
