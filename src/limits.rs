//! How far the tracer can be trusted: each limit, its figure, and the test that holds it.
//!
//! # Ranges
//!
//! | what | takes | held by |
//! | --- | --- | --- |
//! | a scene's numbers | what [`Scene::validate`](crate::scene::Scene::validate) says | `a_scene_is_refused_by_its_first_number_out_of_range` |
//! | lengths, in scene units | [`MIN_LENGTH`](crate::scene::MIN_LENGTH) to [`MAX_LENGTH`](crate::scene::MAX_LENGTH) | `ends_of_the_ranges_of_lengths_draw_what_they_are` |
//! | sizes in pixels | 1x1 to 3840x2160 | `the_largest_is_right_to_the_last_row_and_column` and others in `tests/image/sizes.rs` |
//! | the eye | outside of a sphere, inside, on it and along it | `a_camera_inside_on_and_along_a_sphere_sees_what_the_oracle_sees` |
//! | time in seconds | any; angles are right to 1e-6 up to 1e6 rad | `any_time_gives_a_picture`, `sines_are_within_a_millionth` |
//!
//! A number that is none, or infinite, is refused by `validate`. The tracer itself takes it: the picture is defined, the
//! same on any number of threads, and at most 2.5 times the work of the scene without it
//! (`nan_and_infinity_are_refused_and_still_give_a_picture_for_bounded_work`, `many_spheres_with_invalid_coordinates_give_a_picture`).
//! What such numbers make of a ray is that ray's own: see the lanes below.
//! Whatever the scene, a point costs at most `2^(depth + 1) - 1` rays and as many times the lights in shadow rays
//! (`any_case_is_drawn_by_the_same_bits_for_bounded_work`, which `tests/run --soak` draws for ten minutes).
//!
//! # Rays
//!
//! | what | figure | held by |
//! | --- | --- | --- |
//! | rays that leave a sphere and hit it again; radii 1e-4 to 1e4, rays from up to 1e8 away | 0 of 500,000 and more | `rays_that_leave_a_sphere_do_not_hit_it_again` |
//! | ... centres up to 1e4 from the origin | 0 of 500,000 and more | `rays_that_leave_a_sphere_far_from_the_origin_do_not_hit_it_again` |
//! | rays that leave a plane and hit it again, along it too | 0 of 500,000 and more | `rays_that_leave_a_plane_do_not_hit_it_again` |
//! | rays into a sphere that miss its far side, but for chords of less than 0.003 radii (in the origin) | 0 | the same as of spheres |
//! | rays that leave a box or a cylinder and hit it again, or leak out of it; sides 1e-4 to 1e4 | 0 of 100,000 and more | `rays_that_leave_a_block_do_not_hit_it_again_and_those_inside_do_not_leak` |
//! | ... from up to 1e8 away; boxes along the axes, turned ones and cylinders each | 0 of 80,000 and more | `rays_that_leave_a_block_do_not_hit_it_again_however_far_they_came` |
//! | points of a sphere in their own shadow | 0, n.l above 0.003 | `a_sphere_throws_no_shadow_on_its_side_towards_the_lamp` |
//! | lamps that shine through the sphere they are outside of | 0 | `a_sphere_is_lit_from_within_by_lamps_within_alone` |
//! | length of a reflected or refracted direction, squared; radii 1e-4 to 1e6, indices 0.1 to 10 | 1 to within 5e-7 | `rays_that_leave_a_sphere_of_any_size_are_of_length_one` |
//! | ... 256 roundings about the critical angle | the same, and no light is lost | `rays_at_the_critical_angle_are_of_length_one_and_lose_nothing` |
//! | bits of a ray that depend on its lane, or on the rays beside it | 0 | `what_comes_of_a_ray_depends_on_no_neighbour` |
//! | ... among boxes, cylinders, patterns, haze and lamps of all kinds, and where any of their numbers makes no sense | 0 | `what_comes_of_a_ray_depends_on_no_neighbour_where_there_is_more_than_spheres`, `what_comes_of_a_ray_depends_on_no_neighbour_whatever_numbers_make_no_sense` |
//! | a scene 1e-4 to 1e4 times as large against itself | 50 dB | `a_scene_of_any_scale_gives_the_same_picture` |
//!
//! Every figure here that chance could break held with 13 seeds, by each instruction set; `RAY_SEED=1 cargo test --release
//! --lib trace` draws another one.
//!
//! How that is: a hit is taken back to its sphere, which leaves rounding of the scale of the sphere's own coordinates, and a
//! ray that starts that near a sphere starts on it: on its way out it hits nothing of it, on its way in the far side. On a
//! plane a point is exact. There is no distance below which hits do not count, and so no scale that a scene must have.
//!
//! Rays that are wrong about a sphere so many radii away, that hit it where they should pass by or the other way round
//! (`a_small_sphere_far_away_is_hit_where_it_is`). Three numbers each: of a million as measured with twelve million rays
//! of sixty seeds; of a million on average, at most; and what less than one seed in a million exceeds with its 200,000:
//!
//! | distance | in the origin, AVX2 and AVX-512 | in the origin, SSE2 | anywhere |
//! | ---: | ---: | ---: | ---: |
//! | 1 | 1.7; 3; 7 | 2.2; 4; 8 | 2.4; 5; 9 |
//! | 10 | 0; 1; 5 | 0.1; 1; 5 | 0.1; 1; 5 |
//! | 100 | 0; 1; 5 | 0.2; 1; 5 | 1.1; 2.5; 7 |
//! | 1,000 | 0.1; 1; 5 | 0; 1; 5 | 8.6; 12; 13 |
//! | 10,000 | 0; 1; 5 | 0.1; 1; 5 | 89; 100; 45 |
//! | 100,000 | 13; 16; 15 | 14; 20; 17 | 890; 930; 254 |
//! | 1,000,000 | 1,322; 1,400; 363 | 1,556; 1,650; 420 | 9,490; 9,700; 2,153 |
//!
//! Anywhere is up to twice as far from the origin as from the eye: there, the way from the eye to the centre is rounded
//! before any set starts. `PRECISION_SEEDS=60 cargo test --release --lib small_sphere_far -- --nocapture` measures again.
//! The distance of a hit is right to 4e-7 of itself and 1e-7 radii, but for the outermost tenth of the sphere.
//!
//! In the model scene's picture at 3840x2160, a sphere 1,000 radii away is 5 pixels wide.
//!
//! # Squares
//!
//! | what | figure | held by |
//! | --- | --- | --- |
//! | objects that the eye sees directly, in a pixel at least, and a named quality does not show | 0 | `every_object_that_a_pixel_can_show_is_shown`, `boxes_and_cylinders_of_any_size_are_shown`, `every_object_of_the_show_is_shown_at_any_time_and_size` |
//! | shadows of spheres on planes, by lamps that are points, that a pixel shows and a named quality does not | 0 | `every_shadow_that_a_pixel_can_show_is_shown_and_the_bare_rules_miss_some` |
//! | pixels of such shadows that are lit, by the default quality, and the largest patch of them | 0.4 %, 20 | `few_pixels_of_shadows_are_missed_and_their_patches_are_small` |
//! | pixels more than 8 of 255 off in scenes by chance, by the default quality, and the largest patch of them at 320x240 | 5 %, 512 | `wrong_pixels_are_few_and_their_patches_small` |
//! | pixels of small reflections that are missed, most narrower than a square, and the largest patch of them | 35 %, 90 | `reflections_between_corners_are_missed_by_no_more_than_is_stated` |
//! | blocks of 8x8 pixels whose mean error jumps by more than 8 of 255 from a frame to the next | counted by `lab bench` | `an_error_that_comes_and_goes_flickers` |
//! | what the guard takes of the default quality's time, in the model scene | 10 % | `lab bench --unguarded`; a clock holds no test |
//!
//! # Approximations
//!
//! | function | domain | largest error | held by |
//! | --- | --- | --- | --- |
//! | `pow(x, h)` | x 1e-6 to 1.001, h 1 to 1000 | 1e-6 + 1.2e-7 h \|log2 x\|, relative | `powers_are_as_exact_as_stated` |
//! | `sin`, `cos` | to 1e6 rad | 1e-6 | `sines_are_within_a_millionth` |
//! | `root_below(x, h)` | x 1e-4 to 1, h 1 to 1000 | 0 to 20 % below | `roots_are_below_by_a_fifth_at_most` |
//! | one Newton step to a direction's length | what reflection leaves of it | 5e-7 of the square | `rays_that_leave_a_sphere_of_any_size_are_of_length_one` |
//!
//! Roots and quotients are the processor's exact ones: its fast ones differ from maker to maker.
//!
//! # What is not promised
//!
//! - Surfaces that lie in each other, two planes of one height, or two spheres that are the same: which one is hit is decided
//!   by rounding.
//! - Chords of a sphere so short that rounding hides them, see above: a ray passes by.
//! - Shadows between the corners of squares, but for those of spheres on planes by lamps that are points.
//! - Reflections, and what is seen through glass, between the corners of squares: no guard looks for them.
//! - A sphere smaller than the rounding of its own coordinates, less than 1e-6 of the largest: where it is hit is up to
//!   rounding, but no ray that leaves it hits it again.
