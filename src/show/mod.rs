//! The show, a function from time to a scene, and the model scene and the field for measurements.

mod captions;
mod environment;
mod field;
mod model;
mod path;
mod scene;
mod scenes;
mod solids;
mod timeline;

#[doc(no_inline)]
pub use crate::tempo;
pub use field::field;
pub use model::{MODEL_LENGTH, model, model_scene};
pub use scenes::{BARS, CUTS, LENGTH, NAMES, cut};
pub use timeline::{at, without_transition};
