//! Eightfold's ray tracer: an animated scene, drawn by adaptive 8-pixel squares.
//!
//! The way of a frame, a module per stage:
//!
//! | stage | module |
//! | --- | --- |
//! | time to scene | [`show`], [`scene`] |
//! | what every ray uses, once a frame | `prepare` |
//! | bands of the picture in parallel | [`render()`] |
//! | which points to trace, fill or split | `refine` |
//! | points to colours and keys | `trace` |
//! | rays side by side, by instruction set | `lanes` |
//! | captions over a finished band | `text` |
//! | how a frame came about, for the lab | [`observe`] |
//!
//! What trades accuracy for speed is one struct, [`Quality`]; [`Governor`] chooses one by how long frames take. How far
//! the numbers can be trusted is in [`limits`].
//!
//! A frame is a function of scene, size, quality and instruction set: the same bits for any number of threads. The
//! library cannot allocate; its memory, [`Memory`] and a [`Worker`] per thread, belongs to the caller.
#![no_std]
#![forbid(unsafe_code)]
#![warn(missing_docs)]

mod font;
mod governor;
pub mod grid;
mod lanes;
pub mod limits;
mod maths;
pub mod observe;
mod prepare;
mod quality;
mod refine;
mod render;
pub mod scene;
pub mod show;
pub mod sound;
mod text;
mod trace;

pub use fearless_simd::Level;
pub use governor::Governor;
pub use quality::Quality;
pub use refine::{Band, Worker};
pub use render::{Job, Memory, render, render_observed};
pub use trace::Counts;

/// The widest picture, in pixels.
pub const MAX_WIDTH: usize = 3840;
/// The tallest picture, in pixels.
pub const MAX_HEIGHT: usize = 2160;
