use crate::range_error::{Checked, Range, RangeError};
use glam::Vec3;

/// The largest coordinate and extent, in scene units: a few times its square is finite in f32.
pub const MAX_LENGTH: f32 = 1e9;
/// The smallest radius and extent, in scene units: its square is a normal number.
pub const MIN_LENGTH: f32 = 1e-9;

pub(super) const POINT: Range = Range(-MAX_LENGTH, MAX_LENGTH, "-1e9 to 1e9");
pub(super) const EXTENT: Range = Range(MIN_LENGTH, MAX_LENGTH, "1e-9 to 1e9");
pub(super) const LENGTH: Range = Range(0.0, MAX_LENGTH, "0 to 1e9");
pub(crate) const SHARE: Range = Range(0.0, 1.0, "0 to 1");
pub(super) const SIGNED: Range = Range(-1.0, 1.0, "-1 to 1");
pub(super) const THOUSAND: Range = Range(0.0, 1e3, "0 to 1000");

pub(super) fn is_unit(v: Vec3) -> bool {
    (v.length() - 1.0).abs() < 1e-4
}

pub(crate) fn each<T>(
    object: &'static str,
    items: &[T],
    check: fn(&T, Checked) -> Result<(), RangeError>,
) -> Result<(), RangeError> {
    let mut items = items.iter().enumerate();
    items.try_for_each(|(i, item)| {
        let index = Some(i);
        check(item, Checked { object, index })
    })
}
