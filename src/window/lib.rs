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
//! There are two backends, with one interface: `window`, `threads`, `clock`, `memory` and `arguments` are modules of either.
//!
//! - The small one has a window by Xlib, and the rest by libc: Linux on x86-64, where the intro has 64 kB.
//! - The portable one has a window by `minifb`, and the rest by std: every other system and processor. On Linux on x86-64 it is
//!   taken by the feature `portable`.
//!
//! Files and terminals are those of Unix, or those of Windows, with either. Sound is by ALSA on Linux, and by `cpal` on Windows and
//! macOS.

#![deny(missing_docs)]

pub mod arguments;
#[cfg_attr(
    all(target_os = "linux", target_arch = "x86_64", not(feature = "portable")),
    path = "small/mod.rs"
)]
#[cfg_attr(
    not(all(target_os = "linux", target_arch = "x86_64", not(feature = "portable"))),
    path = "portable/mod.rs"
)]
mod backend;
pub mod clock;
pub mod cpu;
pub mod fixed;
pub mod input;
mod keyboard;
pub mod line;
#[cfg(target_os = "linux")]
mod loading;
pub mod pool;
pub mod screen;
pub mod sound;
#[cfg_attr(unix, path = "system/unix.rs")]
#[cfg_attr(windows, path = "system/windows.rs")]
mod system;
#[cfg_attr(unix, path = "system/terminal.rs")]
#[cfg_attr(windows, path = "system/no_terminal.rs")]
pub mod terminal;
#[cfg(target_os = "linux")]
mod x11;

pub use backend::window;
pub use system::is_signal_ignored;
