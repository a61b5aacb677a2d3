//! The intro for Windows in 64 kB: code as it is compiled for Linux on x86-64, which calls functions of Windows and none of libc.
//!
//! Everything here has its counterpart in the other backends, by the same name. The program is linked for fixed addresses, with
//! nothing of a system, and `src/pack` makes an `.exe` of that. What differs between the two systems for code are calls: to Windows
//! all are `extern "win64"`, and Windows calls nothing of the program but its beginning and that of its threads.

#[path = "../abort.rs"]
mod abort;
pub mod arguments;
pub mod clock;
pub mod functions;
mod heap;
pub mod memory;
mod start;
pub mod threads;
pub mod types;
pub mod window;
