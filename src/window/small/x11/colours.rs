use core::ffi::c_ulong;

use x11_dl::xlib::XImage;

/// The channel masks of a frame's pixels, `0x00RRGGBB`.
pub const MASKS: [c_ulong; 3] = [0xff_0000, 0xff00, 0xff];

/// Converts a pixel to masks such as ten bits a channel.
pub fn with_masks(pixel: u32, masks: [c_ulong; 3]) -> u32 {
    if masks == MASKS {
        return pixel;
    }
    let [_, channels @ ..] = pixel.to_be_bytes();
    let parts = channels.iter().zip(masks);
    // Scale to the mask's value, and round at its lowest bit.
    parts.fold(0, |sum, (&channel, mask)| {
        let lowest = mask & mask.wrapping_neg();
        sum | (((c_ulong::from(channel) * mask + 127 * lowest) / 255) & mask) as u32
    })
}

pub fn masks(image: &XImage) -> [c_ulong; 3] {
    [image.red_mask, image.green_mask, image.blue_mask]
}
