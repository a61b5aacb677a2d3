//! Writes one frame as a binary PPM file: a header with the size, then bytes for red, green and blue of every pixel.

use core::fmt::{self, Write};

use eightfold_tracer::Frame;
use eightfold_window::{
    line::{self, Decimal, Writer},
    render_target::{Headless, RenderTarget},
};

use super::{
    MISUSE, exit_code,
    options::Options,
    qualities::{self, NAMED},
    renderer::ShowRenderer,
};

/// Writes the frame at a time in nanoseconds to standard output. Returns the exit code.
pub fn write(time: u64, options: &Options) -> i32 {
    if line::terminal(line::OUTPUT) {
        line::complain(format_args!(
            "a terminal can't show a PPM file: --still S > frame.ppm"
        ));
        return MISUSE;
    }
    let (_, quality) = &NAMED[options.quality.unwrap_or(qualities::DEFAULT)];
    let (width, height) = options.size;
    let mut target = Headless::new(width, height);
    let pixels = target.canvas(width, height);
    let mut frame = Frame::new(width, height, &mut *pixels);
    ShowRenderer::new(options).draw(time, 0, quality, &mut frame);
    exit_code(write_ppm(width, height, pixels))
}

/// Writes a picture of `0x00RRGGBB` pixels in row-major order.
fn write_ppm(width: usize, height: usize, pixels: &[u32]) -> fmt::Result {
    let mut head = Writer::new(line::OUTPUT);
    let size = [width, height].map(|side| Decimal(side as u64));
    write!(head, "P6\n{} {}\n255\n", size[0], size[1])?;
    head.flush()?;
    let mut part = [[0; 3]; 1024];
    for pixels in pixels.chunks(part.len()) {
        for (to, pixel) in part.iter_mut().zip(pixels) {
            let [_, red, green, blue] = pixel.to_be_bytes();
            *to = [red, green, blue];
        }
        if !line::write(line::OUTPUT, part[..pixels.len()].as_flattened()) {
            return Err(fmt::Error);
        }
    }
    Ok(())
}
