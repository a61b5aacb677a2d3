//! A packet's rays in memory.

use crate::lanes::*;
use crate::scene::MAX_SOLIDS;
use crate::trace::intersect::Hit;
use crate::trace::stack::Rays;
use glam::{Vec3A, Vec4};

/// A number per lane, for the most lanes there are.
pub(crate) type Column = [f32; MAX_LANES];

/// A vector per lane.
pub(crate) struct Columns([Column; 3]);

/// What a closer look finds:
///
/// - where a box or a cylinder is hit, a slack away from it on the ray's side, and its normal, outward;
/// - how far from the surface rays start; 0 where it is no box and no cylinder;
/// - the share of the light that comes through the air;
/// - what a pattern leaves of the colour.
pub(crate) type Closer<T> = [T; 9];
const SLACK: usize = 6;
const THROUGH: usize = 7;
pub(super) const LEFT: usize = 8;

/// Room for all solids, a power of two.
const CANDIDATES: usize = (MAX_SOLIDS + 1).next_power_of_two();

/// What may be in the way of rays: a solid's number, and below it 16 bits, one for each lane whose ray may meet it. The
/// others do not, whatever is found: what a lane meets does not depend on whom it travels with.
#[derive(Clone, Copy)]
pub(crate) struct Candidate(u32);

impl Candidate {
    /// The solid's number.
    #[inline(always)]
    pub fn number(self) -> usize {
        (self.0 >> 16) as usize
    }

    /// Of as many lanes as there are, from number `place` on, those whose rays may meet it.
    #[inline(always)]
    pub fn lanes<S: Isa>(self, simd: S, place: usize) -> M<S> {
        M::<S>::from_bitmask(simd, u64::from(self.0 >> place))
    }
}

/// A packet's rays, and what becomes of them.
pub(crate) struct Packet {
    /// Boxes, cylinders and what else may be in the way of a ray.
    candidates: [Candidate; CANDIDATES],
    count: usize,
    /// Origin and direction of the rays.
    pub o: Columns,
    pub d: Columns,
    /// How far they go, and the object they hit, the bits of its number.
    pub t: Column,
    pub object: Column,
    /// What that looks like, and what lies behind.
    pub closer: Closer<Column>,
    /// The light that the surface's own colour sends back, before a pattern takes of it.
    pub full: Columns,
    pub behind: Columns,
    /// What passes of a lamp, as a colour.
    pub passing: Columns,
}

impl Packet {
    pub const NONE: Self = Self {
        candidates: [Candidate(0); CANDIDATES],
        count: 0,
        o: Columns::NONE,
        d: Columns::NONE,
        t: [0.0; MAX_LANES],
        object: [0.0; MAX_LANES],
        closer: [[0.0; MAX_LANES]; 9],
        full: Columns::NONE,
        behind: Columns::NONE,
        passing: Columns::NONE,
    };

    /// Forgets the candidates.
    #[inline(always)]
    pub fn clear(&mut self) {
        self.count = 0;
    }

    /// Adds the solid number `i` to the candidates of some lanes.
    #[inline(always)]
    pub fn push<S: Isa>(&mut self, i: u16, lanes: M<S>) {
        self.candidates[self.count % CANDIDATES] =
            Candidate(u32::from(i) << 16 | lanes.to_bitmask() as u32);
        self.count += 1;
    }

    /// Whether there are no candidates.
    #[inline(always)]
    pub fn is_empty(&self) -> bool {
        self.count == 0
    }

    /// The candidates.
    pub fn candidates(&self) -> &[Candidate] {
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

    /// See [`Closer`].
    #[inline(always)]
    fn number<S: Isa>(&self, simd: S, i: usize) -> F<S> {
        load(simd, &self.closer[i])
    }

    #[inline(always)]
    fn vector<S: Isa>(&self, simd: S, i: usize) -> Vec3x<S> {
        Vec3x {
            x: self.number(simd, i),
            y: self.number(simd, i + 1),
            z: self.number(simd, i + 2),
        }
    }

    #[inline(always)]
    pub fn p<S: Isa>(&self, simd: S) -> Vec3x<S> {
        self.vector(simd, 0)
    }

    #[inline(always)]
    pub fn n<S: Isa>(&self, simd: S) -> Vec3x<S> {
        self.vector(simd, 3)
    }

    #[inline(always)]
    pub fn slack<S: Isa>(&self, simd: S) -> F<S> {
        self.number(simd, SLACK)
    }

    #[inline(always)]
    pub fn left<S: Isa>(&self, simd: S) -> F<S> {
        self.number(simd, LEFT)
    }

    #[inline(always)]
    pub fn through<S: Isa>(&self, simd: S) -> F<S> {
        self.number(simd, THROUGH)
    }

    /// What a pattern leaves a share of in a lane, blue, green and red, of rays of a weight, and that share.
    pub fn patterned(&self, lane: usize, weight: f32) -> Vec4 {
        let [red, green, blue] = &self.full.0;
        let weight = weight * self.closer[THROUGH][lane];
        let full = Vec3A::new(blue[lane], green[lane], red[lane]) * weight;
        full.extend(self.closer[LEFT][lane])
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
}

/// The lanes.
#[inline(always)]
pub(super) fn load<S: Isa>(simd: S, column: &[f32]) -> F<S> {
    F::<S>::from_slice(simd, &column[..lanes::<S>()])
}

/// Puts lanes.
#[inline(always)]
pub(super) fn store<S: Isa>(numbers: F<S>, column: &mut [f32]) {
    numbers.store_slice(&mut column[..lanes::<S>()]);
}
