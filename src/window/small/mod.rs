//! The small backend, for x86-64 Linux: Xlib and libc.

#[path = "../abort.rs"]
mod abort;
pub mod arguments;
mod blit;
pub mod clock;
mod listener;
pub mod memory;
pub mod threads;
pub mod window;
mod x11;

core::arch::global_asm!(include_str!("start.s"));
