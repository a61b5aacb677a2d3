//! Patterns are the same in filled squares, where the object of a pixel is known, as at traced points.

use super::*;
use crate::prepare::ObjectId;
use crate::scene::Pattern;
use crate::show::{self, grid};
use crate::trace::SeenPattern;

/// The size of the picture in pixels.
const SIZE: [usize; 2] = [320, 180];

/// Checkers about as fine as those of the show.
const CHECKERS: Pattern = Pattern {
    waves: Vec3A::splat(2.0),
    depth: 0.7,
    edge: 20.0,
    ..Pattern::NONE
};

struct Patterns;

impl Property for Patterns {
    #[inline(always)]
    fn hold<S: Isa>(&self, simd: S, isa: &str) {
        let mut scene = Box::new(Scene::default());
        let mut prepared = prepared(&scene);
        let (mut seen, mut far) = (0, 0);
        for bar in (0..show::BARS).step_by(3) {
            show::at((bar as f32 + 0.3) * grid::BAR, &mut scene);
            // Marble, too, is seen by pixels if it has edges, and so are spheres with a pattern.
            for block in scene.blocks.iter_mut() {
                let edge = &mut block.material.pattern.edge;
                *edge = edge.max(2.0);
            }
            for sphere in scene.spheres.iter_mut() {
                sphere.material.pattern = CHECKERS;
            }
            prepared.set(&scene, SIZE[0], SIZE[1]);
            for y in 0..SIZE[1] {
                for x in (0..SIZE[0]).step_by(lanes::<S>()) {
                    let columns: I<S> = numbers(simd).bitcast();
                    let columns = columns.to_float::<F<S>>() + x as f32;
                    let rays = Rays {
                        o: Vec3x::splat(simd, prepared.eye),
                        d: primary_directions(simd, &prepared, columns, splat(simd, y as f32)),
                        weight: splat(simd, 1.0),
                        slot_path: Rays::slot_paths(simd, 0),
                    };
                    let hit = hits(simd, &prepared, &rays);
                    let point = shading_point(simd, &prepared, &rays, &hit);
                    for (lane, &object) in hit.object.as_slice().iter().enumerate() {
                        let object = ObjectId::new(object as usize);
                        if !prepared.has_pattern(object) {
                            continue;
                        }
                        let left = point.reflectance.as_slice()[lane];
                        // Wherever it stands among the four.
                        let start = (x + lane).saturating_sub((x + y) % 4);
                        let columns = [0, 1, 2, 3].map(|i| (start + i) as f32);
                        let four: [f32; 4] = SeenPattern::new(&prepared, object)
                            .at([columns, [y as f32; 4]].map(|c| c.simd_into(baseline())))
                            .into();
                        let is_share = |left| (0.0..=1.0).contains(left);
                        assert!(four.iter().all(is_share), "{isa}: {four:?}");
                        seen += 1;
                        far += usize::from((four[x + lane - start] - left).abs() > 1e-3);
                    }
                }
            }
        }
        std::println!("{isa}: {far} of {seen} farther apart than a thousandth");
        assert!(
            seen > 100_000 && far * 1000 < seen,
            "{isa}: {far} of {seen}"
        );
    }
}

#[test]
fn patterns_are_the_same_for_pixels_as_for_points() {
    on_every_instruction_set(&Patterns);
}
