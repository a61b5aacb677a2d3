//! What is played, as a function of time.

mod captions;
mod field;
pub mod grid;
pub(crate) mod letters;
mod material;
mod model;
mod path;
mod random;
mod settings;
mod steps;
mod swarm;
mod things;
mod timeline;
mod title;

pub use field::field;
pub use model::{LENGTH, model, scene};
pub use timeline::at;

/// What is set up, a row of the tables each.
#[derive(Clone, Copy, PartialEq)]
#[repr(u8)]
enum Set {
    Title,
    /// The model scene, which the method is explained by too.
    Model,
    Colonnade,
    Machine,
    Swarm,
    Finale,
}
