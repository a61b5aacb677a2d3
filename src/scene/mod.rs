//! The scene description: a camera, spheres, planes, boxes and cylinders with their materials, lights and captions.
//!
//! Coordinates are right-handed with y up. Lengths are in scene units, angles in radians, colours in linear RGB with 1 as the
//! brightest that is shown. [`Scene::validate`] checks that every number is in the range that its documentation gives.

mod block;
pub(crate) mod camera;
mod caption;
mod film;
mod list;
mod method;
mod pattern;
mod validate;
mod waves;

pub use block::{Block, Shape};
pub use camera::Camera;
pub use caption::{Caption, MAX_LETTERS};
pub use film::Film;
use glam::{Mat3A, Vec3A};
pub use list::List;
pub use method::Method;
pub use pattern::Pattern;
pub use validate::{MAX_LENGTH, MIN_LENGTH};
pub use waves::Waves;

/// The most spheres in a scene. The show uses up to 256.
pub const MAX_SPHERES: usize = 320;
/// The most planes in a scene.
pub const MAX_PLANES: usize = 8;
/// The most boxes and cylinders in a scene.
pub const MAX_BLOCKS: usize = 64;
/// The most solids in a scene: spheres, boxes and cylinders.
pub(crate) const MAX_SOLIDS: usize = MAX_SPHERES + MAX_BLOCKS;
/// The most lights in a scene.
pub const MAX_LIGHTS: usize = 4;

/// The most captions in a scene. The show has up to 3 at a time.
pub const MAX_CAPTIONS: usize = 10;

/// Everything that one frame shows.
#[derive(Clone, Copy, Debug, Default)]
pub struct Scene {
    /// The camera.
    pub camera: Camera,
    /// The colour of the background at the horizon and below.
    pub background: Vec3A,
    /// Added to the background at the zenith; it may be negative. For a ray whose direction, of length 1, rises by y it is
    /// weighted by `y (2 - y)`.
    pub sky: Vec3A,
    /// The density of the haze, in 1 / scene units, 0 to 1000; 0 is clear air. Over a distance t a surface's light fades to the
    /// share `1 / (1 + (haze t)^2)`, and the background makes up for the rest.
    pub haze: f32,
    /// How far the picture is faded to black, -10 to 1: 0 leaves it as it is, 1 is black, negative values brighten it.
    pub fade: f32,
    /// How light becomes the picture's colours.
    pub film: Film,
    /// Ambient light, which reaches every surface equally.
    pub ambient: Vec3A,
    /// The overlay that explains the rendering method.
    pub method: Method,
    /// Spheres, in any order.
    pub spheres: List<Sphere, MAX_SPHERES>,
    /// Horizontal rectangles.
    pub planes: List<Plane, MAX_PLANES>,
    /// The waves on the first plane.
    pub water: Waves,
    /// Boxes and cylinders.
    pub blocks: List<Block, MAX_BLOCKS>,
    /// Lights.
    pub lights: List<Light, MAX_LIGHTS>,
    /// Text over the picture.
    pub captions: List<Caption, MAX_CAPTIONS>,
}

impl Scene {
    /// All zeros: memory for a scene that takes no space in an executable file. It is not a valid scene.
    pub const ZEROED: Self = {
        let material = Material {
            exponent: 0.0,
            index: 0.0,
            ..Material::BLACK
        };
        Self {
            camera: Camera {
                eye: Vec3A::ZERO,
                look_at: Vec3A::ZERO,
                up: Vec3A::ZERO,
                field_of_view: 0.0,
            },
            background: Vec3A::ZERO,
            sky: Vec3A::ZERO,
            haze: 0.0,
            fade: 0.0,
            film: Film {
                shoulder: 0.0,
                vignette: 0.0,
                dither: 0.0,
                tolerance: 0.0,
            },
            ambient: Vec3A::ZERO,
            method: Method {
                points: 0.0,
                squares: 0.0,
                picture: 0.0,
                coarse: 0.0,
                front: 0.0,
            },
            spheres: List::over(Sphere {
                centre: Vec3A::ZERO,
                radius: 0.0,
                material,
            }),
            planes: List::over(Plane {
                centre: Vec3A::ZERO,
                half_x: 0.0,
                half_z: 0.0,
                material,
            }),
            water: Waves::CALM,
            blocks: List::over(Block {
                centre: Vec3A::ZERO,
                half: Vec3A::ZERO,
                axes: Mat3A::ZERO,
                shape: Shape::Box,
                material,
            }),
            lights: List::over(Light::DARK),
            captions: List::over(Caption::ZERO),
        }
    };

    /// The number of spheres, boxes and cylinders.
    pub(crate) fn solids(&self) -> usize {
        self.spheres.len() + self.blocks.len()
    }
}

