#![doc = include_str!("README.md")]
#![doc = concat!("![A red sphere](data:image/webp;base64,", include_str!("pictures/first.txt"), ")")]
//!
//! # Shapes, materials and lights
//!
//! Shapes are spheres, boxes, cylinders, capsules and planes. Materials are matt, mirrors, metal or
//! glass, and can have a pattern. Lights are points, suns or spotlights; with a diameter they cast
//! soft shadows.
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
//! # How it works
//!
//! A square is split if its corners differ in colour, objects or light, or if conservative bounds
//! place an object, a shadow, a mirror image or a highlight between them.
//! [`Method::squares`](presentation::Method::squares) draws the outlines of the filled squares:
//!
#![doc = concat!("![The same with the squares that were filled](data:image/webp;base64,", include_str!("pictures/squares.txt"), ")")]
//!
//! An [`Observer`](observe::Observer) receives the points and squares as data.
//!
//! # Quality
//!
//! [`Preset::LADDER`] has seven presets, from almost [`Quality::EXHAUSTIVE`] to one for slow
//! machines. A [`Governor`] selects the preset, and optionally a smaller size, that holds a frame
//! rate. An [`AccuracyGovernor`] selects the preset that holds an accuracy, measured by
//! [`Frame::with_probes`]. [`limits`] has the accuracy of the presets in figures.
//!
//! # Memory and threads
//!
//! Rendering never allocates. A renderer needs one [`Memory`], and one [`Worker`] per thread: under
//! 8 MiB with sixteen threads, for pictures of any size. [`Renderer::detect`], [`ScopedThreads`]
//! and [`Worker::several`] allocate them in place on the heap: a small stack suffices. Implement
//! [`Threads`] for your own thread pool.
//!
//! # Without std
//!
//! With `default-features = false` the crate needs neither an operating system nor an allocator,
//! and draws the same bits. Pass the memory to [`Renderer::with_memory`]: new memory and workers
//! are all zeros, so a `static` takes no space in an executable file.
//!
//! # Scenes as data
//!
//! The feature `serde` implements serialisation of a [`Scene`](scene::Scene) and a [`Quality`].
//! Missing fields get their defaults, except an object's position, size and material; unknown
//! fields are errors. Some qualities contain infinity, which JSON cannot represent.
//!
//! # Conventions
//!
//! Coordinates are right-handed with y up, in scene units of any size. Angles are in radians, times
//! in seconds. Pixel (0, 0) is the upper left one, sampled at its centre. Colours are linear RGB; 1
//! is the brightest displayed value. Pixels are `0x00RRGGBB`: colours clamped to 0 to 1, times 255,
//! rounded, without gamma.
//!
//! # Determinism
//!
//! A frame depends only on the scene, the size, the quality, the samples' offset and the
//! instruction set, not on threads or previous frames. Between instruction sets pixels differ by at
//! most 1/255, except on silhouettes.
//!
//! # Compatibility
//!
//! Minor versions may add fields to [`Scene`](scene::Scene),
//! [`Presentation`](presentation::Presentation), their structs, and [`Quality`], with defaults that
//! keep pictures unchanged. End struct expressions with `..Material::BLACK`, `..Scene::default()`
//! or `..Quality::DEFAULT`.
//!
//! The figures of [`limits`] hold in later versions. The bits of pictures and the numbers of each
//! [`Preset`] may change. A breaking version of `glam` or `fearless_simd` ([`Level`]) makes a
//! breaking version of this crate.
#![no_std]
#![forbid(unsafe_code)]
#![warn(missing_docs, missing_debug_implementations)]

#[cfg(feature = "std")]
extern crate std;

#[macro_use]
mod zero;

mod counts;
mod coverage;
mod debug;
mod fold;
#[doc(hidden)]
pub mod font;
mod governor;
mod grid;
mod lanes;
pub mod limits;
#[doc(hidden)]
pub mod maths;
pub mod observe;
mod overlay;
mod picture;
mod plan;
mod prepare;
pub mod presentation;
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
pub use picture::{Band, Error, Frame, MAX_HEIGHT, MAX_WIDTH, Probing};
pub use quality::{Preset, Quality, UnknownPreset};
pub use range_error::{Found, RangeError};
pub use refine::Worker;
#[cfg(feature = "std")]
pub use render::{BoxedMemory, ScopedThreads};
pub use render::{Job, Memory, Renderer, Threads};
