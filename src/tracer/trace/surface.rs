use crate::lanes::*;
use crate::prepare::{ObjectId, Parameter, PerLane, SurfaceNumbers, SurfaceTable, World};

/// The number of cached surfaces, more than most tiles show. One takes 3 % more instructions in the
/// model scene.
const CACHED: usize = 16;

/// A thread's cache of surfaces spread over lanes, at the object's number modulo [`CACHED`].
pub(super) struct SurfaceRows {
    cached: [SurfaceTable; CACHED],
    objects: [Option<ObjectId>; CACHED],
    mixed: SurfaceTable,
}

zero! { SurfaceRows { cached, objects, mixed } }

impl SurfaceRows {
    pub fn clear(&mut self) {
        self.objects = [None; CACHED];
    }
}

pub(super) struct SurfaceLanes<'a, S: Isa> {
    simd: S,
    table: &'a SurfaceTable,
    background: &'a SurfaceNumbers,
    pub is_background: M<S>,
}

impl<'a, S: Isa> SurfaceLanes<'a, S> {
    /// Looks up the objects of the active lanes. Most packets hit one, usually cached; otherwise
    /// surfaces are mixed lane by lane. The cache must belong to this frame.
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
        let id = if rest == 0 { background } else { object_at(simd, objects, &mut rest).0 };
        let first = &world.surfaces[id.index()];
        if rest == 0 {
            let table = &mut memory.cached[id.index() % CACHED];
            let cached = &mut memory.objects[id.index() % CACHED];
            if *cached != Some(id) {
                *cached = Some(id);
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
                let old: F<S> = if is_first { splat(simd, first) } else { load(simd, row) };
                let (old, new): (U<S>, U<S>) = (old.bitcast(), splat::<S>(simd, new).bitcast());
                let both: F<S> = (old ^ ((old ^ new) & mask)).bitcast();
                both.store_slice(&mut row[..lanes::<S>()]);
            }
            is_first = false;
        }
        surfaces(mixed)
    }

    /// Returns a scalar parameter, undefined in lanes that hit the background.
    #[inline(always)]
    pub fn number(&self, parameter: Parameter) -> F<S> {
        load(self.simd, &self.table[parameter as usize])
    }

    #[inline(always)]
    pub fn vector(&self, parameter: Parameter) -> Vec3x<S> {
        let [x, y, z] = [0, 1, 2].map(|i| load(self.simd, &self.table[parameter as usize + i]));
        Vec3x { x, y, z }
    }

    #[inline(always)]
    pub fn is_lit(&self) -> M<S> {
        let zero = splat(self.simd, 0.0);
        self.number(Parameter::IsLit).simd_gt(zero) & !self.is_background
    }

    #[inline(always)]
    pub fn is_light(&self) -> M<S> {
        let zero = splat(self.simd, 0.0);
        !self.number(Parameter::IsLit).simd_gt(zero) & !self.is_background
    }

    #[inline(always)]
    pub fn emitted(&self) -> Vec3x<S> {
        let background = [0, 1, 2].map(|i| self.background[Parameter::Emitted as usize + i]);
        let background = Vec3x::splat(self.simd, background);
        Vec3x::select(self.is_background, background, self.vector(Parameter::Emitted))
    }
}

/// Returns the object of the first lane in `rest` and all lanes that hit it. Removes these from
/// `rest`.
#[inline(always)]
pub(super) fn object_at<S: Isa>(simd: S, objects: U<S>, rest: &mut u64) -> (ObjectId, M<S>) {
    let lane = rest.trailing_zeros() as usize % lanes::<S>();
    let number = objects.as_slice()[lane];
    let same = objects.simd_eq(U::<S>::splat(simd, number));
    *rest &= !same.to_bitmask();
    (ObjectId::new(number as usize), same)
}

#[inline(always)]
fn load<S: Isa>(simd: S, row: &PerLane) -> F<S> {
    F::<S>::from_slice(simd, &row[..lanes::<S>()])
}

/// Not inlined: rarely called.
#[inline(never)]
fn spread(surface: &SurfaceNumbers, table: &mut SurfaceTable) {
    for (row, &number) in table.iter_mut().zip(surface) {
        *row = [number; MAX_LANES];
    }
}
