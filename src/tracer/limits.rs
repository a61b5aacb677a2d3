//! The tracer's accuracy: guarantees and known limitations.
//!
//! # Guarantees
//!
//! Tests check these figures on random scenes, with every preset and at 320x240 unless a row
//! differs. Figures in dB are minimums, all others maximums. A pixel is lost if its exhaustive
//! colour differs by more than 32/255 from all drawn pixels up to 2 pixels away.
//!
//! | property | figure |
//! | --- | --- |
//! | objects in direct view, and slits between bars, that a preset misses | 0 |
//! | missed shadows of spheres on planes, from point lights, darker by 2/255 or more; except "low lights" below | 0 |
//! | missed images of spheres and boxes in a flat first plane, of 2x2 pixels or more | 0 |
//! | missed highlights in direct view, of 5 pixels or more around the point that mirrors the light | 0 |
//! | holes in a bar 1 to 5 pixels wide, its shadow on a plane from a point light, its image in a flat first plane | 3 connected pixels |
//! | lost patches of light between bars, on a plain floor, from a light without a diameter: `default`, 1280x720 | 8 pixels |
//! | lost patches of patterned floors without objects: `default`, 480x270 | 8 pixels |
//! | lost patches of slits of light, shadows on objects, thin things in waves, mirrors and glass: `finest`, to 1280x720 | 19 pixels |
//! | lit pixels in shadows of spheres and thin blocks on floors, from any light: `default` | 0.1 %, in patches of 8 |
//! | fields of up to 320 spheres, crowds of up to 384 spheres and blocks, patterned floors and solids: `default` | 42 dB to exhaustive |
//! | exhaustive frames of the model scene of 24 units, moved by 0, 1e2, 1e3, 1e4 and 1e5 units | 80, 55, 50, 41 and 31 dB to f64 |
//! | scenes scaled by 1e-8 to 1e8 | 50 dB to the original |
//! | pixels where mirrors show themselves, points in their own shadow, light that leaks through a solid | 0 |
//! | rays of a point, each with one shadow ray per light | `2^(depth + 1) - 1` |
//! | rays of a scene made [invalid](crate::scene::Scene::validate), relative to the same scene while valid | 2.5 times |
//!
//! # Known limitations
//!
//! `docs/unguarded.png` shows the first two rows; `docs/accuracy.md`, "Unguarded light", has their
//! figures.
//!
//! | scene | error |
//! | --- | --- |
//! | reflections except in a flat first plane, and refractions | lost thin things; at `finest` only in light multiplied by less than 0.1 |
//! | shadows on spheres and blocks, and slits of light between such shadows | lost except at `finest` |
//! | low lights above a plane | missed shadows, even wider than a square, if the floor around them is nearly as dark |
//! | lights with a diameter | holes in thin shadows and in slits of light on floors |
//! | slits of light on patterned floors, or at `fastest` | lost patches |
//! | objects wider than 5 pixels, at their own corners or in strips between occluders | holes of up to 8 connected pixels |
//! | the rim of a cylinder's end | lost edges of its shadow: points up to 0.087 radii outside may count as inside |
//! | images of cylinders and capsules, and partly covered images, in the first plane | lost patches |
//! | highlights in mirrors, on waves, on white, and on an object around the eye | missed |
//! | highlights whose centre is hidden, shadowed, turned from the light, or off the object | missed, for example on a sphere's rim |
//! | glass spheres inside others | 40 dB to exhaustive |
//! | two spheres and six blocks of mirrors and glass | 37 dB to exhaustive |
//! | eyes inside glass, extreme scales, `fastest` | below 42 dB to exhaustive |
//! | coincident surfaces | rounding decides which one a ray hits |
//! | objects and lights that nearly touch a block | missed by rays that start there: gaps in contact shadows |
//! | a light less than 2e-3 radians below the tangent plane at a point of a sphere | lights the point, although the sphere hides it |
//! | radii of spheres, and chords through them, below 1e-6 of the sphere's largest coordinate | displaced or missed hits |
//! | coordinates | rounded to a relative 6e-8: keep scenes near the origin |
//!
//! Rays start 1e-5 S above a block's surface, or 1.2e-7 S if the eye is within 16e-5 S of it. S is
//! the sum of the block's absolute coordinates and half extents.
