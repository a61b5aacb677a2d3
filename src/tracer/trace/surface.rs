//! The surfaces that a packet hits.

use crate::lanes::*;
use crate::prepare::{
    ObjectId, PerLane, SURFACE_NUMBERS, Surface, SurfaceNumbers, SurfaceTable, World,
};

/// Surfaces that are kept in all lanes: more than a picture's tile shows of most scenes. Packets of primary and of secondary rays
/// take turns and so do their objects: with one, the model scene's frame takes 3 % more instructions.
const KEPT: usize = 16;

/// All zeros: memory before a packet's surfaces are looked up.
const NO_SURFACES: SurfaceTable = [[0.0; MAX_LANES]; SURFACE_NUMBERS];

/// Surfaces spread over lanes, which a thread keeps from packet to packet. That of an object is kept at its number modulo [`KEPT`].
pub(super) struct SurfaceRows {
    kept: [SurfaceTable; KEPT],
    /// The objects whose surfaces are kept.
    objects: [Option<ObjectId>; KEPT],
    /// The surfaces of a packet that hits several objects.
    mixed: SurfaceTable,
}

impl SurfaceRows {
    /// None.
    pub const NONE: Self = Self {
        kept: [NO_SURFACES; KEPT],
        objects: [None; KEPT],
        mixed: NO_SURFACES,
    };

    /// Forgets all surfaces.
    pub fn clear(&mut self) {
        self.objects = [None; KEPT];
    }
}

/// The numbers of surfaces that shading needs, per lane.
pub(super) struct SurfaceLanes<'a, S: Isa> {
    simd: S,
    /// Of lanes that hit the background, any object's.
    table: &'a SurfaceTable,
    background: &'a SurfaceNumbers,
    is_background: M<S>,
}

impl<'a, S: Isa> SurfaceLanes<'a, S> {
    /// Looks up the objects of the active lanes. Most packets hit one object and perhaps the background; its surface is usually
    /// kept already. Otherwise the surfaces of all objects are mixed, lane by lane. What `memory` keeps has to be of this frame.
    #[inline(always)]
    pub fn look_up(
        simd: S,
        world: World<'a>,
        objects: U<S>,
        active: M<S>,
        memory: &'a mut SurfaceRows,
    ) -> Self {
        let background = ObjectId::new(world.background());
        let is_background = objects.simd_eq(U::<S>::splat(simd, background.lane()));
        let surfaces = |table| Self {
            simd,
            table,
            background: world.prepared.surface(background),
            is_background,
        };
        let mut rest = (active & !is_background).to_bitmask();
        let id = if rest == 0 {
            background
        } else {
            object_at(simd, objects, &mut rest).0
        };
        let first = world.surface(id);
        if rest == 0 {
            let table = &mut memory.kept[id.index() % KEPT];
            let kept = &mut memory.objects[id.index() % KEPT];
            if *kept != Some(id) {
                *kept = Some(id);
                spread(first, table);
            }
            return surfaces(table);
        }
        let mixed = &mut memory.mixed;
        let mut is_first = true;
        while rest != 0 {
            let (id, same) = object_at(simd, objects, &mut rest);
            let mask: U<S> = same.to_vector().bitcast();
            let new = world.surface(id);
            for ((row, &first), &new) in mixed.iter_mut().zip(first).zip(new) {
                // Not a selection: of that the compiler makes a masked store, which takes AMD's processors 20 cycles.
                let old: F<S> = if is_first {
                    splat(simd, first)
                } else {
                    load(simd, row)
                };
                let (old, new): (U<S>, U<S>) = (old.bitcast(), splat::<S>(simd, new).bitcast());
                let both: F<S> = (old ^ ((old ^ new) & mask)).bitcast();
                both.store_slice(&mut row[..lanes::<S>()]);
            }
            is_first = false;
        }
        surfaces(mixed)
    }

