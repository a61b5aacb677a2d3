//! The accuracy of the tracer: figures, and the conditions under which they hold. Tests check every figure.
//!
//! # Ranges
//!
//! | what | range |
//! | --- | --- |
//! | numbers of a scene | the ranges that [`Scene::validate`](crate::scene::Scene::validate) checks |
//! | lengths in scene units | [`MIN_LENGTH`](crate::scene::MIN_LENGTH) to [`MAX_LENGTH`](crate::scene::MAX_LENGTH) |
//! | size in pixels | 1x1 to 3840x2160 |
//! | eye | outside a sphere, inside, on its surface, and looking along it |
//! | angles from a time | an error of 1e-6 up to 1e6 rad |
//!
//! `validate` refuses NaN and infinity. The tracer accepts them: the picture is defined, has the same bits on any number of
//! threads, and takes at most 2.5 times the work of the scene without them. Such a number affects only the rays that meet it. In any
//! scene a point costs at most `2^(depth + 1) - 1` rays, and each of them one shadow ray per light.
//!
//! # Rays
//!
//! | what | figure |
//! | --- | --- |
//! | rays that leave a sphere and hit it again; radii 1e-4 to 1e4, centres up to 1e4 from the origin, rays from up to 1e8 away | 0 of 500,000 |
//! | rays that leave a plane and hit it again, along it too | 0 of 500,000 |
//! | pixels of single mirrors in which a box, a cylinder or a capsule shows itself: a ray carries the block that it leaves | 0 of 20,000,000 |
//! | rays that leave a box, a cylinder or a capsule and hit it again, or leak out of one; sides 1e-4 to 1e4 | 0 of 100,000 |
//! | the same from up to 1e8 away, for aligned boxes, rotated boxes, cylinders and capsules each | 0 of 60,000 |
//! | rays into a sphere that miss its far side, except chords shorter than 0.003 radii (at the origin) | 0 |
//! | points of a sphere in their own shadow, where n.l is above 0.003 | 0 |
//! | lights outside a sphere that light its inside, and lights wholly within that do not | 0 |
//! | squared length of a reflected or refracted direction; radii 1e-4 to 1e6, indices 0.1 to 10, also at the critical angle | 1 to within 5e-7 |
//! | bits of a ray's result that depend on its lane or on the rays beside it, also with invalid numbers | 0 |
//! | PSNR of a scene scaled by 1e-4 to 1e4 against the original | 50 dB |
//! | PSNR of a scene scaled by 1e-8 and 1e8 against the oracle at its own size | 45 dB |
//!
//! Figures that depend on random numbers were checked with 13 seeds on each instruction set. `RAY_SEED=1 cargo test -p
//! eightfold-tracer trace` uses another seed.
//!
//! A hit is projected back to its sphere, so its error is the rounding of the sphere's own coordinates. A ray that starts this close
//! to a sphere counts as starting on it: outward it does not hit the sphere, inward it hits the far side. On a plane a point is exact.
//! There is no minimal distance of hits, so a scene may have any scale.
//!
//! The next table counts rays that wrongly hit or miss a sphere, by the distance in radii. Each cell has three numbers: the wrong rays
//! per million, measured with twelve million rays of sixty seeds; the bound on that mean; and the count of wrong rays among
//! 200,000 of one seed that fewer than one seed in a million exceeds.
//!
//! | distance | sphere at the origin, AVX2 and AVX-512 | at the origin, SSE2 | anywhere |
//! | ---: | ---: | ---: | ---: |
//! | 1 | 1.7; 3; 7 | 2.2; 4; 8 | 2.4; 5; 9 |
//! | 10 | 0; 1; 5 | 0.1; 1; 5 | 0.1; 1; 5 |
//! | 100 | 0; 1; 5 | 0.2; 1; 5 | 1.1; 2.5; 7 |
//! | 1,000 | 0.1; 1; 5 | 0; 1; 5 | 8.6; 12; 13 |
//! | 10,000 | 0; 1; 5 | 0.1; 1; 5 | 89; 100; 45 |
//! | 100,000 | 13; 16; 15 | 14; 20; 17 | 890; 930; 254 |
//! | 1,000,000 | 1,322; 1,400; 363 | 1,556; 1,650; 420 | 9,490; 9,700; 2,153 |
//!
//! "Anywhere" is up to twice as far from the origin as from the eye. There the vector from the eye to the centre is already
//! rounded, whatever the instruction set. `PRECISION_SEEDS=60 cargo test -p eightfold-tracer small_sphere_far -- --nocapture`
//! measures again. The error of the distance of a hit is at most 4e-7 of the distance plus 1e-7 radii, except on the outermost
//! tenth of the sphere's disc. In the model scene's picture at 3840x2160, a sphere 1,000 radii away is 5 pixels wide.
//!
//! Coordinates are rounded to 6e-8 of themselves. The tracer does not move a scene to the eye: keep scenes near the origin. The model
//! scene, 24 scene units wide, moved away from the origin has this PSNR in dB, with every pixel traced at 320x240, against an oracle
//! that draws the same moved numbers in f64:
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
//! Random scenes by a named quality; where a picture's size matters, at 320x240.
//!
//! | what | figure |
//! | --- | --- |
//! | objects that a pixel shows directly and the quality misses | 0 |
//! | shadows of spheres on planes by points of light that darken a pixel by two steps of 255 and that the quality misses, except as below | 0 |
//! | holes of 4 connected pixels or more in things 1 to 5 pixels wide, in their shadows on a plane by a point of light, and in their images in the first plane, jagged or antialiased | 0 |
//! | images in the first plane of spheres and boxes that 2x2 pixels show and the quality misses | 0 |
//! | highlights in the eye's own sight that five pixels show together with the place that mirrors the light, and that the quality misses | 0 |
//! | pixels of shadows of spheres that the default quality draws lit, and the largest patch of them | 0.4 %, 20 |
//! | the same by a sun, a spotlight and a ball | 0.6 %, 0.4 % and 0.3 % |
//! | the same of thin blocks, by a point and by a sun | 2.5 % and 0.6 % |
//! | wrong pixels of small reflections of spheres in the first plane, and the largest patch of them | 0.3 %, 8 |
//! | pixels with an error above 8/255 by the default quality, and the largest patch of them | 5 %, 512 |
//! | PSNR of any field of up to 320 spheres by the default quality, 1024x768 | 42 dB |
//! | PSNR of crowds of 48 to 384 spheres and blocks, a third of them and more mirrors and glass, by the default quality, 640x480 | 42 dB |
//! | PSNR of crowds of 20 spheres and 4 to 64 blocks without mirrors, by the default quality, 640x480, except as below | 42 dB |
//! | PSNR of floors, spheres and blocks with patterns of any kind, edges of 0.5 to 10, near and far, by the default quality, 480x270 | 42 dB |
//! | the guard's share of the default quality's time in the model scene (`lab trade` measures it) | 10 % |
//!
//! # Approximations
//!
//! | function | domain | largest error |
//! | --- | --- | --- |
//! | `pow(x, h)` | x 1e-6 to 1.001, h 1 to 1000 | 1e-6 + 1.2e-7 h \|log2 x\|, relative |
//! | `sin`, `cos` | to 1e6 rad | 1e-6 |
//! | `root_below(x, h)` | x 1e-4 to 1, h 1 to 1000 | 0 to 20 % below |
//! | one Newton step that normalises a direction | directions after a reflection | 5e-7 of the squared length |
//!
//! Roots and quotients are correctly rounded: fast approximations differ between manufacturers.
//!
//! # What is not promised
//!
//! - Coincident surfaces, such as two planes at the same height: rounding decides which one is hit.
//! - Chords of a sphere shorter than the rounding error above: the ray passes by.
//! - Some shadows between the corners of squares. The guard looks for shadows on planes, and for light between them. For each shadow of
//!   a sphere by a point of light one corner is right, but this corner may be as dark without the shadow: a light low above a plane
//!   lights a patch of few pixels, and the corner may lie beside the patch. Then the quality can miss a shadow that is wider than a
//!   square. By a light so bright that a shadow is seen wherever it falls it misses none. Of other shadows on planes it misses few.
//! - Holes in wider things: a corner of one, and a narrow strip that others leave of one, can lose connected pixels; 8 were seen.
//!   Thin shadows by area lights have soft edges, which are not looked for.
//! - Shadows on spheres and blocks, and slits of light between these: of 1,000 crowds without mirrors two are below 42 dB for a
//!   bright slit on a block's face, 41.0 dB.
//! - Images in the first plane of cylinders and capsules, and images that others cover in part: a corner in the outlines of both
//!   counts as showing both.
//! - 42 dB for other scenes than in the table above: crowds of glass in glass have 38.8 dB, images of mirrors in mirrors 40.3 dB, faces
//!   that coincide 39.0 dB; an eye inside glass, extreme scales and the fastest quality have less.
//! - Thin bright or dark strips in such images, in slits of light on blocks, and in waves: the show has patches of up to 229 pixels.
//! - Highlights in mirrors, on waves, and from within a sphere, a cylinder or a capsule. Parts of a highlight without the place that
//!   mirrors the light: the rest is hidden, in shadow, on the object's dark side, beyond an edge, or on a white surface. A
//!   corner names the object that it shows, not the face, nor whether the light lights it: a slit of light between shadows, the lit rim
//!   of a sphere, or the narrow side of a flat cylinder can lose its highlight, whatever its length.
//! - Reflections elsewhere than in the first plane without waves, and refractions: the guard does not look for them.
//! - The position of hits on a sphere whose radius is below the rounding error of its coordinates, about 1e-6 of the largest. Still,
//!   no ray that leaves it hits it again.
