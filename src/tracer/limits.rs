//! The tracer's accuracy: guarantees and known limitations.
//!
//! # Guarantees
//!
//! Tests check these figures on random scenes, with every preset and at 320x240 unless a row differs. Figures in dB are minimums, all
//! others maximums. A pixel is lost if its exhaustive colour differs by more than 32/255 from all drawn pixels up to 2 pixels away.
//!
//! | property | figure |
//! | --- | --- |
//! | objects in direct view, and slits between bars, that an exhaustive frame shows and a preset misses | 0 |
//! | missed shadows of spheres on planes, from point lights, darker by 2/255 or more; except "low lights" below | 0 |
//! | missed images of spheres and boxes in a flat first plane, of 2x2 pixels or more | 0 |
//! | missed highlights in direct view, of 5 pixels or more around the point that mirrors the light | 0 |
//! | largest hole in a bar 1 to 5 pixels wide, in its shadow on a plane from a point light, or in its image in a flat first plane | 3 connected pixels |
//! | largest lost patch of light between bars on a floor without a pattern, from a light without a diameter; `default`, 1280x720 | 8 pixels |
//! | largest lost patch of a patterned floor without objects, `default`, 480x270 | 8 pixels |
//! | largest lost patch of thin things in waves, mirrors and glass, of shadows on objects, and of slits of light, `finest`, 640x360 and 1280x720 | 19 pixels |
//! | lit pixels in the shadow of a sphere or a thin block on a floor, any light, `default` | 0.1 %, in patches of at most 8 |
//! | PSNR to exhaustive, `default`: fields of up to 320 spheres, crowds of 8 to 384 spheres and blocks, patterned floors and solids | 42 dB |
//! | PSNR of exhaustive frames to a reference tracer in f64: the model scene of 24 units, moved by 0, 1e2, 1e3, 1e4 and 1e5 units | 80, 55, 50, 41 and 31 dB |
//! | ... with the eye 1e-7 radii above a sphere; and 5e-7 radii or more above it | 25 and 35 dB |
//! | ... with the eye above a block, at a height of 1e-6 of the block's size | 25 dB |
//! | ... of a sphere that is 10 to 10,000 radii away, seen through a telescope | 40 dB |
//! | PSNR of a scene scaled by 1e-8 to 1e8, to the original | 50 dB |
//! | pixels of mirrors that show themselves, of points in their own shadow, and of light that leaks through a sphere or a block | 0 |
//! | darkening of white objects in uniform white light (a white furnace), at any `depth` and `least_contribution` | 5/255 |
//! | black pixels in facing mirrors, unless the background and the ambient light are black | 0 |
//! | rays of a point, each with one shadow ray per light | `2^(depth + 1) - 1` |
//! | rays of a scene made [invalid](crate::scene::Scene::validate), relative to the same scene while valid | 2.5 times |
//! | frames of an invalid scene by different numbers of threads | equal bits |
//! | traced points with a sun 5e4 and 1e6 units away, relative to the sun 1e3 units away | 1.05 and 1.2 times |
//! | traced points through a telescope from 1e2 and 1e3 times the distance, relative to the view from nearby | 1.3 and 1.75 times |
//!
//! # Known limitations
//!
//! `docs/accuracy.md` has a table and pictures of "Unguarded light".
//!
//! | scene | error |
//! | --- | --- |
//! | reflections except in a flat first plane, and refractions | lost thin things ("Unguarded light"); at `finest` only if the reflected or refracted light has a weight below 0.1 |
//! | shadows on spheres and blocks, and slits of light between such shadows | lost except at `finest` ("Unguarded light") |
//! | low lights above a plane | missed shadows, even wider than a square, if the floor around them is nearly as dark |
//! | lights with a diameter | holes in thin shadows and in slits of light on floors |
//! | slits of light on patterned floors, or at `fastest` | lost patches |
//! | objects wider than 5 pixels, at their own corners or in strips between occluders | holes of up to 8 connected pixels |
//! | the rim of a cylinder's end | points up to 0.087 radii beyond its shadow may count as inside, so the shadow's edge may be lost |
//! | images of cylinders and capsules, and partly covered images, in the first plane | lost patches |
//! | highlights in mirrors, on waves, and on an object around the eye | missed |
//! | highlights on white, and highlights whose centre is hidden, in shadow, on the side away from the light, or beyond the object's edge | missed, for example on the rim of a sphere or the side of a flat cylinder |
//! | glass spheres inside others | 40 dB to exhaustive |
//! | two spheres and six blocks of mirrors and glass | 37 dB to exhaustive |
//! | eyes inside glass, extreme scales, `fastest` | below 42 dB to exhaustive |
//! | coincident surfaces | rounding decides which one a ray hits |
//! | objects and lights that nearly touch a block | missed by secondary rays, so contact shadows have gaps. Rays start 1e-5 S above the block's surface, or 1.2e-7 S if the eye is within 16e-5 S of it; S is the sum of the block's absolute coordinates and half extents |
//! | a light less than 2e-3 radians below the tangent plane at a point of a sphere | lights the point, although the sphere hides it |
//! | radii of spheres, and chords of rays through spheres, below 1e-6 of the sphere's largest coordinate | displaced or missed hits |
//! | coordinates | rounded to a relative 6e-8: keep scenes near the origin |
