use crate::fold::Fold;
use crate::maths::to_f32;
use crate::picture::{Frame, Probing};
use crate::presentation::{Method, Presentation};
use crate::quality::Quality;
use crate::scene::Scene;
use glam::Vec2;

pub(crate) struct FramePlan {
    /// The effective quality, see [`Quality::in_scene`].
    pub quality: Quality,
    /// In pixels.
    pub size: [usize; 2],
    /// The number of columns, from the left, without the method's overlay.
    pub finished: usize,
    /// See [`Method::coarse`]; below 2 for none.
    pub coarse: usize,
    pub method: Method,
    pub fold: Fold,
    /// In pixels.
    pub offset: Vec2,
    pub probing: Probing,
}

impl FramePlan {
    pub fn new(scene: &Scene, quality: &Quality, frame: &Frame<'_>) -> Self {
        let size = [frame.width, frame.height];
        let Presentation { method, sectors, .. } = frame.presentation;
        let finished = if *method == Method::PLAIN {
            size[0]
        } else {
            ((method.front * to_f32(size[0])) as usize).min(size[0])
        };
        let coarse = method.coarse as usize;
        let fold = Fold::new(*sectors, &scene.camera, size);
        // Coarse squares and marks keep their hard edges.
        let is_antialiased = coarse < 2 && finished > 0;
        let quality = if is_antialiased { *quality } else { quality.jagged() };
        let quality = quality.in_scene(scene).coarser(coarse).with_positive_edge();
        Self {
            quality,
            size,
            finished,
            coarse,
            method: *method,
            fold,
            offset: frame.offset + fold.offset,
            probing: frame.probing,
        }
    }
}
