//! The plane of a point, a sphere's centre and a lamp, in which lie the ways of light from the lamp to the point by way of the sphere:
//! one angle is to be found. By a cylinder's side it is the same in its cross-section; along its axis such a way is straight.

use eightfold_oracle::geometry::Round;
use eightfold_tracer::glam::{DVec2, DVec3, dvec2};
use std::f64::consts::FRAC_PI_2;

/// Parts of a sphere, seen from a point, in each of which a way of light is looked for: between two of its ends there are at most
/// two, of which the turn of the offset tells.
const PARTS: usize = 16;
/// The most steps to a root: as many as f64 has digits.
const STEPS: usize = 52;
/// The least distance of a lamp from the axis from a point to a sphere's centre, relative to that from the centre: on the axis all
/// planes are the same.
const LEAST_OFF: f64 = 1e-7;

/// The plane of a point, a sphere's centre and a lamp. Its origin is the sphere's centre; the point is at (-`distance`, 0).
pub struct Plan {
    distance: f64,
    radius: f64,
    /// The refractive index of the sphere; `None` if it mirrors.
    index: Option<f64>,
    lamp: DVec2,
    axes: [DVec3; 2],
    /// The axis of a cylinder, and how far the lamp is along that from the point.
    rise: Option<(DVec3, f64)>,
}

/// The ray at an angle of incidence, by which it is looked for, and what changes with it.
struct Candidate {
    /// The sine of the angle of incidence.
    sine: f64,
    /// The direction of the ray at the point, and the derivative of its angle.
    seen: DVec2,
    seen_turns: f64,
    /// The direction in which it leaves the sphere.
    leaving: DVec2,
    /// The signed distance at which it passes the lamp, and its derivative.
    offset: [f64; 2],
}

impl Plan {
    /// For a point `p` and a lamp at `o`; `None` if one of them is within. Cylinders mirror, and have no `index`.
    pub fn new(p: DVec3, o: DVec3, round: &Round, index: Option<f64>) -> Option<Self> {
        let radius = round.radius;
        let axis = round.axis.unwrap_or_default();
        let [p, o, way] = [p - round.centre, o - round.centre, o - p];
        let [p, o] = [p, o].map(|it| it - it.dot(axis) * axis);
        let rise = round.axis.map(|axis| (axis, way.dot(axis)));
        let (distance, outside) = (p.length(), radius * (1.0 + 1e-9));
        if distance <= outside || o.length() <= outside {
            return None;
        }
        let axis = -p / distance;
        let along = o.dot(axis);
        let off = o - along * axis;
        let least = LEAST_OFF * o.length();
        let across = off.normalize_or(axis.any_orthonormal_vector());
        Some(Self {
            distance,
            radius,
            index,
            lamp: dvec2(along, off.length().max(least)),
            axes: [axis, across],
            rise,
        })
    }

    /// Up to which sine of the angle of incidence light goes this way.
    fn most(&self) -> f64 {
        self.index.map_or(1.0, |index| index.min(1.0))
    }

    /// The ray in the direction `d`, as [`Plan::candidate`] takes it.
    pub fn at(&self, d: DVec3) -> f64 {
        let sine = d.dot(self.axes[1]) * self.distance / self.radius;
        (sine / self.most()).clamp(-1.0, 1.0).asin()
    }

