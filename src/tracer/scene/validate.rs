//! Which scenes are within the tracer's limits.

use super::Scene;
use super::fields::{Part, Range};
use crate::flaw::{Checked, Flaw};

/// The largest coordinate and the largest extent, in scene units: their squares, times a few, stay finite in f32.
pub const MAX_LENGTH: f32 = 1e9;
/// The smallest radius and the smallest extent: their squares stay normal numbers.
pub const MIN_LENGTH: f32 = 1e-9;

pub(super) const POINT: Range = Range::new(-MAX_LENGTH, MAX_LENGTH, "coordinates from -1e9 to 1e9");
pub(super) const EXTENT: Range = Range::new(MIN_LENGTH, MAX_LENGTH, "a length from 1e-9 to 1e9");
pub(super) const EXTENTS: Range = Range::new(MIN_LENGTH, MAX_LENGTH, "lengths from 1e-9 to 1e9");
pub(super) const LENGTH: Range = Range::new(0.0, MAX_LENGTH, "a length from 0 to 1e9");
/// Bright lights are above 1; nothing is above what f32 can multiply.
pub(super) const COLOUR: Range = Range::new(0.0, 1e9, "channels from 0 to 1e9");
pub(super) const SHARE: Range = Range::new(0.0, 1.0, "0 to 1");
pub(super) const SHARES: Range = Range::new(0.0, 1.0, "channels from 0 to 1");
pub(super) const THOUSAND: Range = Range::new(0.0, 1e3, "0 to 1000");
pub(super) const THOUSANDS: Range = Range::new(0.0, 1e3, "numbers from 0 to 1000");
/// Components of directions whose length is 1 but for rounding.
pub(super) const UNIT: Range = Range::new(-1.0001, 1.0001, "a direction of length 1");
pub(super) const COSINE: Range = Range::new(-1.0, 1.0, "a cosine, -1 to 1");

impl Scene {
    /// Whether every number of the scene is in the range that its documentation says.
    ///
    /// A scene that is valid gives the picture that [`crate::limits`] promises. One that is not gives some picture, in
    /// bounded time.
    ///
    /// # Errors
    /// The first number that is out of its range, by the name that it has in a program.
    pub fn validate(&self) -> Result<(), Flaw> {
        self.check(Checked::SCENE, "", Range::ANY)
    }
}
