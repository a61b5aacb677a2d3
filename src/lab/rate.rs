//! Frame rates.

use std::fmt;
use std::str::FromStr;

/// A frame rate in frames per second, as a fraction.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Rate {
    pub num: u32,
    pub den: u32,
}

impl Rate {
    /// The largest frame rate.
    const MOST: u32 = 1000;
    /// The largest numerator and denominator. The largest denominator in common use is 1001.
    const LARGEST: u32 = 1_000_000;

    /// The time of a frame in seconds; the first one is frame 0.
    pub fn time(self, frame: usize) -> f32 {
        (frame as f64 * f64::from(self.den) / f64::from(self.num)) as f32
    }

    /// The number of frames that begin within so many seconds.
    pub fn frames(self, seconds: f32) -> usize {
        (f64::from(seconds) * f64::from(self.num) / f64::from(self.den)).ceil() as usize
    }

    /// The rate as a number.
    pub fn hertz(self) -> f64 {
        f64::from(self.num) / f64::from(self.den)
    }
}

impl FromStr for Rate {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let part = |text: &str| {
            let part = text.parse().ok();
            part.filter(|part| (1..=Self::LARGEST).contains(part))
        };
        let (num, den) = text.split_once('/').unwrap_or((text, "1"));
        part(num)
            .zip(part(den))
            .filter(|&(num, den)| num <= Self::MOST * den)
            .map(|(num, den)| Self { num, den })
            .ok_or_else(|| {
                format!(
                    "takes frames a second, such as 60 or 30000/1001, at most {}",
                    Self::MOST
                )
            })
    }
}

impl fmt::Display for Rate {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.num)?;
        if self.den == 1 {
            Ok(())
        } else {
            write!(f, "/{}", self.den)
        }
    }
}
