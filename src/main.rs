//! The intro: plays the show in a window, in a terminal or without a screen, or writes one frame of it.

#![no_main]
#![deny(unsafe_code)]
// Started by a double click it opens no console on Windows. What it prints goes to the one that it is started from.
#![cfg_attr(not(debug_assertions), windows_subsystem = "windows")]

mod intro;

eightfold_window::main!(intro::run);
