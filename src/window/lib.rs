//! Everything that touches the system, behind safe functions: the only `unsafe` of Eightfold.
//!
//! | what | module |
//! | --- | --- |
//! | the C `main` and the arguments | [`main!`], [`arguments`] |
//! | a screen to show frames on: a window, a terminal, or none | [`screen`], [`window`], [`terminal`] |
//! | what is done at a window with keys and mouse | [`input`] |
//! | sound, and the time by which it is heard | [`sound`] |
//! | time, and sleeping until it comes | [`clock`] |
//! | threads that share the work of a frame | [`pool`] |
//! | the best instruction set | [`cpu`] |
//! | memory of fixed size | [`fixed`] |
//! | lines of text to standard output and error | [`mod@line`] |
//!
//! There are three backends, with one interface: `window`, `threads`, `clock`, `memory` and `arguments` are modules of each.
//!
//! - The small one has a window by Xlib, and the rest by libc: Linux on x86-64, where the intro has 64 kB.
//! - The one for Windows in 64 kB, by the feature `windows`, calls functions of Windows alone, from code that is compiled for Linux
//!   on x86-64.
//! - The portable one has a window by `minifb`, and the rest by std: every other system and processor. On Linux on x86-64 it is
//!   taken by the feature `portable`.
//!
//! Files and terminals are those of Unix, or those of Windows, with each. Sound is by ALSA on Linux, by `cpal` on macOS.

#![deny(missing_docs)]

#[cfg(windows)]
compile_error!("the intro for Windows is compiled on Linux, by `cargo exe`");

pub mod arguments;
#[cfg_attr(feature = "windows", path = "win64/mod.rs")]
#[cfg_attr(
    not(any(feature = "windows", feature = "portable")),
    cfg_attr(
        all(target_os = "linux", target_arch = "x86_64"),
        path = "small/mod.rs"
    )
)]
#[cfg_attr(
    all(
        not(feature = "windows"),
        any(
            feature = "portable",
            not(all(target_os = "linux", target_arch = "x86_64"))
        )
    ),
    path = "portable/mod.rs"
)]
mod backend;
pub mod clock;
pub mod cpu;
pub mod fixed;
#[cfg(not(feature = "windows"))]
pub mod input;
pub mod line;
#[cfg(all(target_os = "linux", not(feature = "windows")))]
mod loading;
pub mod pool;
pub mod screen;
pub mod sound;
#[cfg_attr(feature = "windows", path = "system/win64.rs")]
#[cfg_attr(not(feature = "windows"), path = "system/unix.rs")]
mod system;
#[cfg_attr(not(feature = "windows"), path = "system/terminal.rs")]
#[cfg_attr(feature = "windows", path = "system/no_terminal.rs")]
pub mod terminal;

pub use backend::window;
