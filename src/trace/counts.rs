//! Counts of the work that tracing takes.

/// How much work was done.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counts {
    /// Points traced.
    pub points: u64,
    /// Primary and secondary rays.
    pub rays: u64,
    /// Rays towards a light.
    pub shadow_rays: u64,
    /// Lanes of the packets that the primary and secondary rays travelled in, idle ones included.
    pub lanes: u64,
}

impl Counts {
    /// Nothing done.
    pub const NONE: Self = Self {
        points: 0,
        rays: 0,
        shadow_rays: 0,
        lanes: 0,
    };
}

impl core::ops::Add for Counts {
    type Output = Self;

    fn add(mut self, other: Self) -> Self {
        self += other;
        self
    }
}

impl core::ops::AddAssign for Counts {
    fn add_assign(&mut self, other: Self) {
        self.points += other.points;
        self.rays += other.rays;
        self.shadow_rays += other.shadow_rays;
        self.lanes += other.lanes;
    }
}
