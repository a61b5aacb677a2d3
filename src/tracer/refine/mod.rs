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
//! 1. *Points* (`tile::points`): a square's corners are the points at its bit and the next, in the rows above and below, so the points
//!    that a level needs are shifts and ORs of its squares' bits. Those with two even numbers are known from the level above,
//!    and a middle of a side is the mean of the side's ends if these are alike; all others are traced, in full packets, in
//!    clusters of 4x16 points: neighbours meet the same objects.
//! 2. *Guard* ([`coverage`](crate::coverage)): squares that may show an object, a shadow, an image or a highlight that their corners do
//!    not are left open.
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
//! is on, and what is added to that, are interpolated apart, and the pattern is seen at every pixel (see `tile::patterned`).
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

pub(crate) mod antialias;
mod fill;
pub(crate) mod probe;
mod tile;
mod verdict;
mod worker;

#[cfg(test)]
mod tests;

pub(crate) use tile::draw;
pub use worker::Worker;
