//! The lab draws frames, and measures what speed costs in accuracy.
//!
//! This library has a module for each command of `cargo lab`, and the measures and file formats that these and the tests share.
//! The program itself only parses the command line.

pub mod arguments;
pub mod bench;
pub mod bitmap;
pub mod capture;
pub mod cargo;
pub mod error;
pub mod figures;
pub mod flip;
pub mod interrupt;
pub mod markdown;
pub mod measure;
pub mod missed;
pub mod output;
pub mod overlay;
pub mod picture;
pub mod plot;
pub mod progress;
pub mod render;
pub mod report;
pub mod rivals;
pub mod row;
pub mod scenes;
pub mod seen;
pub mod sheet;
pub mod size;
pub mod threaded_renderer;
pub mod timing;
pub mod trade;
pub mod truth;
pub mod view;
pub mod wav;
