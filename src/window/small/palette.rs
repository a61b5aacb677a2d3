//! Colours for displays whose pixels are numbers in a table.

use core::{
    ffi::{c_int, c_ulong},
    mem::zeroed,
};

use x11_dl::xlib;

use super::x11::Toplevel;

/// The pixels that the table is for: three bits of red, three of green, and two of blue.
const MASKS: [c_ulong; 3] = [0xe0, 0x1c, 0x03];

/// The entries of the table.
const COUNT: usize = 256;

/// Gives a window a table of colours, and a picture the pixels that it is for. Says if the display can't have such a table.
///
/// # Safety
/// The picture has to be one of the window's display.
pub unsafe fn set_palette(top: &Toplevel, image: *mut xlib::XImage) -> Result<(), &'static str> {
    let Toplevel {
        x, display, window, ..
    } = *top;
    // SAFETY: zero is a value of a colour; display and window are there, and the table outlives the call.
    unsafe {
        let visual = (*(x.XDefaultScreenOfDisplay)(display)).root_visual;
        // The class's numbers are odd where pixels are numbers in a table that can be changed (`GrayScale`, `PseudoColor`), or three in
        // three (`DirectColor`).
        if (*image).depth != 8 || (*visual).class & 1 == 0 {
            return Err("X display without colours");
        }
        [(*image).red_mask, (*image).green_mask, (*image).blue_mask] = MASKS;
        let mut table: [xlib::XColor; COUNT] = zeroed();
        for (pixel, colour) in (0..).zip(&mut table) {
            // A channel's bits are as bright as their share of the mask.
            let [red, green, blue] = MASKS.map(|mask| ((pixel & mask) * 0xffff / mask) as u16);
            colour.pixel = pixel;
            (colour.red, colour.green, colour.blue) = (red, green, blue);
            colour.flags = xlib::DoRed | xlib::DoGreen | xlib::DoBlue;
        }
        let map = (x.XCreateColormap)(display, window, visual, xlib::AllocAll);
        (x.XStoreColors)(display, map, table.as_mut_ptr(), COUNT as c_int);
        (x.XSetWindowColormap)(display, window, map);
        // Without a window manager nobody else does.
        (x.XInstallColormap)(display, map);
    }
    Ok(())
}
