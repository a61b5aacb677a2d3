//! A frame of the model scene by the library as WebAssembly: it is compiled for a target without a system.

use eightfold::show;
use eightfold_tracer::{Frame, Level, Quality, Renderer, Worker};

/// Width of the frame in pixels.
const WIDTH: usize = 640;
/// Height of the frame in pixels.
const HEIGHT: usize = 360;

/// The frame at 2 s, every pixel traced: the address of 640x360 pixels `0x00RRGGBB`, row by row from the top. They are never freed.
#[unsafe(no_mangle)]
pub extern "C" fn model_scene() -> *const u32 {
    let mut pixels = vec![0; WIDTH * HEIGHT];
    let frame = Frame::new(WIDTH, HEIGHT, &mut pixels);
    let scene = show::model_scene(2.0);
    Renderer::new(Level::baseline())
        .render(&scene, &Quality::EXHAUSTIVE, frame, &mut Worker::new())
        .expect("the scene, the quality and the size are valid");
    pixels.leak().as_ptr()
}
