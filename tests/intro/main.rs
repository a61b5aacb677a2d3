//! The intro's program as it ships: its size, its flags, and how it plays without a window.
//!
//! It is one program of tests: so those that wait, and the build for Windows, run beside the others.

mod again;
mod arguments;
mod headless;
mod size;
mod still;
mod terminal;
