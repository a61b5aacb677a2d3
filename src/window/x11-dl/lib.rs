//! A stand-in for the `x11-dl` crate, through `[patch.crates-io]`.
//!
//! The original looks up 826 functions of Xlib and Xcursor by name and carries code and an error
//! path for each, which is 115 KB of an intro that may have 64. This one has the names and types that
//! `minifb` 0.29 and `eightfold-window` use, with the values of Xlib's own headers:
//!
//! - [`xlib`]: what a window needs, and the functions: those in use, looked up by one loop over a block of names, and
//!   those that answer in place. [`loaded!`] does for other libraries too.
//! - [`xcursor`]: answers without a library; the intro's pointer is the desktop's own, or none.
//! - [`keysym`]: the keys that `minifb` tells apart.
//!
//! Names and signatures are those of the original, so its documentation, and Xlib's, hold here.

#![no_std]
#![allow(non_camel_case_types, non_snake_case, reason = "Xlib's own names")]
#![allow(non_upper_case_globals, reason = "Xlib's own names")]
#![allow(missing_docs, reason = "documented by Xlib")]
#![allow(clippy::missing_safety_doc, reason = "documented by Xlib")]

mod answers;
mod functions;
pub mod keysym;
#[cfg(target_pointer_width = "64")]
mod layout;
mod types;
pub mod xcursor;

pub use functions::{Table, why_not_loaded};

/// Types, constants and functions of libX11.
pub mod xlib {
    pub use crate::answers::Xlib;
    pub use crate::functions::{Functions, Loaded};
    pub use crate::types::*;
}

/// Pictures in memory that the server shares, in libXext.
pub mod xshm {
    pub use crate::functions::Xext;
    pub use crate::types::XShmSegmentInfo;
}

/// Why no function can be called: never, where it is asked. What `minifb` would say of it is left out with it.
#[derive(Debug)]
pub enum OpenError {}
