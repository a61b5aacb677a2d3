//! The intro: plays the show in a window, in a terminal or without a screen, or writes a frame.

#![no_main]
#![deny(unsafe_code)]
// On Windows, opens no console after a double click. Output goes to the parent's console.
#![cfg_attr(not(debug_assertions), windows_subsystem = "windows")]

mod intro;

eightfold_window::main!(intro::run);
