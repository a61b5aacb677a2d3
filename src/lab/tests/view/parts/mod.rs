//! The viewer's parts, without a window. They are tested from here so that the lab's library is compiled once.

mod camera;
mod controls;
mod disk;
mod legend;
mod panel;
