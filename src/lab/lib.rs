//! The crate that draws frames, and measures speed against accuracy. Each command of `cargo lab` is
//! a module.

pub mod arguments;
pub mod bench;
pub mod bitmap;
pub mod capture;
pub mod figures;
pub mod interrupt;
pub mod measure;
pub mod output;
pub mod overlay;
pub mod plot;
pub mod progress;
pub mod render;
pub mod resources;
pub mod row;
pub mod scenes;
#[cfg(target_arch = "x86_64")]
pub mod size;
pub mod technique;
pub mod trade;
pub mod truth;
pub mod view;
pub mod view_errors;
