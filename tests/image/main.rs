//! Properties of pictures, tested on every instruction set of the machine.

use eightfold_harness::{error, picture, threaded_renderer};
use eightfold_window::cpu;

mod antialias;
mod built;
mod convex;
mod depth;
mod drawn;
mod errors;
mod extremes;
mod fold;
mod golden;
mod governor;
mod method;
mod oracle;
mod patterned;
mod penumbra;
mod probes;
mod show;
mod shown;
mod soak;
mod thin;
