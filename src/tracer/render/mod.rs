//! One frame: bands of the picture, drawn by one thread or several.

#[cfg(feature = "std")]
mod boxed;
mod error;
mod memory;
mod schedule;
#[cfg(feature = "std")]
mod scoped;
mod threads;

#[cfg(feature = "std")]
pub use boxed::BoxedMemory;
pub use error::Error;
pub use memory::Memory;
#[cfg(feature = "std")]
pub use scoped::ScopedThreads;
pub use threads::{Job, Threads};

use crate::counts::Counts;
use crate::observe::Observer;
use crate::picture::Frame;
use crate::plan::FramePlan;
use crate::quality::Quality;
use crate::scene::Scene;
use crate::trace::{Kernel, trace_narrow, trace_wide};
use crate::{MAX_HEIGHT, MAX_WIDTH};
use core::borrow::BorrowMut;
use fearless_simd::Level;

impl Frame<'_> {
    /// Whether the size is in its range, and there are enough pixels.
    fn validate(&self) -> Result<(), Error> {
        let Self {
            width,
            height,
            stride,
            ref pixels,
            ..
        } = *self;
        if !(1..=MAX_WIDTH).contains(&width) || !(1..=MAX_HEIGHT).contains(&height) {
            return Err(Error::Size { width, height });
        }
        if stride < width {
            return Err(Error::Stride { width, stride });
        }
        let (needed, given) = (self.count(), pixels.len());
        if given < needed {
            return Err(Error::Pixels { needed, given });
        }
        Ok(())
    }
}

/// Renders frames.
///
/// With the feature `std` it has its [`Memory`] on the heap. Without, it borrows a `&'static mut Memory` by
/// [`Renderer::with_memory`].
///
/// ```
/// use eightfold_tracer::scene::Scene;
/// use eightfold_tracer::{Frame, Quality, Renderer, ScopedThreads};
///
/// let mut pixels = [0; 64 * 48];
/// let frame = Frame::new(64, 48, &mut pixels);
/// let threads = &mut ScopedThreads::of(1);
/// let counts = Renderer::detect().render(&Scene::default(), &Quality::DEFAULT, frame, threads)?;
/// assert!(counts.points < 64 * 48, "most pixels need no ray");
/// # Ok::<(), eightfold_tracer::Error>(())
/// ```
///
/// # A frame tells its own error
///
/// [`Frame::with_probes`] has some pixels of a frame traced as [`Quality::reference`] would have them, and compared with what was
/// drawn. Over some frames that tells how accurate they are, on this scene:
///
/// ```
/// # use eightfold_tracer::glam::{Vec3, vec3};
/// # use eightfold_tracer::scene::{Light, List, Material, Scene, Sphere};
/// use eightfold_tracer::{Frame, Probes, Quality, Renderer, ScopedThreads};
///
/// # let material = Material { colour: Vec3::ONE, kd: 0.8, ..Material::BLACK };
/// # let sphere = |x| Sphere { centre: vec3(x, 0.0, 0.0), radius: 0.3, material };
/// # let light = Light { position: vec3(-2.0, 3.0, 2.0), colour: Vec3::ONE, ..Light::DARK };
/// let mut scene = Scene {
///     spheres: List::of(&[-0.4, 0.0, 0.4].map(sphere)),
///     lights: List::of(&[light]),
///     ..Scene::default()
/// };
/// let mut pixels = [0; 160 * 120];
/// let (mut renderer, mut threads) = (Renderer::detect(), ScopedThreads::new());
/// let mut probes = Probes::NONE;
/// for number in 0..30 {
///     scene.camera.eye.x = number as f32 / 60.0;
///     let frame = Frame::new(160, 120, &mut pixels).with_probes(2000, number);
///     probes += renderer.render(&scene, &Quality::DEFAULT, frame, &mut threads)?.probes;
/// }
/// println!("{:.1} ± {:.1} dB", probes.psnr(), probes.margin());
/// assert!(probes.psnr() > 30.0 && probes.margin() < 3.0);
/// # Ok::<(), eightfold_tracer::Error>(())
/// ```
///
/// # What a frame depends on
///
/// Its pictures depend on the scene, the quality, the size, the offset and the instruction set alone: the same bits by any
/// number of threads, whatever it has rendered before.
pub struct Renderer<#[cfg(feature = "std")] M = BoxedMemory, #[cfg(not(feature = "std"))] M> {
    isa: Level,
    kernel: Kernel,
    memory: M,
}

