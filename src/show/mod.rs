//! What is played, as a function of time.

mod model;

pub use model::{LENGTH, scene};
