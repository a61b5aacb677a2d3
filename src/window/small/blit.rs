//! Pixels to a window.
//!
//! To copy a frame pixel by pixel, and once more through a socket, as `minifb` and Xlib do, takes a third of
//! the time of a frame at 1024x768. Here the tracer draws into memory that the server shares
//! (MIT-SHM), two frames in turns, and the server copies one while the next is drawn. Where memory
//! can't be shared, as with a display on another machine, frames go through the socket.

use core::{
    ffi::{c_int, c_uint, c_ulong},
    mem::{size_of, zeroed},
    ops::Range,
    ptr::{null, null_mut},
    slice::from_raw_parts_mut,
};

use x11_dl::{xlib, xshm::XShmSegmentInfo};

use super::{
    memory::pixels,
    x11::{self, Toplevel},
    xext::Xext,
};
use crate::screen::MOST_PIXELS;

/// Two frames in turns, and how they come to the window.
pub struct Frames {
    context: xlib::GC,
    /// Xlib's record of a picture; made to fit each one.
    image: *mut xlib::XImage,
    put_image: PutImage,
    /// The first is the one to be drawn and shown next.
    frames: [&'static mut [u32]; 2],
    /// Width and height of that one.
    drawn: (usize, usize),
}

/// How pixels come to the server.
#[derive(Clone, Copy)]
enum PutImage {
    /// By the connection to it, as copies.
    ThroughSocket,
    /// In memory that it shares, by functions of libXext.
    Shared(&'static Xext),
}

impl Frames {
    /// Memory for two frames of a window, which the server shares if it can.
    ///
    /// # Safety
    /// The image has to be one that nobody else has, and the context one of the display.
    pub unsafe fn new(top: &Toplevel, image: *mut xlib::XImage, context: xlib::GC) -> Frames {
        let mut frames = Frames {
            context,
            image,
            put_image: PutImage::ThroughSocket,
            frames: [&mut [], &mut []],
            drawn: (0, 0),
        };
        // SAFETY: the image is one.
        let is_shared = unsafe { (*image).bits_per_pixel } == 32;
        let shared = if is_shared { frames.share(top) } else { None };
        let memory = shared.unwrap_or_else(pixels);
        // SAFETY: the image is one.
        unsafe {
            // Of pixels of 32 bits Xlib makes the server's, if these are smaller or have another order of bytes.
            (*image).bits_per_pixel = 32;
            (*image).byte_order = xlib::LSBFirst;
            (top.x.XInitImage)(image);
        }
        let (first, second) = memory.split_at_mut(MOST_PIXELS);
        frames.frames = [first, second];
        frames
    }

    /// Room to draw a frame of a size.
    pub fn canvas(&mut self, width: usize, height: usize) -> &mut [u32] {
        self.drawn = (width, height);
        &mut self.frames[0][..width * height]
    }

    /// Shows the frame in the window, which has a size, stretched where its own is another, and by the server's own colours where
    /// it has them.
    pub fn show(&mut self, top: &Toplevel, (width, height): (usize, usize)) {
        // SAFETY: the image is this one's own.
        let masks = x11::masks(unsafe { &*self.image });
        if self.drawn == (width, height) && masks == x11::MASKS {
            finish(top);
            self.put(top, 0, width, 0..height);
            self.frames.swap(0, 1);
            return;
        }
        let rows = (MOST_PIXELS / width.max(1)).max(1);
        let mut first = 0;
        while first < height {
            let part = first..height.min(first + rows);
            finish(top);
            self.stretch((width, height), part.clone(), masks);
            self.put(top, 1, width, part);
            first += rows;
        }
    }

