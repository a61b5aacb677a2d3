//! Writes a frame with outlines around its filled squares as PNG:
//!
//!     cargo run --release -p eightfold-examples --bin squares target/squares.png

use eightfold::show;
use eightfold_tracer::observe::{Fill, Observer};
use eightfold_tracer::{Counts, Frame, Quality, Renderer, ScopedThreads};
use std::{env, error::Error, fs, path::PathBuf, sync::Mutex};

// Multiples of 8, so that squares end inside the picture.
const WIDTH: usize = 640;
const HEIGHT: usize = 360;

/// `[x, y, width, height]` in pixels.
type Square = [usize; 4];

#[derive(Clone, Copy)]
struct Squares<'a>(&'a Mutex<Vec<Square>>);

impl Observer for Squares<'_> {
    fn point(self, _x: usize, _y: usize, _work: Counts) {}

    fn square(self, x: usize, y: usize, w: usize, h: usize, fill: Fill) {
        if fill != Fill::Points {
            self.0.lock().expect("not poisoned").push([x, y, w, h]);
        }
    }
}

/// Draws the upper and left sides; neighbours draw the others.
fn outline(pixels: &mut [u32], [x, y, w, h]: Square) {
    let blend = |pixel: &mut u32| *pixel = (*pixel >> 1 & 0x007f_7f7f) + 0x0060_6060;
    for x in x..x + w {
        blend(&mut pixels[y * WIDTH + x]);
    }
    for y in y + 1..y + h {
        blend(&mut pixels[y * WIDTH + x]);
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    let mut pixels = vec![0; WIDTH * HEIGHT];
    let frame = Frame::new(WIDTH, HEIGHT, &mut pixels);
    let squares = Mutex::default();
    let mut renderer = Renderer::detect();
    let (scene, quality) = (show::model_scene(2.0), Quality::DEFAULT);
    renderer.render_observed(
        &scene,
        &quality,
        frame,
        &mut ScopedThreads::new(),
        Squares(&squares),
    )?;

    let squares = squares.into_inner()?;
    println!("{} squares", squares.len());
    for &square in &squares {
        outline(&mut pixels, square);
    }

    let rgb = |pixel: &u32| [16, 8, 0].map(|shift| (pixel >> shift) as u8);
    let bytes: Vec<u8> = pixels.iter().flat_map(rgb).collect();
    let path = env::args_os().nth(1).unwrap_or("target/squares.png".into());
    let path = PathBuf::from(path);
    fs::create_dir_all(path.parent().unwrap_or(&path))?;
    let file = fs::File::create(path)?;
    let mut encoder = png::Encoder::new(file, WIDTH as u32, HEIGHT as u32);
    encoder.set_color(png::ColorType::Rgb);
    encoder.write_header()?.write_image_data(&bytes)?;
    Ok(())
}
