//! Copying a frame pixel by pixel (`minifb`) and through a socket (Xlib) takes a third of a frame's
//! time at 1024x768. So the tracer draws into memory shared with the server (MIT-SHM), which copies
//! one frame while the next is drawn. Displays without MIT-SHM get frames through the socket.

use core::ffi::{c_int, c_uint, c_ulong};
use core::mem::{size_of, zeroed};
use core::ops::Range;
use core::ptr::{null, null_mut};
use core::slice::from_raw_parts_mut;

use x11_dl::{xlib, xshm::XShmSegmentInfo};

use super::memory::allocate;
use super::x11::{Toplevel, XEXT, Xext};
use crate::render_target::MAX_PIXELS;

pub struct Frames {
    context: xlib::GC,
    image: *mut xlib::XImage,
    /// Set if the server shares the memory; otherwise frames go through the socket.
    shared: Option<&'static Xext>,
    /// The first is drawn next.
    frames: [&'static mut [u32]; 2],
    frame_size: (usize, usize),
}

impl Frames {
    /// Allocates memory for a window's two frames, shared with the server if possible.
    ///
    /// # Safety
    /// The image must have no other user, and the context must be from the display.
    pub unsafe fn new(top: &Toplevel, image: *mut xlib::XImage, context: xlib::GC) -> Frames {
        let mut frames =
            Frames { context, image, shared: None, frames: [&mut [], &mut []], frame_size: (0, 0) };
        // SAFETY: the image is valid.
        let is_shared = unsafe { (*image).bits_per_pixel } == 32;
        let shared = if is_shared { frames.share(top) } else { None };
        let memory = shared.unwrap_or_else(|| allocate(2 * MAX_PIXELS));
        // SAFETY: the image is valid.
        unsafe {
            // Xlib converts 32-bit pixels if the server's are smaller or have another byte order.
            (*image).bits_per_pixel = 32;
            (*image).byte_order = xlib::LSBFirst;
            (top.x.XInitImage)(image);
        }
        let (first, second) = memory.split_at_mut(MAX_PIXELS);
        frames.frames = [first, second];
        frames
    }

    pub fn canvas(&mut self, width: usize, height: usize) -> &mut [u32] {
        self.frame_size = (width, height);
        &mut self.frames[0][..width * height]
    }

    pub fn show(&mut self, top: &Toplevel, (width, height): (usize, usize)) {
        // SAFETY: the image belongs to this structure.
        let masks = masks(unsafe { &*self.image });
        if self.frame_size == (width, height) && masks == MASKS {
            finish(top);
            self.put(top, 0, width, 0..height);
            self.frames.swap(0, 1);
            return;
        }
        let rows = (MAX_PIXELS / width.max(1)).max(1);
        let mut first = 0;
        while first < height {
            let part = first..height.min(first + rows);
            finish(top);
            self.stretch((width, height), part.clone(), masks);
            self.put(top, 1, width, part);
            first += rows;
        }
    }

    /// Stretches `rows` of the frame to a window's size, with the channel `masks`, in the other
    /// frame's memory.
    fn stretch(
        &mut self,
        (width, height): (usize, usize),
        rows: Range<usize>,
        masks: [c_ulong; 3],
    ) {
        let [from, to] = &mut self.frames;
        let (from_width, from_height) = self.frame_size;
        // In 2^-32 pixels, plus 1, so that integer positions are not rounded down.
        let step = |from: usize, to: usize| (from << 32) / to.max(1) + 1;
        let (across, down) = (step(from_width, width), step(from_height, height));
        for (row, y) in to.chunks_exact_mut(width).zip(rows) {
            let from_row = &from[((y * down) >> 32) * from_width..][..from_width];
            for (x, pixel) in row.iter_mut().enumerate() {
                *pixel = with_masks(from_row[(x * across) >> 32], masks);
            }
        }
    }

    fn put(&mut self, window: &Toplevel, frame: usize, width: usize, rows: Range<usize>) {
        let pixels = &mut self.frames[frame];
        let Toplevel { x, display, window, .. } = *window;
        let context = self.context;
        let (top, columns, height) = (rows.start as c_int, width as c_uint, rows.len() as c_uint);
        // SAFETY: the image belongs to this structure, and describes these pixels.
        unsafe {
            let image = &mut *self.image;
            image.width = width as c_int;
            image.height = rows.len() as c_int;
            image.bytes_per_line = (width * size_of::<u32>()) as c_int;
            image.data = pixels.as_mut_ptr().cast();
            if let Some(xext) = self.shared {
                let put = xext.XShmPutImage;
                put(display, window, context, image, 0, 0, 0, top, columns, height, 0);
            } else {
                let put = x.XPutImage;
                put(display, window, context, image, 0, 0, 0, top, columns, height);
            }
        }
    }

    /// Allocates shared memory for two frames, if the server can attach it.
    fn share(&mut self, top: &Toplevel) -> Option<&'static mut [u32]> {
        let shared = XEXT.open()?;
        let size = 2 * MAX_PIXELS * size_of::<u32>();
        // SAFETY: the display is open and the image valid. The zeroed segment has this size, exists
        // as long as the process, and is read-only for the server. A zeroed `shmid_ds` is valid.
        unsafe {
            let id = libc::shmget(libc::IPC_PRIVATE, size, libc::IPC_CREAT | 0o600);
            let memory = libc::shmat(id, null(), 0);
            // Delete the segment after the last detach. Until then, Linux lets other processes
            // attach.
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
            // In a container the server may attach no segment, or another one with this id.
            let mut state: libc::shmid_ds = zeroed();
            libc::shmctl(id, libc::IPC_STAT, &mut state);
            if state.shm_nattch > 1 {
                self.shared = Some(shared);
            }
            Some(from_raw_parts_mut(memory, 2 * MAX_PIXELS))
        }
    }
}

fn finish(top: &Toplevel) {
    // SAFETY: the display is open.
    unsafe { (top.x.XSync)(top.display, xlib::False) };
}

/// The channel masks of a frame's pixels, `0x00RRGGBB`.
const MASKS: [c_ulong; 3] = [0xff_0000, 0xff00, 0xff];

fn with_masks(pixel: u32, masks: [c_ulong; 3]) -> u32 {
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

fn masks(image: &xlib::XImage) -> [c_ulong; 3] {
    [image.red_mask, image.green_mask, image.blue_mask]
}
