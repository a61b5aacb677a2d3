use crate::lanes::*;

pub(crate) struct TexturePoint<S: Isa> {
    /// Relative to the object's centre, along its own axes, in scene units.
    pub own: Vec3x<S>,
    /// The normal, of length 1, with either sign.
    pub n: Vec3x<S>,
}
