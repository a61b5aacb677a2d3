//! A ray tracer for the CPU that draws animated scenes in real time. It traces few of the pixels and fills the rest.
//!
//! # A first picture
//!
//! A [`Scene`](scene::Scene) describes what there is to see, a [`Quality`] trades accuracy for speed, a [`Frame`] has the pixels, and
//! a [`Renderer`] draws, by the best instruction set of the processor and on all of its cores:
//!
//! ```
//! use eightfold_tracer::glam::vec3;
//! use eightfold_tracer::scene::{Light, Material, Scene, Sphere};
//! use eightfold_tracer::{Frame, Quality, Renderer, ScopedThreads};
//!
//! // The default camera is at z = 1 and looks at the origin.
//! let mut scene = Scene::default();
//! let red = Material::matt(vec3(1.0, 0.3, 0.1), 0.8);
//! scene.spheres.push(Sphere::new(vec3(0.0, 0.0, -1.0), 0.5, red));
//! scene.lights.push(Light::default());
//!
//! let (width, height) = (400, 225);
//! let mut pixels = vec![0; width * height];
//! let frame = Frame::new(width, height, &mut pixels);
//! let mut renderer = Renderer::detect();
//! let mut threads = ScopedThreads::new();
//! let counts = renderer.render(&scene, &Quality::DEFAULT, frame, &mut threads)?;
//!
//! // The sphere is red, the corner is black, and few pixels have a point of their own.
//! let [_, red, green, _] = pixels[height / 2 * width + width / 2].to_be_bytes();
//! assert!(red > 100 && green < red / 2);
//! assert_eq!(pixels[0], 0);
//! assert!(counts.points < 400 * 225 / 10);
//! # Ok::<(), eightfold_tracer::Error>(())
//! ```
//!
#![doc = concat!("![A red sphere](data:image/webp;base64,", include_str!("pictures/first.txt"), ")")]
//!
//! # Shapes, materials and lights
//!
//! Spheres, boxes, cylinders, capsules and planes; matt, mirrors, metal, glass and patterns; points, suns, spotlights and lights with a
//! size, whose shadows are soft:
//!
//! ```
//! use eightfold_tracer::glam::{Mat3, Vec3, vec3};
//! use eightfold_tracer::scene::*;
//!
//! let floor = Material::matt(Vec3::ONE, 0.6).with_pattern(Pattern::checkers(1.0, 0.7));
//! let gold = Material::metal(vec3(1.0, 0.75, 0.4));
//! let cube = Block::new(Shape::Box, vec3(-1.2, 0.5, 0.8), Vec3::splat(0.5), gold);
//! let axes = Mat3::from_rotation_y(0.6);
//! let scene = Scene {
//!     camera: Camera::new(vec3(0.0, 2.0, -6.0), vec3(0.0, 0.7, 0.0), 0.6),
//!     background: vec3(0.5, 0.6, 0.8),
//!     ambient: Vec3::splat(0.2),
//!     planes: List::of(&[Plane::new(Vec3::ZERO, 20.0, 20.0, floor)]),
//!     blocks: List::of(&[Block { axes, ..cube }]),
//!     spheres: List::of(&[Sphere::new(vec3(0.6, 0.8, 0.0), 0.8, Material::glass(1.5))]),
//!     lights: List::of(&[
//!         Light::sun(vec3(-3.0, 6.0, -4.0), Vec3::splat(0.6)),
//!         Light::spotlight(vec3(0.0, 6.0, 0.0), Vec3::NEG_Y, 0.4, Vec3::splat(0.7)),
//!     ]),
//!     ..Scene::default()
//! };
//! assert_eq!(scene.validate(), Ok(()));
//! ```
//!
#![doc = concat!("![A glass ball and a golden cube on checkers](data:image/webp;base64,", include_str!("pictures/table.txt"), ")")]
//!
//! [`Scene::validate`](scene::Scene::validate) names the first number that is out of its range, and [`Renderer::render`] calls it.
//!
//! # The squares
//!
//! The picture is cut into squares of 8 pixels. Only their corners are traced. A square is filled with colours between its corners' if
//! these are similar, and if the corners show the same objects in the same light. Other squares are split into four, down to single
//! pixels. A square is also split if an object, a shadow on a plane, a reflection in the first plane or a highlight may be visible in it
//! that none of its corners shows. A [`Method`](scene::Method) draws the squares over the same scene:
//!
//! ```
//! # use eightfold_tracer::scene::*;
//! # let mut scene = Scene::default();
//! scene.method = Method {
//!     squares: 0.5,
//!     picture: 0.7,
//!     ..Method::PLAIN
//! };
//! ```
//!
#![doc = concat!("![The same with the squares that were filled](data:image/webp;base64,", include_str!("pictures/squares.txt"), ")")]
//!
//! An [`Observer`](observe::Observer) receives the points and squares as data.
//!
//! # Quality
//!
//! [`Quality::EXHAUSTIVE`] traces every pixel. The [`Quality::LADDER`] has seven presets, from one that can hardly be told from
//! it to one for slow machines; [`Quality::DEFAULT`] is in the middle. A [`Governor`] steps along the ladder to hold a frame rate, by
//! the time that each frame took. A frame can measure its own error ([`Frame::with_probes`]), and an [`AccuracyGovernor`] holds an
//! accuracy by that. [`limits`] has the figures of accuracy, and the conditions for them.
//!
//! # Memory and threads
//!
//! Rendering allocates nothing. A renderer has a [`Memory`] of [`Memory::BYTES`] bytes, and each thread has a [`Worker`] of
//! [`Worker::BYTES`] bytes, for pictures of any size: under 8 MiB with sixteen threads. [`Renderer::detect`], [`ScopedThreads`] and
//! [`Worker::several`] allocate them in place: they work on the smallest stack of a thread, in unoptimised programs as well.
//!
//! [`Threads`] is a trait with one method, for threads of your own. [`ScopedThreads`] are the threads of std; a worker alone is the
//! caller's thread.
//!
//! # Without std
//!
//! With `default-features = false` the crate needs neither a system nor an allocator, and draws the same bits. The caller provides
//! memory and workers, as a `static` for example: they are all zeros at first, which takes no room in a program's file.
//! [`Renderer::with_memory`] borrows the memory.
//!
//! # Scenes as data
//!
//! By the feature `serde` a [`Scene`](scene::Scene) and a [`Quality`] are written and read in any of serde's formats, by the names of
//! their fields. Fields that a text leaves out have their defaults; objects need a place, a size and a material. Reading leaves numbers
//! out of their ranges to [`Scene::validate`](scene::Scene::validate). JSON has no infinite numbers, as some qualities have; other
//! formats do. (The scene files of the repository's lab have more: names for materials, and motions.)
//!
//! # Conventions
//!
//! Coordinates are right-handed, y up, in scene units, which are of any size; angles in radians, times in seconds. The
//! picture's pixel (0, 0) is its upper left, x to the right, y down; a pixel's sample is its centre. Colours are linear RGB, 1
//! the brightest that is shown; pixels are `0x00RRGGBB`, a colour clamped to 0 to 1, times 255 and rounded, without gamma.
//! Vectors are those of [`glam`].
//!
//! # What a frame depends on
//!
//! Scene, size, quality, the samples' offset and the instruction set, and nothing else: the same bits by any number of threads,
//! whatever was rendered before. Instruction sets differ by 1 of 255 at most, but for silhouettes.
//!
//! # What later versions change
//!
//! A [`Scene`](scene::Scene), the structs in it, and a [`Quality`] get more fields in minor versions, whose defaults leave pictures as
//! they are. End struct expressions with `..Material::BLACK`, `..Scene::default()` or `..Quality::DEFAULT`, and they compile with any
//! minor version; a struct expression that lists all fields breaks. [`Counts`], [`Error`] and [`Frame`] are `#[non_exhaustive]`.
//!
//! The bits of a picture are no promise between versions, nor are the numbers of [`Quality::LADDER`]; the figures of [`limits`] are.
//! [`glam`] and [`Level`] are those of `glam` and `fearless_simd`: where these break, so does this crate, by a new major version.
//!
//! # Errors
//!
//! [`Renderer::render`] returns an [`Error`], whose text says what to change. [`Renderer::render_valid`] is for scenes that are known
//! to be valid: it does not check them, and panics if a size or a quality is out of its range.
#![no_std]
#![forbid(unsafe_code)]
#![warn(missing_docs)]

#[cfg(feature = "std")]
extern crate std;

mod counts;
mod coverage;
pub mod font;
mod governor;
mod grid;
mod lanes;
pub mod limits;
pub mod maths;
pub mod observe;
mod overlay;
mod picture;
mod plan;
mod prepare;
mod quality;
mod range_error;
mod refine;
mod render;
mod rounding;
pub mod scene;
mod shapes;
mod trace;

pub use counts::{Counts, Probes};
pub use fearless_simd::Level;
pub use glam;
pub use governor::{AccuracyGovernor, Governor};
pub use picture::{Band, Frame, Probing};
pub use quality::Quality;
pub use range_error::{Found, RangeError};
pub use refine::Worker;
#[cfg(feature = "std")]
pub use render::{BoxedMemory, ScopedThreads};
pub use render::{Error, Job, Memory, Renderer, Threads};

/// The widest picture, in pixels.
pub const MAX_WIDTH: usize = 3840;
/// The tallest picture, in pixels.
pub const MAX_HEIGHT: usize = 2160;

/// The example of the README compiles and runs.
#[cfg(doctest)]
#[doc = include_str!("README.md")]
struct Readme;
