//! Which points of the picture are traced, and what becomes of the rest.
//!
//! Threads share the picture by bands of rows (see [`Band`](crate::Band)). A band is drawn a *tile* after the other, 512 pixels wide or
//! fewer at the right, and a tile by *levels*: squares of 8 pixels, then of 4, of 2, and single pixels. A level is a grid of points,
//! the corners of its squares, and a bit for each square and each point. These are its steps, each a pass over rows:
//!
//! ```text
//!   squares of 8         which points?        verdict                 parts of 4           which points?
//!   +---+---+---+       o---o---o---o       +---+---+---+       +---+-+-+---+       +---+-o-+---+
//!   |   |   |   |       |   |   |   |       |###|   |###|       |   | | |   |       |   | | |   |
//!   |   |   |   |  ->   |   |   |   |  ->   |###|   |###|  ->   |   +-+-+   |  ->   |   o-o-o   |
//!   |   |   |   |       |   |   |   |       |###|   |###|       |   | | |   |       |   | | |   |
//!   +---+---+---+       o---o---o---o       +---+---+---+       +---+-+-+---+       +---+-o-+---+
//!     1   1   1             traced            # = filled         0 0 1 1 0 0         o = asked for
//! ```
//!
//! 1. *Points* (`points`): a square's corners are the points at its bit and the next, in the rows above and below, so the points
//!    that a level needs are shifts and ORs of its squares' bits. Those with two even numbers are known from the level above,
//!    and a middle of a side is the mean of the side's ends if these are alike; all others are traced, in full packets, in
//!    clusters of 4x16 points: neighbours meet the same objects.
//! 2. *Guard* (`guard`): squares that may show an object, a shadow on a plane, or an image in one, that their corners do not are
//!    left open.
//! 3. *Verdict* (`verdict`): the least and the greatest of each channel at the four corners of squares side by side, in vector
//!    registers; their keys; a bit for each square that is not open and passes the [`Quality`](crate::Quality)'s rules.
//! 4. *Fill* (`fill`): those squares are painted with colours between their corners', eight pixels at once.
//! 5. *Split*: the bits of all others, each twice in two rows, are the squares of the level below.
//!
//! So no point of a tile is traced twice, by construction. Tiles know nothing of each other: points that two share are traced
//! by both, with the same bits. Of the model scene at 1024x768 that is 8 % of all points, and with bands half as high it would be
//! 16 %; for that there is one parallel phase, no memory between bands, and no order among them. By the times of its bands the
//! default frame at 1920x1080 can be 13.5 times as fast by 16 threads as by one (12.2 times if bands were taken from the top).
//!
//! A square whose corners all show one object with a pattern that has edges is not filled by their colours: what the pattern
//! is on, and what is added to that, are interpolated apart, and the pattern is seen at every pixel (see `patterned`).
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
//! show a shadow, is filled only where one of its corners lies in the shadow on the plane, or where all lie in another one by the same
//! lamp (`prepare::shadow` tells why rounding spoils neither). That corner is dark. It may be as dark without the shadow: see `limits`.
//!
//! Shadows of blocks on planes, and those by all other lamps, are looked for in the same way, but not as exactly: a capsule counts as the
//! cylinder around it, a cylinder that is seen from above as the box, and a lamp with a size as its middle. A spotlight counts where it
//! does not shine, too. So few of them are missed.
//!
//! Slits of light between two shadows by one lamp are looked for as well: a square is left open if two of the shadows hold some of its
//! corners each, and none holds all. Corners that are all dark would fill it otherwise, and the slit would come and go from frame to
//! frame.
//!
//! And it holds for what the first plane mirrors: an image in a plane is what the eye's own image behind the plane sees of the
//! object, so it has the outline that the object has for a camera mirrored in the plane, in the same place of the picture. A square
//! that shows the plane at a corner, and may show an image, is filled only where one of its corners lies in the image's outline
//! on the plane. Such a corner shows the image, or another one in front of it: an image that is partly hidden by others in the
//! mirror can be missed. So can one that is smaller than 2x2 pixels, as corners have to be well inside of a block's outline, and, if
//! rarely, that of a cylinder or a capsule, whose outline is that of the box around it. Images in a first plane with waves (see
//! `Scene::water`) have no outlines: they can be missed as in any other mirror.
//!
//! Highlights in the eye's own sight are guarded by what they look like (see `prepare::highlight`): about the place where a lamp is
//! mirrored, Phong's lobe is a Gaussian of the picture. A square that shows the object is left open if the lobe is visibly brighter
//! anywhere in it than at the corners that show the object. That is no proof: the lobe is only nearly a Gaussian, and such a corner
//! may be in shadow or on another face. Of thousands of highlights of five pixels or more that show their middles none was missed,
//! and few parts of others (`docs/accuracy.md`).
//!
//! Antialiasing leaves a pixel a third of what it shows at least.
//!
//! That is all that is guaranteed. Gaps between objects, shadows on other objects than planes, highlights in mirrors, and what is seen in
//! other mirrors or through glass can be missed where they fall between corners; `cargo lab missed` counts how many are. A guaranteed
//! shadow may be smaller than it is, too: of the pixels of small spheres' shadows on a plane up to 0.4 % are lit
//! (`few_pixels_of_shadows_are_missed_and_their_patches_are_small`). The lab's bench measures how much of the picture is
//! wrong, and how many pixels pop.
//!
//! # Where the time goes
//!
//! A default frame of the model scene, jagged, 1024x768, is 6.0 times as fast as an exhaustive one by AVX2 on an AMD EPYC (Zen 5). It
//! would be 10.9 times as fast if all but tracing took no time: primary rays take 20 % of it, secondary ones 38 %, finding points 15 %,
//! filling 11 %, the guard 9 %, everything else 7 %.
//! A ray takes 1.5 times as many instructions as in an exhaustive frame: half of the pixels of that are background, in packets of
//! nothing else, while the points that squares need are about edges, where the rays of a packet meet several objects. Finding points
//! is flat in the profile: no line of it has more than 2 % of the frame. Branches that go either way by chance cost more than they
//! save there. Hits sorted by their objects, so that packets are of one, cost as much time
//! as they save: batches are too short. To average the middle of a split square from two corners that agree saves 17 % of the
//! rays, 4 % of the time, and costs 1 dB and more errors that come and go, which looser tolerances give for less.

/// Evaluates an expression by an instruction set, with all that it has.
///
/// Where there is AVX-512 it is AVX2 that squares are judged and filled by: a row of a square of 8 is one of its registers, and
/// wider ones take 1,335 packed bytes of the intro for nothing.
macro_rules! by_isa {
    ($isa:expr, $simd:ident => $expression:expr) => {{
        if let Some($simd) = crate::lanes::avx2($isa) {
            fearless_simd::Simd::vectorize(
                $simd,
                #[inline(always)]
                || $expression,
            )
        } else {
            let $simd = crate::lanes::baseline();
            fearless_simd::Simd::vectorize(
                $simd,
                #[inline(always)]
                || $expression,
            )
        }
    }};
}

pub(crate) mod antialias;
mod area;
mod bits;
mod draw;
mod fill;
mod guard;
mod method;
mod patterned;
mod points;
pub(crate) mod probe;
mod pyramid;
mod tile;
mod verdict;
mod worker;

#[cfg(test)]
mod tests;

pub(crate) use draw::draw;
pub use worker::Worker;
