use super::object::Object;
use crate::lanes::MAX_LANES;
use crate::scene::{Material, Scene};
use glam::Vec3;

/// Weaker highlights, below 1/40 of a step of 8-bit output, are not computed.
const MIN_HIGHLIGHT: f32 = 1e-4;

/// Larger than any r.v.
const NO_HIGHLIGHT: f32 = 2.0;

/// A surface's parameter, as the index of its first component. Lengths are in scene units.
#[derive(Clone, Copy)]
pub(crate) enum Parameter {
    /// A vector: the centre of a sphere or a plane.
    Centre = 0,
    /// 0 for planes and blocks.
    InverseRadius = 3,
    /// 0 for visible lights and the background, otherwise 1 and [`Material::film_thickness`].
    IsLit = 4,
    /// A colour: the reflected ambient light (with ambience the reflected share), or the colour of
    /// a visible light or the background.
    Emitted = 5,
    Diffuse = 8,
    /// A colour: the factor on a light's colour in its highlight.
    Highlight = 11,
    Ks = 14,
    Exponent,
    /// The smallest r.v with a visible highlight.
    HighlightStart,
    Kr,
    /// See [`Material::fresnel`].
    Fresnel,
    Kt,
    Index,
}

pub(crate) const SURFACE_NUMBERS: usize = Parameter::Index as usize + 1;

pub(crate) type SurfaceNumbers = [f32; SURFACE_NUMBERS];

pub(crate) type PerLane = [f32; MAX_LANES];

pub(crate) type SurfaceTable = [PerLane; SURFACE_NUMBERS];

/// Above any valid parameter; products of a few such numbers are finite.
const LARGEST: f32 = 2e9;

/// Replaces NaN and magnitudes above [`LARGEST`] with 0: NaN, or an overflow to infinity, spoils a
/// point's sum even with the weight 0.
pub(super) fn bounded(number: f32) -> f32 {
    if number.abs() <= LARGEST { number } else { 0.0 }
}

pub(super) fn surface(object: &Object<'_>, material: &Material, scene: &Scene) -> SurfaceNumbers {
    let mut surface = [0.0; SURFACE_NUMBERS];
    let mut set = |parameter: Parameter, components: &[f32]| {
        surface[parameter as usize..][..components.len()].copy_from_slice(components);
    };
    let emitted = match object {
        Object::Light(light) => light.colour,
        Object::Background => scene.background,
        Object::Sphere(_) | Object::Block(_) | Object::Plane(_) => {
            set(Parameter::IsLit, &[1.0 + material.film_thickness]);
            // With ambience, the ambient light depends on the point.
            let is_uniform = scene.ambience.occlusion == 0.0;
            material.colour * if is_uniform { scene.ambient } else { Vec3::ONE }
        }
    };
    match object {
        Object::Sphere(sphere) => {
            set(Parameter::Centre, &sphere.centre.to_array());
            set(Parameter::InverseRadius, &[1.0 / sphere.radius]);
        }
        Object::Plane(plane) => set(Parameter::Centre, &plane.centre.to_array()),
        // The points of blocks are computed elsewhere.
        Object::Block(_) | Object::Light(_) | Object::Background => {}
    }
    let highlight = Vec3::ONE.lerp(material.colour, material.metallic);
    let highlight_start = if material.ks > MIN_HIGHLIGHT {
        root_below(MIN_HIGHLIGHT / material.ks, material.exponent)
    } else {
        NO_HIGHLIGHT
    };
    set(Parameter::Emitted, &emitted.to_array());
    set(Parameter::Diffuse, &(material.colour * material.kd).to_array());
    set(Parameter::Highlight, &highlight.to_array());
    set(Parameter::Ks, &[material.ks]);
    set(Parameter::Exponent, &[material.exponent]);
    set(Parameter::HighlightStart, &[highlight_start]);
    set(Parameter::Kr, &[material.kr]);
    set(Parameter::Fresnel, &[material.fresnel]);
    set(Parameter::Kt, &[material.kt]);
    set(Parameter::Index, &[material.index]);
    surface.map(bounded)
}

/// Returns 0.8 to 1 times the root of degree `h`, 1 to 1000, of a number from [`MIN_HIGHLIGHT`] to
/// 1.
///
/// A float's bits approximate its logarithm: `e + m` for `2^e (1 + m)` is up to 0.09 too small, and
/// the inverse up to a factor of 1.07 too large.
fn root_below(x: f32, h: f32) -> f32 {
    const ONE: f32 = (1 << 23) as f32;
    const BIAS: f32 = 127.0;
    let log2 = x.to_bits() as f32 / ONE - BIAS;
    0.93 * f32::from_bits(((log2 / h + BIAS) * ONE) as u32)
}

#[cfg(test)]
mod tests {
    use super::{MIN_HIGHLIGHT, root_below};

    #[test]
    fn root_below_is_at_most_a_fifth_too_small() {
        for h in [1.0, 1.5, 2.0, 5.0, 10.0, 40.0, 100.0, 1000.0] {
            for i in 1..100_000 {
                let x = MIN_HIGHLIGHT.max(i as f32 / 100_000.0);
                let root = libm::powf(x, 1.0 / h);
                let below = root_below(x, h);
                assert!(below <= root && below >= 0.8 * root, "{x}, {h}: {below}, {root}");
            }
        }
    }
}
