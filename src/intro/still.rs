//! Binary PPM: a header with the size, then bytes for red, green and blue of every pixel.

use eightfold_tracer::{Frame, Preset};
use eightfold_window::cpu::Isa;
use eightfold_window::line::{self, Writer};
use eightfold_window::render_target::{Headless, RenderTarget};

use super::MISUSE;
use super::options::{Options, SIZE};
use super::renderer::ShowRenderer;

/// Writes the frame at `time`, in nanoseconds, to standard output. Returns the exit code.
pub fn write(time: u64, options: &Options, isa: Isa, output: &mut Writer) -> i32 {
    if line::is_terminal(line::OUTPUT) {
        line::complain("standard output is a terminal; must be a file or a pipe", "");
        return MISUSE;
    }
    let quality = options.quality.unwrap_or(Preset::Default).quality();
    let (width, height) = options.size.unwrap_or(SIZE);
    let mut target = Headless::new((width, height));
    let pixels = target.canvas(width, height);
    let mut frame = Frame::new(width, height, &mut *pixels);
    ShowRenderer::new(options, isa).draw(time, 0, quality, &mut frame);
    output.format("P6\n# #\n255\n", &[width as u64, height as u64]);
    for pixel in pixels {
        for byte in &pixel.to_be_bytes()[1..] {
            output.byte(*byte);
        }
    }
    0
}
