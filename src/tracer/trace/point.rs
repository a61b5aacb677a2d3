use super::intersect::Hit;
use super::rays::{INWARD, Rays, departure};
use super::surface::{SurfaceLanes, object_at};
use crate::lanes::*;
use crate::prepare::{Object, Parameter, World};
use crate::rounding;
use crate::shapes::TexturePoint;
use crate::shapes::block::BlockHit;
use glam::{Mat3, Vec3A};

pub(super) struct ShadingPoint<S: Isa> {
    pub p: Vec3x<S>,
    /// Of length 1, towards the ray.
    pub n: Vec3x<S>,
    pub dn: F<S>,
    pub r: Vec3x<S>,
    /// The distance of `p` from a block's surface, on the ray's side; 0 for other objects.
    pub hit_error: F<S>,
    pub departure: U<S>,
    /// The direction of the grooves, of length 1; undefined where `anisotropy` is 0.
    pub groove: Vec3x<S>,
    pub anisotropy: F<S>,
    /// The texture's factor on the colour, 0 to 1; negative if the texture is finer than squares.
    pub reflectance: F<S>,
    /// See `Pattern::tint`.
    pub tint: Vec3x<S>,
    pub pattern_hash: U<S>,
    /// The least cosine between normal and light, divided by the light's distance. Inside a sphere
    /// it is above 0: the far side blocks lights beyond the chord, which is twice the cosine times
    /// the radius long.
    pub horizon: F<S>,
    pub inside: M<S>,
    pub shaded: M<S>,
}

impl<S: Isa> ShadingPoint<S> {
    #[inline(always)]
    pub fn new(
        simd: S,
        world: World<'_>,
        rays: &Rays<S>,
        hit: &Hit<S>,
        surface: &SurfaceLanes<'_, S>,
        shaded: M<S>,
    ) -> Self {
        let mut point = Self::on_sphere_or_plane(simd, rays, hit.t, surface, shaded);
        if world.has_details {
            point.add_detail(simd, world, rays, hit);
        }
        if !world.scene.water.is_calm() {
            point.ripple(simd, world, rays, hit);
        }
        point.face(simd, rays, hit);
        point
    }

    #[inline(always)]
    fn on_sphere_or_plane(
        simd: S,
        rays: &Rays<S>,
        t: F<S>,
        surface: &SurfaceLanes<'_, S>,
        shaded: M<S>,
    ) -> Self {
        let (zero, one) = (splat(simd, 0.0), splat(simd, 1.0));
        let inverse_radius = surface.number(Parameter::InverseRadius);
        let is_plane = inverse_radius.simd_eq(zero);
        // Projected back onto the sphere: secondary rays do not inherit the error of t.
        let out = (rays.o - surface.vector(Parameter::Centre)).add_scaled(rays.d, t);
        let square: F<S> = out.dot(out) * (inverse_radius * inverse_radius);
        let mut scale = square.mul_add(splat(simd, -0.5), is_plane.select(one, splat(simd, 1.5)));
        let far = shaded & (scale - 1.0).abs().simd_gt(splat(simd, rounding::NEWTON));
        if far.any_true() {
            scale = far.select(one / square.sqrt(), scale);
        }
        let mut p = surface.vector(Parameter::Centre).add_scaled(out, scale);
        p.y = is_plane.select(surface.vector(Parameter::Centre).y, p.y);
        let mut n = out.scaled(scale * inverse_radius);
        n.y = is_plane.select(one, n.y);
        Self {
            p,
            n,
            dn: zero,
            r: n,
            hit_error: zero,
            departure: U::<S>::splat(simd, 0),
            groove: n,
            anisotropy: zero,
            reflectance: splat(simd, 1.0),
            tint: Vec3x::splat(simd, Vec3A::ZERO),
            pattern_hash: U::<S>::splat(simd, 0),
            horizon: inverse_radius * 0.5,
            inside: shaded,
            shaded,
        }
    }

    /// Computes points on blocks, and textures, object by object.
    #[inline(always)]
    fn add_detail(&mut self, simd: S, world: World<'_>, rays: &Rays<S>, hit: &Hit<S>) {
        let Rays { o, d, .. } = rays;
        let mut rest = self.shaded.to_bitmask();
        while rest != 0 {
            let (id, same) = object_at(simd, hit.object, &mut rest);
            let (object, material) = world.object(id);
            let centre = Vec3x::splat(simd, object.centre());
            let out = (*o - centre).add_scaled(*d, hit.t);
            let texture_point = if let Object::Block(block) = object {
                let on_block = BlockHit::near(simd, block, out);
                let error = splat(simd, world.block_errors[id.index() - world.scene.spheres.len()]);
                let n = on_block.texture_point.n;
                let sign = !d.dot(n).bitcast::<U<S>>() & (1 << 31);
                let p = centre + on_block.out;
                let p = p.add_scaled(n, flipped::<S>(error, sign));
                self.p = Vec3x::select(same, p, self.p);
                self.n = Vec3x::select(same, n, self.n);
                self.hit_error = same.select(error, self.hit_error);
                on_block.texture_point
            } else {
                TexturePoint::on(simd, &object, out)
            };
            if material.anisotropy > 0.0 {
                let axes =
                    if let Object::Block(block) = object { block.axes } else { Mat3::IDENTITY };
                let groove = texture_point.groove(simd, &axes);
                self.groove = Vec3x::select(same, groove, self.groove);
                self.anisotropy = same.select(splat(simd, material.anisotropy), self.anisotropy);
            }
            let pattern = &material.pattern;
            if pattern.depth > 0.0 {
                let (left, hash) = texture_point.reflectance(simd, world, pattern, d, hit.t);
                self.pattern_hash = same.select(hash, self.pattern_hash);
                self.reflectance = same.select(left, self.reflectance);
                self.tint = Vec3x::select(same, Vec3x::splat(simd, pattern.tint), self.tint);
            }
        }
    }

    #[inline(always)]
    fn face(&mut self, simd: S, rays: &Rays<S>, hit: &Hit<S>) {
        let n = self.n;
        let outward = rays.d.dot(n);
        // The sign bit that flips normals along the ray.
        let sign = U::<S>::splat(simd, 1 << 31);
        let flip = (outward.bitcast::<U<S>>() & sign) ^ sign;
        let n = n.flipped(flip);
        self.n = n;
        self.dn = flipped::<S>(outward, flip);
        self.r = rays.d.add_scaled(n, self.dn * -2.0);
        let zero = splat(simd, 0.0);
        self.inside = hit.within_block | outward.simd_gt(zero) & self.hit_error.simd_le(zero);
        let inward: U<S> = self.inside.to_vector().bitcast();
        self.departure = departure::<S>(hit.object) | (inward & INWARD);
        self.horizon = self.inside.select(self.horizon, zero);
    }
}
