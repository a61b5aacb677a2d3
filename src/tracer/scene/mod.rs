//! The scene description: a camera, spheres, planes, boxes, cylinders and capsules with their materials, lights, captions and copper
//! bars.
//!
//! Coordinates are right-handed with y up. Lengths are in scene units, angles in radians, colours in linear RGB with 1 as the
//! brightest that is shown. [`Scene::validate`] checks that every number is in the range that its documentation gives.

#[macro_use]
pub(crate) mod fields;

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
pub use fields::{Field, Fields, Items, Range, Value, numbers};
pub use film::Film;
pub use list::{CapacityError, List};
pub use method::Method;
pub use overlay::{Caption, CopperBar};
pub use pattern::Pattern;
pub use validate::{MAX_LENGTH, MIN_LENGTH};
pub use waves::Waves;

use fields::{Part, is_unit};
use glam::Vec3A;
use validate::{COLOUR, COSINE, EXTENT, LENGTH, POINT, SHARE, SHARES, THOUSAND, UNIT};

/// The most spheres in a scene. The show uses up to 256.
pub const MAX_SPHERES: usize = 320;
/// The most planes in a scene.
pub const MAX_PLANES: usize = 8;
/// The most blocks in a scene: boxes, cylinders and capsules.
pub const MAX_BLOCKS: usize = 64;
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

const EXPOSURE: Range = Range::new(0.0, 11.0, "0 to 11");
const EXPONENT: Range = Range::new(1.0, 1000.0, "1 to 1000");
const INDEX: Range = Range::new(0.1, 10.0, "0.1 to 10");
/// Those of an extent, or 0.
const RADIUS: Range = Range::new(0.0, MAX_LENGTH, "0, or a length from 1e-9 to 1e9");
const COS_OUTER: Range = Range {
    takes: "a cosine of at least -1 that is below cos_inner",
    ..COSINE
};

fields! {
    /// Everything that one frame shows.
    pub struct Scene in "" {
        /// The camera.
        camera: Camera = Camera::STANDARD;
        /// The colour of the background at the horizon and below.
        background: Vec3A = Vec3A::ZERO, in COLOUR;
        /// Added to the background at the zenith; it may be negative. For a ray whose direction, of length 1, rises by y it is
        /// weighted by `y (2 - y)`.
        sky: Vec3A = Vec3A::ZERO, if |it| it.has_sky() => "what leaves the background's channels at 0 to 1e9 when it is added";
        /// The density of the haze, in 1 / scene units, 0 to 1000; 0 is clear air. Over a distance t a surface's light fades to the
        /// share `1 / (1 + (haze t)^2)`, and the background makes up for the rest.
        haze: f32 = 0.0, in THOUSAND;
        /// The factor on all light of the picture, 0 to 11: 0 is black, 1 leaves it as it is, more brightens it.
        exposure: f32 = 1.0, in EXPOSURE;
        /// How light becomes the picture's colours.
        film: Film = Film::PLAIN;
        /// Ambient light, which reaches every surface equally.
        ambient: Vec3A = Vec3A::ZERO, in COLOUR;
        /// The overlay that explains the rendering method.
        method: Method = Method::PLAIN;
        /// Spheres, in any order.
        spheres: List<Sphere, MAX_SPHERES> = Part::ZERO;
        /// Horizontal rectangles.
        planes: List<Plane, MAX_PLANES> = Part::ZERO;
        /// The waves on the first plane.
        water: Waves = Waves::CALM;
        /// Boxes, cylinders and capsules.
        blocks: List<Block, MAX_BLOCKS> = Part::ZERO;
        /// Lights.
        lights: List<Light, MAX_LIGHTS> = Part::ZERO;
        /// Text over the picture.
        captions: List<Caption, MAX_CAPTIONS> = Part::ZERO;
        /// Bars over the picture, behind its text.
        copper_bars: List<CopperBar, MAX_COPPER_BARS> = Part::ZERO;
        .. _more;
    }
}

impl Scene {
    /// All zeros: memory for a scene that takes no space in an executable file. It is not a valid scene.
    pub const ZEROED: Self = Self::ZERO;

    /// Whether the sky is a colour where it is brightest.
    fn has_sky(&self) -> bool {
        let zenith = self.background + self.sky;
        zenith.to_array().into_iter().all(|c| COLOUR.holds(c))
    }

