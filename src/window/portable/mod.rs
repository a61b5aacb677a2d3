//! The portable backend: `minifb` and std.

#[path = "../small/arguments.rs"]
pub mod arguments;
pub mod clock;
mod keyboard;
#[path = "../small/memory.rs"]
pub mod memory;
mod mouse;
pub mod threads;
pub mod window;
