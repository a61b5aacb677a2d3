//! Eightfold's ray tracer: an animated scene, drawn by adaptive 8-pixel squares.
//!
//! # The way of a frame
//!
//! A module per stage, from the time to the pixels:
//!
//! | stage | module |
//! | --- | --- |
//! | what there is to draw: a camera, primitives, lights, captions | [`scene`] |
//! | time to scene: the show, and the model scene of all measurements | [`show`] |
//! | what trades accuracy for speed, as one struct | [`Quality`] |
//! | what every ray of a frame uses, computed once | `prepare` |
//! | rays to colours and keys, as many side by side as the instruction set holds | `trace` |
//! | which points to trace, and which squares to fill or to split | `refine` |
//! | captions over a finished band | `text` |
//! | a frame: bands of the picture in parallel | [`Renderer`] |
//!
//! Beside it: the soundtrack in [`sound`], on the beats of [`grid`] as the show is; [`Governor`], which chooses a quality by how
//! long frames take; [`observe`], which tells how a frame came about; [`limits`], how far the numbers can be trusted. At the
//! bottom, `lanes` holds the vectors that kernels are written in, `maths` functions of single numbers, `font` the letters. No
//! module depends on itself by way of others (`tests/modules.rs`).
//!
//! # Conventions
//!
//! Coordinates are right-handed, y up, in scene units, which are of any size; angles in radians, times in seconds. The
//! picture's pixel (0, 0) is its upper left, x to the right, y down; a pixel's sample is its centre. Colours are linear RGB, 1
//! the brightest that is shown; pixels are `0x00RRGGBB`, a colour clamped to 0 to 1, times 255 and rounded, without gamma.
//! Vectors are those of [`glam`].
//!
//! # What a frame depends on
//!
//! Scene, size, quality and instruction set: the same bits for any number of threads. The library cannot allocate; its memory,
//! [`Memory`] and a [`Worker`] per thread, belongs to the caller.
#![no_std]
#![forbid(unsafe_code)]
#![warn(missing_docs)]

// Leaves: what needs no other module.
mod flaw;
mod font;
pub mod grid;
mod lanes;
mod maths;

// What is drawn and heard.
pub mod scene;
pub mod show;
pub mod sound;

// How it is drawn.
pub mod observe;
mod prepare;
mod quality;
mod refine;
mod render;
mod text;
mod trace;

mod governor;
pub mod limits;

pub use fearless_simd::Level;
pub use flaw::{Flaw, Found};
pub use glam;
pub use governor::Governor;
pub use quality::Quality;
pub use refine::{Band, Worker};
pub use render::{Error, Frame, Job, Memory, Renderer, Threads};
pub use trace::Counts;

/// The widest picture, in pixels.
pub const MAX_WIDTH: usize = 3840;
/// The tallest picture, in pixels.
pub const MAX_HEIGHT: usize = 2160;
