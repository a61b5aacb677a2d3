//! The show, a function from time to a scene, and two scenes for measurements: the model scene and the field.
//!
//! The show is a list of scenes in `scenes`, each in a file with its environment, shots and captions. A new scene needs such a
//! file, an entry in the list, and bars in the song.

mod captions;
mod environment;
mod field;
mod material;
mod model;
mod path;
mod props;
mod scene;
mod scenes;
mod timeline;

#[doc(no_inline)]
pub use crate::grid;
pub use field::field;
pub use model::{MODEL_LENGTH, model, model_scene};
pub use scenes::{BARS, CUTS, LENGTH, NAMES, cut};
pub use timeline::{at, without_transition};
