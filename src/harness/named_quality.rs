use eightfold_tracer::Quality;
use std::fmt::{self, Display};
use std::str::FromStr;

#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NamedQuality {
    pub name: &'static str,
    pub quality: Quality,
}

impl NamedQuality {
    pub const EXHAUSTIVE: Self = Self { name: "exhaustive", quality: Quality::EXHAUSTIVE };
    pub const THESIS: Self = Self { name: "thesis", quality: Quality::THESIS };

    /// Returns exhaustive, thesis, then the presets from finest to fastest.
    pub fn all() -> impl Iterator<Item = Self> {
        let ladder = Quality::NAMES.into_iter().zip(Quality::LADDER);
        let ladder = ladder.map(|(name, &quality)| Self { name, quality });
        [Self::EXHAUSTIVE, Self::THESIS].into_iter().chain(ladder)
    }
}

impl FromStr for NamedQuality {
    type Err = String;

    fn from_str(name: &str) -> Result<Self, String> {
        Self::all().find(|quality| quality.name == name).ok_or_else(|| {
            let names: Vec<&str> = Self::all().map(|quality| quality.name).collect();
            format!("must be one of {}", names.join(", "))
        })
    }
}

impl Display for NamedQuality {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name)
    }
}
