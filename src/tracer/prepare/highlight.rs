//! The highlights that lamps leave on objects in the eye's own sight, as ellipses in the picture.
//!
//! A lobe of Phong's model is `ks (r.l)^h = ks (1 - d.d / 2)^h`, where d is the difference of the mirrored ray r and of the
//! direction l to the lamp. Where d is 0 the surface mirrors the lamp. About that place d is linear in the pixels x to the right
//! and y below, so the lobe is `ks e^-u` with `u = a x^2 + 2 b x y + c y^2`. Grooves, which make a lobe wider, are left out.

use super::object::{self, Object, ObjectId};
use super::{Axes, Prepared};
use crate::maths::sqrt;
use crate::scene::camera::pixels;
use crate::scene::{MAX_BLOCKS, MAX_LIGHTS, MAX_PLANES, MAX_SPHERES, Scene};
use crate::shapes::{Mirror, block, plane, sphere};
use core::array;
use glam::{Mat3A, Vec2, Vec3A, Vec4, Vec4Swizzles};

/// The most highlights: a lamp leaves one on a sphere and on a plane, and three on a box or a cylinder.
pub(crate) const MAX_HIGHLIGHTS: usize = MAX_LIGHTS * (MAX_SPHERES + 3 * MAX_BLOCKS + MAX_PLANES);

/// The side of the largest squares of the named qualities, in pixels.
const SQUARE: f32 = 8.0;

/// How much brighter than what is around it a highlight has to be for being missed, of 255: errors of that size are counted as
/// wrong pixels.
const VISIBLE: f32 = 8.0;

/// The decay u at which a highlight ends: `255 e^-u` is below [`VISIBLE`].
const REACH: f32 = 3.5;

/// The part of [`VISIBLE`] that may be missed, and that of a lobe's decay that is counted on: away from its middle a lobe is wider
/// than the Gaussian that is taken for it. With these, none of 5,115 highlights on spheres and planes was missed, where one was
/// without; rays of the model scene are 0.05 % more.
const SPARE: f32 = 0.6;
const COUNTED_DECAY: f32 = 0.75;

/// A highlight.
#[derive(Clone, Copy)]
pub(crate) struct Highlight {
    /// The object that shows it.
    pub object: ObjectId,
    /// Its middle, in pixels.
    middle: Vec2,
    /// Where it may be seen, in pixels: the least x and y, and the greatest, these two negative.
    bounds: Vec4,
    /// The decay a, b and c.
    decay: [f32; 3],
    /// How bright it is, of 255.
    strength: f32,
}

impl Highlight {
    /// All zeros.
    const ZERO: Self = Self {
        object: ObjectId::FIRST,
        middle: Vec2::ZERO,
        bounds: Vec4::ZERO,
        decay: [0.0; 3],
        strength: 0.0,
    };

    /// Whether it may be seen in a rectangle of the picture, in pixels.
    #[inline(always)]
    pub fn meets(&self, rect: Vec4) -> bool {
        self.bounds
            .cmple(rect.zwxy() * Vec4::new(1.0, 1.0, -1.0, -1.0))
            .all()
    }

    /// The least and the greatest of its pixels, from a place in the picture.
    pub fn ends(&self, from: [f32; 2]) -> [Vec2; 2] {
        let from = Vec2::from_array(from);
        [self.bounds.xy() - from, -self.bounds.zw() - from]
    }

    /// Whether no square of a side in pixels may show something that is visibly brighter than it is at its corners, if all of these
    /// show the object.
    ///
    /// The decay is least in the square's middle, on a side or at a corner: at a corner it is greater by as much as the quadratic
    /// form makes of half a side across and half a side down, at most.
    pub fn is_even(&self, side: usize) -> bool {
        let [a, b, c] = self.decay;
        let half = 0.5 * pixels(side);
        self.strength * (a + 2.0 * b.abs() + c) * half * half <= self.most(pixels(side))
    }

    /// How much brighter a square of some width may be than what its corners show.
    ///
    /// What is missed of a smaller square has fewer pixels, so it may be more, as for the tolerances of a quality; but never a third
    /// of what is there.
    fn most(&self, width: f32) -> f32 {
        SPARE * (VISIBLE * SQUARE / width).min(0.5 * self.strength)
    }

    /// Whether a square, given by its ends in pixels, may show something that is visibly brighter than it is at those corners that
    /// have a bit: upper left, upper right, lower left, lower right.
    #[inline(never)]
    pub fn is_missed(&self, rect: Vec4, corners: u64) -> bool {
        let [a, b, c] = self.decay;
        // Left, top, right and bottom.
        let rect = rect - Vec4::from((self.middle, self.middle));
        let u = |x: Vec4, y: Vec4| a * x * x + y * (2.0 * b * x + c * y);
        let unseen = array::from_fn(|i| [f32::INFINITY, 0.0][(corners >> i & 1) as usize]);
        let seen = (u(rect.xzxz(), rect.yyww()) + Vec4::from_array(unseen)).min_element();
        // It is brightest in its middle, or else somewhere on a side.
        let mut least = 0.0;
        if rect.xy().max(-rect.zw()).max_element() > 0.0 {
            // The left and the right side, then the upper and the lower one.
            let sides = rect.xzyw();
            let along = (-b * sides / Vec4::new(c, c, a, a))
                .max(rect.yyxx())
                .min(rect.wwzz());
            let x = Vec4::from((sides.xy(), along.zw()));
            let y = Vec4::from((along.xy(), sides.zw()));
            least = u(x, y).min_element();
        }
        // e^-u is at most 1 / (1 + u + u^2 / 2), and e^-u - e^-v at most min(1, v - u) e^-u.
        let most = self.most(rect.z - rect.x);
        self.strength * (seen - least).min(1.0) > most * (1.0 + least + 0.5 * least * least)
    }
}

