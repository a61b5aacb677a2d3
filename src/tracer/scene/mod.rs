//! The scene description: camera, shapes, materials, lights and captions.
//!
//! Units are in [the crate's conventions](crate#conventions).

mod ambience;
mod block;
pub(crate) mod camera;
mod film;
mod list;
mod method;
mod overlay;
mod pattern;
#[cfg(feature = "serde")]
mod serial;
mod softbox;
mod validate;
mod waves;

pub use ambience::Ambience;
pub use block::Block;
pub use camera::{Camera, Raster};
pub use film::Film;
pub use list::{CapacityError, List};
pub use method::Method;
pub use overlay::Caption;
pub use pattern::Pattern;
pub use softbox::Softbox;
pub use validate::{MAX_LENGTH, MIN_LENGTH};
pub use waves::Waves;

use crate::range_error::{Checked, Range, RangeError};
use core::f32::consts::PI;
use glam::{Mat3, Vec3, Vec3A};
use validate::{EXTENT, LENGTH, POINT, SHARE};

/// The maximum number of spheres. The show uses up to 71.
pub const MAX_SPHERES: usize = 320;
/// The maximum number of planes.
pub const MAX_PLANES: usize = 8;
/// The maximum number of blocks: boxes, cylinders and capsules.
pub const MAX_BLOCKS: usize = 128;
pub(crate) const MAX_SOLIDS: usize = MAX_SPHERES + MAX_BLOCKS;
/// The maximum number of lights.
pub const MAX_LIGHTS: usize = 4;

/// The maximum number of softboxes.
pub const MAX_SOFTBOXES: usize = 3;

/// The maximum number of captions. The show uses one at a time.
pub const MAX_CAPTIONS: usize = 10;
/// The maximum number of letters in a caption. The longest of the show has 32.
pub const MAX_LETTERS: usize = 32;

/// The content of a frame.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(default, deny_unknown_fields))]
pub struct Scene {
    /// The viewpoint.
    pub camera: Camera,
    /// The colour of the background at the horizon and below, 0 to 1e9 in each channel.
    pub background: Vec3,
    /// The zenith's colour minus `background`, which may be negative; the sum is 0 to 1e9 in each channel. Its weight for a ray
    /// whose direction, of length 1, rises by y is `y (2 - y)`.
    pub sky: Vec3,
    /// The density of the haze in 1 / scene units, 0 to 1000. A surface at the distance t has the weight `1 / (1 + (haze t)^2)`;
    /// the background has the rest.
    pub haze: f32,
    /// The fall of the haze with height in 1 / scene units, 0 to 1000: at the height y above 0, its density is
    /// `haze / (1 + haze_fall y)^2`.
    pub haze_fall: f32,
    /// The share of the first light's colour that sky and haze scatter, 0 to 1. In a direction at an angle with the cosine c from
    /// the direction of the light's position, its weight is `c^8`, or 0 from 90 degrees on.
    pub scatter: f32,
    /// The factor on all light of the picture, 0 to 11.
    pub exposure: f32,
    /// The conversion of light to the picture's colours.
    pub film: Film,
    /// The ambient light on all surfaces, or from above, see [`Ambience`]; 0 to 1e9 in each channel.
    pub ambient: Vec3,
    /// The occlusion of ambient light, and the ambient light from below.
    pub ambience: Ambience,
    /// Whether rays beyond [`Quality::depth`](crate::Quality::depth) and
    /// [`Quality::least_contribution`](crate::Quality::least_contribution) are black, as in the 2008 thesis. Softboxes
    /// are black, too.
    pub black_beyond: bool,
    /// The number of sectors of a kaleidoscope, 1, 2, 4 or 8, rounded down: 1 for none, 2 for a picture that is mirrored left and right, 4
    /// for one that is also mirrored up and down, 8 for one that is also mirrored along diagonals.
    ///
    /// The centre is in the middle, at 46 % of the height; the picture moves up and left by up to 8 pixels, so that it is the corner of a
    /// square. Only a part is traced: with 8 sectors, the wedge from the line to the right to the diagonal to the lower right, or in narrow
    /// pictures the wedge from there to the line downwards. The rest copies its pixels. Captions are not mirrored.
    pub sectors: f32,
    /// The overlay that explains the rendering method.
    pub method: Method,
    /// The spheres, in any order.
    pub spheres: List<Sphere, MAX_SPHERES>,
    /// The planes: horizontal rectangles.
    pub planes: List<Plane, MAX_PLANES>,
    /// The waves on the first plane.
    pub water: Waves,
    /// The boxes, cylinders and capsules.
    pub blocks: List<Block, MAX_BLOCKS>,
    /// The lights.
    pub lights: List<Light, MAX_LIGHTS>,
    /// The lights beyond the scene that only mirrors and glass show.
    pub softboxes: List<Softbox, MAX_SOFTBOXES>,
    /// Text over the picture.
    pub captions: List<Caption, MAX_CAPTIONS>,
}

