use super::candidates::{CONES, Candidate, Occluders};
use crate::lanes::*;
use crate::prepare::{PreparedLight, ShadowCone, World};
use crate::shapes::plane;

#[derive(Clone, Copy)]
pub(super) struct ShadowRays<S: Isa> {
    pub o: Vec3x<S>,
    /// To the light, of length 1.
    pub d: Vec3x<S>,
    /// To the light; 0 in inactive lanes.
    pub distance: F<S>,
    pub departure: U<S>,
}

impl Occluders {
    /// Returns the rays that planes block, or spheres if the light is a point. Lists other
    /// occluders.
    ///
    /// A bound's shadow cone contains the cones of its solids. All solids of a leaf are tested
    /// without a branch.
    #[inline(always)]
    pub fn find<S: Isa>(
        &mut self,
        simd: S,
        world: World<'_>,
        light: &PreparedLight,
        rays: &ShadowRays<S>,
    ) -> M<S> {
        let mut blocked = M::<S>::splat(simd, false);
        let cones = &light.shadow_cones[..world.tree.solid_nodes().len()];
        let (mut i, mut count) = (0, 0);
        while let Some(bound) = cones.get(i) {
            if !rays.start_inside(simd, bound).any_true() {
                i += usize::from(bound.skip);
                continue;
            }
            i += 1;
            for cone in &cones[i..i + usize::from(bound.solids)] {
                if cone.object < light.listed_from {
                    blocked |= rays.meet_sphere(simd, cone);
                } else {
                    // Branch-free: the cones that a packet meets are unpredictable.
                    self.cones[count % CONES] = i as u16;
                    count += usize::from(rays.start_inside(simd, cone).any_true());
                }
                i += 1;
            }
        }
        self.solids.clear();
        for &index in &self.cones[..count.min(CONES)] {
            let cone = &cones[usize::from(index)];
            let shaded = rays.start_inside(simd, cone);
            let near = shaded & !rays.are_off(simd, cone, light.diameter);
            if near.any_true() {
                self.solids.push(Candidate::new::<S>(cone.object, near));
            }
        }
        blocked | rays.meet_planes(simd, world, light)
    }
}

impl<S: Isa> ShadowRays<S> {
    #[inline(always)]
    fn start_inside(&self, simd: S, cone: &ShadowCone) -> M<S> {
        let chord = self.d - Vec3x::splat(simd, cone.axis);
        let is_near = chord.dot(chord).simd_lt(splat(simd, cone.chord2));
        is_near & self.distance.simd_gt(splat(simd, cone.from))
    }

    /// Returns the rays that certainly miss a solid and its penumbra, or are wholly inside the
    /// sphere, as in [`ShadowRays::meet_sphere`].
    #[inline(always)]
    fn are_off(&self, simd: S, cone: &ShadowCone, diameter: f32) -> M<S> {
        let &Self { d, distance, .. } = self;
        let off = d.dot(Vec3x::splat(simd, cone.side));
        let f = Vec3x::splat(simd, cone.to_light);
        let along = f.dot(d);
        let across = f.add_scaled(d, -along);
        // Half of the penumbra is outside the sphere. Multiplying by the distance avoids a
        // division.
        let share = at_least::<S>(distance - along, splat(simd, 0.0));
        let reach = share.mul_add(splat(simd, 0.5 * diameter), distance * cone.radius);
        let across2 = across.dot(across);
        if cone.around_light {
            return (splat::<S>(simd, cone.r2) - across2).simd_ge(share * share);
        }
        let past = across2 * distance * distance;
        (off * off).simd_gt(splat(simd, cone.sine2)) | past.simd_gt(reach * reach)
    }

    /// Returns the rays that a sphere blocks. A ray that starts on the sphere and leaves it passes,
    /// see [`ShadowCone::r2`].
    #[inline(always)]
    fn meet_sphere(&self, simd: S, cone: &ShadowCone) -> M<S> {
        let zero = splat(simd, 0.0);
        // From the light to the ray's point nearest to the sphere's centre.
        let f = Vec3x::splat(simd, cone.to_light);
        let along = f.dot(self.d);
        let across = f.add_scaled(self.d, -along);
        let half2 = splat(simd, cone.r2) - across.dot(across);
        if cone.around_light {
            // The chord extends by sqrt(half2) to both sides of that point, and ends between the
            // light and the origin.
            let left = at_least::<S>(self.distance - along, zero);
            return half2.simd_lt(left * left);
        }
        // A part of the chord is between the light and the origin.
        let short = at_least::<S>(at_least::<S>(along - self.distance, -along), zero);
        half2.simd_gt(short * short)
    }

    #[inline(always)]
    fn meet_planes(&self, simd: S, world: World<'_>, light: &PreparedLight) -> M<S> {
        let mut blocked = M::<S>::splat(simd, false);
        for rectangle in world.planes() {
            let height = splat(simd, rectangle.centre.y);
            let behind = if light.position.y > rectangle.centre.y {
                self.o.y.simd_lt(height)
            } else {
                self.o.y.simd_gt(height)
            };
            if behind.any_true() {
                blocked |= behind & plane::hit(simd, rectangle, self.o, self.d, self.distance).0;
            }
        }
        blocked
    }
}
