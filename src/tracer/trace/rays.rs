use super::queue::{BATCH, Queue};
use crate::lanes::*;
use crate::prepare::{MAX_OBJECTS, ObjectId, World};
use crate::quality::Quality;

#[derive(Clone, Copy)]
pub(crate) struct Rays<S: Isa> {
    pub o: Vec3x<S>,
    /// Of length 1.
    pub d: Vec3x<S>,
    /// See [`Quality::key_weight`].
    pub weight: F<S>,
    /// The point's index in the batch, and the node in its ray tree: `slot << PATH_BITS | path`. A
    /// primary ray has the path 1; the ray with the path p has the reflected ray 2 p and the
    /// transmitted ray 2 p + 1. The upper bits are the [`departure`] and the mark of mirrored rays.
    pub slot_path: U<S>,
}

/// Marks reflections of primary rays in the first plane.
const MIRRORED: u32 = 1 << 31;

const DEPARTURE: u32 = PATH_BITS + BATCH.trailing_zeros();

/// Marks departures into the object.
pub(super) const INWARD: u32 = 1 << 30;

const _: () = assert!(MAX_OBJECTS < 1 << (30 - DEPARTURE));

/// Returns the departures of rays that leave `objects` outward. Add [`INWARD`] for rays that go
/// inside.
#[inline(always)]
pub(super) fn departure<S: Isa>(objects: U<S>) -> U<S> {
    (objects + 1) << DEPARTURE
}

/// Returns the rays that leave an object outward, and inward.
#[inline(always)]
pub(super) fn departing<S: Isa>(simd: S, departures: U<S>, object: ObjectId) -> [M<S>; 2] {
    let departures = departures & !(MIRRORED | ((1 << DEPARTURE) - 1));
    let outward = (object.lane() + 1) << DEPARTURE;
    [outward, outward | INWARD].map(|it| departures.simd_eq(U::<S>::splat(simd, it)))
}

/// A leading 1, and one bit for each reflection or transmission.
pub(super) const PATH_BITS: u32 = Quality::MAX_DEPTH + 1;

impl<S: Isa> Rays<S> {
    #[inline(always)]
    pub fn primary(simd: S, world: World<'_>, points: &Queue, start: usize) -> Self {
        let [x, y] = points.packet(simd, start);
        Self {
            o: Vec3x::splat(simd, world.eye),
            d: primary_directions(simd, world, x, y),
            weight: splat(simd, world.weight),
            slot_path: Self::slot_paths(simd, start),
        }
    }

    #[inline(always)]
    pub fn slot_paths(simd: S, slot: usize) -> U<S> {
        (lane_numbers(simd) << PATH_BITS) + ((slot as u32) << PATH_BITS | 1)
    }

    #[inline(always)]
    pub fn slots(&self) -> U<S> {
        (self.slot_path >> PATH_BITS) & (BATCH as u32 - 1)
    }

    #[inline(always)]
    pub fn paths(&self) -> U<S> {
        self.slot_path & ((1 << PATH_BITS) - 1)
    }

    /// Transmitted rays have the next larger path.
    #[inline(always)]
    pub fn reflected_slot_paths(&self) -> U<S> {
        (self.slot_path + self.paths()) & ((1 << DEPARTURE) - 1)
    }

    /// Returns [`MIRRORED`] for rays that the first plane, object number `plane`, reflects.
    #[inline(always)]
    pub fn mirror_marks(&self, simd: S, objects: U<S>, plane: usize) -> U<S> {
        let plane = objects.simd_eq(U::<S>::splat(simd, plane as u32));
        let mirrored = plane & self.paths().simd_eq(U::<S>::splat(simd, 1));
        mirrored.to_vector().bitcast::<U<S>>() & MIRRORED
    }

    #[inline(always)]
    pub fn mirrored(&self, simd: S) -> M<S> {
        self.slot_path.bitcast::<I<S>>().simd_lt(I::<S>::splat(simd, 0))
    }
}

#[inline(always)]
pub(super) fn primary_directions<S: Isa>(simd: S, world: World<'_>, x: F<S>, y: F<S>) -> Vec3x<S> {
    let d = to_picture(simd, world, x, y);
    d.scaled(splat(simd, 1.0) / d.dot(d).sqrt())
}

#[inline(always)]
pub(super) fn to_picture<S: Isa>(simd: S, world: World<'_>, x: F<S>, y: F<S>) -> Vec3x<S> {
    let raster = &world.raster;
    Vec3x::splat(simd, raster.corner)
        .add_scaled(Vec3x::splat(simd, raster.dx), x)
        .add_scaled(Vec3x::splat(simd, raster.dy), y)
}
