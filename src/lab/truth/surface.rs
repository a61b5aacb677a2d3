//! Scattering of the light that reaches a point of a surface: how much of it goes where.
//!
//! A surface has up to four parts, each a share of the light: diffuse, a glossy lobe, a mirror, and glass that lets light through.
//! The shares of a surface that keeps energy add up to 1 at most. Radiance is taken over the squared refractive index of where
//! it travels, which refraction leaves as it is.

use crate::sampler::{around, cosine_hemisphere};
use eightfold_oracle::grooves;
use eightfold_tracer::glam::{DVec2, DVec3};
use eightfold_tracer::scene::Material;
use std::f64::consts::{PI, TAU};

/// The ways of light at a surface that does not scatter it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Bounce {
    Mirrored,
    Through,
}

/// A point of a surface, seen from a direction.
#[derive(Clone, Copy, Debug)]
pub struct Bsdf {
    /// The normal on the side from which it is seen.
    pub n: DVec3,
    /// Where a mirror would reflect the sight.
    mirrored: DVec3,
    /// Where glass would refract the sight; `None` if it lets none through, or reflects all.
    refracted: Option<DVec3>,
    /// The share of each channel that is scattered diffusely.
    pub diffuse: DVec3,
    /// The share that is scattered into the lobe, at most: no part of the lobe may lie below the surface, and none of the light be
    /// taken by its colour.
    pub glossy: f64,
    /// The radiance of the lobe's peak per irradiance of a surface that faces the light.
    peak: DVec3,
    /// The exponent of the lobe.
    exponent: f64,
    /// The direction of the grooves that spread the lobe, and how far.
    groove: DVec3,
    anisotropy: f64,
    /// Whether the lobe is the real-time model's: with no cosine of the angle of the light.
    is_plain_lobe: bool,
    /// The share that is mirrored.
    pub reflected: f64,
    /// The share that is let through.
    pub transmitted: f64,
}

/// A direction in which a path goes on.
#[derive(Clone, Copy, Debug)]
pub struct Scattered {
    pub d: DVec3,
    /// The light that goes back along the path per radiance from that direction.
    pub weight: DVec3,
    /// The density of the direction over solid angle; `None` if it is the only one, by mirroring or refraction.
    pub density: Option<f64>,
}

impl Bsdf {
    /// The surface at a point that a ray in direction `d` sees, where it has the normal `n` on the ray's side and grooves along
    /// `groove`. `keeps_energy` is whether it is a physical one; otherwise it is the real-time model's.
    pub fn new(
        material: &Material,
        colour: DVec3,
        d: DVec3,
        n: DVec3,
        groove: DVec3,
        is_inside: bool,
        keeps_energy: bool,
    ) -> Self {
        let [kd, ks, exponent, anisotropy] = [
            material.kd,
            material.ks,
            material.exponent,
            material.anisotropy,
        ]
        .map(f64::from);
        let [kr, kt, fresnel, index] =
            [material.kr, material.kt, material.fresnel, material.index].map(f64::from);
        let cosine = -d.dot(n);
        let ratio = if is_inside { index } else { 1.0 / index };
        let k = 1.0 - ratio * ratio * (1.0 - cosine * cosine);
        // Schlick's approximation: what is mirrored more, is let through less.
        let gain = fresnel * (1.0 - cosine).powi(5);
        let kr = kr + gain * (1.0 - kr);
        let kt = kt * (1.0 - gain);
        let is_through = kt > 0.0 && k >= 0.0;
        let refracted =
            is_through.then(|| (ratio * d + (ratio * cosine - k.sqrt()) * n).normalize());
        let (reflected, transmitted) = match refracted {
            // Total reflection.
            None => (kr + kt, 0.0),
            Some(_) if keeps_energy => {
                let share = kr + kt;
                let reflected = share * fresnel_reflectance(cosine, k.sqrt(), ratio);
                (reflected, share - reflected)
            }
            Some(_) => (kr, kt),
        };
        let diffuse = kd * colour;
        // The peak of the lobe is the real-time model's, for light along the normal.
        let glossy = if anisotropy > 0.0 {
            // What the lobe across grooves scatters at most: the integral of the lobe, along the grooves, times a half circle's of
            // the cosine, across them. This bound by Kershaw's inequality for the gamma function is too large by 1 % at most.
            ks * (8.0 / (PI * (exponent + 0.75))).sqrt()
        } else {
            ks * 2.0 / (exponent + if keeps_energy { 2.0 } else { 1.0 })
        };
        let highlight = DVec3::ONE.lerp(material.colour.as_dvec3(), material.metallic.into());
        let all = diffuse.max_element() + glossy + reflected + transmitted;
        let scale = if keeps_energy {
            1.0 / all.max(1.0)
        } else {
            1.0
        };
        Self {
            n,
            mirrored: (d + 2.0 * cosine * n).normalize(),
            refracted,
            diffuse: scale * diffuse,
            glossy: scale * glossy,
            peak: scale * ks / PI * highlight,
            groove,
            anisotropy,
            exponent,
            is_plain_lobe: !keeps_energy,
            reflected: scale * reflected,
            transmitted: scale * transmitted,
        }
    }