#[cfg(feature = "std")]
impl Renderer {
    /// A renderer by an instruction set, with memory of its own: [`Memory::BYTES`] bytes.
    ///
    /// [`Level::baseline`] is what every processor has that the program is compiled for. [`Renderer::detect`], with the feature `std`,
    /// finds the best that this one has.
    #[must_use]
    pub fn new(level: Level) -> Self {
        Self::with_memory(level, BoxedMemory::new())
    }

    /// A renderer by the best instruction set that this processor has, with memory of its own.
    #[must_use]
    pub fn detect() -> Self {
        Self::new(Level::new())
    }
}

impl<M: BorrowMut<Memory>> Renderer<M> {
    /// A renderer by an instruction set, in memory that lies elsewhere.
    #[must_use]
    pub fn with_memory(level: Level, memory: M) -> Self {
        Self {
            isa: level,
            kernel: trace_wide,
            memory,
        }
    }

    /// The same, which takes AVX2 where there is AVX-512: a program that makes no other renderer leaves that kernel, of 16 kB, out of
    /// its file.
    #[must_use]
    pub fn narrow(level: Level, memory: M) -> Self {
        Self {
            isa: level,
            kernel: trace_narrow,
            memory,
        }
    }

    /// Has the next frames rendered by another instruction set.
    pub fn set_level(&mut self, level: Level) {
        self.isa = level;
    }

    /// Renders one frame, and says how much work it was.
    ///
    /// # Errors
    /// If a side of the frame is 0 or too long, if it has too few pixels, or if a number of the quality or the scene is out of
    /// its range. Then the pixels are as they were.
    pub fn render(
        &mut self,
        scene: &Scene,
        quality: &Quality,
        frame: Frame<'_>,
        threads: &mut dyn Threads,
    ) -> Result<Counts, Error> {
        validate(scene, quality, &frame)?;
        Ok(self.render_valid(scene, quality, frame, threads))
    }

    /// Like [`Renderer::render`], and the observer hears how the frame comes about: the same frame, the same counts, more time.
    /// Of the points that edges get in the end (see [`Quality::antialias`]) it hears by their stages alone.
    ///
    /// # Errors
    /// As [`Renderer::render`].
    pub fn render_observed<O: Observer>(
        &mut self,
        scene: &Scene,
        quality: &Quality,
        frame: Frame<'_>,
        threads: &mut dyn Threads,
        observer: O,
    ) -> Result<Counts, Error> {
        validate(scene, quality, &frame)?;
        let plan = self.plan(scene, quality, &frame);
        let memory = self.memory.borrow_mut();
        Ok(memory.render_observed(&plan, scene, frame, threads, observer))
    }

    /// Renders one frame of what is known to be valid, as the intro's scenes are.
    ///
    /// A scene that is not valid gives some picture, in bounded time.
    ///
    /// # Panics
    /// If the frame's size is out of its range, if it has too few pixels, or if the quality's [`square`](Quality::square) or
    /// [`depth`](Quality::depth) is out of its range.
    pub fn render_valid(
        &mut self,
        scene: &Scene,
        quality: &Quality,
        frame: Frame<'_>,
        threads: &mut dyn Threads,
    ) -> Counts {
        let plan = self.plan(scene, quality, &frame);
        let memory = self.memory.borrow_mut();
        memory.render(&plan, scene, frame, threads)
    }

    /// The plan of a frame.
    fn plan(&self, scene: &Scene, quality: &Quality, frame: &Frame<'_>) -> FramePlan {
        let is_valid = frame.validate().is_ok() && quality.is_drawable();
        assert!(is_valid, "size or quality out of range");
        FramePlan::new(self.isa, self.kernel, scene, quality, frame)
    }
}

/// Whether all that a frame is made of is in its range.
fn validate(scene: &Scene, quality: &Quality, frame: &Frame<'_>) -> Result<(), Error> {
    frame.validate()?;
    quality.validate()?;
    scene.validate()?;
    Ok(())
}
