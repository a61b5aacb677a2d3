use eightfold_harness::error::worst_channel;
use eightfold_harness::frame_trace::FrameTrace;
use eightfold_harness::picture::from_rgb;
use eightfold_tracer::Quality;
use std::sync::LazyLock;

pub fn draw_points(trace: &FrameTrace, pixels: &mut [u32]) {
    for (pixel, rays) in pixels.iter_mut().zip(trace.rays()) {
        let dark = (*pixel >> 2) & 0x003f_3f3f;
        *pixel = if rays > 0 { 0x00ff_ffff } else { dark };
    }
}

/// Colours squares by size, with dark left and upper edges.
pub fn draw_squares(trace: &FrameTrace, pixels: &mut [u32]) {
    for square in trace.squares() {
        let colour = square_colour(square.side);
        let dark = (colour >> 1) & 0x007f_7f7f;
        let edge = if square.side > 2 { dark } else { colour };
        for y in square.y..square.y + square.h {
            let row = &mut pixels[y * trace.width + square.x..][..square.w];
            row.fill(if y == square.y { edge } else { colour });
            row[0] = edge;
        }
    }
}

/// Draws 0 rays black, `max` white.
pub fn draw_heat(trace: &FrameTrace, pixels: &mut [u32], max: u32) {
    for (pixel, rays) in pixels.iter_mut().zip(trace.rays()) {
        *pixel = heat(rays as f32 / max as f32);
    }
}

/// Small squares, which cost more, are brighter.
pub fn square_colour(side: usize) -> u32 {
    let halvings = (Quality::MAX_SQUARE / side.max(1)).max(1).ilog2();
    heat(0.12 + 0.83 * halvings as f32 / Quality::MAX_SQUARE.ilog2() as f32)
}

/// Replaces pixels with their errors, white for `max` of 255 in a channel.
pub fn draw_error(pixels: &mut [u32], exhaustive: &[u32], max: u32) {
    for (pixel, &exhaustive) in pixels.iter_mut().zip(exhaustive) {
        *pixel = heat(worst_channel(*pixel, exhaustive) as f32 / max as f32);
    }
}

/// Returns a colour of the perceptually uniform "magma", from 0 to 1.
pub fn heat(share: f32) -> u32 {
    static SCALE: LazyLock<Vec<u32>> = LazyLock::new(|| from_rgb(&nv_flip::magma_lut().to_vec()));
    SCALE[(share.clamp(0.0, 1.0) * 255.0).round() as usize]
}
