//! The 64 kB backend for Windows: code compiled for x86-64 Linux that calls only functions of Windows. The program is linked at
//! fixed addresses without any library, and `src/pack` makes an `.exe` of it. Windows calls only the entry points of the program
//! and of its threads.

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
