//! Everything that touches the system, behind safe functions: the only `unsafe` of Eightfold.
//!
//! | what | module |
//! | --- | --- |
//! | the C `main` and its arguments | [`main!`], [`arguments`] |
//! | where a panic ends in the intro | [`abort`](mod@abort) |
//! | a screen to show frames on: a window, a terminal, or none | [`screen`], [`window`], [`terminal`] |
//! | sound, and the time by which it is heard | [`sound`] |
//! | time, and sleeping until it comes | [`clock`] |
//! | threads that share the work of a frame | [`pool`] |
//! | the best instruction set | [`cpu`] |
//! | memory of fixed size | [`fixed`] |
//! | lines of text to standard output and error | [`mod@line`] |
//!
//! Threads, waiting, time and output go through libc.
//!
//! It runs on Linux, on any processor of 64 bits.

#![deny(missing_docs)]
#![warn(clippy::undocumented_unsafe_blocks)]

#[cfg(not(target_os = "linux"))]
compile_error!("Eightfold's windows, threads and terminals are made for Linux");

pub mod abort;
pub mod arguments;
mod blit;
pub mod clock;
pub mod cpu;
pub mod fixed;
mod fullscreen;
mod keyboard;
pub mod line;
pub mod pool;
pub mod screen;
pub mod sound;
mod system;
pub mod terminal;
pub mod window;
