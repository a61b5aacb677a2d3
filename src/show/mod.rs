//! What is played, as a function of time.

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

/// What is set up for a scene of the show: its air, floor, lamps and props.
#[derive(Clone, Copy)]
enum Set {
    Title,
    /// The model scene, which the method is explained by too.
    Model,
    Colonnade,
    Machine,
    Swarm,
    Finale,
}
