use crate::coverage::Coverage;
use crate::picture::{Frame, Probing};
use crate::prepare::{self, VisibleGroups, World};
use crate::quality::Quality;
use crate::scene::camera::pixels;
use crate::scene::{Method, Scene};
use crate::trace::{Batch, Kernel, Tracer};
use fearless_simd::Level;
use glam::Vec2;

/// The largest side of squares in a crowd of mirrors and glass, whose images are narrow.
const CROWD_SQUARE: usize = 4;

pub(crate) struct FramePlan {
    pub isa: Level,
    pub kernel: Kernel,
    /// The effective quality for this scene.
    pub quality: Quality,
    /// In pixels.
    pub size: [usize; 2],
    /// The number of columns, from the left, without the method's overlay.
    pub finished: usize,
    /// See [`Method::coarse`]; below 2 for none.
    pub coarse: usize,
    /// Whether all points of strong mirrors and glass have different keys.
    pub glitters: bool,
    /// In pixels.
    pub offset: Vec2,
    pub probing: Probing,
}

impl FramePlan {
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
            // Squares may be larger than the quality's to reach the coarse size.
            square: if is_coarse {
                let side = 1 << coarse.min(Quality::MAX_SQUARE).ilog2();
                square.max(side)
            } else {
                square
            },
            tolerance_agreeing: quality.tolerance_agreeing * tolerance,
            tolerance_differing: quality.tolerance_differing * tolerance,
            tolerance_side: quality.tolerance_side * tolerance,
            key_weight: quality.key_weight * tolerance * tolerance,
            // Coarse squares and marks keep their hard edges.
            antialias: quality.antialias && !is_coarse && finished > 0,
            edge: quality.edge.max(1),
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

pub(crate) struct Context<'a, O> {
    pub plan: &'a FramePlan,
    pub world: World<'a>,
    pub coverage: &'a Coverage,
    pub observer: O,
}

impl<O> Context<'_, O> {
    pub fn trace(&self, quality: &Quality, seen: VisibleGroups, batch: &mut Batch) {
        let tracer = Tracer {
            isa: self.plan.isa,
            world: self.world,
            quality,
        };
        (self.plan.kernel)(&tracer, seen, batch);
    }
}
