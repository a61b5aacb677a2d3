use super::band::{MAX_HEIGHT, MAX_WIDTH};
use crate::range_error::RangeError;
use core::fmt;

/// The reason why a frame cannot be rendered.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Error {
    /// A side of the frame is 0, or above [`MAX_WIDTH`] or [`MAX_HEIGHT`].
    Size {
        /// In pixels.
        width: usize,
        /// In pixels.
        height: usize,
    },
    /// The stride is below the width.
    Stride {
        /// In pixels.
        width: usize,
        /// In pixels.
        stride: usize,
    },
    /// There are fewer pixels than the size needs.
    Pixels {
        /// The number of pixels from the first to the last one of the frame.
        needed: usize,
        /// The number of pixels in the slice.
        given: usize,
    },
    /// A number of the scene or the quality is out of range.
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
            Self::Size { width, height } => {
                write!(f, "frame size is {width}x{height}; must be 1x1 to {MAX_WIDTH}x{MAX_HEIGHT}")
            }
            Self::Stride { width, stride } => {
                write!(f, "frame stride is {stride}; must be {width} or more")
            }
            Self::Pixels { needed, given } => {
                write!(f, "pixel count is {given}; must be {needed} or more")
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
