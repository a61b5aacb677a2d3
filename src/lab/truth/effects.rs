//! Effects that the real-time model leaves out, each to be switched off.

use crate::arguments::BadInput;
use anyhow::{Result, bail};

/// The effects that a picture has beyond the real-time model. Where an effect is off, what the model has in its stead takes its place.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Effects {
    /// Light that reaches a surface from others, and from the background; instead of the ambient light.
    pub indirect: bool,
    /// Light of lamps that comes by way of mirrors and glass; instead of shadows with a material's tint.
    pub caustics: bool,
    /// Lamps with an extent as spheres that shine; instead of points.
    pub soft_shadows: bool,
    /// Surfaces that give back no more light than they get, and reflect more at grazing angles where they are of glass; instead of
    /// constant coefficients.
    pub surfaces: bool,
    /// Lamps that shine less on what is farther away; instead of equally on everything.
    pub falloff: bool,
}

impl Effects {
    /// The real-time model.
    pub const NONE: Self = Self {
        indirect: false,
        caustics: false,
        soft_shadows: false,
        surfaces: false,
        falloff: false,
    };
    /// All but [`Effects::falloff`]: that lamps shine equally on everything is what a scene says.
    pub const TRUTH: Self = Self {
        indirect: true,
        caustics: true,
        soft_shadows: true,
        surfaces: true,
        falloff: false,
    };
    /// The names of the effects.
    pub const NAMES: [&'static str; 5] = [
        "indirect",
        "caustics",
        "soft-shadows",
        "surfaces",
        "falloff",
    ];

    /// The same with an effect, by its index in [`Effects::NAMES`], on or off.
    pub fn with(mut self, effect: usize, is_on: bool) -> Self {
        let Self {
            indirect,
            caustics,
            soft_shadows,
            surfaces,
            falloff,
        } = &mut self;
        *[indirect, caustics, soft_shadows, surfaces, falloff][effect] = is_on;
        self
    }

    /// The truth with some effects and without others.
    ///
    /// # Errors
    /// If an effect is both on and off.
    pub fn chosen(with: &[usize], without: &[usize]) -> Result<Self> {
        if let Some(&both) = with.iter().find(|effect| without.contains(effect)) {
            bail!(BadInput(format!(
                "--with {name} cannot be used with --without {name}",
                name = Self::NAMES[both]
            )));
        }
        let on = with.iter().fold(Self::TRUTH, |all, &i| all.with(i, true));
        Ok(without.iter().fold(on, |all, &i| all.with(i, false)))
    }
}

/// Parses the name of an effect: its index in [`Effects::NAMES`].
pub fn effect(name: &str) -> Result<usize, String> {
    let found = Effects::NAMES.iter().position(|known| *known == name);
    found.ok_or_else(|| format!("takes one of {}", Effects::NAMES.join(", ")))
}
