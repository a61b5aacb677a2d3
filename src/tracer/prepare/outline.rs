//! Outlines: what objects cover of the picture, and what they hide, so that no square is filled over something unseen.

use super::cone::{Cone, ROUNDING, RoundCone};
use super::screen::{Axes, Rects, ScreenBounds};
use super::{BvhNode, MAX_IMAGES, ObjectId, Prepared, World};
use crate::lanes::*;
use crate::maths::sqrt;
use crate::scene::Block;
use crate::shapes::block::Silhouette;
use crate::shapes::plane::Rectangle;
use crate::shapes::sphere::{HIT_ERROR, hit_error};
use glam::{Mat3A, Vec3A, Vec3Swizzles, Vec4};

/// An object's outline.
#[derive(Clone, Copy)]
pub(crate) struct Outline {
    sides: Sides,
    /// Bounds of a sphere's power of the eye, distance squared minus radius squared: of two spheres the one with the smaller power
    /// is in front wherever both are, since the plane of equal powers parts what can be seen of them (Aurenhammer: Power
    /// Diagrams, SIAM Journal on Computing, 1987). Infinite around the eye, and not a number where that is not sure, and of
    /// what is no sphere.
    power: [f32; 2],
    /// Where it begins and ends along the scene's axes, and forward from the eye.
    ///
    /// Along the axes these are the scene's own numbers, where they are exact: what stands on something, or rises out of it by
    /// the last digit of its height, does so here.
    least: Vec4,
    most: Vec4,
}

/// How far a block's corner may be from where the eye sees it, as a share of its distance and size: what axes may be off, by
/// [`Scene::validate`](crate::scene::Scene::validate), which is far more than rounding, and a tenth of a pixel.
const CORNER: f32 = 2e-4;

/// The same from a lamp, which may be a thousand times as far away: two roundings.
const CORNER_BY_LAMP: f32 = 1e-7;

/// The part of [`ROUNDING`] that is usual: some 5 roundings. That is enough for shadows that are not exact by more, and leaves something
/// of those by lamps that are a thousand times as far away.
const USUAL: f32 = 0.03;

/// More than rounding moves a hit towards the eye, as a share of how far the object reaches from it.
const CONTACT: f32 = 1e-6;

/// An eye as near to a sphere as so many times its slack, below which hits are none, is neither outside nor inside for
/// sure.
const TOUCHING: f32 = 4.0;

impl Outline {
    pub const NONE: Self = Self {
        sides: Sides::NONE,
        power: [0.0; 2],
        least: Vec4::ZERO,
        most: Vec4::ZERO,
    };

    /// Takes in a sphere, `to` from the eye, and returns where it can be seen.
    pub fn set_sphere(&mut self, axes: &Axes, to: Vec3A, ball: &BvhNode) -> ScreenBounds {
        let radius = ball.radius;
        let distance2 = to.length_squared();
        let distance = sqrt(distance2);
        let power = distance2 - radius * radius;
        let is_sure = (distance - radius).abs() > TOUCHING * ball.hit_error;
        let power = if ball.is_block || !is_sure {
            f32::NAN
        } else if power < 0.0 {
            f32::INFINITY
        } else {
            power
        };
        let unsure = HIT_ERROR * (distance2 + radius * radius);
        self.power = [power - unsure, power + unsure];
        self.set_extent(axes, to, ball.centre, Vec4::splat(radius));
        let cone = RoundCone::around(to, radius + ball.hit_error);
        self.sides = Sides::of_ball(&axes.rows, &cone, ball.hit_error);
        cone.bounds(&axes.rows, axes.pixel)
    }

    /// Takes in the block that the sphere is around, `to` from the eye.
    pub fn set_block(&mut self, axes: &Axes, to: Vec3A, block: &Block) {
        self.sides = Sides::of_block(&axes.rows, to, block, CORNER);
        let inward = Mat3A::from(block.axes).transpose();
        let half = Vec3A::from(block.half);
        let forward = inward * axes.rows[2];
        let own = [inward.x_axis, inward.y_axis, inward.z_axis, forward];
        let extent = own.map(|axis| {
            // Exact along an axis of its own, and larger by what axes may be off elsewhere.
            let tilt = (axis.abs().element_sum() - 1.0).abs();
            axis.abs().dot(half) + CORNER.min(4.0 * tilt) * half.element_sum()
        });
        self.set_extent(axes, to, block.centre.into(), Vec4::from(extent));
    }

    /// Takes in how far it reaches from its centre, `to` from the eye, along the scene's axes and forward.
    fn set_extent(&mut self, axes: &Axes, to: Vec3A, centre: Vec3A, extent: Vec4) {
        let centre = centre.extend(to.dot(axes.rows[2]));
        self.least = centre - extent;
        self.most = centre + extent;
    }

