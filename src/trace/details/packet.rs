//! A packet's rays in memory.

use crate::lanes::*;
use crate::scene::MAX_SOLIDS;
use crate::trace::intersect::Hit;
use crate::trace::stack::Rays;
use glam::Vec3A;

/// A number per lane, for the most lanes there are.
pub(crate) type Column = [f32; MAX_LANES];

/// A vector per lane.
pub(crate) struct Columns([Column; 3]);

/// Room for all solids, a power of two.
const CANDIDATES: usize = (MAX_SOLIDS + 1).next_power_of_two();

/// A packet's rays, and what becomes of them.
pub(crate) struct Packet {
    /// Boxes, cylinders and what else may be in the way of a ray.
    candidates: [u16; CANDIDATES],
    count: usize,
    /// Origin and direction of the rays.
    pub o: Columns,
    pub d: Columns,
    /// How far they go, and the object they hit, the bits of its number.
    pub t: Column,
    pub object: Column,
    /// Where a box or a cylinder is hit, a slack away from it on the ray's side, and its normal, outward.
    pub p: Columns,
    pub n: Columns,
    /// How far from the surface rays start; 0 where it is no box and no cylinder.
    pub slack: Column,
    /// What a pattern leaves of the colour.
    pub left: Column,
    /// The share of the light that comes through the air, and what lies behind.
    pub through: Column,
    pub behind: Columns,
    /// What passes of a lamp, as a colour.
    pub passing: Columns,
}

impl Packet {
    pub const NONE: Self = Self {
        candidates: [0; CANDIDATES],
        count: 0,
        o: Columns::NONE,
        d: Columns::NONE,
        t: [0.0; MAX_LANES],
        object: [0.0; MAX_LANES],
        p: Columns::NONE,
        n: Columns::NONE,
        slack: [0.0; MAX_LANES],
        left: [0.0; MAX_LANES],
        through: [0.0; MAX_LANES],
        behind: Columns::NONE,
        passing: Columns::NONE,
    };

    /// Forgets the candidates.
    #[inline(always)]
    pub fn clear(&mut self) {
        self.count = 0;
    }

    /// Adds the solid number `i` to the candidates.
    #[inline(always)]
    pub fn push(&mut self, i: u16) {
        self.candidates[self.count % CANDIDATES] = i;
        self.count += 1;
    }

    /// The candidates.
    pub fn candidates(&self) -> &[u16] {
        &self.candidates[..self.count % CANDIDATES]
    }

    /// Takes rays in.
    #[inline(always)]
    pub fn set<S: Isa>(&mut self, o: Vec3x<S>, d: Vec3x<S>, t: F<S>) {
        self.o.store(o);
        self.d.store(d);
        store::<S>(t, &mut self.t);
    }

    /// Takes rays and their hits in.
    #[inline(always)]
    pub fn set_hits<S: Isa>(&mut self, rays: &Rays<S>, hit: &Hit<S>) {
        self.set(rays.o, rays.d, hit.t);
        store::<S>(hit.object.bitcast(), &mut self.object);
    }

    /// The hits.
    #[inline(always)]
    pub fn hits<S: Isa>(&self, simd: S) -> Hit<S> {
        Hit {
            t: load(simd, &self.t),
            object: load(simd, &self.object).bitcast(),
        }
    }
}

impl Columns {
    const NONE: Self = Self([[0.0; MAX_LANES]; 3]);

    /// The lanes.
    #[inline(always)]
    pub fn load<S: Isa>(&self, simd: S) -> Vec3x<S> {
        self.load_from(simd, 0)
    }

    /// As many lanes as there are, from number `place` on.
    #[inline(always)]
    pub fn load_from<S: Isa>(&self, simd: S, place: usize) -> Vec3x<S> {
        let [x, y, z] = &self.0;
        Vec3x {
            x: load(simd, &x[place..]),
            y: load(simd, &y[place..]),
            z: load(simd, &z[place..]),
        }
    }

    /// Puts lanes.
    #[inline(always)]
    pub fn store<S: Isa>(&mut self, v: Vec3x<S>) {
        self.store_from(v, 0);
    }

    /// Puts lanes from number `place` on.
    #[inline(always)]
    pub fn store_from<S: Isa>(&mut self, v: Vec3x<S>, place: usize) {
        let [x, y, z] = &mut self.0;
        store::<S>(v.x, &mut x[place..]);
        store::<S>(v.y, &mut y[place..]);
        store::<S>(v.z, &mut z[place..]);
    }

    /// A lane's vector.
    #[inline(never)]
    pub fn at(&self, lane: usize) -> Vec3A {
        let [x, y, z] = &self.0;
        Vec3A::new(x[lane], y[lane], z[lane])
    }

    /// Puts a lane's vector.
    #[inline(never)]
    pub fn put(&mut self, lane: usize, v: Vec3A) {
        let [x, y, z] = &mut self.0;
        (x[lane], y[lane], z[lane]) = v.into();
    }
}

/// The lanes.
#[inline(always)]
pub(crate) fn load<S: Isa>(simd: S, column: &[f32]) -> F<S> {
    F::<S>::from_slice(simd, &column[..lanes::<S>()])
}

/// Puts lanes.
#[inline(always)]
pub(crate) fn store<S: Isa>(numbers: F<S>, column: &mut [f32]) {
    numbers.store_slice(&mut column[..lanes::<S>()]);
}
