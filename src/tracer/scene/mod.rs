//! The scene description: a camera, spheres, planes, boxes, cylinders and capsules with their materials, lights, captions and copper
//! bars.
//!
//! Coordinates are right-handed with y up. Lengths are in scene units, angles in radians, colours in linear RGB with 1 as the
//! brightest that is shown. [`Scene::validate`] checks that every number is in the range that its documentation gives.

mod block;
pub(crate) mod camera;
mod film;
mod list;
mod method;
mod overlay;
mod pattern;
#[cfg(feature = "serde")]
mod serial;
mod validate;
mod waves;

pub use block::Block;
pub use camera::Camera;
pub use film::Film;
pub use list::{CapacityError, List};
pub use method::Method;
pub use overlay::{Caption, CopperBar};
pub use pattern::Pattern;
pub use validate::{MAX_LENGTH, MIN_LENGTH};
pub use waves::Waves;

use crate::range_error::{Checked, Range, RangeError};
use core::f32::consts::PI;
use glam::{Mat3, Vec3, Vec3A};
use validate::{EXTENT, LENGTH, POINT, SHARE};

/// The most spheres in a scene. The show uses up to 256.
pub const MAX_SPHERES: usize = 320;
/// The most planes in a scene.
pub const MAX_PLANES: usize = 8;
/// The most blocks in a scene: boxes, cylinders and capsules.
pub const MAX_BLOCKS: usize = 128;
/// The most solids in a scene: spheres and blocks.
pub(crate) const MAX_SOLIDS: usize = MAX_SPHERES + MAX_BLOCKS;
/// The most lights in a scene.
pub const MAX_LIGHTS: usize = 4;

/// The most captions in a scene. The show has up to 3 at a time.
pub const MAX_CAPTIONS: usize = 10;
/// The most copper bars in a scene. The show has 2 at a time.
pub const MAX_COPPER_BARS: usize = 16;
/// The most letters in a caption. The longest in the show has 32.
pub const MAX_LETTERS: usize = 32;

/// Everything that one frame shows.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(default, deny_unknown_fields))]
pub struct Scene {
    /// The camera.
    pub camera: Camera,
    /// The colour of the background at the horizon and below, 0 to 1e9 in each channel.
    pub background: Vec3,
    /// Added to the background at the zenith; it may be negative, and the sum is 0 to 1e9 in each channel. For a ray whose direction,
    /// of length 1, rises by y it is weighted by `y (2 - y)`.
    pub sky: Vec3,
    /// The density of the haze, in 1 / scene units, 0 to 1000; 0 is clear air. Over a distance t a surface's light fades to the
    /// share `1 / (1 + (haze t)^2)`, and the background makes up for the rest.
    pub haze: f32,
    /// The factor on all light of the picture, 0 to 11: 0 is black, 1 leaves it as it is, more brightens it.
    pub exposure: f32,
    /// How light becomes the picture's colours.
    pub film: Film,
    /// Ambient light, which reaches every surface equally, 0 to 1e9 in each channel.
    pub ambient: Vec3,
    /// The overlay that explains the rendering method.
    pub method: Method,
    /// Spheres, in any order.
    pub spheres: List<Sphere, MAX_SPHERES>,
    /// Horizontal rectangles.
    pub planes: List<Plane, MAX_PLANES>,
    /// The waves on the first plane.
    pub water: Waves,
    /// Boxes, cylinders and capsules.
    pub blocks: List<Block, MAX_BLOCKS>,
    /// Lights.
    pub lights: List<Light, MAX_LIGHTS>,
    /// Text over the picture.
    pub captions: List<Caption, MAX_CAPTIONS>,
    /// Bars over the picture, behind its text.
    pub copper_bars: List<CopperBar, MAX_COPPER_BARS>,
}

impl Default for Scene {
    fn default() -> Self {
        Self::EMPTY
    }
}

impl Scene {
    /// Without objects. The unused memory of lists is all zeros.
    const EMPTY: Self = {
        let material = Material {
            exponent: 0.0,
            index: 0.0,
            ..Material::BLACK
        };
        let block = Block {
            axes: Mat3::ZERO,
            ..Block::new(Shape::Box, Vec3::ZERO, Vec3::ZERO, material)
        };
        Self {
            camera: Camera::STANDARD,
            background: Vec3::ZERO,
            sky: Vec3::ZERO,
            haze: 0.0,
            exposure: 1.0,
            film: Film::PLAIN,
            ambient: Vec3::ZERO,
            method: Method::PLAIN,
            spheres: List::over(Sphere::new(Vec3::ZERO, 0.0, material)),
            planes: List::over(Plane::new(Vec3::ZERO, 0.0, 0.0, material)),
            water: Waves::CALM,
            blocks: List::over(block),
            lights: List::over(Light::DARK),
            captions: List::over(Caption::ZERO),
            copper_bars: List::over(CopperBar::ZERO),
        }
    };

