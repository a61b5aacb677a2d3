//! The 64 kB backend for Windows, see `docs/windows.md`.

#[path = "../abort.rs"]
mod abort;
pub mod arguments;
pub mod clock;
pub mod functions;
mod heap;
pub mod memory;
pub mod threads;
pub mod window;

core::arch::global_asm!(include_str!("start.s"));