    /// The number of spheres and blocks.
    pub(crate) fn solids(&self) -> usize {
        self.spheres.len() + self.blocks.len()
    }
}

fields! {
    /// How a surface reflects light, by Phong's model, and how it continues rays.
    pub struct Material in "material." as Material {
        /// The colour of the surface.
        colour: Vec3A = Vec3A::ZERO, in COLOUR;
        /// The diffuse coefficient, 0 to 1.
        kd: f32 = 0.0, in SHARE;
        /// The specular coefficient, 0 to 1.
        ks: f32 = 0.0, in SHARE;
        /// The exponent of the highlight, 1 to 1000. Larger exponents make smaller, sharper highlights.
        exponent: f32 = 1.0, in EXPONENT;
        /// How far highlights take the surface's colour, 0 to 1. Those of plastic, 0, have the light's colour, and those of metal, 1,
        /// the light's times the surface's. What the surface mirrors keeps its colours.
        metallic: f32 = 0.0, in SHARE;
        /// How far fine grooves spread highlights, 0 to 1. They run in circles around the object's own y axis, which of a sphere or a
        /// plane is the vertical, as a lathe leaves them. The cosine of Phong's model is `1 - d.d / 2`, where d is the difference
        /// of the directions to the light and of the mirrored ray; the part of d across the grooves counts by the share
        /// `1 - anisotropy` of its square. 1 is about the model of threads (Kajiya and Kay: Rendering Fur with Three Dimensional
        /// Textures, SIGGRAPH 1989).
        anisotropy: f32 = 0.0, in SHARE;
        /// The weight of the reflected ray, 0 to 1.
        kr: f32 = 0.0, in SHARE;
        /// How much more it reflects at grazing angles, 0 to 1, by Schlick's approximation: at an angle with the cosine c the share
        /// `f = fresnel (1 - c)^5` of what `kr` leaves of 1 is added to it, and the transmitted ray loses the share f. 1 is a
        /// polished surface, 0 one that reflects the same at all angles.
        fresnel: f32 = 0.0, in SHARE;
        /// The weight of the transmitted ray, 0 to 1. The surface is transparent if it is above 0.
        kt: f32 = 0.0, in SHARE;
        /// The refractive index of the inside relative to the outside, 0.1 to 10. It matters only if `kt` is above 0.
        index: f32 = 1.0, if |it| it.kt == 0.0 || INDEX.holds(it.index) => "0.1 to 10 where kt is above 0";
        /// The colour of the object's shadow by lights with a [`Light::diameter`]: the share of each channel that it lets through, 0
        /// to 1. Black casts a full shadow.
        tint: Vec3A = Vec3A::ZERO, in SHARES;
        /// The texture.
        pattern: Pattern = Pattern::NONE;
        .. _more;
    }
}

impl Material {
    /// Black, without highlights, reflection or transmission.
    pub const BLACK: Self = Self::STANDARD;

