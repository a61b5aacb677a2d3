//! Which points of a band of the picture are traced, and what becomes of the rest.
//!
//! A band is some rows of squares. Its points are refined breadth-first, a stretch of the band at a time: the corners
//! of all squares are traced, then each square is filled or split, then the points that the splits asked for are
//! traced, and so on down to single pixels, so that lanes stay full. No point is traced twice: a stretch finds what the
//! one before it traced at their seam, and bands exchange the rows they share (see [`Border`]).
//!
//! A square whose corners all show one object with a pattern that has edges is not filled by their colours: what the pattern
//! is on, and what is added to that, are interpolated apart, and the pattern is seen at every pixel (see [`patterned`]).
//!
//! # What is not missed
//!
//! Corners do not see what lies between them. A guarded quality (see `Quality::guarded`), as all named ones are, shows every
//! object that tracing every pixel shows, each in one pixel at least: a square is split as long as some object may be
//! seen in it that none of its corners shows. An object that has a pixel p is in a candidate's outline around each square
//! with p, since outlines are bounds (see `prepare::outline`), so a square with p is filled only where one of its corners
//! that are pixels shows the object, or where all corners show one that covers the square and is in front. Averaged
//! points count as showing what both their ends show. What a square is cleared of, its parts are, too.
//!
//! The same holds for the shadows that spheres throw on planes by the light of lamps that are points: a shadow on a plane is
//! a cone as seen from the lamp, and has an outline like an object's. A square that shows the plane at a corner, and may
//! show a shadow, is filled only where one of its corners lies in the shadow on the plane.
//!
//! That is all that is guaranteed. Gaps between objects and between shadows, shadows on and of other objects, and by lamps
//! that are more than points or that touch a sphere to within 0.1 % of its radius, highlights, and what is seen by
//! reflection or through glass can be missed where they fall between corners. A guaranteed shadow may be smaller than it
//! is, too: of the pixels of small spheres' shadows on a plane up to 0.4 % are lit
//! (`few_pixels_of_shadows_are_missed_and_their_patches_are_small`). The lab's bench measures how much of the picture is
//! wrong, and how it flickers.

pub(crate) mod antialias;
pub(crate) mod band;
mod fill;
mod marks;
mod patterned;
mod points;
pub(crate) mod refiner;
mod square;
mod unseen;
mod verdict;

pub use band::Band;
pub(crate) use band::render;
pub(crate) use band::render_observed;
pub(crate) use points::{Border, Points};
pub(crate) use square::{Limit, Square};
pub(crate) use unseen::Unseen;
