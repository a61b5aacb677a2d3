//! Properties of the pictures, each checked on every instruction set of the machine.

use eightfold_lab::{error, flip, missed, overlay, picture, threaded_renderer};
use eightfold_window::cpu;

mod accuracy;
mod antialias;
mod any_scene;
mod drawn;
mod error_measures;
mod extremes;
mod far_away;
mod film;
mod generator;
mod golden;
mod highlights;
mod highlights_shown;
mod images_shown;
mod limits;
mod method;
mod nothing_missed;
mod observed;
mod patterned;
mod penumbra;
mod probes;
mod ranges;
mod refinement;
mod reflected;
mod rounding;
mod sameness;
mod shadows_shown;
mod shipped;
mod show;
mod sizes;
mod soak;
mod text;
mod water;
mod written;
mod wrong_pixels;
