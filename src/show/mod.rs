//! The show: the scene as a function of time. So are the model scene and the field, which serve measurements.
//!
//! The show is a list of scenes that are played one after another (`scenes`), each in a file of its own: its air, floor, lamps and
//! props, its shots and its captions. A new scene is such a file, its place in the list, and its bars in the song.
//!
//! | what | module |
//! | --- | --- |
//! | the scenes of the show; their names, cuts and length | `scenes` |
//! | the record of a scene, and of a shot | `act` |
//! | what is set up: air, floor, lamps, props | `set`, `props`, `material` |
//! | camera and overlay | `path` |
//! | captions | `captions` |
//! | the show as a function of time | `timeline` |

mod act;
mod captions;
mod field;
mod material;
mod model;
mod path;
mod props;
mod scenes;
mod set;
mod timeline;

#[doc(no_inline)]
pub use crate::grid;
pub use field::field;
pub use model::{MODEL_LENGTH, model, model_scene};
pub use scenes::{BARS, CUTS, LENGTH, NAMES, cut};
pub use timeline::{at, whole};
