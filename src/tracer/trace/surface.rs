//! The surfaces that a packet hits.

use crate::lanes::*;
use crate::prepare::{
    ObjectId, Parameter, PerLane, SURFACE_NUMBERS, SurfaceNumbers, SurfaceTable, World,
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
            background: &world.prepared.surfaces[background.index()],
            is_background,
        };
        let mut rest = (active & !is_background).to_bitmask();
        let id = if rest == 0 {
            background
        } else {
            object_at(simd, objects, &mut rest).0
        };
        let first = &world.surfaces[id.index()];
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
            let new = &world.surfaces[id.index()];
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

    /// A parameter that is one number. Of lanes that hit the background it is of no meaning.
    #[inline(always)]
    pub fn number(&self, parameter: Parameter) -> F<S> {
        load(self.simd, &self.table[parameter as usize])
    }

    /// A parameter of three components.
    #[inline(always)]
    pub fn vector(&self, parameter: Parameter) -> Vec3x<S> {
        let [x, y, z] = [0, 1, 2].map(|i| load(self.simd, &self.table[parameter as usize + i]));
        Vec3x { x, y, z }
    }

    /// Which lanes hit something that lights light: no light, and not the background.
    #[inline(always)]
    pub fn is_lit(&self) -> M<S> {
        let zero = splat(self.simd, 0.0);
        self.number(Parameter::IsLit).simd_gt(zero) & !self.is_background
    }

    /// Which lanes hit a light's own sphere.
    #[inline(always)]
    pub fn is_light(&self) -> M<S> {
        let zero = splat(self.simd, 0.0);
        !self.number(Parameter::IsLit).simd_gt(zero) & !self.is_background
    }

    /// The light that they emit, the background included.
    #[inline(always)]
    pub fn emitted(&self) -> Vec3x<S> {
        let background = [0, 1, 2].map(|i| self.background[Parameter::Emitted as usize + i]);
        let background = Vec3x::splat(self.simd, background);
        Vec3x::select(
            self.is_background,
            background,
            self.vector(Parameter::Emitted),
        )
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
