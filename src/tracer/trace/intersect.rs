use super::candidates::{Candidate, Candidates};
use super::rays::{Rays, departing};
use crate::lanes::*;
use crate::prepare::{BvhNode, GroupSet, Object, ObjectId, World};
use crate::shapes::sphere::Chord;
use crate::shapes::{block, plane};

const NO_HIT: f32 = 1e30;

#[derive(Clone, Copy)]
pub(crate) struct Hit<S: Isa> {
    /// In lengths of the ray's direction.
    pub t: F<S>,
    pub object: U<S>,
    /// The rays that start inside a block and hit it.
    pub within_block: M<S>,
}

impl<S: Isa> Hit<S> {
    #[inline(always)]
    pub fn keep_nearer(&mut self, nearer: M<S>, t: F<S>, object: ObjectId) {
        self.t = nearer.select(t, self.t);
        self.object = nearer.select(U::<S>::splat(self.t.token(), object.lane()), self.object);
    }
}

/// Returns the nearest hits among planes and the spheres of `groups`, and lists the blocks that may
/// be hit.
#[inline(always)]
pub(crate) fn nearest<S: Isa>(
    simd: S,
    world: World<'_>,
    rays: &Rays<S>,
    groups: GroupSet,
    blocks: &mut Candidates,
) -> Hit<S> {
    blocks.clear();
    let mut hit = Hit {
        t: splat(simd, NO_HIT),
        object: U::<S>::splat(simd, ObjectId::new(world.background()).lane()),
        within_block: M::<S>::splat(simd, false),
    };
    for (i, rectangle) in world.planes().iter().enumerate() {
        let (m, t) = plane::hit(simd, rectangle, rays.o, rays.d, hit.t);
        hit.keep_nearer(m, t, ObjectId::new(world.first_plane() + i));
    }
    let nodes = world.tree.nodes();
    let mut i = world.tree.start(groups);
    while let Some(node) = nodes.get(i) {
        let mut is_met = node.groups & groups != 0;
        if is_met {
            let quick = Chord::new(simd, node.centre, rays.o, rays.d);
            let near = quick.may_be_ahead(node.cull2);
            is_met = near.any_true();
            if is_met && !node.is_bound {
                let chord = quick.refined(rays.d);
                if node.is_block {
                    let cylinder = (node.axis, node.thin2);
                    let near = near & !block::is_off(&chord, rays.d, cylinder, node.radius, hit.t);
                    if near.any_true() {
                        blocks.push(Candidate::new::<S>(node.object, near));
                    }
                } else {
                    let (m, t) = if node.is_at_eye {
                        let power = power(rays, node);
                        chord.exact_entry(near, power, hit.t)
                    } else {
                        chord.entry(near, node.r2, node.hit_error, node.r2_error, hit.t)
                    };
                    hit.keep_nearer(m, t, node.object);
                }
            }
        }
        i += node.step(is_met);
    }
    hit
}

/// Returns the powers of rays' origins with respect to a sphere: 0 for rays that leave the sphere
/// outward, negative for rays that leave it inward.
#[inline(always)]
fn power<S: Isa>(rays: &Rays<S>, node: &BvhNode) -> F<S> {
    let simd = rays.weight.token();
    let [x, y, z] = [&rays.o.x, &rays.o.y, &rays.o.z].map(SimdBase::as_slice);
    let mut powers = [0.0; MAX_LANES];
    node.powers([x, y, z], &mut powers);
    let power = F::<S>::from_slice(simd, &powers[..lanes::<S>()]);
    let [outward, inward] = departing(simd, rays.slot_path, node.object);
    let power = outward.select(splat(simd, 0.0), power);
    inward.select(splat(simd, -f32::MIN_POSITIVE), power)
}

#[inline(always)]
pub(super) fn resolve_blocks<S: Isa>(
    simd: S,
    world: World<'_>,
    rays: &Rays<S>,
    blocks: &Candidates,
    hit: &mut Hit<S>,
) {
    for &candidate in blocks.iter() {
        if let Object::Block(block) = world.object(candidate.object).0 {
            let [outward, inward] = departing(simd, rays.slot_path, candidate.object);
            let (t, is_inside) = block::distance(simd, block, &rays.o, &rays.d, inward);
            let is_nearer = t.simd_lt(hit.t) & candidate.lanes(simd) & !outward;
            hit.keep_nearer(is_nearer, t, candidate.object);
            hit.within_block = is_inside & is_nearer | hit.within_block & !is_nearer;
        }
    }
}
