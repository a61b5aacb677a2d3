//! A ray tracer of animated scenes for the CPU, which traces few of a picture's pixels and fills the rest.
//!
//! # A first picture
//!
//! A [`Scene`](scene::Scene) says what there is to see, a [`Quality`] how much may be left out, a [`Frame`] where the picture
//! goes, and a [`Renderer`] makes it, by the best instruction set of the processor and on all of its cores:
//!
//! ```
//! use eightfold_tracer::glam::{Vec3, vec3};
//! use eightfold_tracer::scene::{Light, List, Material, Scene, Sphere};
//! use eightfold_tracer::{Frame, Quality, Renderer, ScopedThreads};
//!
//! // The camera stands at z = 1 and looks at the origin, unless told otherwise.
//! let scene = Scene {
//!     spheres: List::of(&[Sphere {
//!         centre: vec3(0.0, 0.0, -1.0),
//!         radius: 0.5,
//!         material: Material {
//!             colour: vec3(1.0, 0.3, 0.1),
//!             kd: 0.8,
//!             ..Material::BLACK
//!         },
//!     }]),
//!     lights: List::of(&[Light {
//!         position: vec3(-2.0, 3.0, 2.0),
//!         colour: Vec3::ONE,
//!         ..Light::DARK
//!     }]),
//!     ..Scene::default()
//! };
//!
//! let (width, height) = (320, 240);
//! let mut pixels = vec![0; width * height];
//! let frame = Frame::new(width, height, &mut pixels);
//! let mut renderer = Renderer::detect();
//! let mut threads = ScopedThreads::new();
//! let counts = renderer.render(&scene, &Quality::DEFAULT, frame, &mut threads)?;
//!
//! // The sphere is red in the middle, and black lies around it.
//! let [_, red, green, _] = pixels[height / 2 * width + width / 2].to_be_bytes();
//! assert!(red > 100 && green < red / 2);
//! assert_eq!(pixels[0], 0);
//! // Most pixels were filled without a ray of their own.
//! assert!(counts.points < 320 * 240 / 4);
//! # Ok::<(), eightfold_tracer::Error>(())
//! ```
//!
//! [`Scene::validate`](scene::Scene::validate) says what is wrong with a scene, by the name of the number, and
//! [`Renderer::render`] asks it. The repository's `examples` write such a picture to a file, show it in a window, measure what
//! each quality costs, draw the squares, and play an intro of ten seconds.
//!
//! # How it comes about
//!
//! The picture is cut into squares of 8 pixels. Only their corners are traced. Where the four corners of a square have
//! similar colours, show the same object, and have the same light on it, the square is filled with colours between theirs;
//! elsewhere it is split into four, down to single pixels. What an object between corners would look like is not left to
//! chance: a square is also split where an object may be seen that none of its corners shows.
//!
//! A module per stage, from the scene to the pixels:
//!
//! | stage | module |
//! | --- | --- |
//! | what there is to draw: a camera, primitives, lights, captions, copper bars | [`scene`] |
//! | what trades accuracy for speed, as one struct | [`Quality`] |
//! | what only one shape knows, such as where rays meet it | `shapes` |
//! | what every ray of a frame uses, computed once | `prepare` |
//! | how a frame is drawn, settled once | `plan` |
//! | rays to colours and keys, as many side by side as the instruction set holds | `trace` |
//! | which points to trace, and which squares to fill or to split | `refine` |
//! | captions and copper bars over a finished picture | `overlay` |
//! | a frame: bands of the picture, by one thread or several | [`Renderer`] |
//!
//! Beside it: [`Governor`], which chooses a quality by how long frames take; [`observe`], which tells how a frame came about;
//! [`limits`], how far the numbers can be trusted. At the bottom, `lanes` holds the vectors that kernels are written in, [`maths`]
//! functions of single numbers, [`font`] the letters.
//!
//! # Accuracy for speed
//!
//! [`Quality::EXHAUSTIVE`] traces every pixel. The [`Quality::LADDER`] has seven rungs, from one that can hardly be told from
//! it to one that is for slow machines; [`Quality::DEFAULT`] is in the middle. A [`Governor`] walks the ladder so that frames
//! come in time: it is told how long each frame took, and has no clock itself. A frame can tell how accurate it is
//! ([`Frame::with_probes`]), and an [`AccuracyGovernor`] holds that instead.
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
//! # When something is wrong
//!
//! Whatever can't be rendered is an [`Error`], which is displayed as a sentence that says what to mend. [`Renderer::render_valid`]
//! is for scenes that are known to be valid: it leaves them unchecked, and panics where a size or a quality is out of its range.
#![no_std]
#![forbid(unsafe_code)]
#![warn(missing_docs)]

#[cfg(feature = "std")]
extern crate std;

// Leaves: what needs no other module.
mod flaw;
pub mod font;
mod lanes;
pub mod maths;

// Where it is drawn, and what it took.
mod counts;
mod picture;

// What is drawn.
pub mod scene;

// How it is drawn.
mod coverage;
mod grid;
pub mod observe;
mod overlay;
mod plan;
mod prepare;
mod quality;
mod refine;
mod render;
mod shapes;
mod trace;

mod governor;
pub mod limits;

pub use counts::{Counts, Probes};
pub use fearless_simd::Level;
pub use flaw::{Flaw, Found};
pub use glam;
pub use governor::{AccuracyGovernor, Governor};
pub use picture::{Band, Frame, Probing};
pub use quality::Quality;
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
