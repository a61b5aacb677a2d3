//! Error bounds of single-precision geometry.
//!
//! Rounding has a relative error of at most `u` = 2^-24. A bound is the sum of its operations'
//! errors plus a margin.
//!
//! # Shadows of spheres from point lights
//!
//! Each pixel of a sphere's shadow on a plane must lie in the shadow's outline, and each point that
//! counts as certainly in the shadow must be dark. Let `h` be the sphere's hit error, and `e` its
//! distance from the light times [`HIT`]. Each test changes the sphere's radius:
//!
//! | radius | of |
//! | --- | --- |
//! | `r + h` | the outline's cone |
//! | `r - h - e` | the sphere for shadow rays (see `ShadowCone::r2`) |
//! | `r - 2 h - 3 e` | the cone of certain points (see [`UNSURE`]) |
//!
//! These radii leave `2 h + e` between the outline and the shadow rays, and `h + 2 e` between the
//! shadow rays and the certain points. That covers four errors:
//!
//! - The vector from the light and the perpendicular have errors of some `u` of the light's
//!   distance, below `e / 2`.
//! - The point on the plane has an error below `h / 3` by the sphere's coordinates, plus `e / 3` by
//!   its distance from the light: the error shrinks along the ray to the light. (The plane's
//!   centre, the origin of its points, must not be much farther from the eye.)
//! - The point's distance from the eye has an error of some `u`. [`SIDE`] allows 1e-5, since a
//!   side's terms are scaled by a length above the eye's height.
//! - The cone's terms have errors below [`SIDE`]. [`CONE_RADIUS_FACTOR`] covers its cosine.
//!
//! # Lights and eyes far away
//!
//! A vector from a light at the distance `D` has an error of some `u D`, but its direction is exact
//! to some `u`. Sides and bounds of shadows use only the direction, from the object's centre:
//! margins grow with the eye's distance, not with `D` (`far_suns_and_telescopes_open_few_squares`).
//!
//! - A cone's squared cosine, `1 - r^2 / D^2`, has an error of some `u`, which
//!   [`CONE_RADIUS_FACTOR`] covers.
//! - The point of tangency, the sphere's chord and the squared chord of a shadow's cone are
//!   products with `r / D`: nothing cancels.
//! - Differences of coordinates near an edge are exact. A difference far below its terms, like a
//!   sphere's power, gets a margin in `u` of the terms.

use glam::Vec3A;

/// The largest distance of a computed hit from its sphere, relative to the sphere's largest
/// coordinate.
///
/// The errors in `u` are 1.7 (the root of 3) for the point's coordinates, 2.5 for its distance from
/// the centre, 1.5 for the ray's length, and 2.8 for the next ray's vector from the centre, its
/// square and the discriminant. The sum is 8.5; the largest measured error is 5.
pub(crate) const HIT: f32 = 10.0 / (1 << 24) as f32;

pub(crate) fn hit_error(centre: Vec3A, radius: f32) -> f32 {
    HIT * (centre.abs().max_element() + radius)
}

/// The error of a `Chord`'s squared perpendicular before it is refined, without FMA, relative to
/// `t_mid^2`.
///
/// Rounding the product `d t_mid` moves the perpendicular by `u t_mid`. Rounding `t_mid` lengthens
/// it along the ray by less than `5 u t_mid`. For a ray that meets a sphere of radius `r`,
/// `(r + u t)^2 <= r^2 (1 + m) + u^2 t^2 (1 + 1 / m)`. With `m = 0.001`, which [`BOUND`] covers,
/// the error is `(1001 + 5^2) u^2 = 3.6e-12`.
pub(crate) const UNREFINED: f32 = 4e-12;

/// The largest distance of a hit from its sphere, in radii, that one Newton step reduces to
/// rounding errors.
pub(crate) const NEWTON: f32 = 1.0 / (1 << 13) as f32;

/// The depth inside a sphere up to which a point counts as on its surface, relative to the largest
/// coordinate: 3.4 times [`HIT`].
pub(crate) const DEEP: f32 = 2e-6;

/// The offset of secondary rays from a block's surface, relative to the sum of its coordinates and
/// half extents. Many times the rounding error: rays start beyond a coincident face.
pub(crate) const BLOCK_HIT: f32 = 1e-5;

/// The offset where a block's side is nearer to the eye than [`AT_EYE`] times the usual offset:
/// twice the rounding error.
pub(crate) const MIN_BLOCK_HIT: f32 = 2.0 / (1 << 24) as f32;

/// Nearer to the eye the usual offset is visible.
pub(crate) const AT_EYE: f32 = 16.0;

/// The relative enlargement of a block's bounding sphere: many times the rounding error of its
/// corners.
pub(crate) const BLOCK_BOUND: f32 = 1e-4;

/// The error of the dot product of two directions: some 10 roundings.
pub(crate) const COSINE: f32 = 1e-6;

/// The error of [`COSINE`]'s square.
pub(crate) const COSINE2: f32 = 4e-6;

/// The relative enlargement of bounding spheres: more than the rounding error of a ray from a
/// thousand radii away.
pub(crate) const BOUND: f32 = 1e-3;

/// The enlargement of a sphere before its bounding cone is computed: more than the rounding error
/// of any cone's cosine.
pub(crate) const CONE_RADIUS_FACTOR: f32 = 1.0 + 1e-6;

/// The certain shadow's radius is smaller than the outline's by this multiple of `h + e`: 1 for the
/// outline, 1 for the shadow rays, and less than 1/3 for their origins.
pub(crate) const UNSURE: f32 = 3.0;

/// The error of an outline's side, an inequality whose terms are below twice the picture's largest
/// u or v.
pub(crate) const SIDE: f32 = 1e-5;

/// The usual share of [`SIDE`], some 5 roundings: enough for soft shadows, and small enough for
/// lights a thousand times as far away.
pub(crate) const USUAL_SIDE_SHARE: f32 = 0.03;

/// The largest error of a block's corner, relative to its distance and size, far above rounding.
pub(crate) const CORNER: f32 = 2e-4;

/// The largest error of a block's corner seen from a light: two roundings.
pub(crate) const CORNER_BY_LIGHT: f32 = 1e-7;

/// Limits a margin to a tenth of a pixel, but to no less than 5 roundings: telescopes have small
/// pixels.
pub(crate) fn within_pixel(margin: f32, pixel: f32) -> f32 {
    margin.min((0.1 * pixel).max(SIDE * USUAL_SIDE_SHARE))
}

/// The error of an object's point recomputed from the picture, relative to the largest coordinate:
/// far above some `u`.
pub(crate) const SURFACE_POINT: f32 = 1e-5;

/// The distance from a sphere, in hit errors, up to which rounding decides whether the eye is
/// inside.
pub(crate) const TOUCHING: f32 = 4.0;

/// The least height of a light above a plane, relative to the light's distance from the eye, at
/// which bounds of shadows are reliable.
pub(crate) const MIN_HEIGHT: f32 = 0.01;

/// The margin of a bounding rectangle in pixels, far above rounding.
pub(crate) const PIXELS_AROUND: f32 = 0.5;

/// The largest error of the ends of a range of squares, in pixels.
pub(crate) const COLUMN: f32 = 0.02;

/// The least determinant of a highlight's ellipse, relative to the product of its diagonal: longer
/// ellipses are unreliable.
pub(crate) const DRAWN_OUT: f32 = 1e-6;
