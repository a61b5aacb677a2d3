//! The surfaces that a packet hits.

use crate::lanes::*;
use crate::prepare::{FIELDS, Prepared};

/// What shading needs of an object, per lane.
pub(super) struct SurfaceLanes<S: Isa> {
    /// In the order of `Surface::fields`.
    fields: [F<S>; FIELDS],
}

impl<S: Isa> SurfaceLanes<S> {
    /// The surface of the first active lane's object, in all lanes.
    #[inline(always)]
    pub fn first(simd: S, scene: &Prepared, objects: U<S>, active: M<S>) -> Self {
        let surface = &scene.surfaces[number_in::<S>(objects, active.to_bitmask())];
        Self {
            fields: core::array::from_fn(
                #[inline(always)]
                |i| splat(simd, surface[i]),
            ),
        }
    }

    /// Puts the other active lanes' surfaces in, an object after the other: most packets meet one or two.
    #[inline(always)]
    pub fn add_others(&mut self, simd: S, scene: &Prepared, objects: U<S>, active: M<S>) {
        let mut rest = active.to_bitmask();
        let first = number_in::<S>(objects, rest);
        rest &= !objects
            .simd_eq(U::<S>::splat(simd, first as u32))
            .to_bitmask();
        while rest != 0 {
            let number = number_in::<S>(objects, rest);
            let mask = objects.simd_eq(U::<S>::splat(simd, number as u32));
            rest &= !mask.to_bitmask();
            let surface = &scene.surfaces[number];
            // The count comes from memory so that this stays a loop: unrolled it takes a kilobyte.
            let fields = &surface[..scene.field_count.min(FIELDS)];
            for (lane, &field) in self.fields.iter_mut().zip(fields) {
                *lane = mask.select(splat(simd, field), *lane);
            }
        }
    }

    #[inline(always)]
    fn vector(&self, i: usize) -> Vec3x<S> {
        Vec3x {
            x: self.fields[i],
            y: self.fields[i + 1],
            z: self.fields[i + 2],
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
        self.fields[9]
    }

    #[inline(always)]
    pub fn upright(&self) -> F<S> {
        self.fields[10]
    }

    #[inline(always)]
    pub fn ks(&self) -> F<S> {
        self.fields[11]
    }

    #[inline(always)]
    pub fn exponent(&self) -> F<S> {
        self.fields[12]
    }

    #[inline(always)]
    pub fn faint(&self) -> F<S> {
        self.fields[13]
    }

    #[inline(always)]
    pub fn kr(&self) -> F<S> {
        self.fields[14]
    }

    #[inline(always)]
    pub fn kt(&self) -> F<S> {
        self.fields[15]
    }

    #[inline(always)]
    pub fn index(&self) -> F<S> {
        self.fields[16]
    }

    #[inline(always)]
    pub fn solid(&self) -> F<S> {
        self.fields[17]
    }
}

/// The number of the object in the first lane of a set.
#[inline(always)]
fn number_in<S: Isa>(objects: U<S>, set: u64) -> usize {
    objects.as_slice()[set.trailing_zeros() as usize % lanes::<S>()] as usize
}