    /// See [`hit_error`].
    #[inline(never)]
    pub fn hit_error(&self) -> f32 {
        let reach = self.least.abs().max(self.most.abs());
        hit_error(Vec3A::from_vec4(reach), 0.0)
    }

    /// Whether its extent is finite.
    #[inline(always)]
    pub fn is_finite(&self) -> bool {
        self.most.is_finite()
    }

    /// Whether a plane across an axis has the eye and this object on one side, and another one on the other: then this one is in
    /// front wherever both are.
    ///
    /// The other has to be beyond by what rounding does to hits, but for a solid seen from outside, which is in front of what it
    /// stands on by its own height.
    #[inline(never)]
    fn is_before(&self, other: &Self, eye: Vec4) -> bool {
        let is_solid = self.least.y < self.most.y && self.is_beside(eye);
        let lanes = if is_solid { Vec4::W } else { Vec4::ONE };
        let [far, near] = [other.least, other.most].map(|end| (end - eye).abs() + end.abs());
        let slack = (far + near) * lanes * CONTACT;
        let below = self.most.max(eye).cmple(other.least - slack);
        let above = self.least.min(eye).cmpge(other.most + slack);
        (below | above).any()
    }

    /// Whether a point is outside of it for sure.
    fn is_beside(&self, point: Vec4) -> bool {
        let is_beside = self.least.cmpgt(point) | self.most.cmplt(point);
        is_beside.bitmask() & 0b111 != 0
    }

    /// Takes in a horizontal rectangle.
    pub fn set_rectangle(&mut self, axes: &Axes, eye: Vec3A, plane: &Rectangle) {
        self.sides = Sides::NONE;
        self.sides.cone.set_flat(axes, eye, plane);
        self.power = [f32::NAN; 2];
        // Forward it is nowhere before or behind anything.
        let extent = Vec4::new(plane.half_x, 0.0, plane.half_z, 1e30);
        self.set_extent(axes, plane.centre - eye, plane.centre, extent);
    }
}

/// The rays that meet an object, from the eye or a lamp.
#[derive(Clone, Copy)]
pub(super) struct Sides {
    /// The rays that meet it, all of them where their origin is inside, or nearly.
    cone: Cone,
    /// More of the sides of a box or a cylinder: the rays between those that `cone` has no room for.
    ends: Cone,
    /// How much of it may not show what has it: for a sphere the share of its sine, see [`RoundCone::unsure`], and for a block, whose
    /// sides are wider by [`CORNER`], the sine of an angle.
    unsure: f32,
}

impl Sides {
    const NONE: Self = Self {
        cone: Cone::NONE,
        ends: Cone::NONE,
        unsure: 0.0,
    };

    /// The sides of a sphere around which a cone is, as the picture's rays see it that are given (see [`RoundCone::seen_by`]).
    fn of_ball(rays: &[Vec3A; 3], cone: &RoundCone, hit_error: f32) -> Self {
        Self {
            cone: cone.seen_by(rays),
            ends: Cone::NONE,
            unsure: cone.unsure(hit_error),
        }
    }

    /// The sides of a block, `to` from the eye or a lamp: the planes through that and an edge that have all of it on one side, two for
    /// each of its axes, at most. They leave room for [`CORNER`], or what is given for it.
    #[inline(never)]
    fn of_block(rays: &[Vec3A; 3], to: Vec3A, block: &Block, corner: f32) -> Self {
        let inward = Mat3A::from(block.axes).transpose();
        let half = Vec3A::from(block.half);
        let slack = corner * (to.abs() + half).element_sum() + hit_error(block.centre.into(), 0.0);
        let silhouette = Silhouette::new(block.shape, inward * to, half + slack);
        let has_none = silhouette.has_none;
        let mut unsure = 0.0_f32;
        let [cone, ends] = [1.0, -1.0].map(|way| {
            let [x, y] = silhouette.ends(way);
            let scale = Vec3A::select(has_none, Vec3A::ZERO, way / (x.abs() + y.abs()));
            // The root of 3 is for the length of rays, and those of 2 because the scale has a sum for the distance of an edge, and
            // because a lamp's rays are longer than the eye's.
            unsure = unsure.max(3.5 * slack * scale.abs().max_element());
            let mut terms = rays.map(|ray| {
                let ray = inward * ray;
                let side = (ray.zxy() * x - ray.yzx() * y) * scale;
                // Not a number within a cylinder.
                Vec3A::select(has_none, Vec3A::ZERO, side).extend(0.0)
            });
            // What is no side has all rays on its inner side.
            terms[2] += Vec3A::select(has_none, Vec3A::ONE, Vec3A::ZERO).extend(1.0);
            Cone {
                terms,
                is_flat: true,
            }
        });
        Self { cone, ends, unsure }
    }
}

