//! Tests for objects in direct view between the corners of a square.

use super::search::Search;
use super::squares::Squares;
use crate::coverage::corners;
use crate::lanes::*;
use crate::prepare::ObjectId;
use crate::trace::surface_points;

impl Search<'_> {
    /// Opens a square if too few corners show the object and no occluder hides it: all must show it
    /// if it is thin, otherwise one. Returns whether the square was opened.
    pub(super) fn look_for_object(&mut self, id: ObjectId, shown: u64, x: usize, y: usize) -> bool {
        let labels = self.squares.labels(x, y);
        let is_same = labels.simd_eq(labels[0]).all_true();
        let is_missed =
            shown < self.enough && !(shown == 0 && is_same && self.is_hidden(id, labels[0], x, y));
        if is_missed {
            self.open[y].set(x);
        }
        is_missed
    }

    /// Returns whether the object `back` is hidden in a square whose corners all have the label
    /// `front`.
    ///
    /// The occluder is convex, so the quadrilateral between its points at the corners is inside it.
    /// If the eye is outside, the pyramid from the eye to these points contains all that the square
    /// can show in front of the occluder. The object is hidden if a plane separates it from the
    /// pyramid.
    #[inline(never)]
    fn is_hidden(&self, back: ObjectId, front: u32, x: usize, y: usize) -> bool {
        let &Squares { world, coverage, .. } = self.squares;
        if front == 0 || front as usize > world.background() {
            return false;
        }
        let front = ObjectId::new(front as usize - 1);
        if coverage.has_less_power(front, back) {
            return true;
        }
        let points = || {
            let places = corners(self.squares.pixels(x, y));
            let (d, t) = surface_points(world, &world.object(front).0, places);
            [d.x * t, d.y * t, d.z * t, t]
        };
        let [front, back] = [front, back].map(|id| &coverage.objects[id.index()]);
        let eye = world.eye.extend(0.0);
        front.excludes(eye) && back.is_beyond(front, eye, points)
    }
}