impl Default for Scene {
    fn default() -> Self {
        Self::EMPTY
    }
}

impl Scene {
    /// Unused memory of lists is zero.
    const EMPTY: Self = {
        let material = Material { exponent: 0.0, index: 0.0, ..Material::BLACK };
        let block =
            Block { axes: Mat3::ZERO, ..Block::new(Shape::Box, Vec3::ZERO, Vec3::ZERO, material) };
        Self {
            camera: Camera::STANDARD,
            background: Vec3::ZERO,
            sky: Vec3::ZERO,
            haze: 0.0,
            haze_fall: 0.0,
            scatter: 0.0,
            exposure: 1.0,
            film: Film::PLAIN,
            ambient: Vec3::ZERO,
            ambience: Ambience::UNIFORM,
            black_beyond: false,
            sectors: 1.0,
            method: Method::PLAIN,
            spheres: List::over(Sphere::new(Vec3::ZERO, 0.0, material)),
            planes: List::over(Plane::new(Vec3::ZERO, 0.0, 0.0, material)),
            water: Waves::CALM,
            blocks: List::over(block),
            lights: List::over(Light::DARK),
            softboxes: List::over(Softbox::ZERO),
            captions: List::over(Caption::ZERO),
        }
    };

    /// All zeros, for a `static` scene that takes no space in an executable file. It is invalid.
    pub const ZEROED: Self = Self {
        camera: Camera { eye: Vec3::ZERO, up: Vec3::ZERO, field_of_view: 0.0, ..Camera::STANDARD },
        exposure: 0.0,
        sectors: 0.0,
        method: Method { picture: 0.0, ..Method::PLAIN },
        ..Self::EMPTY
    };

    pub(crate) fn solids(&self) -> usize {
        self.spheres.len() + self.blocks.len()
    }
}

/// A surface that reflects light by Phong's model, and reflects and transmits rays.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(default, deny_unknown_fields))]
pub struct Material {
    /// The colour, 0 to 1e9 in each channel. Above 1 it amplifies light.
    pub colour: Vec3,
    /// The diffuse coefficient, 0 to 1.
    pub kd: f32,
    /// The specular coefficient, 0 to 1.
    pub ks: f32,
    /// The exponent of highlights, 1 to 1000.
    pub exponent: f32,
    /// The tint of highlights by the surface's colour, from 0 for plastic to 1 for metal. Mirror images keep their colours.
    pub metallic: f32,
    /// The spread of highlights by grooves in circles around the object's own y axis (vertical for spheres and planes), 0 to 1. The
    /// cosine of Phong's model is `1 - d.d / 2`, where d is the difference between the directions of the light and of the mirrored
    /// ray; the square of d's part across the grooves is multiplied by `1 - anisotropy`. 1 is close to the thread model (Kajiya and
    /// Kay: Rendering Fur with Three Dimensional Textures, SIGGRAPH 1989).
    pub anisotropy: f32,
    /// The weight of the reflected ray, 0 to 1.
    pub kr: f32,
    /// The increase of reflection at grazing angles, from 0 to 1 (a polished surface), by Schlick's approximation. At an angle with
    /// the cosine c, `f = fresnel (1 - c)^5` changes the reflected weight to `kr + f (1 - kr)`, and the transmitted one to
    /// `kt (1 - f)`.
    pub fresnel: f32,
    /// The weight of the transmitted ray, 0 to 1. Above 0 the surface is transparent.
    pub kt: f32,
    /// The mean thickness of a thin film, such as a soap bubble's, in nm, 0 to 10,000; 0 for none. A film reflects no traced ray, but
    /// the light of untraced ones: the brighter of background and ambient light, and softboxes.
    ///
    /// At an angle with the cosine c, the factor on red, green and blue light of the wavelengths w = 610, 540 and 455 nm is
    /// `sin^2(2 pi n D t / w)` with n = 1.33 and `t = sqrt(1 - (1 - c^2) / n^2)`; parabolas replace the sine. At the height h above the
    /// centre of a sphere, in radii, the film is `D = (1 - 0.8 h) film_thickness` thick; on other shapes, `film_thickness`.
    pub film_thickness: f32,
    /// The refractive index of the inside relative to the outside, 0.1 to 10.
    pub index: f32,
    /// The colour of the object's shadow from lights with a [`Light::diameter`], 0 to 1 in each channel; black for a full shadow.
    pub tint: Vec3,
    /// The texture.
    pub pattern: Pattern,
}

