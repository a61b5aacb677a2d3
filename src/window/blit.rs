//! Pixels to a window.
//!
//! `minifb` copies a frame pixel by pixel, and Xlib once more through a socket: together a third of
//! the time of a frame at 1024x768. Here the tracer draws into memory that the server shares
//! (MIT-SHM), two frames in turns, and the server copies one while the next is drawn. Where memory
//! can't be shared, as with a display on another machine, frames go through the socket.

use core::{
    ffi::c_int,
    mem::size_of,
    ptr::{null_mut, with_exposed_provenance_mut},
    slice::from_raw_parts_mut,
    sync::atomic::{AtomicBool, Ordering::Relaxed},
};

use x11_dl::{
    xlib::{self, Functions},
    xshm::{XShmSegmentInfo, Xext},
};

use crate::{
    screen::{MOST_PIXELS, pixels},
    system::call,
};

/// Set when the server refuses a request for another reason than that the window is gone.
pub(crate) static REFUSED: AtomicBool = AtomicBool::new(false);

/// Two frames, and the way from there to a window.
pub(crate) struct Blit {
    x: Functions,
    display: *mut xlib::Display,
    window: xlib::Window,
    context: xlib::GC,
    /// What Xlib knows of a picture; made to fit each one.
    image: *mut xlib::XImage,
    shared: Option<&'static Xext>,
    frames: [&'static mut [u32]; 2],
    /// Width and height of the first frame, which is the one to be drawn and shown next.
    size: (usize, usize),
}

impl Blit {
    /// For a window on a display, if a pixel of it has 32 bits.
    pub fn new(x: Functions, display: *mut xlib::Display, window: xlib::Window) -> Option<Blit> {
        // SAFETY: the display is open. Xlib's picture without pixels belongs to nobody else.
        unsafe {
            let screen = &*(*display).screen();
            let image = (x.XCreateImage)(
                display,
                screen.root_visual,
                screen.root_depth as u32,
                xlib::ZPixmap,
                0,
                null_mut(),
                1,
                1,
                32,
                0,
            );
            if (*image).bits_per_pixel != 32 {
                return None;
            }
            let memory = share(x, display, image);
            let shared = memory.is_some();
            let memory = memory.unwrap_or_else(pixels);
            let (first, second) = memory.split_at_mut(MOST_PIXELS);
            Some(Blit {
                x,
                display,
                window,
                context: screen.default_gc,
                image,
                shared: if shared { Xext::load() } else { None },
                frames: [first, second],
                size: (0, 0),
            })
        }
    }

    /// The pixels of the next frame.
    pub fn canvas(&mut self, width: usize, height: usize) -> &mut [u32] {
        self.size = (width, height);
        &mut self.frames[0][..width * height]
    }

    /// Shows the frame in a window of a size, stretched where that is another.
    pub fn show(&mut self, (width, height): (usize, usize)) {
        if self.size == (width, height) {
            self.finish();
            self.put(0, width, 0, height);
            self.frames.swap(0, 1);
            return;
        }
        let rows = (MOST_PIXELS / width.max(1)).max(1);
        let mut top = 0;
        while top < height {
            let bottom = height.min(top + rows);
            self.finish();
            self.stretch((width, height), top, bottom);
            self.put(1, width, top, bottom);
            top = bottom;
        }
    }

    /// Stretches the frame for some rows of a window, to the place of the other frame.
    fn stretch(&mut self, (width, height): (usize, usize), top: usize, bottom: usize) {
        let [from, to] = &mut self.frames;
        let (from_width, from_height) = self.size;
        // Steps in units of 2^-32 pixels, rounded up, so that what is just a pixel stays one.
        let step = |from: usize, to: usize| (from << 32) / to.max(1) + 1;
        let (across, down) = (step(from_width, width), step(from_height, height));
        let mut pixels = to.iter_mut();
        for y in top..bottom {
            let row = ((y * down) >> 32) * from_width;
            for x in 0..width {
                if let (Some(to), Some(from)) =
                    (pixels.next(), from.get(row + ((x * across) >> 32)))
                {
                    *to = *from;
                }
            }
        }
    }

    /// Waits until the server has taken the pixels that it was given before.
    fn finish(&self) {
        if self.shared.is_some() {
            // SAFETY: the display is open.
            unsafe { (self.x.XSync)(self.display, xlib::False) };
        }
    }

    /// Has the server copy one of the frames to some rows of the window.
    fn put(&mut self, frame: usize, width: usize, top: usize, bottom: usize) {
        let height = bottom - top;
        let pixels = &mut self.frames[frame][..width * height];
        // SAFETY: the image is this one's own, and says of the pixels what is so.
        unsafe {
            let image = &mut *self.image;
            image.width = width as c_int;
            image.height = height as c_int;
            image.bytes_per_line = (width * size_of::<u32>()) as c_int;
            image.data = pixels.as_mut_ptr().cast();
            let (display, window, context) = (self.display, self.window, self.context);
            let (top, width, height) = (top as c_int, width as u32, height as u32);
            if let Some(shared) = self.shared {
                (shared.XShmPutImage)(
                    display,
                    window,
                    context,
                    image,
                    0,
                    0,
                    0,
                    top,
                    width,
                    height,
                    xlib::False,
                );
            } else {
                (self.x.XPutImage)(display, window, context, image, 0, 0, 0, top, width, height);
            }
        }
    }
}

/// Memory for two frames that the server shares, if it can.
///
/// # Safety
/// The display has to be open, and the image to be an image.
unsafe fn share(
    x: Functions,
    display: *mut xlib::Display,
    image: *mut xlib::XImage,
) -> Option<&'static mut [u32]> {
    let shared = Xext::load()?;
    let size = 2 * MOST_PIXELS * size_of::<u32>();
    // SAFETY: the segment is as large as it says, zero to begin with, and stays as long as the process.
    // The server reads it, and writes never.
    unsafe {
        let id = call!(SYS_shmget, libc::IPC_PRIVATE, size, libc::IPC_CREAT | 0o600);
        let memory = call!(SYS_shmat, id, 0, 0);
        if memory == -1 {
            return None;
        }
        let memory: *mut u32 = with_exposed_provenance_mut(memory as usize);
        let segment = Box::leak(Box::new(XShmSegmentInfo {
            shmseg: 0,
            shmid: id as c_int,
            shmaddr: memory.cast(),
            readOnly: xlib::True,
        }));
        (*image).obdata = (&raw mut *segment).cast();
        REFUSED.store(false, Relaxed);
        let attached =
            (shared.XShmQueryExtension)(display) != 0 && (shared.XShmAttach)(display, segment) != 0;
        (x.XSync)(display, xlib::False);
        // It goes away with the last that is attached, however that ends.
        call!(SYS_shmctl, id, libc::IPC_RMID, 0);
        if !attached || REFUSED.load(Relaxed) {
            return None;
        }
        Some(from_raw_parts_mut(memory, 2 * MOST_PIXELS))
    }
}
