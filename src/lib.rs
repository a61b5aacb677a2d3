//! The show and its soundtrack, as functions of time: what the intro plays by [`eightfold_tracer`], and the lab measures.
//!
//! | what | module |
//! | --- | --- |
//! | time to scene: the show, and the model scene of all measurements | [`show`] |
//! | the soundtrack | [`sound`] |
//! | the beats that both are laid out on | [`grid`] |
//!
//! It can't allocate, and needs no std. `ARCHITECTURE.md` in the repository says where a change goes.
#![no_std]
#![forbid(unsafe_code)]
#![warn(missing_docs)]

pub mod grid;
pub mod show;
pub mod sound;
