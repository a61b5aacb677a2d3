use super::TexturePoint;
use crate::lanes::*;
use crate::rounding;
use crate::scene::Sphere;
use glam::Vec3A;

pub(crate) struct Chord<S: Isa> {
    f: Vec3x<S>,
    /// The distance along the ray to the chord's middle.
    pub t_mid: F<S>,
    /// The vector from the centre to the chord's middle.
    pub l: Vec3x<S>,
    pub l2: F<S>,
}

impl<S: Isa> Chord<S> {
    /// The perpendicular loses no digits when the sphere is small and far away (Haines, Günther,
    /// Akenine-Möller: Precision Improvements for Ray/Sphere Intersection, Ray Tracing Gems, 2019).
    #[inline(always)]
    pub fn new(simd: S, centre: Vec3A, o: Vec3x<S>, d: Vec3x<S>) -> Self {
        let f = Vec3x::splat(simd, centre) - o;
        let t_mid = f.dot(d);
        let l = d.scaled_minus(t_mid, f);
        let l2 = l.dot(l);
        Self { f, t_mid, l, l2 }
    }

    /// Recomputes the perpendicular as accurately as with FMA.
    ///
    /// Without FMA, rounding `d t_mid` is magnified by cancellation. Halves of 12 bits have exact
    /// products (Dekker: A Floating-Point Technique for Extending the Available Precision,
    /// Numerische Mathematik 18, 1971); only the last, smaller by 2^12, is rounded.
    #[inline(always)]
    pub fn refined(self, d: Vec3x<S>) -> Self {
        if S::FUSES_MUL_ADD {
            return self;
        }
        let d_high =
            Vec3x { x: upper_half::<S>(d.x), y: upper_half::<S>(d.y), z: upper_half::<S>(d.z) };
        let d_low = d - d_high;
        let t_high = upper_half::<S>(self.t_mid);
        let t_low = self.t_mid - t_high;
        let l = d_high
            .scaled_minus(t_high, self.f)
            .add_scaled(d_high, t_low)
            .add_scaled(d_low, self.t_mid);
        let l2 = l.dot(l);
        Self { l, l2, ..self }
    }

    /// Conservative. `cull2` is the squared radius, enlarged by at least a thousandth.
    #[inline(always)]
    pub fn may_be_ahead(&self, cull2: f32) -> M<S> {
        let simd = self.t_mid.token();
        let unsure = if S::FUSES_MUL_ADD {
            splat(simd, 0.0)
        } else {
            self.t_mid * splat(simd, -rounding::UNREFINED)
        };
        // The far end is ahead if the middle is, or if half the chord is longer than the distance
        // back to the middle.
        let back2 = at_most::<S>(self.t_mid, unsure) * self.t_mid;
        (splat(simd, cull2) - self.l2).simd_ge(back2)
    }

    /// Returns the nearest end of the chord ahead and within `limit`.
    ///
    /// An origin within `hit_error` of the sphere counts as on it: outward the ray misses, inward
    /// it hits the far side. `r2` is the squared radius, `r2_error` its change by `hit_error`.
    #[inline(always)]
    pub fn entry(
        &self,
        mask: M<S>,
        r2: f32,
        hit_error: f32,
        r2_error: f32,
        limit: F<S>,
    ) -> (M<S>, F<S>) {
        let simd = self.t_mid.token();
        let r2_error = splat(simd, r2_error);
        // Negative for rays that miss the sphere: its root is NaN, and all comparisons fail.
        let discriminant = splat::<S>(simd, r2) - self.l2;
        let start = self.t_mid.mul_add(self.t_mid, -discriminant);
        let is_inward = self.t_mid.simd_gt(splat(simd, hit_error));
        let is_ahead = is_inward | start.simd_lt(-r2_error);
        let half = discriminant.sqrt();
        let sign =
            U::<S>::splat(simd, 1 << 31) & start.simd_gt(r2_error).to_vector().bitcast::<U<S>>();
        let t = flipped::<S>(half, sign) + self.t_mid;
        (mask & is_ahead & t.simd_lt(limit), t)
    }

    /// Returns the result of [`Chord::entry`] for origins whose powers (squared distance from the
    /// centre minus squared radius) are exact: 0 on the sphere, below 0 inside.
    ///
    /// The ends of the chord are roots of `t^2 - 2 t_mid t + power`. The nearer one needs no
    /// difference of large numbers.
    #[inline(always)]
    pub fn exact_entry(&self, mask: M<S>, power: F<S>, limit: F<S>) -> (M<S>, F<S>) {
        let zero = splat(self.t_mid.token(), 0.0);
        let is_ahead = self.t_mid.simd_gt(zero);
        let half = self.t_mid.mul_add(self.t_mid, -power).sqrt();
        let far = self.t_mid.abs() + half;
        let near = (power / far).abs();
        let is_inside = power.simd_lt(zero);
        let t = (is_inside & is_ahead).select(far, near);
        let is_met = is_inside | (is_ahead & power.simd_gt(zero));
        (mask & is_met & t.simd_lt(limit), t)
    }
}

#[inline(always)]
fn upper_half<S: Isa>(c: F<S>) -> F<S> {
    (c.bitcast::<U<S>>() & 0xffff_f000).bitcast()
}

/// Returns the distances at which rays hit a sphere, or leave it from inside, in lengths of `d`.
/// `length2` is the squared length of `d`; `from` is relative to the centre.
#[inline(always)]
pub(crate) fn distance<S: Isa>(
    simd: S,
    radius: f32,
    from: &Vec3x<S>,
    d: &Vec3x<S>,
    length2: F<S>,
) -> F<S> {
    let zero = splat(simd, 0.0);
    let back: F<S> = from.dot(*d) / length2;
    let across = from.add_scaled(*d, -back);
    let half2 = -across.dot(across) + radius * radius;
    let half = (at_least::<S>(half2, zero) / length2).sqrt();
    let (near, far) = (-back - half, half - back);
    near.simd_gt(zero).select(near, far)
}

/// Returns the distance, at most `length`, at which a ray is nearest to the centre, and its depth
/// there, negative outside.
#[inline(always)]
pub(crate) fn deepest<S: Isa>(
    simd: S,
    sphere: &Sphere,
    o: Vec3x<S>,
    d: Vec3x<S>,
    length: F<S>,
) -> (F<S>, F<S>) {
    let centre = sphere.centre;
    let to_centre = Vec3x::splat(simd, centre) - o;
    let a = at_least::<S>(to_centre.dot(d), splat(simd, 0.0));
    let a = at_most::<S>(a, length);
    let off = to_centre.add_scaled(d, -a);
    // A point within the rounding error of the sphere counts as on it.
    let error = rounding::DEEP * (centre.abs().max_element() + sphere.radius);
    (a, -off.dot(off).sqrt() + (sphere.radius - error))
}

#[inline(always)]
pub(crate) fn texture_point<S: Isa>(simd: S, sphere: &Sphere, out: Vec3x<S>) -> TexturePoint<S> {
    TexturePoint { own: out, n: out.scaled(splat(simd, 1.0 / sphere.radius)) }
}
