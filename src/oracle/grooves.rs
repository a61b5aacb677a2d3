use glam::DVec3;

/// Returns the direction of the grooves; `out` is the point from the object's centre, `n` its
/// normal.
pub fn direction(axis: DVec3, out: DVec3, n: DVec3) -> DVec3 {
    axis.cross(out).reject_from(n).normalize_or_zero()
}

/// Returns the cosine between the mirrored direction `r` and the direction `l` to a light, with
/// grooves, see `Material::anisotropy`.
pub fn cosine(r: DVec3, l: DVec3, groove: DVec3, anisotropy: f64) -> f64 {
    let apart = l - r;
    let along = apart.dot(groove);
    let apart2 = apart.length_squared();
    1.0 - 0.5 * (apart2 + anisotropy * (along * along - apart2))
}
