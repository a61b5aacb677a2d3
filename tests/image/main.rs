//! What the pictures are held to, on every instruction set of the machine.

#[path = "../../src/bin/lab/error.rs"]
mod error;
#[cfg(feature = "lab")]
#[path = "../../src/bin/lab/flicker.rs"]
mod flicker;
#[cfg(feature = "lab")]
#[path = "../../src/bin/lab/flip.rs"]
mod flip;
#[path = "../../src/bin/lab/isa.rs"]
mod isa;
#[cfg(feature = "lab")]
#[path = "../../src/bin/lab/missed.rs"]
mod missed;
#[path = "../oracle/mod.rs"]
mod oracle;
#[cfg(feature = "lab")]
#[path = "../../src/bin/lab/overlay.rs"]
mod overlay;
#[path = "../../src/bin/lab/picture.rs"]
#[allow(dead_code, reason = "the lab needs more of it")]
mod picture;
#[path = "../reader/mod.rs"]
mod reader;
#[path = "../../src/bin/lab/studio.rs"]
#[allow(dead_code, reason = "the lab needs more of it")]
mod studio;

mod accuracy;
#[cfg(feature = "lab")]
mod antialias;
mod details;
mod drawn;
#[cfg(feature = "lab")]
mod errors;
mod extremes;
mod golden;
mod limits;
#[cfg(feature = "lab")]
mod method;
#[cfg(feature = "lab")]
mod observed;
mod patterned;
mod random;
mod ranges;
mod refinement;
mod reflected;
mod sameness;
mod show;
mod sizes;
mod soak;
mod unseen;
mod unshaded;
mod wrong;