    /// All zeros: memory for a scene that takes no space in an executable file. It is not a valid scene.
    pub const ZEROED: Self = Self {
        camera: Camera {
            eye: Vec3::ZERO,
            up: Vec3::ZERO,
            field_of_view: 0.0,
            ..Camera::STANDARD
        },
        exposure: 0.0,
        film: Film {
            shoulder: 0.0,
            tolerance: 0.0,
            ..Film::PLAIN
        },
        method: Method {
            picture: 0.0,
            ..Method::PLAIN
        },
        ..Self::EMPTY
    };

    /// The number of spheres and blocks.
    pub(crate) fn solids(&self) -> usize {
        self.spheres.len() + self.blocks.len()
    }
}

/// How a surface reflects light, by Phong's model, and how it continues rays.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(default, deny_unknown_fields))]
pub struct Material {
    /// The colour of the surface, 0 to 1e9 in each channel; above 1 it reflects more light than reaches it.
    pub colour: Vec3,
    /// The diffuse coefficient, 0 to 1.
    pub kd: f32,
    /// The specular coefficient, 0 to 1.
    pub ks: f32,
    /// The exponent of the highlight, 1 to 1000. Larger exponents make smaller, sharper highlights.
    pub exponent: f32,
    /// How far highlights take the surface's colour, 0 to 1. Those of plastic, 0, have the light's colour, and those of metal, 1,
    /// the light's times the surface's. What the surface mirrors keeps its colours.
    pub metallic: f32,
    /// How far fine grooves spread highlights, 0 to 1. They run in circles around the object's own y axis, which of a sphere or a
    /// plane is the vertical, as a lathe leaves them. The cosine of Phong's model is `1 - d.d / 2`, where d is the difference
    /// of the directions to the light and of the mirrored ray; the part of d across the grooves counts by the share
    /// `1 - anisotropy` of its square. 1 is about the model of threads (Kajiya and Kay: Rendering Fur with Three Dimensional
    /// Textures, SIGGRAPH 1989).
    pub anisotropy: f32,
    /// The weight of the reflected ray, 0 to 1.
    pub kr: f32,
    /// How much more it reflects at grazing angles, 0 to 1, by Schlick's approximation: at an angle with the cosine c the share
    /// `f = fresnel (1 - c)^5` of what `kr` leaves of 1 is added to it, and the transmitted ray loses the share f. 1 is a
    /// polished surface, 0 one that reflects the same at all angles.
    pub fresnel: f32,
    /// The weight of the transmitted ray, 0 to 1. The surface is transparent if it is above 0.
    pub kt: f32,
    /// The refractive index of the inside relative to the outside, 0.1 to 10. It matters only if `kt` is above 0.
    pub index: f32,
    /// The colour of the object's shadow by lights with a [`Light::diameter`]: the share of each channel that it lets through, 0
    /// to 1. Black casts a full shadow.
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
        index: 1.0,
        tint: Vec3::ZERO,
        pattern: Pattern::NONE,
    };

    /// One that scatters light alone, in a colour and with a diffuse coefficient, 0 to 1.
    #[must_use]
    pub const fn matt(colour: Vec3, kd: f32) -> Self {
        Self {
            colour,
            kd,
            ..Self::BLACK
        }
    }

    /// A mirror that reflects the share `kr` of light, 0 to 1, and nothing else.
    #[must_use]
    pub const fn mirror(kr: f32) -> Self {
        Self { kr, ..Self::BLACK }
    }

    /// Clear glass of a refractive index, 0.1 to 10: that of windows is 1.5. It reflects by Schlick's approximation of Fresnel's
    /// equations.
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

    /// Polished metal of a colour, whose highlights have the colour, too. What it mirrors keeps its colours.
    #[must_use]
    pub const fn metal(colour: Vec3) -> Self {
        Self {
            colour,
            kd: 0.4,
            ks: 0.9,
            exponent: 40.0,
            metallic: 1.0,
            kr: 0.25,
            ..Self::BLACK
        }
    }

    /// The same material with a texture.
    #[must_use]
    pub const fn with_pattern(self, pattern: Pattern) -> Self {
        Self { pattern, ..self }
    }

    /// Whether it mirrors light or lets light through. Glass does even with a `kr` of 0: it reflects all light at some angles.
    #[must_use]
    pub fn is_specular(&self) -> bool {
        self.kr + self.fresnel + self.kt > 0.0
    }

    pub(super) fn check(&self, of: Checked) -> Result<(), RangeError> {
        of.field("material.colour", self.colour, LENGTH)?;
        of.field("material.kd", self.kd, SHARE)?;
        of.field("material.ks", self.ks, SHARE)?;
        of.field(
            "material.exponent",
            self.exponent,
            Range(1.0, 1000.0, "1 to 1000"),
        )?;
        of.field("material.metallic", self.metallic, SHARE)?;
        of.field("material.anisotropy", self.anisotropy, SHARE)?;
        of.field("material.kr", self.kr, SHARE)?;
        of.field("material.fresnel", self.fresnel, SHARE)?;
        of.field("material.kt", self.kt, SHARE)?;
        of.field("material.index", self.index, Range(0.1, 10.0, "0.1 to 10"))?;
        of.field("material.tint", self.tint, SHARE)?;
        self.pattern.check(of)
    }
}