    /// One that scatters light alone, in a colour and with a diffuse coefficient, 0 to 1.
    #[must_use]
    pub const fn matt(colour: Vec3A, kd: f32) -> Self {
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

    /// Whether it mirrors light or lets light through. Glass does even with a `kr` of 0: it reflects all light at some angles.
    #[must_use]
    pub fn is_specular(&self) -> bool {
        self.kr + self.fresnel + self.kt > 0.0
    }
}

fields! {
    /// A sphere.
    ///
    /// As far as shadows are concerned it is hollow: a lamp that lies wholly within lights its inside, and nothing outside but by the
    /// material's `tint` (see [`Light::diameter`]).
    pub struct Sphere in "" {
        /// The centre, in scene units.
        centre: Vec3A, in POINT;
        /// The radius, [`MIN_LENGTH`] to [`MAX_LENGTH`].
        radius: f32, in EXTENT;
        /// The surface.
        material: Material;
    }
}

impl Sphere {
    /// A sphere by its centre and radius.
    #[must_use]
    pub const fn new(centre: Vec3A, radius: f32, material: Material) -> Self {
        Self {
            centre,
            radius,
            material,
        }
    }
}

fields! {
    /// A horizontal rectangle, visible from above and from below.
    pub struct Plane in "" {
        /// The centre, in scene units.
        centre: Vec3A, in POINT;
        /// Half the extent along x, [`MIN_LENGTH`] to [`MAX_LENGTH`].
        half_x: f32, in EXTENT;
        /// Half the extent along z, [`MIN_LENGTH`] to [`MAX_LENGTH`].
        half_z: f32, in EXTENT;
        /// The surface.
        material: Material;
    }
}

impl Plane {
    /// A rectangle by its centre and half its extents along x and z.
    #[must_use]
    pub const fn new(centre: Vec3A, half_x: f32, half_z: f32, material: Material) -> Self {
        Self {
            centre,
            half_x,
            half_z,
            material,
        }
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

fields! {
    /// A light whose brightness does not fall off with distance.
    pub struct Light in "" {
        /// The position, in scene units.
        position: Vec3A = Vec3A::ZERO, in POINT;
        /// The colour times the brightness, each channel from 0 up.
        colour: Vec3A = Vec3A::ZERO, in COLOUR;
        /// The radius of the sphere that shows the light, [`MIN_LENGTH`] to [`MAX_LENGTH`], or 0 for a light that is invisible. The
        /// sphere casts no shadow.
        drawn_radius: f32 = 0.0, in RADIUS,
            if |it| it.drawn_radius == 0.0 || EXTENT.holds(it.drawn_radius) => "0, or a length from 1e-9 to 1e9";
        /// Whether its rays are nearly parallel, like the sun's: `position`, `diameter` and `glow` are multiplied by [`Light::FAR`], and
        /// the light is not drawn.
        parallel: bool = false;
        /// The diameter of the light as far as shadows are concerned, 0 to [`MAX_LENGTH`]. Above 0 the shadows of spheres have
        /// penumbrae, and a material's `tint` colours its shadow. 0 is a point, whose shadows are hard and black. The inside of a
        /// sphere is lit by lights that lie wholly within; one that reaches through the surface leaves it dark.
        diameter: f32 = 0.0, in LENGTH;
        /// The radius of the glow around it, 0 to [`MAX_LENGTH`]; 0 is none. The air shines with the light's colour, as bright as that
        /// where a ray passes through the position, half as bright at this distance, and less by its square far away. What is before
        /// the light is in front of the half of the glow that is behind it. Of parallel rays the radius is multiplied by
        /// [`Light::FAR`], too, so that the glow is the sun's disc.
        glow: f32 = 0.0, in LENGTH;
        /// The cone of a spotlight; `None` shines in all directions.
        spot: Option<Spot> = None;
        .. _more;
    }
}

impl Light {
    /// The factor on the position of a light with parallel rays. Across a scene as wide as the light's distance its rays differ
    /// in direction by at most 0.001 radians.
    pub const FAR: f32 = 1000.0;

    /// A black, invisible point.
    pub const DARK: Self = Self::STANDARD;

    /// An invisible point at a position, in a colour times its brightness.
    #[must_use]
    pub const fn new(position: Vec3A, colour: Vec3A) -> Self {
        Self {
            position,
            colour,
            ..Self::DARK
        }
    }

    /// The factor on lengths: parallel rays come from far away.
    fn far(&self) -> f32 {
        if self.parallel { Self::FAR } else { 1.0 }
    }

    /// The position that shadow rays aim at.
    pub(crate) fn shadow_position(&self) -> Vec3A {
        self.position * self.far()
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
}

fields! {
    /// The cone of a spotlight, with a soft edge.
    ///
    /// Its brightness depends on the cosine of the angle between `aim` and the direction of the light: 0 up to `cos_outer`, 1 from
    /// `cos_inner` on, and `s^2 (3 - 2 s)` between them, where s rises linearly from 0 to 1.
    pub struct Spot in "spot." {
        /// The direction in which it points, of length 1.
        aim: Vec3A, in UNIT, if |it| is_unit(it.aim) => "a direction of length 1";
        /// The cosine at the inner edge, up to 1.
        cos_inner: f32, in COSINE;
        /// The cosine at the outer edge, from -1 to below `cos_inner`.
        cos_outer: f32, in COS_OUTER, if |it| it.cos_outer < it.cos_inner => "a cosine of at least -1 that is below cos_inner";
    }
}
