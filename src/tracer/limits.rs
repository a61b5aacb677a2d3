//! The accuracy of the tracer: its limits, their figures, and the tests that check them.
//!
//! # Ranges
//!
//! | what | range | test |
//! | --- | --- | --- |
//! | the numbers of a scene | those that [`Scene::validate`](crate::scene::Scene::validate) accepts | `a_scene_is_refused_by_its_first_number_out_of_range` |
//! | lengths, in scene units | [`MIN_LENGTH`](crate::scene::MIN_LENGTH) to [`MAX_LENGTH`](crate::scene::MAX_LENGTH) | `ends_of_the_ranges_of_lengths_draw_what_they_are` |
//! | sizes in pixels | 1x1 to 3840x2160 | `the_largest_is_right_to_the_last_row_and_column` and others in `tests/image/sizes.rs` |
//! | the eye | outside of a sphere, inside, on its surface, and looking along it | `a_camera_inside_on_and_along_a_sphere_sees_what_the_oracle_sees` |
//! | time in seconds | any; angles have an error of 1e-6 up to 1e6 rad | `any_time_gives_a_picture`, `sines_are_within_a_millionth` |
//!
//! `validate` refuses NaN and infinity. The tracer itself accepts them: the picture is defined, is the same on any number of
//! threads, and takes at most 2.5 times the work of the scene without them
//! (`nan_and_infinity_are_refused_and_still_give_a_picture_for_bounded_work`,
//! `many_spheres_with_invalid_coordinates_give_a_picture`). Such a number affects no other ray than those that meet it. In any
//! scene a point costs at most `2^(depth + 1) - 1` rays, and for each of them one shadow ray per light
//! (`any_case_is_drawn_by_the_same_bits_for_bounded_work`, which `tests/run --soak` runs for ten minutes).
//!
//! # Rays
//!
//! | what | figure | test |
//! | --- | --- | --- |
//! | rays that leave a sphere and hit it again; radii 1e-4 to 1e4, rays from up to 1e8 away | 0 of 500,000 and more | `rays_that_leave_a_sphere_do_not_hit_it_again` |
//! | ... centres up to 1e4 from the origin | 0 of 500,000 and more | `rays_that_leave_a_sphere_far_from_the_origin_do_not_hit_it_again` |
//! | rays that leave a plane and hit it again, along it too | 0 of 500,000 and more | `rays_that_leave_a_plane_do_not_hit_it_again` |
//! | rays into a sphere that miss its far side, except chords shorter than 0.003 radii (at the origin) | 0 | those for spheres |
//! | rays that leave a box, a cylinder or a capsule and hit it again, or that leak out of one; sides 1e-4 to 1e4 | 0 of 100,000 and more | `rays_that_leave_a_block_do_not_hit_it_again_and_those_inside_do_not_leak` |
//! | ... from up to 1e8 away; for aligned boxes, rotated boxes, cylinders and capsules each | 0 of 80,000 and more | `rays_that_leave_a_block_do_not_hit_it_again_however_far_they_came` |
//! | points of a sphere in their own shadow | 0, n.l above 0.003 | `a_sphere_throws_no_shadow_on_its_side_towards_the_lamp` |
//! | lights outside of a sphere that light its inside, and those wholly within that do not, of any size, with blocks or without | 0 | `a_sphere_is_lit_from_within_by_lamps_within_alone` |
//! | length of a reflected or refracted direction, squared; radii 1e-4 to 1e6, indices 0.1 to 10 | 1 to within 5e-7 | `rays_that_leave_a_sphere_of_any_size_are_of_length_one` |
//! | ... 256 roundings about the critical angle | the same, and no light is lost | `rays_at_the_critical_angle_are_of_length_one_and_lose_nothing` |
//! | bits of a ray's result that depend on its lane or on the rays beside it | 0 | `what_comes_of_a_ray_depends_on_no_neighbour` |
//! | ... among boxes, cylinders, capsules, patterns, haze and lights of all kinds, also with invalid numbers | 0 | `what_comes_of_a_ray_depends_on_no_neighbour_where_there_is_more_than_spheres`, `what_comes_of_a_ray_depends_on_no_neighbour_whatever_numbers_make_no_sense` |
//! | PSNR of a scene scaled by 1e-4 to 1e4 against the original | 50 dB | `a_scene_of_any_scale_gives_the_same_picture` |
//! | ... by 1e-8 and 1e8 against the oracle at its own size, which sees them alike | 45 dB | `scene_of_any_size_is_as_the_oracle_sees_it` |
//!
//! All figures that depend on random numbers were checked with 13 seeds on each instruction set. `RAY_SEED=1 cargo test
//! -p eightfold-tracer trace` uses another seed.
//!
//! The reason is that a hit is projected back to its sphere, so that its error is that of rounding the sphere's own coordinates.
//! A ray that starts so close to a sphere counts as starting on it: outward it does not hit the sphere, inward it hits the far
//! side. On a plane a point is exact. No minimal distance of hits is needed, so a scene may have any scale.
//!
//! The next table counts rays that wrongly hit or miss a sphere at a distance of so many radii
//! (`a_small_sphere_far_away_is_hit_where_it_is`). Each cell has three numbers: the wrong rays per million, measured with twelve
//! million rays of sixty seeds; the stated bound on that mean; and the number of wrong rays among 200,000 of one seed that less
//! than one seed in a million exceeds.
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
//! "Anywhere" is up to twice as far from the origin as from the eye. There, the vector from the eye to the centre is already
//! rounded, whatever the instruction set. `PRECISION_SEEDS=60 cargo test -p eightfold-tracer small_sphere_far -- --nocapture`
//! measures again. The error of the distance of a hit is at most 4e-7 of the distance plus 1e-7 radii, except on the outermost
//! tenth of the sphere's disc.
//!
//! In the model scene's picture at 3840x2160, a sphere 1,000 radii away is 5 pixels wide.
//!
//! Coordinates are rounded to 6e-8 of themselves, and so is what lies far from the origin. The tracer does not move a scene to the
//! eye: scenes should be near the origin. The model scene, 24 scene units wide, moved by so many of them has at least this PSNR,
//! in dB, with every pixel traced at 320x240, against an oracle that draws the same moved numbers in f64
//! (`the_further_from_the_origin_the_coarser_a_picture_is_as_stated`):
//!
//! | distance from the origin | PSNR, stated | measured, at 0 and 2.5 s |
//! | ---: | ---: | ---: |
//! | 0 | 80 | 83.7; 85.1 |
//! | 100 | 55 | 78.4; 57.5 |
//! | 1,000 | 50 | 56.2; 52.4 |
//! | 10,000 | 41 | 43.5; 43.0 |
//! | 100,000 | 31 | 33.7; 33.1 |
//!
//! # Squares
//!
//! | what | figure | test |
//! | --- | --- | --- |
//! | objects that are directly visible in a pixel at least, and that a named quality does not show | 0 | `every_object_that_a_pixel_can_show_is_shown`, `boxes_and_cylinders_of_any_size_are_shown`, `every_object_of_the_show_is_shown_at_any_time_and_size`, `whatever_touches_or_rises_by_any_height_is_shown` |
//! | shadows of spheres on planes by point lights that darken a pixel by two steps of 255 at least, of which a named quality has no pixel that is dark | 0, but for what is named below | `every_shadow_that_a_pixel_can_show_is_shown_and_the_bare_rules_miss_some`, `every_shadow_is_shown_however_thin_and_however_near_its_sphere_is_to_the_plane_or_the_lamp` |
//! | pixels of such shadows that the default quality draws lit, and the largest patch of them | 0.4 %, 20 | `few_pixels_of_shadows_are_missed_and_their_patches_are_small` |
//! | pixels of the shadows of blocks that the default quality draws lit; by the sun; of spheres by the sun, a spotlight and a ball | 2.5 %; 0.6 %; 0.6 %, 0.4 % and 0.3 % | `few_pixels_of_shadows_of_blocks_and_by_other_lamps_are_missed` |
//! | pixels of random scenes with an error above 8/255 by the default quality, and the largest patch of them at 320x240 | 5 %, 512 | `wrong_pixels_are_few_and_their_patches_small` |
//! | highlights that five pixels show in the eye's own sight, with the place that mirrors the lamp, and that a named quality does not show: in the scenes of this test | 0, and of what is cut off from that place as `docs/accuracy.md` tells | `every_highlight_that_five_pixels_show_is_shown_and_the_bare_rules_miss_some` |
//! | PSNR of any field of up to 320 spheres by the default quality, 1024x768 | 42 dB | `crowded_pictures_have_42_db` |
//! | PSNR of scenes by chance of 48 to 384 spheres and blocks, a third of them and more mirrors and glass, by the default quality, 640x480 | 42 dB | `crowds_of_mirrors_and_glass_have_42_db` |
//! | PSNR of scenes by chance of 20 spheres and 4 to 64 blocks without mirrors, under lamps of all kinds, by the default quality, 640x480 | 42 dB, but for what is named below | `crowds_without_mirrors_have_42_db` |
//! | images in the first plane that 2x2 pixels show, but of cylinders and capsules, and that a named quality does not show | 0 | `every_image_in_a_plane_that_2x2_pixels_show_is_shown_and_the_bare_rules_miss_some`, `the_image_of_a_single_thing_is_shown_wherever_it_is` |
//! | wrong pixels of small reflections in the first plane, most of them narrower than a square, and the largest patch of them | 1 %, 8 | `reflections_between_corners_are_missed_by_no_more_than_is_stated` |
//! | pixels that change by more than 16/255 from a frame to the next while those of exhaustive frames stay within 4 | counted by `lab bench` | `pixel_that_jumps_beside_its_reference_pops` |
//! | the guard's share of the default quality's time in the model scene | 10 % | none, since it takes a clock: `lab trade` measures it |
//!
//! # Approximations
//!
//! | function | domain | largest error | test |
//! | --- | --- | --- | --- |
//! | `pow(x, h)` | x 1e-6 to 1.001, h 1 to 1000 | 1e-6 + 1.2e-7 h \|log2 x\|, relative | `powers_are_as_exact_as_stated` |
//! | `sin`, `cos` | to 1e6 rad | 1e-6 | `sines_are_within_a_millionth` |
//! | `root_below(x, h)` | x 1e-4 to 1, h 1 to 1000 | 0 to 20 % below | `roots_are_below_by_a_fifth_at_most` |
//! | one Newton step that normalises a direction | directions after a reflection | 5e-7 of the squared length | `rays_that_leave_a_sphere_of_any_size_are_of_length_one` |
//!
//! Roots and quotients are correctly rounded: fast approximations differ between manufacturers.
//!
//! # What is not promised
//!
//! - Coincident surfaces, such as two planes at the same height: rounding decides which one is hit.
//! - Chords of a sphere so short that rounding hides them, see above: the ray passes by.
//! - All shadows between the corners of squares. The guard looks for those on planes, and for light between them. Of the shadows of
//!   spheres by point lights each that reaches a pixel has one that is right, and that pixel may be as dark without the shadow: a lamp low
//!   above a plane lights a patch of few pixels, and the corner that tells of the shadow may lie beside the patch. Then all that is seen of
//!   the shadow can be missed (`a_shadow_may_be_shown_where_it_makes_no_difference`, where it darkens a pixel by 13 steps). In a lamp so
//!   bright that a shadow is seen wherever it falls none was missed. Of other shadows on planes few are missed.
//! - Shadows on spheres and blocks, and slits of light between these: of 1,000 scenes by chance without mirrors two are below 42 dB for a
//!   bright slit on a block's face, 41.0 dB (`PROPTEST_CASES=200 cargo test --test image crowds_without -- --include-ignored`).
//! - Images in the first plane beside others that cover a part of them: a corner that is in the outlines of both counts as showing
//!   both.
//! - Highlights in mirrors, on waves, and those that are seen from within a sphere, a cylinder or a capsule. Of a highlight a part
//!   of which is hidden, in shadow, on the object's own dark side, beyond an edge of a face, or on what is white without it: that
//!   part which does not hold the place that mirrors the lamp. A corner tells of the object that it shows, not of the face, nor
//!   whether the lamp lights it: so a slit of light between shadows, the lit rim of a sphere, or the narrow side of a flat cylinder
//!   can lose all its highlight, whatever its length.
//! - Reflections between the corners of squares but in the first plane without waves, and refractions: the guard does not look
//!   for them.
//! - The position of hits on a sphere whose radius is below the rounding error of its coordinates, about 1e-6 of the largest. No ray that
//!   leaves it hits it again, though.