/// The highlights of a frame.
pub(super) struct Highlights {
    list: [Highlight; MAX_HIGHLIGHTS],
    count: usize,
}

impl Highlights {
    /// None, all zeros.
    pub const NONE: Self = Self {
        list: [Highlight::ZERO; MAX_HIGHLIGHTS],
        count: 0,
    };
}

impl Prepared {
    /// The highlights.
    pub fn highlights(&self) -> &[Highlight] {
        &self.highlights.list[..self.highlights.count]
    }

    /// Prepares the highlights, after objects and lamps. Those that are seen from within a sphere or a cylinder are left out, and
    /// those on waves.
    pub(super) fn set_highlights(&mut self, scene: &Scene) {
        self.highlights.count = 0;
        for i in 0..self.background() {
            let (object, material) = object::of(scene, ObjectId::new(i));
            let centre = match object {
                Object::Sphere(sphere) => sphere.centre,
                Object::Block(block) => block.centre,
                Object::Plane(plane) => plane.centre,
                Object::Light(_) | Object::Background => continue,
            };
            if i == self.first_plane() && !scene.water.are_calm() {
                continue;
            }
            // Beyond the object's own bounds no corner shows it.
            let bounds = self.screen[i].in_pixels(&self.axes);
            // Those of several lamps may add up.
            let visible = VISIBLE / pixels(self.lamp_count);
            let tint = Vec3A::ONE.lerp(material.colour.into(), material.metallic);
            for lamp in &self.lamps[..self.lamp_count] {
                let colour = tint * lamp.colour * (material.ks * self.weight * 255.0);
                let strength = colour.max_element();
                if strength <= visible {
                    continue;
                }
                let [eye, lamp] =
                    [self.eye, lamp.position].map(|point| point - Vec3A::from(centre));
                // What of an object is nearest to the middle of a highlight beside it has most of that.
                let mut add = |mut place: Mirror| {
                    if let Object::Block(block) = object {
                        let (axes, half) = (Mat3A::from(block.axes), Vec3A::from(block.half));
                        place.p = axes * (axes.transpose() * place.p).clamp(-half, half);
                    }
                    let seen = place.seen(&self.axes, eye, lamp, 0.5 * material.exponent);
                    let highlight = Highlight {
                        object: ObjectId::new(i),
                        bounds: seen.bounds.max(bounds),
                        strength,
                        ..seen
                    };
                    // Not to be branched on: what is no number is kept out as well.
                    let count = &mut self.highlights.count;
                    self.highlights.list[*count % MAX_HIGHLIGHTS] = highlight;
                    *count += usize::from(highlight.is_small(visible));
                };
                match object {
                    Object::Sphere(it) => add(sphere::mirror(eye, lamp, it.radius)),
                    Object::Block(block) => block::mirrors(block, eye, lamp, add),
                    Object::Plane(_) | Object::Light(_) | Object::Background => {
                        add(plane::mirror(eye, lamp))
                    }
                }
            }
        }
    }
}

impl Highlight {
    /// Whether it is small enough to lie between corners: 4 pixels across and down from a corner u is 64 times the greater of a and
    /// c at most. However thin it is, it shows in many pixels if it goes through their middles.
    fn is_small(&self, visible: f32) -> bool {
        let [a, _, c] = self.decay;
        self.strength * a.max(c) * SQUARE * SQUARE > visible
    }
}

impl Mirror {
    /// The highlight there, in a picture with some axes; `eye` and `lamp` are from the object's centre, too. It is no number where
    /// the eye or the lamp does not see the place.
    fn seen(&self, axes: &Axes, eye: Vec3A, lamp: Vec3A, half_exponent: f32) -> Highlight {
        let &Self {
            p,
            n,
            curvature,
            axis,
        } = self;
        let (way, to_lamp) = (p - eye, lamp - p);
        let (distance, lamp_distance) = (way.length(), to_lamp.length());
        let (d, l) = (way / distance, to_lamp / lamp_distance);
        let [x, y, depth] = axes.rows.map(|row| row.dot(way));
        let facing = -d.dot(n);
        // How d - l changes from pixel to pixel, with the place on the surface.
        let [right, down] = [axes.rows[0], axes.rows[1]].map(|step| {
            let step = (step + d * (step.dot(n) / facing)) * (depth * axes.pixel);
            let turned = (step - axis * step.dot(axis)) * curvature;
            let ray = (step - d * d.dot(step)) / distance;
            let mirrored = ray - (n * (ray.dot(n) + d.dot(turned)) - turned * facing) * 2.0;
            mirrored + (step - l * l.dot(step)) / lamp_distance
        });
        let is_seen = depth.min(facing).min(l.dot(n)) > 0.0;
        let scale = if is_seen {
            COUNTED_DECAY * half_exponent
        } else {
            f32::NAN
        };
        let [a, b, c] =
            [(right, right), (right, down), (down, down)].map(|(v, w)| v.dot(w) * scale);
        // No more drawn out than rounding allows for.
        let scale = REACH / (a * c - b * b).max(a * c * 1e-6);
        let middle = axes.pixel_at(x / depth, y / depth);
        let reach = Vec2::new(sqrt(c * scale), sqrt(a * scale));
        Highlight {
            middle,
            bounds: Vec4::from((middle - reach, -middle - reach)),
            decay: [a, b, c],
            ..Highlight::ZERO
        }
    }
}