/// A sphere.
///
/// As far as shadows are concerned it is hollow: a light that lies wholly within lights its inside, and nothing outside but by the
/// material's `tint` (see [`Light::diameter`]).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(deny_unknown_fields))]
pub struct Sphere {
    /// The centre, in scene units; coordinates up to [`MAX_LENGTH`].
    pub centre: Vec3,
    /// The radius in scene units, [`MIN_LENGTH`] to [`MAX_LENGTH`].
    pub radius: f32,
    /// The surface.
    pub material: Material,
}

impl Sphere {
    /// A sphere by its centre and radius.
    #[must_use]
    pub const fn new(centre: Vec3, radius: f32, material: Material) -> Self {
        Self {
            centre,
            radius,
            material,
        }
    }

    pub(super) fn check(&self, of: Checked) -> Result<(), RangeError> {
        of.field("centre", self.centre, POINT)?;
        of.field("radius", self.radius, EXTENT)?;
        self.material.check(of)
    }
}

/// A horizontal rectangle, visible from above and from below. It casts a shadow, which no `tint` colours.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(deny_unknown_fields))]
pub struct Plane {
    /// The centre, in scene units; coordinates up to [`MAX_LENGTH`].
    pub centre: Vec3,
    /// Half the extent along x in scene units, [`MIN_LENGTH`] to [`MAX_LENGTH`].
    pub half_x: f32,
    /// Half the extent along z in scene units, [`MIN_LENGTH`] to [`MAX_LENGTH`].
    pub half_z: f32,
    /// The surface.
    pub material: Material,
}

impl Plane {
    /// A rectangle by its centre and half its extents along x and z.
    #[must_use]
    pub const fn new(centre: Vec3, half_x: f32, half_z: f32, material: Material) -> Self {
        Self {
            centre,
            half_x,
            half_z,
            material,
        }
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
    /// A cylinder about the block's own y axis.
    Cylinder,
    /// A cylinder about the block's own y axis, with a half sphere at each end.
    Capsule,
}

/// A light whose brightness does not fall off with distance.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(default, deny_unknown_fields))]
pub struct Light {
    /// The position, in scene units; coordinates up to [`MAX_LENGTH`].
    pub position: Vec3,
    /// The colour times the brightness, 0 to 1e9 in each channel.
    pub colour: Vec3,
    /// The radius of the sphere that shows the light, [`MIN_LENGTH`] to [`MAX_LENGTH`], or 0 for a light that is invisible. The
    /// sphere casts no shadow, and haze does not dim it.
    pub drawn_radius: f32,
    /// Whether its rays are nearly parallel, like the sun's: `position`, `diameter` and `glow` are multiplied by [`Light::FAR`], and
    /// the light is not drawn.
    pub parallel: bool,
    /// The diameter of the light as far as shadows are concerned, 0 to [`MAX_LENGTH`]. Above 0 the shadows of spheres have
    /// penumbrae, and a material's `tint` colours its shadow: without `tint` no light passes through glass. 0 is a point, whose shadows are
    /// hard and black. The inside of a
    /// sphere is lit by lights that lie wholly within; one that reaches through the surface leaves it dark.
    pub diameter: f32,
    /// The radius of the glow around it, 0 to [`MAX_LENGTH`]; 0 is none. The air shines with the light's colour, as bright as that
    /// where a ray passes through the position, half as bright at this distance, and less by its square far away. What is before
    /// the light is in front of the half of the glow that is behind it. Of parallel rays the radius is multiplied by
    /// [`Light::FAR`], too, so that the glow is the sun's disc.
    pub glow: f32,
    /// The cone of a spotlight; `None` shines in all directions.
    pub spot: Option<Spot>,
}

/// A white light above the left of the default camera.
impl Default for Light {
    fn default() -> Self {
        Self::new(Vec3::new(-2.0, 3.0, 2.0), Vec3::ONE)
    }
}

impl Light {
    /// The factor on the position of a light with parallel rays. Across a scene as wide as the light's distance its rays differ
    /// in direction by at most 0.001 radians.
    pub const FAR: f32 = 1000.0;

