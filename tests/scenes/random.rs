use glam::{Mat3, Quat, Vec3, vec3};

/// A pseudorandom generator: SplitMix by Steele, Lea and Flood.
#[derive(Clone, Debug)]
pub struct Random {
    pub seed: u64,
    state: u64,
}

impl Random {
    pub const fn new(seed: u64) -> Self {
        Self { seed, state: seed }
    }

    pub fn bits(&mut self) -> u64 {
        self.state = self.state.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut bits = self.state;
        bits = (bits ^ (bits >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        bits = (bits ^ (bits >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        bits ^ (bits >> 31)
    }

    pub fn unit(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1_u64 << 53) as f64
    }

    pub fn below(&mut self, end: usize) -> usize {
        (self.bits() % end as u64) as usize
    }

    pub fn between(&mut self, low: f32, high: f32) -> f32 {
        low + (high - low) * ((self.bits() >> 40) as f32 / (1 << 24) as f32)
    }

    pub fn zero_or(&mut self, low: f32, high: f32) -> f32 {
        [0.0, self.between(low, high)][self.below(2)]
    }

    pub fn power(&mut self, low: f32, high: f32) -> f32 {
        10_f32.powf(self.between(low, high))
    }

    pub fn one_of<T: Copy, const N: usize>(&mut self, values: [T; N]) -> T {
        values[self.below(N)]
    }

    pub fn vector(&mut self, low: Vec3, high: Vec3) -> Vec3 {
        let mut share = || self.between(0.0, 1.0);
        low + (high - low) * vec3(share(), share(), share())
    }

    pub fn colour(&mut self) -> Vec3 {
        self.vector(Vec3::ZERO, Vec3::ONE)
    }

    pub fn turn(&mut self) -> Mat3 {
        let turn = self.vector(Vec3::splat(-3.0), Vec3::splat(3.0));
        Mat3::from_quat(Quat::from_scaled_axis(turn))
    }
}

/// Returns a generator per case. `CASES` sets another count, and `FIRST_CASE` the first seed (0).
/// To repeat a failed case, set `FIRST_CASE` to its seed and `CASES=1`.
pub fn cases(count: u64) -> impl Iterator<Item = Random> {
    let number = |name: &str| {
        let text = std::env::var(name).ok()?;
        Some(text.parse::<u64>().expect("a number of cases"))
    };
    let first = number("FIRST_CASE").unwrap_or(0);
    let end = first.saturating_add(number("CASES").unwrap_or(count));
    (first..end).map(Random::new)
}
