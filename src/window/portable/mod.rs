//! The intro wherever `minifb` opens windows: by `minifb` and std.
//!
//! Everything here has its counterpart in the small backend, by the same name.

pub mod arguments;
pub mod clock;
mod keys;
pub mod memory;
mod mouse;
pub mod threads;
pub mod window;