    /// Whether some light is scattered into many directions.
    pub fn is_rough(&self) -> bool {
        self.diffuse.max_element() + self.glossy > 0.0
    }

    /// Chooses what becomes of light that is mirrored or let through, by a number from 0 to 1; `None` if it goes elsewhere. The chance is
    /// the share of the light.
    pub fn sample_bounce(&self, choice: f64) -> Option<Bounce> {
        if choice < self.reflected {
            Some(Bounce::Mirrored)
        } else {
            (choice < self.reflected + self.transmitted).then_some(Bounce::Through)
        }
    }

    /// Where light goes that is mirrored or let through, and its share.
    pub fn bounced(&self, bounce: Bounce) -> Option<(DVec3, f64)> {
        match bounce {
            Bounce::Mirrored => Some((self.mirrored, self.reflected)),
            Bounce::Through => Some((self.refracted?, self.transmitted)),
        }
    }

    /// The radiance that goes back along the path, per irradiance of a surface that faces direction `d`: the reflectance
    /// distribution times the cosine.
    pub fn of(&self, d: DVec3) -> DVec3 {
        let cosine = self.n.dot(d);
        if cosine <= 0.0 {
            return DVec3::ZERO;
        }
        let along = grooves::cosine(self.mirrored, d, self.groove, self.anisotropy);
        let lobe = along.max(0.0).powf(self.exponent);
        let lobe = if self.is_plain_lobe {
            lobe
        } else {
            lobe * cosine
        };
        self.diffuse * cosine / PI + self.peak * lobe
    }

    /// The shares of diffuse, glossy, mirrored and transmitted light with which a path goes on, which add up to 1.
    fn chances(&self) -> Option<[f64; 4]> {
        let diffuse = self.diffuse.max_element();
        // A lobe that grooves spread is wide: directions are chosen as for diffuse light.
        let (diffuse, glossy) = if self.anisotropy > 0.0 {
            (diffuse + self.glossy, 0.0)
        } else {
            (diffuse, self.glossy)
        };
        let shares = [diffuse, glossy, self.reflected, self.transmitted];
        let all: f64 = shares.iter().sum();
        (all > 0.0).then(|| shares.map(|share| share / all))
    }

    /// The density over solid angle with which [`Bsdf::sample`] scatters into a direction.
    pub fn density(&self, d: DVec3) -> f64 {
        let cosine = self.n.dot(d);
        let Some([diffuse, glossy, ..]) = self.chances() else {
            return 0.0;
        };
        let lobe = self.mirrored.dot(d).max(0.0).powf(self.exponent);
        diffuse * cosine.max(0.0) / PI + glossy * (self.exponent + 1.0) * lobe / TAU
    }

    /// A direction in which the path goes on, by numbers from 0 to 1; `None` if it ends.
    pub fn sample(&self, choice: f64, u: DVec2) -> Option<Scattered> {
        let [diffuse, glossy, mirrored, through] = self.chances()?;
        let only = |d: DVec3, weight: f64| Scattered {
            d,
            weight: DVec3::splat(weight),
            density: None,
        };
        let d = if choice < diffuse {
            cosine_hemisphere(self.n, u)
        } else if choice < diffuse + glossy {
            around(self.mirrored, u.x.powf(1.0 / (self.exponent + 1.0)), u.y)
        } else if choice < diffuse + glossy + mirrored || through == 0.0 {
            // The last of the shares may be missed by rounding.
            return (mirrored > 0.0).then(|| only(self.mirrored, self.reflected / mirrored));
        } else {
            return Some(only(self.refracted?, self.transmitted / through));
        };
        // Below the surface the lobe is cut off.
        let weight = self.of(d);
        let density = self.density(d);
        (weight != DVec3::ZERO && density > 0.0).then(|| Scattered {
            d,
            weight: weight / density,
            density: Some(density),
        })
    }
}

/// The share of unpolarised light that glass reflects, by Fresnel's equations. The cosines are those of the angles on the side of
/// the light and behind the surface; `ratio` is the refractive index here over that behind.
pub fn fresnel_reflectance(cosine: f64, behind: f64, ratio: f64) -> f64 {
    let parallel = (cosine - ratio * behind) / (cosine + ratio * behind);
    let perpendicular = (ratio * cosine - behind) / (ratio * cosine + behind);
    0.5 * (parallel * parallel + perpendicular * perpendicular)
}
