//! Properties of pictures, tested on every instruction set of the machine.

use eightfold_harness::{error, picture, threaded_renderer};
use eightfold_window::cpu;

mod antialias;
mod assertions;
mod built;
mod convex;
mod depth;
mod drawn;
mod error_measures;
mod errors;
mod extremes;
mod film;
mod fold;
mod golden;
mod governor;
mod highlights;
mod huge;
mod method;
mod oracle;
mod patches;
mod patterned;
mod penumbra;
mod probes;
mod refinement;
mod sameness;
mod show;
mod shown;
mod soak;
mod thin;
mod unguarded;
mod written;
