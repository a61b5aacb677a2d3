//! The tracer's accuracy: guarantees and known limitations.
//!
//! # Guarantees
//!
//! Tests check these figures on random scenes, by every preset, at 320x240 unless a row differs. A PSNR in dB is a minimum, any other figure
//! a maximum.
//!
//! | property | figure |
//! | --- | --- |
//! | missed features of an exhaustive frame: objects in direct view | 0 |
//! | ... shadows of spheres on planes from point lights, if darker by 2/255; "low lights" below are an exception | 0 |
//! | ... images of spheres and boxes in a flat first plane, from 2x2 pixels on | 0 |
//! | ... highlights in direct view, from 5 pixels on, around the point that mirrors the light | 0 |
//! | the largest hole in bars 1 to 5 pixels wide, in their shadows on a plane from a point light, and in their images in a flat first plane | 3 connected pixels |
//! | the largest lost patch of a plain floor lit between bars by a light without a diameter, `default`, 1280x720; a pixel is lost if no pixel within 2 pixels is within 32/255 | 8 pixels |
//! | ... of patterned floors without objects, `default`, 480x270 | 8 pixels |
//! | ... of thin things in waves, mirrors, glass, shadows on objects and slits of light, `finest`, 640x360 and 1280x720 | 19 pixels |
//! | lit pixels in shadows of spheres and thin blocks on a floor, any light, `default` | 0.1 %, in patches of at most 8 |
//! | PSNR to exhaustive, `default`: fields of up to 320 spheres; crowds of 8 to 384 spheres and blocks; patterned floors and solids | 42 dB |
//! | PSNR to a reference tracer in f64, exhaustive: model scene of 24 units moved 0; 100; 1,000; 10,000; 100,000 units from the origin | 80; 55; 50; 41; 31 dB |
//! | ... the eye 1e-7; from 5e-7 radii above a sphere; 1e-6 of its size above a block | 25; 35; 25 dB |
//! | ... a sphere 10 to 10,000 radii away in a telescope | 40 dB |
//! | PSNR of a scene scaled by 1e-8 to 1e8 to the original | 50 dB |
//! | mirrors that show themselves, points in their own shadow, and light that leaks through a sphere, box, cylinder or capsule | 0 pixels |
//! | darkening of a white furnace, any depth and least contribution | 5/255 |
//! | black pixels in facing mirrors, unless background and ambient light are black | 0 |
//! | rays of a point; each has one shadow ray per light | `2^(depth + 1) - 1` |
//! | rays of an [invalid](crate::scene::Scene::validate) scene, relative to the valid one; its picture has the same bits on any number of threads | 2.5 |
//! | points of a scene by a sun 50,000; 1,000,000 units away, relative to 1,000 units | 1.05; 1.2 |
//! | ... from 100; 1,000 times the distance, in a telescope | 1.3; 1.75 |
//!
//! # Known limitations
//!
//! `docs/accuracy.md` has the table "Unguarded light" with a picture of each kind, `docs/unguarded.png`.
//!
//! | scene | error |
//! | --- | --- |
//! | reflections except in a flat first plane, and refractions | all presets except `finest` lose thin things ("Unguarded light"); `finest` loses light fainter than a tenth |
//! | shadows on spheres and blocks, slits of light between them | lost except at `finest` ("Unguarded light") |
//! | low lights above a plane | a shadow wider than a square can be missed, if the floor around it is nearly as dark |
//! | lights with a diameter | holes in thin shadows, and in slits of light on floors |
//! | slits of light on patterned floors, or at `fastest` | lost patches |
//! | wider objects, at a corner or in a strip between occluders | holes of up to 8 connected pixels |
//! | the edge of a cylinder's or capsule's end | a shadow can be too wide by a thirteenth of the radius |
//! | images of cylinders and capsules, and partly covered images, in the first plane | lost patches |
//! | highlights in mirrors, on waves, inside an object | missed |
//! | highlights whose centre is hidden, in shadow, on the dark side, beyond an edge, or on white | missed, also on the rim of a sphere or the side of a flat cylinder |
//! | glass spheres inside others; two spheres and six blocks of mirrors and glass | 40; 37 dB to exhaustive |
//! | eyes inside glass, extreme scales, `fastest` | below 42 dB to exhaustive |
//! | coincident surfaces | rounding decides which one a ray hits |
//! | objects and lights nearer to a block than 1e-5 of its coordinates and size (1.2e-7 if the eye is within 16 times that distance) | they are beyond its surface: contact shadows have gaps |
//! | light from less than 2e-3 radians below the horizon of a sphere | it passes the sphere |
//! | spheres with a radius below 1e-6 of their largest coordinate, chords shorter than that | displaced or missed hits |
//! | coordinates | rounded to 6e-8: keep scenes near the origin |
