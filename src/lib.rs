//! The crate of the show and its soundtrack as functions of time, which the intro plays and the lab
//! measures.
//!
//! | part | module |
//! | --- | --- |
//! | the show, and the model scene of measurements | [`show`] |
//! | the soundtrack | [`sound`] |
//! | the beats of picture and sound | [`tempo`] |
//!
//! The crate allocates nothing, and needs no std.
#![no_std]
#![forbid(unsafe_code)]
#![warn(missing_docs)]

pub mod show;
pub mod sound;
pub mod tempo;