impl Default for Material {
    fn default() -> Self {
        Self::BLACK
    }
}

impl Material {
    /// Black, without highlights, reflection or transmission.
    pub const BLACK: Self = Self {
        colour: Vec3::ZERO,
        kd: 0.0,
        ks: 0.0,
        exponent: 1.0,
        metallic: 0.0,
        anisotropy: 0.0,
        kr: 0.0,
        fresnel: 0.0,
        kt: 0.0,
        film_thickness: 0.0,
        index: 1.0,
        tint: Vec3::ZERO,
        pattern: Pattern::NONE,
    };

    /// Returns a diffuse material.
    #[must_use]
    pub const fn matt(colour: Vec3, kd: f32) -> Self {
        Self { colour, kd, ..Self::BLACK }
    }

    /// Returns a black mirror.
    #[must_use]
    pub const fn mirror(kr: f32) -> Self {
        Self { kr, ..Self::BLACK }
    }

    /// Returns clear glass with a refractive index, 0.1 to 10: 1.5 for window glass.
    #[must_use]
    pub const fn glass(index: f32) -> Self {
        let root = (index - 1.0) / (index + 1.0);
        let kr = root * root;
        Self {
            ks: 0.5,
            exponent: 200.0,
            kr,
            fresnel: 1.0,
            kt: 1.0 - kr,
            index,
            tint: Vec3::splat(1.0 - kr),
            ..Self::BLACK
        }
    }

    /// Returns polished metal with tinted highlights.
    #[must_use]
    pub const fn metal(colour: Vec3) -> Self {
        Self { colour, kd: 0.4, ks: 0.9, exponent: 40.0, metallic: 1.0, kr: 0.25, ..Self::BLACK }
    }

    /// Returns the material with a texture.
    #[must_use]
    pub const fn with_pattern(self, pattern: Pattern) -> Self {
        Self { pattern, ..self }
    }

    /// Returns whether the material may reflect or transmit rays; true for invalid weights. Glass reflects at angles of total
    /// reflection even if `kr` is 0.
    #[must_use]
    pub fn is_specular(&self) -> bool {
        [self.kr, self.fresnel, self.kt] != [0.0; 3]
    }

    pub(super) fn check(&self, of: Checked) -> Result<(), RangeError> {
        of.field("material.colour", self.colour, LENGTH)?;
        of.field("material.kd", self.kd, SHARE)?;
        of.field("material.ks", self.ks, SHARE)?;
        of.field("material.exponent", self.exponent, Range(1.0, 1000.0, "1 to 1000"))?;
        of.field("material.metallic", self.metallic, SHARE)?;
        of.field("material.anisotropy", self.anisotropy, SHARE)?;
        of.field("material.kr", self.kr, SHARE)?;
        of.field("material.fresnel", self.fresnel, SHARE)?;
        of.field("material.kt", self.kt, SHARE)?;
        let thickness = Range(0.0, 1e4, "0 to 10000");
        of.field("material.film_thickness", self.film_thickness, thickness)?;
        of.field("material.index", self.index, Range(0.1, 10.0, "0.1 to 10"))?;
        of.field("material.tint", self.tint, SHARE)?;
        self.pattern.check(of)
    }
}