/// How a surface reflects light, by Phong's model, and how it continues rays.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Material {
    /// The colour of the surface.
    pub colour: Vec3A,
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
    /// The colour of the object's shadow by lights with a [`Light::size`]: the share of each channel that it lets through, 0
    /// to 1. Black casts a full shadow.
    pub tint: Vec3A,
    /// The texture.
    pub pattern: Pattern,
}

impl Material {
    /// Black, without highlights, reflection or transmission.
    pub const BLACK: Self = Self {
        colour: Vec3A::ZERO,
        kd: 0.0,
        ks: 0.0,
        exponent: 1.0,
        metallic: 0.0,
        anisotropy: 0.0,
        kr: 0.0,
        fresnel: 0.0,
        kt: 0.0,
        index: 1.0,
        tint: Vec3A::ZERO,
        pattern: Pattern::NONE,
    };
}

/// A sphere.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Sphere {
    /// The centre, in scene units.
    pub centre: Vec3A,
    /// The radius, [`MIN_LENGTH`] to [`MAX_LENGTH`].
    pub radius: f32,
    /// The surface.
    pub material: Material,
}

/// A horizontal rectangle, visible from above and from below.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Plane {
    /// The centre, in scene units.
    pub centre: Vec3A,
    /// Half the extent along x, [`MIN_LENGTH`] to [`MAX_LENGTH`].
    pub half_x: f32,
    /// Half the extent along z, [`MIN_LENGTH`] to [`MAX_LENGTH`].
    pub half_z: f32,
    /// The surface.
    pub material: Material,
}

/// A light whose brightness does not fall off with distance.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Light {
    /// The position, in scene units.
    pub position: Vec3A,
    /// The colour times the brightness, each channel from 0 up.
    pub colour: Vec3A,
    /// The radius of the sphere that shows the light, [`MIN_LENGTH`] to [`MAX_LENGTH`], or 0 for a light that is invisible. The
    /// sphere casts no shadow.
    pub radius: f32,
    /// Whether its rays are nearly parallel, like the sun's: `position`, `size` and `glow` are multiplied by [`Light::FAR`], and the
    /// light is not drawn.
    pub parallel: bool,
    /// The diameter of the light as far as shadows are concerned, 0 to [`MAX_LENGTH`]. Above 0 the shadows of spheres have
    /// penumbrae, and a material's `tint` colours its shadow. 0 is a point, whose shadows are hard and black.
    pub size: f32,
    /// The radius of the glow around it, 0 to [`MAX_LENGTH`]; 0 is none. The air shines with the light's colour, as bright as that
    /// where a ray passes through the position, half as bright at this distance, and less by its square far away. What is before
    /// the light is in front of the half of the glow that is behind it. Of parallel rays the radius is multiplied by
    /// [`Light::FAR`], too, so that the glow is the sun's disc.
    pub glow: f32,
    /// The cone of a spotlight; `None` shines in all directions.
    pub spot: Option<Spot>,
}

impl Light {
    /// The factor on the position of a light with parallel rays. Across a scene as wide as the light's distance its rays differ
    /// in direction by at most 0.001 radians.
    pub const FAR: f32 = 1000.0;

    /// A black, invisible point.
    pub const DARK: Self = Self {
        position: Vec3A::ZERO,
        colour: Vec3A::ZERO,
        radius: 0.0,
        parallel: false,
        size: 0.0,
        glow: 0.0,
        spot: None,
    };

    /// The factor on lengths: parallel rays come from far away.
    fn far(&self) -> f32 {
        if self.parallel { Self::FAR } else { 1.0 }
    }

    /// The position that shadow rays aim at.
    pub(crate) fn shadow_position(&self) -> Vec3A {
        self.position * self.far()
    }

    /// The diameter at [`Light::shadow_position`].
    pub(crate) fn diameter(&self) -> f32 {
        self.size * self.far()
    }

    /// The radius of the glow at [`Light::shadow_position`].
    pub(crate) fn glow_radius(&self) -> f32 {
        self.glow * self.far()
    }

    /// The largest width of a penumbra where its shadow is cast. Penumbrae of parallel rays would grow without end: theirs stay
    /// as wide as at four times the distance of `position`.
    pub(crate) fn max_penumbra(&self) -> f32 {
        if self.parallel {
            4.0 * self.size
        } else {
            self.size
        }
    }

    /// Whether it is a point that shines in all directions: its shadows are hard.
    pub(crate) fn is_point(&self) -> bool {
        self.size == 0.0 && !self.parallel && self.spot.is_none()
    }
}

/// The cone of a spotlight, with a soft edge.
///
/// Its brightness depends on the cosine of the angle between `aim` and the direction of the light: 0 up to `dark`, 1 from
/// `bright` on, and `s^2 (3 - 2 s)` between them, where s rises linearly from 0 to 1.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Spot {
    /// The direction in which it points, of length 1.
    pub aim: Vec3A,
    /// The cosine at the outer edge, from -1 to below `bright`.
    pub dark: f32,
    /// The cosine at the inner edge, up to 1.
    pub bright: f32,
}
