//! `lab view` in a window: scene files that are written meanwhile, the camera, the keys, and the ways in which it ends.

mod camera;
mod ending;
mod keys;
mod reload;
mod stage;
