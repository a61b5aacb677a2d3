//! What the pictures are held to, on every instruction set of the machine.

#[path = "../../src/bin/lab/error.rs"]
mod error;
#[path = "../../src/bin/lab/isa.rs"]
mod isa;
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
mod drawn;
mod golden;
#[cfg(feature = "lab")]
mod observed;
mod random;
mod ranges;
mod refinement;
mod sameness;
mod sizes;
