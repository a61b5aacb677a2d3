//! What is played, as a function of time.

mod field;
pub mod grid;
mod model;

pub use field::field;
pub use model::{LENGTH, scene};
