//! Highlights on brushed surfaces.

use glam::DVec3;

/// The direction of the grooves around an axis, at a point `out` from the centre of an object, where its normal is `n`.
pub fn direction(axis: DVec3, out: DVec3, n: DVec3) -> DVec3 {
    axis.cross(out).reject_from(n).normalize_or_zero()
}

/// The cosine of the angle between the direction `r` of a mirrored ray and the direction `l` to a light, or what grooves make of it;
/// see `Material::anisotropy`. Directions have a length of 1.
pub fn cosine(r: DVec3, l: DVec3, groove: DVec3, anisotropy: f64) -> f64 {
    let apart = l - r;
    let along = apart.dot(groove);
    let apart2 = apart.length_squared();
    1.0 - 0.5 * (apart2 + anisotropy * (along * along - apart2))
}
