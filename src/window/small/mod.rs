//! The intro in 64 kB: Linux on x86-64, by what libc and Xlib have.
//!
//! Everything here has its counterpart in the portable backend, by the same name.

#[path = "../abort.rs"]
mod abort;
pub mod arguments;
mod blit;
pub mod clock;
mod listener;
pub mod memory;
mod start;
pub mod threads;
pub mod window;
mod x11;
mod xext;
