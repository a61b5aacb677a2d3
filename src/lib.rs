//! The show and its soundtrack as functions of time, which the intro plays and the lab measures.
//!
//! | part | module |
//! | --- | --- |
//! | from time to a scene: the show, and the model scene of all measurements | [`show`] |
//! | the soundtrack | [`sound`] |
//! | the beats of picture and sound | [`grid`] |
//!
//! The crate allocates nothing, and needs no std. `ARCHITECTURE.md` in the repository lists where to make a change.
#![no_std]
#![forbid(unsafe_code)]
#![warn(missing_docs)]

pub mod grid;
pub mod show;
pub mod sound;
