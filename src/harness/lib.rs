//! The crate for the lab and the tests: draws frames on a pool of threads, compares and encodes
//! them, and builds programs.

pub mod cargo;
pub mod error;
pub mod frame_trace;
pub mod patches;
pub mod picture;
pub mod threaded_renderer;

pub use picture::Size;
