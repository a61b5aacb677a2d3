use crate::fold::Fold;
use crate::maths::to_f32;
use crate::picture::{Frame, Probing};
use crate::prepare;
use crate::quality::Quality;
use crate::scene::{Method, Presentation, Scene};
use glam::Vec2;

/// The largest side of squares in a crowd of mirrors and glass, whose images are narrow.
const CROWD_SQUARE: usize = 4;

pub(crate) struct FramePlan {
    pub quality: Quality,
    /// In pixels.
    pub size: [usize; 2],
    /// The number of columns, from the left, without the method's overlay.
    pub finished: usize,
    /// See [`Method::coarse`]; below 2 for none.
    pub coarse: usize,
    pub method: Method,
    pub fold: Fold,
    /// Whether all points of strong mirrors and glass have different keys.
    pub glitters: bool,
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
        let glitters = quality.key_weight > 0.0 && prepare::is_crowd(scene);
        let square = if glitters { quality.square.min(CROWD_SQUARE) } else { quality.square };
        let quality = Quality {
            square,
            // Coarse squares and marks keep their hard edges.
            antialias: quality.antialias && coarse < 2 && finished > 0,
            edge: quality.edge.max(1),
            ..*quality
        }
        .coarser(coarse);
        Self {
            quality,
            size,
            finished,
            coarse,
            method: *method,
            fold,
            glitters,
            offset: frame.offset + fold.offset,
            probing: frame.probing,
        }
    }
}
