//! Tolerances of rounding: how far the errors of single precision move what geometry computes, and the room that is left for them.
//!
//! A number is rounded by up to `u` = 2^-24 of itself. Errors of a few operations add up to a few `u` of the largest number among them.
//! Each bound here is the sum of such errors, with its derivation, and some room above it. Tests of the kernels shoot rays by the million
//! against these bounds (see [`limits`](crate::limits)).
//!
//! # Shadows
//!
//! By a point light, all pixels of a sphere's shadow on a plane are inside of its cone in the picture, and a point that is sure to be
//! inside (see [`UNSURE`]) is dark. Let `h` be the sphere's hit error and `e` the same share, [`HIT`], of its distance from the light.
//! Shadow rays meet a sphere whose radius is smaller by `h + e` (see `ShadowCone::r2`), the cone is about one that is larger by `h`, and a
//! sure point is inside of one that is smaller by `2 h + 3 e`: `2 h + e` outside and `h + 2 e` inside are left for errors. These are, at
//! the sphere:
//!
//! - The vector from the light, and the perpendicular that is computed of it: some `u` of the distance from the light, less than `e / 2`.
//! - The point on the plane, by its coordinates: less than `h / 3` by the coordinates of the sphere, and `e / 3` by the way from it, as
//!   an error that moves the far end of a ray from the light by a share of that way moves its part at the sphere by less. (Points are
//!   computed from the plane's centre. One that is much farther from the eye than all this is not allowed for.)
//! - The point on the plane, by its distance from the eye: some `u` of it. [`SIDE`] is 1e-5 of that distance there, as a side's
//!   terms are scaled by the way from the light to the eye's mirror image, which is longer than the eye is high.
//! - The cone's own terms: below [`SIDE`], and [`WIDE`] is for the cosine.

use glam::Vec3A;

/// How far rounding moves a computed point of a sphere off it, at most, as a share of the sphere's largest coordinate.
///
/// In units of `u` the errors are 1.7 for the point's coordinates (the root of 3), 2.5 for its distance from the centre, 1.5
/// for the ray's length, and 2.8 for the vector from the centre, its square and the discriminant when the next ray is tested
/// against the sphere: 8.5 in total. Hundreds of millions of rays had at most 5 (`rays_that_leave_a_sphere_do_not_hit_it_again`).
pub(crate) const HIT: f32 = 10.0 / (1 << 24) as f32;

/// Returns how far rounding moves a point of a sphere off it, at most, see [`HIT`].
pub(crate) fn hit_error(centre: Vec3A, radius: f32) -> f32 {
    HIT * (centre.abs().max_element() + radius)
}

/// Without fused multiply-add, the error of a chord's squared perpendicular before it is refined, as a share of the square of `t_mid`,
/// see [`Chord`](crate::shapes::sphere::Chord).
///
/// Rounding the product `d t_mid` displaces the perpendicular by `u t_mid`, and rounding `t_mid` itself lengthens it along the ray by
/// less than `5 u t_mid`. For a ray that meets a sphere of radius `r`, `(r + u t)^2 <= r^2 (1 + m) + u^2 t^2 (1 + 1 / m)`. With
/// `m = 0.001`, for which [`BOUND`] makes room, and the square of the 5, that is `(1001 + 25) u^2 = 3.6e-12`.
pub(crate) const UNREFINED: f32 = 4e-12;

/// The largest distance of a hit from its sphere, as a share of the radius, that one Newton step reduces to rounding errors.
pub(crate) const NEWTON: f32 = 1.0 / (1 << 13) as f32;

/// The depth in a sphere below which a point counts as on it, as a share of the sphere's largest coordinate: four times [`HIT`].
pub(crate) const DEEP: f32 = 2e-6;

/// The offset from a block's surface at which secondary rays start, as a share of the sum of its coordinates and half extents: many
/// times the rounding error of a point on it. At ten units from the origin it is 1e-4. So a face of another block that coincides with
/// its own is behind the rays.
pub(crate) const BLOCK_HIT: f32 = 1e-5;

/// The share by which the bounding sphere of a block is larger than its diagonal: many times the rounding of its corners.
pub(crate) const BLOCK_BOUND: f32 = 1e-4;

/// The error of the dot product of two directions: some 10 roundings.
pub(crate) const COSINE: f32 = 1e-6;

/// The error of the squared dot product of two directions.
pub(crate) const COSINE2: f32 = 4e-6;

/// The share by which bounding spheres are enlarged. It is more than the rounding error of a ray that comes from a thousand radii away,
/// so that no ray hits a sphere and misses its bound.
pub(crate) const BOUND: f32 = 1e-3;

/// The factor that enlarges a sphere before its bounding cone is computed: the cosine of the cone grows by more than its rounding, however
/// flat the cone is.
pub(crate) const WIDE: f32 = 1.0 + 1e-6;

/// The sine that is added to a cone's before its tangent planes are computed: more than rounding turns them.
pub(crate) const WIDER: f32 = 1e-4;

/// The factor on the errors of a sphere's shadow, above, by which points are sure to be inside of its cone: one error widens the cone, one
/// is taken from the radius for shadow rays, and the points that these leave from are off by less than a third one.
pub(crate) const UNSURE: f32 = 3.0;

/// The error of the inequality of a side of an outline, whose terms are below twice the picture's largest u or v.
pub(crate) const SIDE: f32 = 1e-5;

/// The part of [`SIDE`] that is usual: some 5 roundings. That is enough for shadows that are not exact by more, and leaves
/// a part of the shadows by lights that are a thousand times as far away.
pub(crate) const USUAL: f32 = 0.03;

/// How far a block's corner may be from where the eye sees it, as a share of its distance and size: the error of axes that
/// [`Scene::validate`](crate::scene::Scene::validate) allows, which is far more than rounding, and a tenth of a pixel.
pub(crate) const CORNER: f32 = 2e-4;

/// The same from a light, which may be a thousand times as far away: two roundings.
pub(crate) const CORNER_BY_LIGHT: f32 = 1e-7;

/// More than rounding moves a hit towards the eye, as a share of how far the object reaches from it.
pub(crate) const CONTACT: f32 = 1e-6;

/// An eye nearer to a sphere than this many times its hit error may be inside or outside.
pub(crate) const TOUCHING: f32 = 4.0;

/// The least height of the eye and of a light above a plane, as a share of the way from the light to the eye's mirror image, that
/// leaves shadows bounds which rounding cannot spoil.
pub(crate) const LEAST_HEIGHT: f32 = 0.01;

/// Pixels around a bounding rectangle in the picture, far more than its rounding.
pub(crate) const PIXELS_AROUND: f32 = 0.5;

/// The most that rounding moves the ends of a range of squares, in pixels.
pub(crate) const COLUMN: f32 = 0.02;

/// The least determinant of a highlight's ellipse, as a share of the product of its diagonal: no more drawn out than rounding allows for.
pub(crate) const DRAWN_OUT: f32 = 1e-6;
