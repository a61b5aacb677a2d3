//! The show: the scene as a function of time. So are the model scene and the field, which serve measurements.

mod captions;
mod environment;
mod field;
mod material;
mod model;
mod path;
mod props;
mod random;
mod swarm;
mod timeline;
mod title;

#[doc(no_inline)]
pub use crate::grid;
pub use field::field;
pub use model::{MODEL_LENGTH, model, scene};
pub use timeline::at;

/// What a shot is filmed in: background, haze, floor, lights and props.
#[derive(Clone, Copy)]
enum Set {
    Title,
    /// The model scene, on which the method is explained, too.
    Model,
    Colonnade,
    Machine,
    Swarm,
    Finale,
}
