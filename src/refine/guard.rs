//! The guard against what lies between corners: objects, shadows on planes, and mirror images in the first plane, that a square may
//! show although no corner does.
//!
//! Everything that can be seen has a convex outline (see `prepare::outline`). It covers one range of a row of squares, which its
//! tangents give. Only squares in that range are looked at.
//!
//! Which object a corner shows is known from tracing it. Whether it shows a shadow or an image on a plane is not, so there the
//! outline tells: a corner that shows the plane and lies in the outline shows what has it, or what is in front of that.

use super::area::Area;
use super::bits::Bits;
use super::pyramid::Pyramid;
use super::{TILE_HEIGHT, TILE_WIDTH};
use crate::prepare::{MAX_OUTLINES, ObjectId, Prepared, SeenOutline, rectangle};
use core::ops::RangeInclusive;

/// The outlines of what may be seen in a tile although no corner has shown it so far, by number.
pub(super) struct CoverageGuard {
    outlines: [u16; MAX_OUTLINES],
    count: usize,
}

/// The most that rounding moves the ends of a range, in pixels.
const MARGIN: f32 = 0.02;

impl CoverageGuard {
    pub const fn new() -> Self {
        Self {
            outlines: [0; MAX_OUTLINES],
            count: 0,
        }
    }

    /// Lists the outlines that a tile may show.
    pub fn begin(&mut self, scene: &Prepared, area: &Area) {
        let (width, height) = (area.columns(0) as f32, area.rows(0) as f32);
        let corner = rectangle(area.left, area.top, area.left, area.top);
        let rect = scene
            .axes
            .rect(corner + glam::vec4(0.0, 0.0, width, height));
        self.count = 0;
        let planes = scene.first_plane()..scene.background();
        let mut sees_plane = false;
        for number in 0..scene.outlined.min(MAX_OUTLINES) {
            // Images and shadows are on planes.
            if number >= planes.end && !sees_plane {
                break;
            }
            if scene.outline(number).narrow(rect).is_some() {
                sees_plane |= planes.contains(&number);
                self.outlines[self.count] = number as u16;
                self.count += 1;
            }
        }
    }

    /// Leaves only those of a level's squares in `open` that may show something which their corners do not, and keeps the
    /// outlines of all such things for the level below: what a square is cleared of, its parts are, too.
    pub fn look_at(
        &mut self,
        scene: &Prepared,
        area: &Area,
        pyramid: &Pyramid,
        level: usize,
        open: &mut [Bits; TILE_HEIGHT],
    ) {
        let rows = area.rows(level);
        let mut uncovered = [Bits::NONE; TILE_HEIGHT];
        let mut kept = 0;
        for i in 0..self.count {
            let number = self.outlines[i];
            let outline = scene.outline(number.into());
            let mut is_kept = false;
            for y in 0..rows {
                if open[y].is_empty() {
                    continue;
                }
                let Some(range) = area.range(scene, &outline, level, y) else {
                    continue;
                };
                (open[y] & Bits::range(range)).for_each(|x| {
                    // The first corner is always a pixel, and shows most of what there is.
                    let first = pyramid.sample(Pyramid::index(level, x, y)).object();
                    if first.is_some_and(|id| id.index() == usize::from(number)) {
                        return;
                    }
                    let square = Square {
                        area,
                        level,
                        x,
                        y,
                        objects: pyramid.corners(level, x, y).map(|corner| corner.object()),
                    };
                    if !square.shows(scene, number.into(), &outline) {
                        uncovered[y].set(x);
                        is_kept = true;
                    }
                });
            }
            if is_kept {
                self.outlines[kept] = number;
                kept += 1;
            }
        }
        self.count = kept;
        open[..rows].copy_from_slice(&uncovered[..rows]);
    }
}

impl Area {
    /// The squares of a row, sides included, that may show what has an outline.
    fn range(
        &self,
        scene: &Prepared,
        outline: &SeenOutline<'_>,
        level: usize,
        y: usize,
    ) -> Option<RangeInclusive<usize>> {
        let side = self.side(level);
        let columns = self.columns(level);
        let (left, top) = (self.left, self.top + y * side);
        let row = rectangle(left, top, left + columns * side, top + side);
        let [from, to] = outline.narrow(scene.axes.rect(row))?;
        let [from, to] = [from, to].map(|u| scene.axes.column(u) - left as f32);
        // A square that ends where the outline begins shows it on its side.
        let first = libm::ceilf((from - MARGIN) / side as f32) as usize;
        let last = ((to + MARGIN) / side as f32) as usize;
        let last = last.min(columns - 1).min(TILE_WIDTH - 1);
        Some(first.saturating_sub(1)..=last)
    }
}

/// A square of a level, and the objects that its corners show, where they are known.
struct Square<'a> {
    area: &'a Area,
    level: usize,
    x: usize,
    y: usize,
    objects: [Option<ObjectId>; 4],
}

impl Square<'_> {
    /// Whether its corners show what has an outline, or that it cannot be seen.
    fn shows(&self, scene: &Prepared, number: usize, outline: &SeenOutline<'_>) -> bool {
        let object = scene.outlined_object(number);
        if number == object.index() {
            self.shows_object(object) || self.is_hidden(scene, object)
        } else {
            // Where no corner shows the plane of a shadow or an image it cannot be seen, or is looked for itself.
            !self.shows_object(object) || self.shows_on(scene, outline, object)
        }
    }

    /// Whether all corners show one object, if it is known.
    fn only_object(&self) -> Option<ObjectId> {
        let [first, others @ ..] = self.objects;
        let is_one = others.iter().all(|&object| object == first);
        if is_one { first } else { None }
    }

    /// Whether an object is shown by a corner that is a pixel of the picture, or by all.
    fn shows_object(&self, object: ObjectId) -> bool {
        self.only_object() == Some(object)
            || (0..4).any(|i| self.objects[i] == Some(object) && self.is_pixel(i))
    }

    /// Whether all corners show an object that is in front of another one.
    fn is_hidden(&self, scene: &Prepared, object: ObjectId) -> bool {
        self.only_object()
            .is_some_and(|front| scene.occludes(front, object))
    }

    /// Whether a corner that is a pixel shows a plane within a shadow's or an image's outline.
    fn shows_on(&self, scene: &Prepared, outline: &SeenOutline<'_>, plane: ObjectId) -> bool {
        (0..4).any(|i| {
            let [x, y] = self.corner(i);
            let point = scene.axes.rect(rectangle(x, y, x, y));
            self.objects[i] == Some(plane) && self.is_pixel(i) && outline.contains(point)
        })
    }

    /// The position of corner number `i` in the picture.
    fn corner(&self, i: usize) -> [usize; 2] {
        let side = self.area.side(self.level);
        [
            self.area.left + (self.x + i % 2) * side,
            self.area.top + (self.y + i / 2) * side,
        ]
    }

    /// Whether corner number `i` is a pixel of the picture.
    fn is_pixel(&self, i: usize) -> bool {
        let [x, y] = self.corner(i);
        x < self.area.picture[0] && y < self.area.picture[1]
    }
}
