//! The intro: plays the show in a window, in a terminal or without a screen, or writes one frame of it.

#![no_main]
#![deny(unsafe_code)]

mod intro;

eightfold_window::main!(intro::run);
