//! The renderer.

#[cfg(feature = "std")]
mod boxed;
mod memory;
mod schedule;
#[cfg(feature = "std")]
mod scoped;
mod threads;

#[cfg(feature = "std")]
pub use boxed::BoxedMemory;
pub use memory::Memory;
#[cfg(feature = "std")]
pub use scoped::ScopedThreads;
pub use threads::{Job, Threads};

use crate::counts::Counts;
use crate::observe::Observer;
use crate::picture::{Error, Frame};
use crate::plan::FramePlan;
use crate::quality::Quality;
use crate::refine::Kernels;
use crate::scene::Scene;
use core::borrow::BorrowMut;
use fearless_simd::Level;
#[cfg(target_arch = "x86_64")]
use fearless_simd::x86::Avx2;

/// Renders frames, with one instruction set and one [`Memory`].
///
/// # Measuring the error of a frame
///
/// The [probes](Frame::with_probes) of several frames estimate the accuracy:
///
/// ```
/// # use eightfold_tracer::glam::{Vec3, vec3};
/// # use eightfold_tracer::scene::{Light, Material, Scene, Sphere};
/// use eightfold_tracer::{Frame, Probes, Quality, Renderer, ScopedThreads};
///
/// # let mut scene = Scene::default();
/// # scene.lights.push(Light::default());
/// # for x in [-0.4, 0.0, 0.4] {
/// #     scene.spheres.push(Sphere::new(vec3(x, 0.0, 0.0), 0.3, Material::matt(Vec3::ONE, 0.8)));
/// # }
/// let mut pixels = [0; 160 * 120];
/// let (mut renderer, mut threads) = (Renderer::detect(), ScopedThreads::new());
/// let mut probes = Probes::NONE;
/// for number in 0..30 {
///     scene.camera.eye.x = number as f32 / 60.0;
///     let frame = Frame::new(160, 120, &mut pixels).with_probes(2000, number);
///     probes += renderer.render(&scene, &Quality::DEFAULT, frame, &mut threads)?.probes;
/// }
/// println!("{:.1} ± {:.1} dB to exhaustive", probes.psnr(), probes.margin());
/// assert!(probes.psnr() > 30.0 && probes.margin() < 3.0);
/// # Ok::<(), eightfold_tracer::Error>(())
/// ```
pub struct Renderer<#[cfg(feature = "std")] M = BoxedMemory, #[cfg(not(feature = "std"))] M> {
    pub(crate) kernels: Kernels,
    memory: M,
}

#[cfg(feature = "std")]
impl Renderer {
    /// Returns a renderer for an instruction set, with its own memory.
    ///
    /// [`Level::baseline`] is the program's own instruction set.
    #[must_use]
    pub fn new(level: Level) -> Self {
        Self::with_memory(level, BoxedMemory::new())
    }

    /// Returns a renderer for the best instruction set of this CPU, with its own memory.
    #[must_use]
    pub fn detect() -> Self {
        Self::new(Level::new())
    }
}

impl<M: BorrowMut<Memory>> Renderer<M> {
    /// Returns a renderer for an instruction set with the caller's memory.
    #[must_use]
    pub fn with_memory(level: Level, memory: M) -> Self {
        Self { kernels: Kernels::widest(level), memory }
    }

    /// Returns a renderer that uses at most AVX2. If a program makes no other renderer, the linker
    /// leaves out the AVX-512 kernel of 16 kB.
    #[doc(hidden)]
    #[must_use]
    pub fn narrow(level: Level, memory: M) -> Self {
        Self { kernels: Kernels::narrow(level), memory }
    }

    /// Returns a renderer that uses AVX2. If a program makes no other renderer, the linker leaves
    /// out all other kernels.
    #[cfg(target_arch = "x86_64")]
    #[doc(hidden)]
    #[must_use]
    pub fn avx2(simd: Avx2, memory: M) -> Self {
        Self { kernels: Kernels::avx2(simd), memory }
    }

    /// Renders a frame, and returns its work.
    ///
    /// # Errors
    /// If the frame's size, stride or number of pixels, or a number of the quality, the scene or
    /// its presentation is out of range. Pixels stay unchanged.
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

    /// Renders a frame like [`Renderer::render`], and reports its points and squares, except points
    /// of antialiasing, to an observer.
    ///
    /// # Errors
    /// Like [`Renderer::render`].
    pub fn render_observed<O: Observer>(
        &mut self,
        scene: &Scene,
        quality: &Quality,
        frame: Frame<'_>,
        threads: &mut dyn Threads,
        observer: O,
    ) -> Result<Counts, Error> {
        validate(scene, quality, &frame)?;
        let plan = plan(scene, quality, &frame);
        let memory = self.memory.borrow_mut();
        Ok(memory.render_observed(self.kernels, &plan, scene, frame, threads, observer))
    }

    /// Renders a frame without checking the scene. An invalid scene gives some picture, in bounded
    /// time, see [`limits`](crate::limits).
    ///
    /// # Panics
    /// If the frame's size, stride or number of pixels, or the quality's
    /// [`square`](Quality::square) or [`depth`](Quality::depth), is out of range.
    pub fn render_valid(
        &mut self,
        scene: &Scene,
        quality: &Quality,
        frame: Frame<'_>,
        threads: &mut dyn Threads,
    ) -> Counts {
        let plan = plan(scene, quality, &frame);
        let memory = self.memory.borrow_mut();
        memory.render(self.kernels, &plan, scene, frame, threads)
    }
}

fn plan(scene: &Scene, quality: &Quality, frame: &Frame<'_>) -> FramePlan {
    let is_valid = frame.validate().is_ok() && quality.is_drawable();
    assert!(is_valid, "size or quality out of range");
    FramePlan::new(scene, quality, frame)
}

fn validate(scene: &Scene, quality: &Quality, frame: &Frame<'_>) -> Result<(), Error> {
    frame.validate()?;
    quality.validate()?;
    scene.validate()?;
    Ok(frame.presentation.validate()?)
}
