//! Objects that may be seen between the corners of squares.

use crate::prepare::{GroupSet, MAX_OBJECTS, Prepared, Rect};
use crate::trace::Sample;
use core::ops::Range;

/// The objects that a part of the picture may show.
pub(crate) struct Unseen {
    objects: [u16; MAX_OBJECTS],
    count: usize,
}

impl Unseen {
    pub const fn new() -> Self {
        Self {
            objects: [0; MAX_OBJECTS],
            count: 0,
        }
    }

    /// Lists the objects that the rectangle with these corners may show, in pixels; the spheres are in `groups`.
    #[inline(never)]
    pub fn set(&mut self, scene: &Prepared, groups: GroupSet, rectangle: [f32; 4]) {
        let rect = scene.axes.rect(rectangle);
        self.count = 0;
        let mut i = scene.tree.start(groups);
        while let Some(node) = scene.tree.nodes().get(i) {
            let is_met = node.groups & groups != 0;
            if is_met && !node.is_bound {
                let number = node.number as usize;
                self.add(scene, number..number + 1, rect);
            }
            i += node.step(is_met);
        }
        let planes = scene.first_plane()..scene.nothing();
        self.add(scene, planes, rect);
    }

    /// Lists those of some objects that a rectangle may show.
    #[inline(never)]
    fn add(&mut self, scene: &Prepared, objects: Range<usize>, rect: Rect) {
        for object in objects {
            if scene.may_show(object, rect) {
                self.objects[self.count] = object as u16;
                self.count += 1;
            }
        }
    }

    /// Whether a square, its sides included, may show an object that none of some samples shows. They are on its sides
    /// and inside, the outermost at its corners; the first one is a pixel of the picture, and all where `is_inside`.
    #[inline(never)]
    pub fn may_show(
        &self,
        scene: &Prepared,
        rectangle: [f32; 4],
        samples: &[Sample],
        is_inside: bool,
    ) -> bool {
        let rect = scene.axes.rect(rectangle);
        let first = samples[0].object();
        let pixels = if is_inside { samples } else { &samples[..1] };
        let all_show = first > 0 && samples.iter().all(|sample| sample.object() == first);
        self.objects[..self.count].iter().any(|&object| {
            let object = object as usize;
            let is_shown = pixels.iter().any(|sample| sample.object() == object + 1);
            !is_shown
                && scene.may_show(object, rect)
                && !(all_show && scene.hides(first - 1, object))
        })
    }
}
