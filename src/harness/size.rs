use eightfold_tracer::{MAX_HEIGHT, MAX_WIDTH};
use std::fmt::{self, Display};
use std::str::FromStr;

/// In pixels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Size {
    pub width: usize,
    pub height: usize,
}

impl Size {
    pub const fn new(width: usize, height: usize) -> Self {
        Self { width, height }
    }

    pub fn area(self) -> usize {
        self.width * self.height
    }

    /// Scales both sides, to at least 1.
    pub fn scaled(self, scale: f64) -> Self {
        let scaled = |side: usize| ((side as f64 * scale).round() as usize).max(1);
        Self::new(scaled(self.width), scaled(self.height))
    }
}

impl FromStr for Size {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let size = text.split_once('x').and_then(|(width, height)| {
            let (width, height) = (width.parse().ok()?, height.parse().ok()?);
            let fits = (1..=MAX_WIDTH).contains(&width) && (1..=MAX_HEIGHT).contains(&height);
            fits.then_some(Self { width, height })
        });
        size.ok_or_else(|| format!("must be WIDTHxHEIGHT, 1x1 to {MAX_WIDTH}x{MAX_HEIGHT}"))
    }
}

impl Display for Size {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}x{}", self.width, self.height)
    }
}