/// A sphere. Shadow rays treat it as hollow: a light wholly inside illuminates its inside, and the outside only through
/// [`Material::tint`].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(deny_unknown_fields))]
pub struct Sphere {
    /// The centre in scene units, coordinates up to [`MAX_LENGTH`].
    pub centre: Vec3,
    /// The radius in scene units, [`MIN_LENGTH`] to [`MAX_LENGTH`].
    pub radius: f32,
    /// The surface.
    pub material: Material,
}

impl Sphere {
    /// Returns a sphere.
    #[must_use]
    pub const fn new(centre: Vec3, radius: f32, material: Material) -> Self {
        Self { centre, radius, material }
    }

    pub(super) fn check(&self, of: Checked) -> Result<(), RangeError> {
        of.field("centre", self.centre, POINT)?;
        of.field("radius", self.radius, EXTENT)?;
        self.material.check(of)
    }
}

/// A horizontal rectangle, visible from both sides. It casts a black shadow, whatever its `tint`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(deny_unknown_fields))]
pub struct Plane {
    /// The centre in scene units, coordinates up to [`MAX_LENGTH`].
    pub centre: Vec3,
    /// Half the extent along x in scene units, [`MIN_LENGTH`] to [`MAX_LENGTH`].
    pub half_x: f32,
    /// Half the extent along z, in the same range.
    pub half_z: f32,
    /// The surface.
    pub material: Material,
}

impl Plane {
    /// Returns a rectangle.
    #[must_use]
    pub const fn new(centre: Vec3, half_x: f32, half_z: f32, material: Material) -> Self {
        Self { centre, half_x, half_z, material }
    }

    pub(super) fn check(&self, of: Checked) -> Result<(), RangeError> {
        of.field("centre", self.centre, POINT)?;
        of.field("half_x", self.half_x, EXTENT)?;
        of.field("half_z", self.half_z, EXTENT)?;
        self.material.check(of)
    }
}

/// The shape of a [`Block`].
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Shape {
    /// A box.
    #[default]
    Box,
    /// A cylinder along the block's own y axis, with flat ends.
    Cylinder,
    /// A cylinder along the block's own y axis with a half sphere at each end.
    Capsule,
}

/// A light whose brightness does not fall off with distance.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(default, deny_unknown_fields))]
pub struct Light {
    /// The position in scene units, coordinates up to [`MAX_LENGTH`].
    pub position: Vec3,
    /// The colour times the brightness, 0 to 1e9 in each channel.
    pub colour: Vec3,
    /// The radius of the visible light, [`MIN_LENGTH`] to [`MAX_LENGTH`]; 0 makes it invisible. Lights cast no shadows, and haze
    /// does not dim them.
    pub drawn_radius: f32,
    /// Whether the rays are nearly parallel: `position`, `diameter`, `glow` and `core` are multiplied by [`Light::FAR`], and the light is
    /// invisible.
    pub parallel: bool,
    /// The diameter for shadows, 0 to [`MAX_LENGTH`]. Above 0, solids cast penumbrae, and an object's `tint` colours its shadow.
    /// At 0 shadows are hard and black.
    pub diameter: f32,
    /// The radius of the glow, 0 to [`MAX_LENGTH`]. A ray through the position sees the light's colour, a ray at this distance half
    /// of it; far away the glow falls off with the squared distance. An object hides the glow behind it. The glow of a parallel
    /// light is the sun's disc.
    pub glow: f32,
    /// The radius of a sphere from which the glow's distances count, 0 to [`MAX_LENGTH`]: the rim of air around a planet with this
    /// radius and centre, or a corona. The glow is then as bright as the light where the ray is nearest to the position: a
    /// spotlight's cone, with its `aim` towards the sun, restricts it to the sun's side.
    pub core: f32,
    /// The cone of a spotlight; `None` shines in all directions.
    pub spot: Option<Spot>,
}

/// A white light above and to the left of the default camera.
impl Default for Light {
    fn default() -> Self {
        Self::new(Vec3::new(-2.0, 3.0, 2.0), Vec3::ONE)
    }
}

impl Light {
    /// The factor on lengths of parallel lights: across a scene as wide as the distance to `position`, rays differ in direction by
    /// at most 0.001 radians.
    pub const FAR: f32 = 1000.0;

