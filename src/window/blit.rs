//! Pixels to a window.
//!
//! `minifb` copies a frame pixel by pixel, and Xlib once more through a socket: together a third of
//! the time of a frame at 1024x768. Here the tracer draws into memory that the server shares
//! (MIT-SHM), two frames in turns, and the server copies one while the next is drawn. Where memory
//! can't be shared, as with a display on another machine, frames go through the socket.

use core::{
    ffi::{c_int, c_uint, c_ulong},
    mem::{size_of, zeroed},
    ptr::{null, null_mut},
    slice::from_raw_parts_mut,
};

use x11_dl::{
    xlib,
    xshm::{XShmSegmentInfo, Xext},
};

use crate::{
    screen::{MOST_PIXELS, pixels},
    window::Window,
};

/// How pixels come to the server.
#[derive(Clone, Copy)]
pub(crate) enum PutImage {
    /// By the connection to it, as copies.
    ThroughSocket,
    /// In memory that it shares, by functions of libXext.
    Shared(&'static Xext),
}

/// The masks of a frame's pixels, `0x00RRGGBB`.
const MASKS: [c_ulong; 3] = [0xff_0000, 0xff00, 0xff];

/// A frame's pixel with other masks, such as those of ten bits a channel.
fn with_masks(pixel: u32, masks: [c_ulong; 3]) -> u32 {
    if masks == MASKS {
        return pixel;
    }
    let [_, channels @ ..] = pixel.to_be_bytes();
    let parts = channels.iter().zip(masks);
    // The mask is the brightest; below its lowest bit is what is cut off.
    parts.fold(0, |sum, (&channel, mask)| {
        sum | ((c_ulong::from(channel) * mask / 255) & mask) as u32
    })
}

impl Window {
    /// Shows the frame in the window, stretched where its size is another, and by the server's own colours where it has them.
    pub(crate) fn blit(&mut self) {
        let (width, height) = self.size;
        let masks = self.masks();
        if self.drawn == (width, height) && masks == MASKS {
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
            self.stretch((width, height), top, bottom, masks);
            self.put(1, width, top, bottom);
            top = bottom;
        }
    }

    /// The bits of a pixel of the server's that are red, green and blue.
    fn masks(&self) -> [c_ulong; 3] {
        // SAFETY: the image is this one's own.
        let image = unsafe { &*self.image };
        [image.red_mask, image.green_mask, image.blue_mask]
    }

    /// Stretches the frame for some rows of a window, to the place of the other frame, and to pixels with such masks.
    fn stretch(
        &mut self,
        (width, height): (usize, usize),
        top: usize,
        bottom: usize,
        masks: [c_ulong; 3],
    ) {
        let [from, to] = &mut self.frames;
        let (from_width, from_height) = self.drawn;
        // Steps in units of 2^-32 pixels, rounded up, so that what is just a pixel stays one.
        let step = |from: usize, to: usize| (from << 32) / to.max(1) + 1;
        let (across, down) = (step(from_width, width), step(from_height, height));
        for (row, y) in to.chunks_exact_mut(width).zip(top..bottom) {
            let from_row = &from[((y * down) >> 32) * from_width..][..from_width];
            for (x, pixel) in row.iter_mut().enumerate() {
                *pixel = with_masks(from_row[(x * across) >> 32], masks);
            }
        }
    }

    /// Waits until the server has taken the pixels that it was given before.
    fn finish(&self) {
        // SAFETY: the display is open.
        unsafe { (self.x.XSync)(self.display, xlib::False) };
    }

    /// Has the server copy one of the frames to some rows of the window.
    fn put(&mut self, frame: usize, width: usize, top: usize, bottom: usize) {
        let height = bottom - top;
        let pixels = &mut self.frames[frame];
        let (display, window, context) = (self.display, self.window, self.context);
        let (top, columns, rows) = (top as c_int, width as c_uint, height as c_uint);
        // SAFETY: the image is this one's own, and says of the pixels what is so.
        unsafe {
            let image = &mut *self.image;
            image.width = width as c_int;
            image.height = height as c_int;
            image.bytes_per_line = (width * size_of::<u32>()) as c_int;
            image.data = pixels.as_mut_ptr().cast();
            match self.put_image {
                PutImage::ThroughSocket => {
                    let put = self.x.XPutImage;
                    put(display, window, context, image, 0, 0, 0, top, columns, rows);
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
                        rows,
                        unannounced,
                    );
                }
            }
        }
    }

    /// Memory for two frames, which the server shares if it can.
    pub(crate) fn find_memory(&mut self) {
        let memory = self.share().unwrap_or_else(pixels);
        let (first, second) = memory.split_at_mut(MOST_PIXELS);
        self.frames = [first, second];
    }

    /// Memory for two frames that other processes can share, if the system has it. If the server does, it takes frames from
    /// there.
    fn share(&mut self) -> Option<&'static mut [u32]> {
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
            if (shared.XShmQueryExtension)(self.display) != 0 {
                (shared.XShmAttach)(self.display, segment);
                (self.x.XSync)(self.display, xlib::False);
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
