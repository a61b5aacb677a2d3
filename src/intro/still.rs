//! Binary PPM: a header with the size, then bytes for red, green and blue of every pixel.

use eightfold_tracer::Frame;
use eightfold_window::{
    cpu::Isa,
    line::{self, Writer},
    render_target::{Headless, RenderTarget},
};

use super::{
    MISUSE, exit_code,
    options::Options,
    qualities::{self, NAMED},
    renderer::ShowRenderer,
};

/// Writes the frame at `time`, in nanoseconds, to standard output. Returns the exit code.
pub fn write(time: u64, options: &Options, isa: Isa) -> i32 {
    if line::is_terminal(line::OUTPUT) {
        line::complaint()
            .text("standard output is a terminal; must be a file or a pipe\n")
            .flush();
        return MISUSE;
    }
    let (_, quality) = &NAMED[options.quality.unwrap_or(qualities::DEFAULT)];
    let (width, height) = options.size;
    let mut target = Headless::new(width, height);
    let pixels = target.canvas(width, height);
    let mut frame = Frame::new(width, height, &mut *pixels);
    ShowRenderer::new(options, isa).draw(time, 0, quality, &mut frame);
    exit_code(write_ppm(width, height, pixels))
}

/// Writes a picture of `0x00RRGGBB` pixels in row-major order.
fn write_ppm(width: usize, height: usize, pixels: &[u32]) -> bool {
    let mut head = Writer::new(line::OUTPUT);
    head.text("P6\n").decimal(width as u64);
    head.text(" ").decimal(height as u64).text("\n255\n");
    let mut is_written = head.flush();
    let mut part = [[0; 3]; 1024];
    for pixels in pixels.chunks(part.len()) {
        for (to, pixel) in part.iter_mut().zip(pixels) {
            let [_, red, green, blue] = pixel.to_be_bytes();
            *to = [red, green, blue];
        }
        let bytes = part[..pixels.len()].as_flattened();
        is_written = is_written && line::write(line::OUTPUT, bytes);
    }
    is_written
}
