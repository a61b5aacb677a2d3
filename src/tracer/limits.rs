//! The tracer's accuracy in figures. Tests check every one.
//!
//! # Ranges
//!
//! [`Scene::validate`](crate::scene::Scene::validate) checks all ranges and rejects NaN and infinity. If you draw an invalid scene,
//! its picture has the same bits on any number of threads, takes at most 2.5 times the work of the valid scene, and differs only
//! where rays meet the invalid number. Pictures have 1x1 to 3840x2160 pixels. The eye may be outside, inside or on a sphere, and
//! look along its surface. A point takes at most `2^(depth + 1) - 1` rays, each with one shadow ray per light.
//!
//! # Rays
//!
//! | error | figure |
//! | --- | --- |
//! | pixels of single mirrors in which a sphere, a box, a cylinder or a capsule shows itself; sides 1e-4 to 1e4 | 0 of 20,000,000 |
//! | rays that leave such a solid and hit it again, or leak out of one | 0 of 3,000,000 |
//! | points of a sphere in their own shadow, where n.l is above 0.01 | 0 |
//! | lights outside a sphere that light its inside, and lights wholly inside that do not | 0 |
//! | darkest channel of a furnace with white background and ambient light: surfaces that lose no light, any depth and least contribution | 250 |
//! | black pixels in facing mirrors, unless background and ambient light are black | 0 |
//! | PSNR to an oracle in f64 from an eye 5e-7 to 1e-5 radii above a sphere, two balls between, a light at 3 and 10 times the height | 35 dB |
//! | the same, 1e-6 of the size above a single box, cylinder or capsule | 25 dB |
//! | the same of a sphere seen through a telescope, from 10 to 10,000 radii away | 40 dB |
//! | bits of a traced point that depend on its lane or on other points, even invalid ones | 0 |
//! | PSNR of a scene scaled by 1e-8 to 1e8 against the original | 50 dB |
//!
//! A hit is projected back to its sphere, so its error is the rounding of the sphere's coordinates. A ray that starts within this
//! error misses the sphere if it goes outward, and hits the far side if inward. If the eye is within two such errors of a sphere, about
//! 2.4e-6 radii, all rays from the eye and from other objects are instead classified in f64. Points on a plane are exact. Hits have no minimal
//! distance, so a scene may have any scale.
//!
//! Coordinates have a relative error of 6e-8, so keep scenes near the origin. The model scene, 24 units wide, has this PSNR in dB
//! at 320x240, every pixel traced, against an oracle that draws the same scene in f64:
//!
//! | distance from the origin | PSNR, at least | measured, at 0 and 2.5 s |
//! | ---: | ---: | ---: |
//! | 0 | 80 | 83.7; 85.1 |
//! | 100 | 55 | 78.4; 57.5 |
//! | 1,000 | 50 | 56.2; 52.4 |
//! | 10,000 | 41 | 43.5; 43.0 |
//! | 100,000 | 31 | 33.7; 33.1 |
//!
//! # Squares
//!
//! Random scenes at a named quality, at 320x240 unless a size is given.
//!
//! | error | figure |
//! | --- | --- |
//! | missed objects that a pixel shows directly | 0 |
//! | missed shadows of spheres on planes from point lights that darken a pixel by 2/255, except as below | 0 |
//! | holes of 4 connected pixels or more in objects 1 to 5 pixels wide, their shadows on a plane from a point light, and their images in the first plane, jagged or antialiased | 0 |
//! | lost patches of 9 pixels or more (no pixel within 2 is alike within 32/255) of a plain floor lit between bars by a point light, a sun or a spotlight, at `default`, jagged, 1280x720 | 0 of 600 scenes (`finest`, `faster`: 0 of 180) |
//! | missed images in the first plane of spheres and boxes that show in 2x2 pixels | 0 |
//! | missed highlights, seen directly, of five pixels and more around the point that mirrors the light | 0 |
//! | pixels of shadows of spheres and thin blocks on a floor that the default quality draws lit, from a point light, a sun, a spotlight or an area light, and their largest patch | 0.1 %, 8 |
//! | patches of 20 pixels at `finest` (connected pixels that differ by more than 32/255 from all drawn pixels within 2 pixels) in bars and nets in wavy water, mirror walls, mirror balls and behind glass, their shadows on balls, boxes and patterned walls, and strips of light on stairs and shelves; 200 scenes of each kind at 640x360, 40 at 1280x720 | 0 |
//! | dB to exhaustive, default quality: any field of up to 320 spheres, 1024x768 | 42 dB |
//! | the same: crowds of 8 or 48 to 384 spheres and blocks, a third or more of them mirrors and glass, 640x480, except as below | 42 dB |
//! | the same: crowds of 20 spheres and 4 to 64 blocks without mirrors, 640x480, except as below | 42 dB |
//! | the same: floors, spheres and blocks with patterns of any kind, edges of 0.5 to 40, warp to 3, with and without waves, near and far, 480x270 | 42 dB |
//! | missed spots and veins of such patterns on floors without shapes, of 9 pixels and more | 0 |
//!
//! # Approximations
//!
//! | function | domain | largest error |
//! | --- | --- | --- |
//! | `pow(x, h)` | x 1e-6 to 1.001, h 1 to 1000 | 1e-6 + 1.2e-7 h \|log2 x\|, relative |
//! | `sin`, `cos` | to 1e6 rad | 1e-6 |
//! | `root_below(x, h)` | x 1e-4 to 1, h 1 to 1000 | 0 to 20 % below |
//! | Newton step that normalises a direction | after a reflection | 5e-7 of the squared length |
//!
//! Square roots and quotients are correctly rounded, since fast approximations differ between CPUs.
//!
//! # Known limitations
//!
//! - Coincident surfaces: rounding decides which one a ray hits.
//! - Chords of a sphere shorter than the rounding error: the ray misses.
//! - Shadows between corners. The guard tests shadows on planes, and light between them. A point light low above a plane may light
//!   only a few pixels: a corner in a sphere's shadow can then be as dark without the shadow, and even a shadow wider than a square
//!   can be missed. Bright lights cause no misses. Other shadows on planes are rarely missed.
//! - Holes of up to 8 connected pixels in wider objects, at a corner or in a narrow strip between occluders; and holes in thin
//!   shadows from lights with a diameter, whose soft edges are unguarded.
//! - Lights and eyes far away: bounds widen with rounding, so frames are right but slow. In scenes of words, nets, ropes and grass
//!   `default` traces 6 % of the pixels by a light 5 units away, 13 % at 5,000 (a sun), 52 % at 50,000; with a telescope 8 % at 60
//!   units and 54 % at 6,000.
//! - Light between bars on floors with patterns, at `fastest`, and from lights with a diameter. Where the end of a cylinder or capsule
//!   meets its side, a thirteenth of its radius counts as dark in a shadow.
//! - Shadows on spheres and blocks, and slits of light between these, except at `finest`: two of 1,000 crowds without mirrors have
//!   41.0 dB, because of a bright slit on a block's face.
//! - Images of cylinders and capsules in the first plane, and partly covered images: a corner inside two outlines counts as showing
//!   both. Thin bright or dark strips in these images, in slits of light on blocks, and in waves: patches of up to 54 pixels.
//! - dB to exhaustive of other scenes: 40.7 for eight glass spheres with others inside, 37.3 for two spheres and six blocks of
//!   mirrors and glass, 35.5 for coincident faces; less for an eye inside glass, extreme scales and the fastest quality.
//! - Highlights in mirrors, on waves, or seen from inside a sphere, a cylinder or a capsule; and highlights whose centre, the point
//!   that mirrors the light, is hidden, in shadow, on the dark side, beyond an edge, or on a white surface. A corner identifies its
//!   object, but neither face nor light: a slit of light between shadows, the lit rim of a sphere, or the narrow side of a flat
//!   cylinder can lose its highlight, whatever its length.
//! - Contact shadows and coincident faces on blocks: rays leave a block 1e-5 of its coordinates and size above its surface, or 1.2e-7
//!   if the eye is nearer than 16 times the former. Lights and objects nearer to the surface than that are beyond it.
//! - Light from below the horizon of a sphere by less than 2e-3 radians: it passes the sphere, whose shadow is smaller by the hit error.
//! - Refractions, and reflections in anything but a first plane without waves, except at `finest`: they are unguarded. Other presets
//!   lose thin things there, at `default` a bar's whole image: `docs/accuracy.md` has a table and a picture of each kind. `finest`
//!   traces each pixel with such light of a tenth or more; fainter images can have holes.
//! - The position of hits on a sphere with a radius below the rounding error, about 1e-6 of its largest coordinate. Rays that leave
//!   it still never hit it again.