    /// Black and invisible.
    pub const DARK: Self = Self {
        position: Vec3::ZERO,
        colour: Vec3::ZERO,
        drawn_radius: 0.0,
        parallel: false,
        diameter: 0.0,
        glow: 0.0,
        core: 0.0,
        spot: None,
    };

    /// Returns an invisible point light.
    #[must_use]
    pub const fn new(position: Vec3, colour: Vec3) -> Self {
        Self { position, colour, ..Self::DARK }
    }

    /// Returns a sun in the direction of `position` from the origin.
    #[must_use]
    pub const fn sun(position: Vec3, colour: Vec3) -> Self {
        Self { parallel: true, ..Self::new(position, colour) }
    }

    /// Returns a spotlight, see [`Spot::new`].
    #[must_use]
    pub const fn spotlight(position: Vec3, aim: Vec3, outer_angle: f32, colour: Vec3) -> Self {
        Self { spot: Some(Spot::new(aim, outer_angle)), ..Self::new(position, colour) }
    }

    pub(crate) fn far(&self) -> f32 {
        if self.parallel { Self::FAR } else { 1.0 }
    }

    pub(crate) fn shadow_position(&self) -> Vec3A {
        Vec3A::from(self.position) * self.far()
    }

    pub(crate) fn shadow_diameter(&self) -> f32 {
        self.diameter * self.far()
    }

    pub(crate) fn glow_radius(&self) -> f32 {
        self.glow * self.far()
    }

    /// Returns the upper limit of a penumbra's width at its occluder: for parallel rays, whose penumbrae grow without end, the
    /// width at four times the distance of `position`.
    pub(crate) fn max_penumbra(&self) -> f32 {
        if self.parallel { 4.0 * self.diameter } else { self.diameter }
    }

    /// Returns whether the light has neither a diameter nor a cone, and is not parallel.
    pub(crate) fn is_point(&self) -> bool {
        self.diameter == 0.0 && !self.parallel && self.spot.is_none()
    }

    pub(super) fn check(&self, of: Checked) -> Result<(), RangeError> {
        let is_drawable = self.drawn_radius == 0.0 || EXTENT.holds(self.drawn_radius);
        of.field("position", self.position, POINT)?;
        of.field("colour", self.colour, LENGTH)?;
        of.rule("drawn_radius", self.drawn_radius, is_drawable, "0 or 1e-9 to 1e9")?;
        of.field("diameter", self.diameter, LENGTH)?;
        of.field("glow", self.glow, LENGTH)?;
        of.field("core", self.core, LENGTH)?;
        self.spot.map_or(Ok(()), |spot| spot.check(of))
    }
}

/// The cone of a spotlight, with a soft edge.
///
/// Between the angles the brightness is `s^2 (3 - 2 s)`, where s rises linearly with the cosine of the angle.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(default, deny_unknown_fields))]
pub struct Spot {
    /// The direction of the light, of any length above 0.
    pub aim: Vec3,
    /// The angle from `aim` in radians up to which the brightness is 1, at least 0 and below `outer_angle`.
    pub inner_angle: f32,
    /// The angle from `aim` in radians from which the brightness is 0, up to pi.
    pub outer_angle: f32,
}

/// Points down, with an outer angle of 30 degrees.
impl Default for Spot {
    fn default() -> Self {
        Self::new(Vec3::NEG_Y, PI / 6.0)
    }
}

impl Spot {
    /// Returns a cone whose inner angle is three quarters of the outer one.
    #[must_use]
    pub const fn new(aim: Vec3, outer_angle: f32) -> Self {
        Self { aim, inner_angle: 0.75 * outer_angle, outer_angle }
    }

    pub(super) fn check(&self, of: Checked) -> Result<(), RangeError> {
        let is_aimed = self.aim.normalize_or_zero() != Vec3::ZERO;
        let is_narrower = 0.0 <= self.inner_angle && self.inner_angle < self.outer_angle;
        let angle = Range(0.0, PI, "0 to pi");
        of.field("spot.aim", self.aim, POINT)?;
        of.rule("spot.aim", self.aim, is_aimed, "longer than 0")?;
        of.field("spot.outer_angle", self.outer_angle, angle)?;
        of.rule(
            "spot.inner_angle",
            self.inner_angle,
            is_narrower,
            "at least 0 and below outer_angle",
        )
    }
}