    /// The rows of numbers of what the lanes hit, by name.
    #[inline(always)]
    fn rows(&self) -> Surface<&PerLane> {
        Surface::from_numbers(self.table.each_ref())
    }

    /// The background's numbers, by name.
    #[inline(always)]
    fn behind(&self) -> Surface<f32> {
        Surface::from_numbers(*self.background)
    }

    #[inline(always)]
    fn number(&self, row: &PerLane) -> F<S> {
        load(self.simd, row)
    }

    #[inline(always)]
    fn vector(&self, [x, y, z]: [&PerLane; 3]) -> Vec3x<S> {
        Vec3x {
            x: self.number(x),
            y: self.number(y),
            z: self.number(z),
        }
    }

    #[inline(always)]
    pub fn centre(&self) -> Vec3x<S> {
        self.vector(self.rows().centre)
    }

    #[inline(always)]
    pub fn inverse_radius(&self) -> F<S> {
        self.number(self.rows().inverse_radius)
    }

    /// Which lanes hit something that lamps light: no lamp, and not the background.
    #[inline(always)]
    pub fn is_lit(&self) -> M<S> {
        let zero = splat(self.simd, 0.0);
        self.number(self.rows().is_lit).simd_gt(zero) & !self.is_background
    }

    /// Which lanes hit a lamp's own sphere.
    #[inline(always)]
    pub fn is_lamp(&self) -> M<S> {
        let zero = splat(self.simd, 0.0);
        !self.number(self.rows().is_lit).simd_gt(zero) & !self.is_background
    }

    #[inline(always)]
    pub fn emitted(&self) -> Vec3x<S> {
        let background = Vec3x::splat(self.simd, self.behind().emitted);
        let emitted = self.vector(self.rows().emitted);
        Vec3x::select(self.is_background, background, emitted)
    }

    #[inline(always)]
    pub fn diffuse(&self) -> Vec3x<S> {
        self.vector(self.rows().diffuse)
    }

    #[inline(always)]
    pub fn highlight(&self) -> Vec3x<S> {
        self.vector(self.rows().highlight)
    }

    #[inline(always)]
    pub fn ks(&self) -> F<S> {
        self.number(self.rows().ks)
    }

    #[inline(always)]
    pub fn exponent(&self) -> F<S> {
        self.number(self.rows().exponent)
    }

    #[inline(always)]
    pub fn highlight_start(&self) -> F<S> {
        self.number(self.rows().highlight_start)
    }

    #[inline(always)]
    pub fn kr(&self) -> F<S> {
        self.number(self.rows().kr)
    }

    #[inline(always)]
    pub fn fresnel(&self) -> F<S> {
        self.number(self.rows().fresnel)
    }

    #[inline(always)]
    pub fn kt(&self) -> F<S> {
        self.number(self.rows().kt)
    }

    #[inline(always)]
    pub fn index(&self) -> F<S> {
        self.number(self.rows().index)
    }
}

/// The object of the first lane in `rest`, and all lanes that hit it. These lanes are removed from `rest`.
#[inline(always)]
pub(super) fn object_at<S: Isa>(simd: S, objects: U<S>, rest: &mut u64) -> (ObjectId, M<S>) {
    let lane = rest.trailing_zeros() as usize % lanes::<S>();
    let number = objects.as_slice()[lane];
    let same = objects.simd_eq(U::<S>::splat(simd, number));
    *rest &= !same.to_bitmask();
    (ObjectId::new(number as usize), same)
}

/// A packet's lanes of a row.
#[inline(always)]
fn load<S: Isa>(simd: S, row: &PerLane) -> F<S> {
    F::<S>::from_slice(simd, &row[..lanes::<S>()])
}

/// Copies a surface to all lanes. Few packets need that, so it is compiled only once, not for each instruction set.
#[inline(never)]
fn spread(surface: &SurfaceNumbers, table: &mut SurfaceTable) {
    for (row, &number) in table.iter_mut().zip(surface) {
        *row = [number; MAX_LANES];
    }
}
