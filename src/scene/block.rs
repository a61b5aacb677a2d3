//! Boxes and cylinders, turned as one likes.

use super::Material;
use glam::{Mat3A, Vec3A};

/// A box, or a cylinder with flat ends; hollow where its material is transparent.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Block {
    /// Centre.
    pub centre: Vec3A,
    /// Half its extent along each of its own axes, above 0. A cylinder stands along its y; its radius is `half.x`, and
    /// `half.z` is the same.
    pub half: Vec3A,
    /// Its own axes in the scene, each of length 1 and square to the others; the identity is a box along the scene's.
    pub axes: Mat3A,
    /// Round about its y axis: a cylinder, not a box.
    pub round: bool,
    /// Surface.
    pub material: Material,
}
