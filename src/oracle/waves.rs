use eightfold_tracer::scene::Waves;
use glam::{DVec2, DVec3};

/// Returns the upward normal, where a pixel covers `pixel_size` scene units.
pub fn normal(waves: &Waves, p: DVec3, d: DVec3, pixel_size: f64) -> DVec3 {
    let mut slope = DVec2::ZERO;
    let (mut length, mut phase) = (f64::from(waves.length), f64::from(waves.phase));
    let mut turned = 0.0_f64;
    while length * f64::from(Waves::FINEST) > f64::from(waves.length) {
        let towards = DVec2::new(turned.sin(), turned.cos());
        let periods = towards.dot(DVec2::new(p.x, p.z)) / length - phase;
        let u = periods - periods.round();
        let share = (1.0 - f64::from(Waves::PIXELS) * pixel_size / length).max(0.0);
        slope += towards * (f64::from(waves.slope) * share * 8.0 * u * (1.0 - 2.0 * u.abs()));
        length *= f64::from(Waves::SHORTER);
        phase *= f64::from(Waves::FASTER);
        turned += f64::from(Waves::TURN);
    }
    let slope = slope.clamp_length_max(f64::from(Waves::STEEPEST) * d.y.abs());
    DVec3::new(-slope.x, 1.0, -slope.y).normalize()
}
