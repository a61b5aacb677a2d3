//! The crate of safe functions for the operating system.
//!
//! Three backends have the modules `window`, `threads`, `clock`, `memory` and `arguments`:
//!
//! - The small one, on Xlib and libc, for the 64 kB intro on x86-64 Linux.
//! - The one for the 64 kB intro on Windows (feature `windows`), compiled for x86-64 Linux.
//! - The portable one, on `minifb` and std, for other systems and processors, or the feature
//!   `portable`.

#[cfg(windows)]
compile_error!("the intro for Windows is compiled on Linux, by `cargo exe`");

pub mod arguments;
#[cfg_attr(feature = "windows", path = "win64/mod.rs")]
#[cfg_attr(
    not(any(feature = "windows", feature = "portable")),
    cfg_attr(all(target_os = "linux", target_arch = "x86_64"), path = "small/mod.rs")
)]
#[cfg_attr(
    all(
        not(feature = "windows"),
        any(feature = "portable", not(all(target_os = "linux", target_arch = "x86_64")))
    ),
    path = "portable/mod.rs"
)]
mod backend;
pub mod clock;
pub mod cpu;
pub mod enlarge;
#[cfg(not(feature = "windows"))]
pub mod input;
pub mod line;
#[cfg(all(target_os = "linux", not(feature = "windows")))]
mod loading;
pub mod pool;
pub mod render_target;
pub mod sound;
pub mod static_cell;
#[cfg_attr(feature = "windows", path = "system/win64.rs")]
#[cfg_attr(not(feature = "windows"), path = "system/unix.rs")]
mod system;
#[cfg_attr(not(feature = "windows"), path = "system/terminal.rs")]
#[cfg_attr(feature = "windows", path = "system/no_terminal.rs")]
pub mod terminal;

pub use backend::window;
