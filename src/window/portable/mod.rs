//! The intro wherever `minifb` opens windows: by `minifb` and std, and by the system only for what these cannot do.
//!
//! Everything here has its counterpart in the small backend, by the same name.

pub mod arguments;
pub mod clock;
mod desktop;
pub mod memory;
mod mouse;
pub mod threads;
mod typing;
pub mod window;
