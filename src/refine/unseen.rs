//! Objects, and shadows on planes, that may be seen between the corners of squares.

use crate::prepare::{GroupSet, OUTLINES, Outline, Prepared, ROUNDING, Rect};
use crate::trace::Sample;
use core::ops::Range;
use glam::{Vec2Swizzles, Vec4, vec2};

/// The objects and shadows that a part of the picture may show, by the numbers of their outlines.
pub(crate) struct Unseen {
    outlines: [u16; OUTLINES],
    count: usize,
}

impl Unseen {
    pub const fn new() -> Self {
        Self {
            outlines: [0; OUTLINES],
            count: 0,
        }
    }

    /// Lists what the rectangle with these corners may show, in pixels; the spheres are in `groups`.
    #[inline(never)]
    pub fn set(&mut self, scene: &Prepared, groups: GroupSet, rectangle: Vec4) {
        let rect = scene.axes.rect(rectangle);
        self.count = 0;
        let mut i = scene.tree.start(groups);
        while let Some(node) = scene.tree.nodes().get(i) {
            let is_met = node.groups & groups != 0;
            if is_met && !node.is_bound {
                let number = node.number as usize;
                self.add(scene, number..number + 1, &rect);
            }
            i += node.step(is_met);
        }
        self.add(scene, scene.first_plane()..scene.outlined, &rect);
    }

    /// Lists those of some outlines that a rectangle may show.
    #[inline(never)]
    fn add(&mut self, scene: &Prepared, outlines: Range<usize>, rect: &Rect) {
        for outline in outlines {
            if scene.may_show(outline, rect) {
                self.outlines[self.count % OUTLINES] = outline as u16;
                self.count += 1;
            }
        }
    }

    /// Whether a square, its sides included, may show an object or a shadow that none of some samples shows. They are in two
    /// rows of two or three of three from corner to corner; the first one is a pixel of the picture, and all where
    /// `is_inside`.
    #[inline(never)]
    pub fn may_show(
        &self,
        scene: &Prepared,
        rectangle: Vec4,
        samples: &[Sample],
        is_inside: bool,
    ) -> bool {
        let rect = scene.axes.rect(rectangle);
        let first = samples[0].object();
        let others = |bits, sample: &Sample| bits | (sample.0 ^ samples[0].0);
        let all_show = Sample(samples.iter().fold(0, others)).object() == 0;
        let pixels = if is_inside { samples } else { &samples[..1] };
        // What all show one shows.
        let shown = if all_show { &samples[..1] } else { pixels };
        let outlines = &self.outlines[..self.count.min(OUTLINES)];
        outlines.iter().any(|&number| {
            let number = number as usize;
            let outline = &scene.outlines[number % OUTLINES];
            let object = outline.object as usize;
            let is_object = number == object;
            let is_shown = |sample: &Sample| sample.object() == object + 1;
            // Where no sample shows the plane of a shadow it cannot be seen, or is unseen itself.
            if shown.iter().any(is_shown) == is_object || !scene.may_show(number, &rect) {
                return false;
            }
            if is_object {
                !(first > 0 && all_show && scene.hides(first - 1, object))
            } else {
                !is_shaded(outline, &rect, samples.len(), pixels)
            }
        })
    }
}

/// Whether one of the first of `count` samples, one at a corner of the rectangle, shows the shadow that an outline is of; all
/// four, where there are more, which are of a square that is about to be split: where it is all in the shadow, so are its
/// parts.
#[inline(never)]
fn is_shaded(outline: &Outline, rect: &Rect, count: usize, samples: &[Sample]) -> bool {
    let sides = rect.to_array();
    let is_one_enough = count == 4;
    // Samples from one corner to the next.
    let step = if is_one_enough { 1 } else { 2 };
    let is_decided = (0..4).any(|i| {
        let (column, row) = (i & 1, i & 2);
        let corner = vec2(sides[2 * column], sides[row + 1]);
        let sample = samples.get(step * column + step * (step + 1) / 2 * row);
        let shows = |sample: &Sample| sample.object() == outline.object as usize + 1;
        let is_in = sample.is_some_and(shows) && outline.cone.meets(&corner.xyxy(), ROUNDING);
        is_in == is_one_enough
    });
    is_decided == is_one_enough
}