/// An outline, as a part of the picture is held against it.
pub(crate) struct SeenOutline {
    /// The object that shows it: of a shadow its plane, and of an image the first one.
    pub shown_by: ObjectId,
    /// Where its object is seen from: of a shadow the lamp, otherwise the eye.
    pub seen_from: Vec3A,
    bounds: ScreenBounds,
    sides: Sides,
    /// The most that rounding may add to a side's inequality.
    rounding: f32,
    /// How far inside of all sides points are for sure.
    margin: f32,
}

impl SeenOutline {
    /// The least and the greatest u in rectangles of the picture that may show it; the least beyond the greatest where none
    /// may.
    #[inline(always)]
    pub fn narrow<S: Isa>(&self, mut rects: Rects<S>) -> [F<S>; 2] {
        self.bounds.narrow(&mut rects);
        self.sides.cone.narrow(&mut rects, -self.rounding);
        if self.sides.ends.is_flat {
            self.sides.ends.narrow(&mut rects, -self.rounding);
        }
        [rects.left, rects.right]
    }

    /// Whether points of the picture are inside for sure.
    #[inline(always)]
    pub fn contains<S: Isa>(&self, [u, v]: [F<S>; 2]) -> M<S> {
        let Sides { cone, ends, unsure } = &self.sides;
        let mut depth = cone.depth::<S>(u, v, 1.0 - unsure);
        if ends.is_flat {
            depth = depth.min(ends.depth::<S>(u, v, 1.0));
        }
        depth.simd_ge(splat(u.token(), self.margin))
    }
}

impl World<'_> {
    /// The outline of a number.
    #[inline(never)]
    pub fn outline(self, number: usize) -> SeenOutline {
        let (mut object, mut plane, mut seen_from) = (number, 0, self.eye);
        let mut rounding = ROUNDING * self.axes.reach;
        // Those of a shadow, whose number may be beyond all images', replace what is taken here.
        let mut sides = self.outlines[number % MAX_IMAGES].sides;
        if number >= self.first_shadow {
            let shadow = self.shadow(number);
            (object, plane, seen_from) = (shadow.object, shadow.plane, shadow.lamp);
            let rays = &shadow.seen.rays;
            let block = object.wrapping_sub(self.scene.spheres.len());
            sides = match self.scene.blocks.get(block) {
                Some(block) => {
                    let to = Vec3A::from(block.centre) - seen_from;
                    Sides::of_block(rays, to, block, CORNER_BY_LAMP)
                }
                None => Sides::of_ball(rays, shadow.cone, self.outlines[object].hit_error()),
            };
            if !shadow.is_sharp {
                rounding *= USUAL;
            }
        }
        let mut margin = rounding;
        if sides.ends.is_flat {
            margin += sides.unsure * self.axes.reach;
        }
        let mut seen = SeenOutline {
            shown_by: ObjectId::new(number),
            seen_from,
            bounds: self.screen[number],
            sides,
            rounding,
            margin,
        };
        // What a plane cuts has rays in its outline that only its part beyond would meet.
        if number > self.background() {
            seen.shown_by = ObjectId::new(self.first_plane() + plane);
            let [least, most] = self.heights(object, plane, seen_from);
            if least < 0.0 {
                seen.margin = f32::INFINITY;
            }
            if most < 0.0 {
                seen.bounds = ScreenBounds::NONE;
            }
        }
        seen
    }
}

impl Prepared {
    /// How far an object, which casts a shadow on a plane or has an image in it, reaches from the plane towards the viewer, least and
    /// most, and a bound on rounding more. The viewer is the shadow's lamp or, of an image, the eye.
    fn heights(&self, object: usize, plane: usize, viewer: Vec3A) -> [f32; 2] {
        let (object, height) = (&self.outlines[object], self.planes[plane].centre.y);
        let error = object.hit_error();
        let [least, most] = [object.least.y - height, object.most.y - height];
        if viewer.y > height {
            [least + error, most + error]
        } else {
            [error - most, error - least]
        }
    }

    /// Whether a patch whose corners all see the object `front` cannot see the object `back` anywhere.
    ///
    /// Objects are convex: between what the corners see of it, it is nowhere farther away than that.
    pub fn occludes(&self, front: ObjectId, back: ObjectId) -> bool {
        let (f, b) = (&self.outlines[front.index()], &self.outlines[back.index()]);
        front.index() < self.background()
            && (f.is_before(b, self.eye.extend(0.0)) || f.power[1] < b.power[0])
    }

    /// Whether a plane, `back`, leaves on the eye's side of it a convex part of an object, which the eye is not in.
    pub fn may_part(&self, front: ObjectId, back: ObjectId) -> bool {
        let front = &self.outlines[front.index()];
        back.index() >= self.first_plane() && front.is_beside(self.eye.extend(0.0))
    }
}