    /// Stretches the frame for some rows of a window, to the place of the other frame, and to pixels with such masks.
    fn stretch(
        &mut self,
        (width, height): (usize, usize),
        rows: Range<usize>,
        masks: [c_ulong; 3],
    ) {
        let [from, to] = &mut self.frames;
        let (from_width, from_height) = self.drawn;
        // Steps in units of 2^-32 pixels, rounded up, so that what is just a pixel stays one.
        let step = |from: usize, to: usize| (from << 32) / to.max(1) + 1;
        let (across, down) = (step(from_width, width), step(from_height, height));
        for (row, y) in to.chunks_exact_mut(width).zip(rows) {
            let from_row = &from[((y * down) >> 32) * from_width..][..from_width];
            for (x, pixel) in row.iter_mut().enumerate() {
                *pixel = x11::with_masks(from_row[(x * across) >> 32], masks);
            }
        }
    }

    /// Has the server copy one of the frames to some rows of the window.
    fn put(&mut self, window: &Toplevel, frame: usize, width: usize, rows: Range<usize>) {
        let pixels = &mut self.frames[frame];
        let Toplevel {
            x, display, window, ..
        } = *window;
        let context = self.context;
        let (top, columns, height) = (rows.start as c_int, width as c_uint, rows.len() as c_uint);
        // SAFETY: the image is this one's own, and says of the pixels what is so.
        unsafe {
            // Describe the rows to Xlib.
            let image = &mut *self.image;
            image.width = width as c_int;
            image.height = rows.len() as c_int;
            image.bytes_per_line = (width * size_of::<u32>()) as c_int;
            image.data = pixels.as_mut_ptr().cast();
            // Send them through the socket, or have the server read the shared memory.
            match self.put_image {
                PutImage::ThroughSocket => {
                    let put = x.XPutImage;
                    put(
                        display, window, context, image, 0, 0, 0, top, columns, height,
                    );
                }
                PutImage::Shared(xext) => {
                    let (put, unannounced) = (xext.XShmPutImage, xlib::False);
                    put(
                        display,
                        window,
                        context,
                        image,
                        0,
                        0,
                        0,
                        top,
                        columns,
                        height,
                        unannounced,
                    );
                }
            }
        }
    }

    /// Memory for two frames that other processes can share, if the system has it. If the server does, it takes frames from
    /// there.
    fn share(&mut self, top: &Toplevel) -> Option<&'static mut [u32]> {
        let shared = Xext::load()?;
        let size = 2 * MOST_PIXELS * size_of::<u32>();
        // SAFETY: the display is open and the image is one. The segment is as large as it says, zero to begin with, and
        // stays as long as the process. The server reads it, and writes never. Zero is a value of every field of its state.
        unsafe {
            let id = libc::shmget(libc::IPC_PRIVATE, size, libc::IPC_CREAT | 0o600);
            let memory = libc::shmat(id, null(), 0);
            // It goes away with the last that is attached, however that ends. Linux lets others attach to it all the same.
            libc::shmctl(id, libc::IPC_RMID, null_mut());
            if memory.addr() == usize::MAX {
                return None;
            }
            let memory: *mut u32 = memory.cast();
            let segment = Box::leak(Box::new(XShmSegmentInfo {
                shmseg: 0,
                shmid: id,
                shmaddr: memory.cast(),
                readOnly: xlib::True,
            }));
            (*self.image).obdata = (&raw mut *segment).cast();
            if (shared.XShmQueryExtension)(top.display) != 0 {
                (shared.XShmAttach)(top.display, segment);
                finish(top);
            }
            // This process is attached, and the server should be. From within a container it may not find the memory, or
            // find another by its number.
            let mut state: libc::shmid_ds = zeroed();
            libc::shmctl(id, libc::IPC_STAT, &mut state);
            if state.shm_nattch > 1 {
                self.put_image = PutImage::Shared(shared);
            }
            Some(from_raw_parts_mut(memory, 2 * MOST_PIXELS))
        }
    }
}

/// Waits until the server has taken the pixels that it was given before.
fn finish(top: &Toplevel) {
    // SAFETY: the display is open.
    unsafe { (top.x.XSync)(top.display, xlib::False) };
}
