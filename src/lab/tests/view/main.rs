//! `lab view` shows in its window what keys select, and edits scene files by keys and mouse.

mod camera;
mod disk;
mod editing;
mod ending;
mod keeping;
mod moving;
mod parts;
mod playing;
mod saving;
mod stage;
