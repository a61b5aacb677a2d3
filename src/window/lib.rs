//! Everything that touches the system, behind safe functions: the only `unsafe` of Eightfold.
//!
//! | what | module |
//! | --- | --- |
//! | the C `main` and the arguments | [`main!`], [`arguments`] |
//! | a screen to show frames on: a window, a terminal, or none | [`screen`], [`window`], [`terminal`] |
//! | sound, and the time by which it is heard | [`sound`] |
//! | time, and sleeping until it comes | [`clock`] |
//! | threads that share the work of a frame | [`pool`] |
//! | the best instruction set | [`cpu`] |
//! | memory of fixed size | [`fixed`] |
//! | lines of text to standard output and error | [`mod@line`] |
//!
//! `backend` has what is made for one system: the window by Xlib, and threads, the clock, memory and arguments by libc. Files and
//! terminals are those of Unix.
//!
//! It runs on Linux, on any processor of 64 bits.

#![deny(missing_docs)]
#![warn(clippy::undocumented_unsafe_blocks)]

#[cfg(not(target_os = "linux"))]
compile_error!("Eightfold's windows, threads and terminals are made for Linux");

pub mod arguments;
#[path = "small/mod.rs"]
mod backend;
pub mod clock;
pub mod cpu;
pub mod fixed;
mod keyboard;
pub mod line;
mod loading;
pub mod pool;
pub mod screen;
pub mod sound;
#[path = "system/unix.rs"]
mod system;
#[path = "system/terminal.rs"]
pub mod terminal;
mod x11;

pub use backend::window;
