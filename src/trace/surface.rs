//! The surfaces that a packet hits.

use crate::lanes::*;
use crate::prepare::{FIELDS, Prepared};

/// What shading needs of an object, per lane.
pub(super) struct SurfaceLanes<S: Isa> {
    /// The numbers' bits, in the order of [`crate::prepare::Surface`].
    fields: [U<S>; FIELDS],
}

impl<S: Isa> SurfaceLanes<S> {
    /// Nothing that is looked at; what it holds is no matter.
    #[inline(always)]
    pub fn new(any: U<S>) -> Self {
        Self {
            fields: [any; FIELDS],
        }
    }

    /// Looks the objects of the active lanes up: the first one's surface goes to all lanes, each other one's to those that
    /// hit it. Most packets meet one or two objects.
    #[inline(always)]
    pub fn look_up(&mut self, simd: S, scene: &Prepared, objects: U<S>, active: M<S>) {
        let mut rest = active.to_bitmask();
        let mut is_first = true;
        while rest != 0 {
            let lane = rest.trailing_zeros() as usize % lanes::<S>();
            let number = objects.as_slice()[lane];
            let same = objects.simd_eq(U::<S>::splat(simd, number));
            rest &= !same.to_bitmask();
            let mask = (same | M::<S>::splat(simd, is_first))
                .to_vector()
                .bitcast::<U<S>>();
            is_first = false;
            let surface = &scene.surfaces[number as usize];
            // In the intro the count comes from memory, so that this stays a loop: unrolled it takes a kilobyte.
            let count = if cfg!(feature = "avx512") {
                FIELDS
            } else {
                scene.field_count
            };
            let fields = &surface[..count.min(FIELDS)];
            for (lane, &field) in self.fields.iter_mut().zip(fields) {
                // Not a selection: of that the compiler makes a masked store, which takes AMD's processors 20 cycles.
                let new = U::<S>::splat(simd, field.to_bits());
                *lane ^= (*lane ^ new) & mask;
            }
        }
    }

    #[inline(always)]
    fn vector(&self, i: usize) -> Vec3x<S> {
        Vec3x {
            x: self.fields[i].bitcast(),
            y: self.fields[i + 1].bitcast(),
            z: self.fields[i + 2].bitcast(),
        }
    }

    #[inline(always)]
    pub fn centre(&self) -> Vec3x<S> {
        self.vector(0)
    }

    #[inline(always)]
    pub fn base(&self) -> Vec3x<S> {
        self.vector(3)
    }

    #[inline(always)]
    pub fn diffuse(&self) -> Vec3x<S> {
        self.vector(6)
    }

    #[inline(always)]
    pub fn inverse_radius(&self) -> F<S> {
        self.fields[9].bitcast()
    }

    #[inline(always)]
    pub fn upright(&self) -> F<S> {
        self.fields[10].bitcast()
    }

    #[inline(always)]
    pub fn ks(&self) -> F<S> {
        self.fields[11].bitcast()
    }

    #[inline(always)]
    pub fn exponent(&self) -> F<S> {
        self.fields[12].bitcast()
    }

    #[inline(always)]
    pub fn faint(&self) -> F<S> {
        self.fields[13].bitcast()
    }

    #[inline(always)]
    pub fn kr(&self) -> F<S> {
        self.fields[14].bitcast()
    }

    #[inline(always)]
    pub fn kt(&self) -> F<S> {
        self.fields[15].bitcast()
    }

    #[inline(always)]
    pub fn index(&self) -> F<S> {
        self.fields[16].bitcast()
    }

    #[inline(always)]
    pub fn solid(&self) -> F<S> {
        self.fields[17].bitcast()
    }
}
