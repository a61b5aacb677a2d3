//! The intro's program as it ships: size, flags, and playing without a window.

mod arguments;
mod headless;
mod size;
mod still;
mod terminal;
