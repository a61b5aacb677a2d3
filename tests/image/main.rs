//! What the pictures are held to, on every instruction set of the machine.

use eightfold_lab::{error, flicker, flip, missed, overlay, picture, studio};
use eightfold_window::cpu;

#[path = "../reader/mod.rs"]
mod reader;
#[path = "../stage/mod.rs"]
mod stage;

mod accuracy;
mod antialias;
mod details;
mod drawn;
mod errors;
mod extremes;
mod golden;
mod limits;
mod method;
mod observed;
mod patterned;
mod random;
mod ranges;
mod refinement;
mod reflected;
mod sameness;
mod shipped;
mod show;
mod sizes;
mod soak;
mod unseen;
mod unshaded;
mod wrong;
