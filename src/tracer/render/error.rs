//! Why a frame can't be rendered.

use crate::range_error::RangeError;
use crate::{MAX_HEIGHT, MAX_WIDTH};
use core::fmt;

/// Why a frame can't be rendered. It is displayed as a sentence that says what to mend.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Error {
    /// A side of the frame is 0, or beyond [`MAX_WIDTH`] or [`MAX_HEIGHT`].
    Size {
        /// The frame's width, in pixels.
        width: usize,
        /// The frame's height, in pixels.
        height: usize,
    },
    /// A row of the frame begins before the one above it ends.
    Stride {
        /// The frame's width, in pixels.
        width: usize,
        /// The frame's stride, in pixels.
        stride: usize,
    },
    /// The frame has fewer pixels than its size says.
    Pixels {
        /// As many as there are from its first to its last one: width times height, unless it has a stride.
        needed: usize,
        /// How many there are.
        given: usize,
    },
    /// A number of the scene or the quality is out of its range.
    Range(RangeError),
}

impl From<RangeError> for Error {
    fn from(error: RangeError) -> Self {
        Self::Range(error)
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Size { width, height } => write!(
                f,
                "a frame has 1x1 to {MAX_WIDTH}x{MAX_HEIGHT} pixels, and not {width}x{height}"
            ),
            Self::Stride { width, stride } => write!(
                f,
                "a frame {width} pixels wide has a stride of {width} or more, and not {stride}"
            ),
            Self::Pixels { needed, given } => {
                write!(
                    f,
                    "a frame of this size takes {needed} pixels, and there are {given}"
                )
            }
            Self::Range(error) => error.fmt(f),
        }
    }
}

impl core::error::Error for Error {
    fn source(&self) -> Option<&(dyn core::error::Error + 'static)> {
        match self {
            Self::Range(error) => Some(error),
            Self::Size { .. } | Self::Stride { .. } | Self::Pixels { .. } => None,
        }
    }
}
