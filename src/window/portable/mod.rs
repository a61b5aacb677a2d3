//! The intro wherever `minifb` opens windows: by `minifb`, std and libc.
//!
//! Everything here has its counterpart in the small backend, by the same name.

#[path = "../small/arguments.rs"]
pub mod arguments;
pub mod clock;
mod keys;
#[path = "../small/memory.rs"]
pub mod memory;
mod mouse;
pub mod threads;
pub mod window;
