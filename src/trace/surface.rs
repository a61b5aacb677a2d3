//! The surfaces that a packet hits.

use crate::lanes::*;
use crate::prepare::{Prepared, Spread};

/// What shading needs of an object, per lane.
pub(super) struct SurfaceLanes<'a, S: Isa> {
    simd: S,
    /// The numbers in the order of [`FIELDS`](crate::prepare::FIELDS).
    fields: &'a Spread,
}

impl<'a, S: Isa> SurfaceLanes<'a, S> {
    /// Looks the objects of the active lanes up. Most packets meet one object, whose numbers lie ready; else each further
    /// one's go to those lanes that hit it, in `mixed`.
    #[inline(always)]
    pub fn look_up(
        simd: S,
        scene: &'a Prepared,
        objects: U<S>,
        active: M<S>,
        mixed: &'a mut Spread,
    ) -> Self {
        let mut rest = active.to_bitmask();
        let first = scene.surface(object_at(simd, objects, &mut rest).0);
        if rest == 0 {
            return Self {
                simd,
                fields: first,
            };
        }
        let mut is_first = true;
        while rest != 0 {
            let (number, same) = object_at(simd, objects, &mut rest);
            let mask: U<S> = same.to_vector().bitcast();
            let new = scene.surface(number);
            for ((field, first), new) in mixed.iter_mut().zip(first).zip(new) {
                // Not a selection: of that the compiler makes a masked store, which takes AMD's processors 20 cycles.
                let old: U<S> = load(simd, if is_first { first } else { field }).bitcast();
                let new: U<S> = load(simd, new).bitcast();
                let both: F<S> = (old ^ ((old ^ new) & mask)).bitcast();
                both.store_slice(&mut field[..lanes::<S>()]);
            }
            is_first = false;
        }
        Self {
            simd,
            fields: mixed,
        }
    }

    #[inline(always)]
    fn number(&self, i: usize) -> F<S> {
        load(self.simd, &self.fields[i])
    }

    #[inline(always)]
    fn vector(&self, i: usize) -> Vec3x<S> {
        Vec3x {
            x: self.number(i),
            y: self.number(i + 1),
            z: self.number(i + 2),
        }
    }

    #[inline(always)]
    pub fn centre(&self) -> Vec3x<S> {
        self.vector(0)
    }

    #[inline(always)]
    pub fn base(&self) -> Vec3x<S> {
        self.vector(4)
    }

    #[inline(always)]
    pub fn diffuse(&self) -> Vec3x<S> {
        self.vector(8)
    }

    #[inline(always)]
    pub fn inverse_radius(&self) -> F<S> {
        self.number(3)
    }

    #[inline(always)]
    pub fn upright(&self) -> F<S> {
        self.number(7)
    }

    #[inline(always)]
    pub fn ks(&self) -> F<S> {
        self.number(12)
    }

    #[inline(always)]
    pub fn exponent(&self) -> F<S> {
        self.number(13)
    }

    #[inline(always)]
    pub fn faint(&self) -> F<S> {
        self.number(14)
    }

    #[inline(always)]
    pub fn kr(&self) -> F<S> {
        self.number(15)
    }

    #[inline(always)]
    pub fn kt(&self) -> F<S> {
        self.number(16)
    }

    #[inline(always)]
    pub fn index(&self) -> F<S> {
        self.number(17)
    }

    #[inline(always)]
    pub fn solid(&self) -> F<S> {
        self.number(11)
    }
}

/// The object of the first lane in `rest`, and the lanes that hit it, which are taken out.
#[inline(always)]
pub(super) fn object_at<S: Isa>(simd: S, objects: U<S>, rest: &mut u64) -> (usize, M<S>) {
    let lane = rest.trailing_zeros() as usize % lanes::<S>();
    let number = objects.as_slice()[lane];
    let same = objects.simd_eq(U::<S>::splat(simd, number));
    *rest &= !same.to_bitmask();
    (number as usize, same)
}

/// A packet's lanes of a number.
#[inline(always)]
fn load<S: Isa>(simd: S, field: &[f32; MAX_LANES]) -> F<S> {
    F::<S>::from_slice(simd, &field[..lanes::<S>()])
}
