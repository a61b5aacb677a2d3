//! The common ground of a frame's phases: how it is drawn, what it shows, and who listens.

use crate::coverage::Coverage;
use crate::picture::{Frame, Probing};
use crate::prepare::{self, VisibleGroups, World};
use crate::quality::Quality;
use crate::scene::camera::pixels;
use crate::scene::{Method, Scene};
use crate::trace::{Batch, Kernel, Tracer};
use fearless_simd::Level;
use glam::Vec2;

/// The largest squares of scenes with a crowd of mirrors and glass: strips of images in them are as narrow there as the crowd is dense.
const CROWD_SQUARE: usize = 4;

/// How a frame is drawn: all that is settled before its first band.
pub(crate) struct FramePlan {
    /// The instruction set.
    pub isa: Level,
    /// The function that traces points by it.
    pub kernel: Kernel,
    /// The caller's quality as far as the scene leaves it: the only one that the phases ask.
    pub quality: Quality,
    /// The width and the height of the picture in pixels.
    pub size: [usize; 2],
    /// How many columns of pixels, from the left, are finished: without marks of the method.
    pub finished: usize,
    /// The side in pixels up to which squares are filled with one colour, see [`Method::coarse`]: below 2, none are.
    pub coarse: usize,
    /// Whether no two points of a strong mirror or glass have one key, since a crowd of them shows each other.
    pub glitters: bool,
    /// How far samples are off the centres of their pixels, in pixels.
    pub offset: Vec2,
    /// Which pixels are probed.
    pub probing: Probing,
}

impl FramePlan {
    /// The plan of a frame of a scene, by a quality that the caller asks for.
    pub fn new(
        isa: Level,
        kernel: Kernel,
        scene: &Scene,
        quality: &Quality,
        frame: &Frame<'_>,
    ) -> Self {
        let size = [frame.width, frame.height];
        let method = &scene.method;
        let finished = if *method == Method::PLAIN {
            size[0]
        } else {
            ((method.front * pixels(size[0])) as usize).min(size[0])
        };
        let coarse = method.coarse as usize;
        let is_coarse = coarse >= 2;
        let tolerance = scene.film.tolerance;
        let glitters = quality.key_weight > 0.0 && prepare::is_crowd(scene);
        let square = if glitters {
            quality.square.min(CROWD_SQUARE)
        } else {
            quality.square
        };
        let quality = Quality {
            // The largest squares are as large as the coarse ones.
            square: if is_coarse {
                let side = 1 << coarse.min(Quality::MAX_SQUARE).ilog2();
                square.max(side)
            } else {
                square
            },
            tolerance_agreeing: quality.tolerance_agreeing * tolerance,
            tolerance_differing: quality.tolerance_differing * tolerance,
            tolerance_side: quality.tolerance_side * tolerance,
            // Coarse squares have edges, which stay, and so do those of marks.
            antialias: quality.antialias && !is_coarse && finished > 0,
            ..*quality
        };
        Self {
            isa,
            kernel,
            quality,
            size,
            finished,
            coarse,
            glitters,
            offset: frame.offset,
            probing: frame.probing,
        }
    }
}

/// The context that all phases of a frame work in.
pub(crate) struct Context<'a, O> {
    pub plan: &'a FramePlan,
    pub world: World<'a>,
    pub coverage: &'a Coverage,
    /// Hears how the frame comes about.
    pub observer: O,
}

impl<O> Context<'_, O> {
    /// Traces a batch's points with all their rays by a quality; the primary rays and their reflections meet none but the groups `seen`.
    pub fn trace(&self, quality: &Quality, seen: VisibleGroups, batch: &mut Batch) {
        let tracer = Tracer {
            isa: self.plan.isa,
            world: self.world,
            quality,
        };
        (self.plan.kernel)(&tracer, seen, batch);
    }
}