    /// The ray whose angle of incidence is `at`, or has `at` for the angle behind the surface if that is larger.
    fn candidate(&self, at: f64) -> Candidate {
        let (y, x) = at.sin_cos();
        let sine = [self.most() * y, self.most() * x];
        // A direction at the angle whose sine is that times a factor, and the derivative of the angle.
        let angle = |factor: f64| {
            let sine = [factor * sine[0], factor * sine[1]];
            let cosine = (1.0 - sine[0] * sine[0]).max(0.0).sqrt();
            (dvec2(cosine, sine[0]), sine[1] / cosine)
        };
        let (seen, seen_turns) = angle(self.radius / self.distance);
        let (incident, incident_turns) = angle(1.0);
        let back = dvec2(incident.x, -incident.y);
        let (turned, turns) = match self.index {
            None => (-back.rotate(back), -2.0 * incident_turns),
            Some(index) => {
                let (refracted, refracted_turns) = angle(1.0 / index);
                let bent = refracted.rotate(back);
                (bent.rotate(bent), 2.0 * (refracted_turns - incident_turns))
            }
        };
        let leaving = seen.rotate(turned);
        // A sphere keeps the distance at which a ray passes its centre.
        let offset = [
            self.lamp.perp_dot(leaving) + self.radius * sine[0],
            self.lamp.dot(leaving) * (seen_turns + turns) + self.radius * sine[1],
        ];
        Candidate {
            sine: sine[0],
            seen,
            seen_turns,
            leaving,
            offset,
        }
    }

    /// Where the offset is 0.
    pub fn roots(&self) -> Vec<f64> {
        // Just short of the rays that touch the sphere.
        let most = FRAC_PI_2 * (1.0 - 1e-6);
        let at = |i: usize| most * (2.0 * i as f64 / PARTS as f64 - 1.0);
        let offset = |at: f64| self.candidate(at).offset;
        // Its derivative, by which it is halved.
        let turn = |at: f64| [self.candidate(at).offset[1], 0.0];
        let mut roots = Vec::new();
        let mut from = (at(0), self.candidate(at(0)).offset);
        for i in 1..=PARTS {
            let to = (at(i), self.candidate(at(i)).offset);
            let ([a, a_turn], [b, b_turn]) = (from.1, to.1);
            if a * b < 0.0 {
                roots.push(zero(from.0, to.0, offset));
            } else if a * a_turn < 0.0 && b * b_turn > 0.0 {
                // It comes nearer to 0 and goes away again: there may be two in between.
                let nearest = zero(from.0, to.0, turn);
                if a * offset(nearest)[0] < 0.0 {
                    roots.push(zero(from.0, nearest, offset));
                    roots.push(zero(nearest, to.0, offset));
                }
            }
            from = to;
        }
        roots
    }

    /// The direction of a root, and the solid angle per area at the lamp; `None` if the lamp is not ahead.
    pub fn way(&self, at: f64) -> Option<(DVec3, f64)> {
        let found = self.candidate(at);
        let leaves_at = self.radius * (1.0 - found.sine * found.sine).sqrt();
        if self.lamp.dot(found.leaving) <= leaves_at {
            return None;
        }
        let d = found.seen.x * self.axes[0] + found.seen.y * self.axes[1];
        // Within the plane, and by turning it about its axis or, by a cylinder, by tilting the way along that.
        let within = found.seen_turns / found.offset[1];
        let (d, across) = match self.rise {
            None => (d, found.seen.y / self.lamp.y),
            Some((axis, rise)) => {
                let seen_at = self.distance * found.seen.x - leaves_at;
                let flat = seen_at + self.lamp.dot(found.leaving) - leaves_at;
                (d + rise / flat * axis, flat / (flat * flat + rise * rise))
            }
        };
        let spread = (within * across).abs();
        spread.is_finite().then_some((d.normalize(), spread))
    }
}

/// Where a function, given with its derivative, changes its sign, which it does between `from` and `to`: by Newton's steps, and by
/// halving where these lead out.
fn zero(mut from: f64, mut to: f64, of: impl Fn(f64) -> [f64; 2]) -> f64 {
    let is_negative = of(from)[0] < 0.0;
    let mut at = 0.5 * (from + to);
    for _ in 0..STEPS {
        let [value, slope] = of(at);
        if (value < 0.0) == is_negative {
            from = at;
        } else {
            to = at;
        }
        let next = at - value / slope;
        let is_between = (next - from) * (next - to) < 0.0;
        let next = if is_between { next } else { 0.5 * (from + to) };
        if (next - at).abs() < f64::EPSILON {
            return next;
        }
        at = next;
    }
    at
}