    /// A black, invisible point.
    pub const DARK: Self = Self {
        position: Vec3::ZERO,
        colour: Vec3::ZERO,
        drawn_radius: 0.0,
        parallel: false,
        diameter: 0.0,
        glow: 0.0,
        spot: None,
    };

    /// An invisible point at a position, in a colour times its brightness.
    #[must_use]
    pub const fn new(position: Vec3, colour: Vec3) -> Self {
        Self {
            position,
            colour,
            ..Self::DARK
        }
    }

    /// A sun, whose rays come from where the position is seen from the origin.
    #[must_use]
    pub const fn sun(position: Vec3, colour: Vec3) -> Self {
        Self {
            parallel: true,
            ..Self::new(position, colour)
        }
    }

    /// A spotlight at a position, see [`Spot::new`].
    #[must_use]
    pub const fn spotlight(position: Vec3, aim: Vec3, outer_angle: f32, colour: Vec3) -> Self {
        Self {
            spot: Some(Spot::new(aim, outer_angle)),
            ..Self::new(position, colour)
        }
    }

    /// The factor on lengths: parallel rays come from far away.
    fn far(&self) -> f32 {
        if self.parallel { Self::FAR } else { 1.0 }
    }

    /// The position that shadow rays aim at.
    pub(crate) fn shadow_position(&self) -> Vec3A {
        Vec3A::from(self.position) * self.far()
    }

    /// The diameter at [`Light::shadow_position`].
    pub(crate) fn shadow_diameter(&self) -> f32 {
        self.diameter * self.far()
    }

    /// The radius of the glow at [`Light::shadow_position`].
    pub(crate) fn glow_radius(&self) -> f32 {
        self.glow * self.far()
    }

    /// The largest width of a penumbra where its shadow is cast. Penumbrae of parallel rays would grow without end: theirs stay
    /// as wide as at four times the distance of `position`.
    pub(crate) fn max_penumbra(&self) -> f32 {
        if self.parallel {
            4.0 * self.diameter
        } else {
            self.diameter
        }
    }

    /// Whether it is a point that shines in all directions: its shadows are hard.
    pub(crate) fn is_point(&self) -> bool {
        self.diameter == 0.0 && !self.parallel && self.spot.is_none()
    }

    pub(super) fn check(&self, of: Checked) -> Result<(), RangeError> {
        let is_drawable = self.drawn_radius == 0.0 || EXTENT.holds(self.drawn_radius);
        of.field("position", self.position, POINT)?;
        of.field("colour", self.colour, LENGTH)?;
        of.rule(
            "drawn_radius",
            self.drawn_radius,
            is_drawable,
            "0, or 1e-9 to 1e9",
        )?;
        of.field("diameter", self.diameter, LENGTH)?;
        of.field("glow", self.glow, LENGTH)?;
        self.spot.map_or(Ok(()), |spot| spot.check(of))
    }
}

/// The cone of a spotlight, with a soft edge.
///
/// Its brightness depends on the cosine of the angle between `aim` and the direction of the light: 1 within `inner_angle`, 0 beyond
/// `outer_angle`, and `s^2 (3 - 2 s)` between them, where s rises linearly from 0 to 1 as the cosine does.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(default, deny_unknown_fields))]
pub struct Spot {
    /// The direction in which it points, of any length but 0.
    pub aim: Vec3,
    /// The angle from `aim` to the inner edge in radians, from 0 to below `outer_angle`.
    pub inner_angle: f32,
    /// The angle from `aim` to the outer edge in radians, up to pi.
    pub outer_angle: f32,
}

/// A cone of 60 degrees that points down.
impl Default for Spot {
    fn default() -> Self {
        Self::new(Vec3::NEG_Y, PI / 6.0)
    }
}

impl Spot {
    /// A cone by its direction, of any length, and the angle to its outer edge. Three quarters of that are the angle to its inner edge.
    #[must_use]
    pub const fn new(aim: Vec3, outer_angle: f32) -> Self {
        Self {
            aim,
            inner_angle: 0.75 * outer_angle,
            outer_angle,
        }
    }

    pub(super) fn check(&self, of: Checked) -> Result<(), RangeError> {
        let is_aimed = self.aim.normalize_or_zero() != Vec3::ZERO;
        let is_narrower = 0.0 <= self.inner_angle && self.inner_angle < self.outer_angle;
        let angle = Range(0.0, PI, "0 to pi");
        of.field("spot.aim", self.aim, POINT)?;
        of.rule("spot.aim", self.aim, is_aimed, "of a length above 0")?;
        of.field("spot.outer_angle", self.outer_angle, angle)?;
        of.rule(
            "spot.inner_angle",
            self.inner_angle,
            is_narrower,
            "at least 0, and below outer_angle",
        )
    }
}
