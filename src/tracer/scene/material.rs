use super::Pattern;
use super::ranges::{LENGTH, SHARE};
use crate::range_error::{Checked, Range, RangeError};
use crate::zero::Zero;
use glam::Vec3;

/// A surface that reflects light by Phong's model, and reflects and transmits rays.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(default, deny_unknown_fields))]
pub struct Material {
    /// The colour, 0 to 1e9 in each channel. Above 1 it amplifies light.
    pub colour: Vec3,
    /// The diffuse coefficient, 0 to 1.
    pub kd: f32,
    /// The specular coefficient, 0 to 1.
    pub ks: f32,
    /// The exponent of highlights, 1 to 1000.
    pub exponent: f32,
    /// The tint of highlights by the surface's colour, from 0 for plastic to 1 for metal. Mirror
    /// images keep their colours.
    pub metallic: f32,
    /// The spread of highlights by grooves in circles around the object's y axis (vertical for
    /// spheres and planes), 0 to 1. The cosine of Phong's model is `1 - d.d / 2`, where d is the
    /// difference between the directions of the light and of the mirrored ray; `1 - anisotropy`
    /// multiplies the square of d's part across the grooves. 1 is close to the thread model (Kajiya
    /// and Kay, 1989).
    pub anisotropy: f32,
    /// The weight of the reflected ray, 0 to 1.
    pub kr: f32,
    /// The increase of reflection at grazing angles, from 0 to 1 (a polished surface), by Schlick's
    /// approximation: at the cosine c, `f = fresnel (1 - c)^5` changes the reflected weight to
    /// `kr + f (1 - kr)`, and the transmitted one to `kt (1 - f)`.
    pub fresnel: f32,
    /// The weight of the transmitted ray, 0 to 1. Above 0 the surface is transparent.
    pub kt: f32,
    /// The mean thickness of a thin film, such as a soap bubble's, in nm, 0 to 10,000; 0 for none.
    /// A film reflects only softboxes, and the brighter of background and ambient light.
    ///
    /// At the cosine c, the factor on red, green and blue light of the wavelengths w = 610, 540 and
    /// 455 nm is `sin^2(2 pi n D t / w)` with n = 1.33 and `t = sqrt(1 - (1 - c^2) / n^2)`;
    /// parabolas replace the sine. On a sphere, at the height h above the centre in radii, the
    /// thickness D is `(1 - 0.8 h) film_thickness`; on other shapes it is `film_thickness`.
    pub film_thickness: f32,
    /// The refractive index of the inside relative to the outside, 0.1 to 10.
    pub index: f32,
    /// The colour of the object's shadow from lights with a diameter, 0 to 1 in each channel; black
    /// for a full shadow.
    pub tint: Vec3,
    /// The texture.
    pub pattern: Pattern,
}

default!(Material = Self::BLACK);

zero! {
    Material {
        colour, kd, ks, exponent, metallic, anisotropy, kr, fresnel, kt, film_thickness, index,
        tint, pattern
    }
}

impl Material {
    /// Black, without highlights, reflection or transmission.
    pub const BLACK: Self = Self { exponent: 1.0, index: 1.0, ..Self::ZERO };

    /// Returns a diffuse material.
    #[must_use]
    pub const fn matt(colour: Vec3, kd: f32) -> Self {
        Self { colour, kd, ..Self::BLACK }
    }

    /// Returns a black mirror.
    #[must_use]
    pub const fn mirror(kr: f32) -> Self {
        Self { kr, ..Self::BLACK }
    }

    /// Returns clear glass with a refractive index, 0.1 to 10: 1.5 for window glass.
    #[must_use]
    pub const fn glass(index: f32) -> Self {
        let root = (index - 1.0) / (index + 1.0);
        let kr = root * root;
        Self {
            ks: 0.5,
            exponent: 200.0,
            kr,
            fresnel: 1.0,
            kt: 1.0 - kr,
            index,
            tint: Vec3::splat(1.0 - kr),
            ..Self::BLACK
        }
    }

    /// Returns polished metal with tinted highlights.
    #[must_use]
    pub const fn metal(colour: Vec3) -> Self {
        Self { colour, kd: 0.4, ks: 0.9, exponent: 40.0, metallic: 1.0, kr: 0.25, ..Self::BLACK }
    }

    /// Returns the material with a texture.
    #[must_use]
    pub const fn with_pattern(self, pattern: Pattern) -> Self {
        Self { pattern, ..self }
    }

    /// Returns whether the material may reflect or transmit rays; true for invalid weights. Glass
    /// totally reflects even if `kr` is 0.
    #[must_use]
    pub fn is_specular(&self) -> bool {
        [self.kr, self.fresnel, self.kt] != [0.0; 3]
    }

    pub(super) fn check(&self, of: Checked) -> Result<(), RangeError> {
        of.field("material.colour", self.colour, LENGTH)?;
        of.field("material.kd", self.kd, SHARE)?;
        of.field("material.ks", self.ks, SHARE)?;
        of.field("material.exponent", self.exponent, Range(1.0, 1000.0, "1 to 1000"))?;
        of.field("material.metallic", self.metallic, SHARE)?;
        of.field("material.anisotropy", self.anisotropy, SHARE)?;
        of.field("material.kr", self.kr, SHARE)?;
        of.field("material.fresnel", self.fresnel, SHARE)?;
        of.field("material.kt", self.kt, SHARE)?;
        let thickness = Range(0.0, 1e4, "0 to 10000");
        of.field("material.film_thickness", self.film_thickness, thickness)?;
        of.field("material.index", self.index, Range(0.1, 10.0, "0.1 to 10"))?;
        of.field("material.tint", self.tint, SHARE)?;
        self.pattern.check(of)
    }
}
