//! The tracer, which every step of tracing takes.

use crate::lanes::*;
use crate::prepare::Prepared;
use crate::quality::Quality;

/// How a frame's rays are traced.
#[derive(Clone, Copy)]
pub(super) struct Tracer<'a, S: Isa> {
    /// The instruction set.
    pub simd: S,
    pub scene: &'a Prepared,
    pub quality: &'a Quality,
}
