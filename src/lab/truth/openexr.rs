//! Writes OpenEXR files: what light a pixel has, also where a picture would clip it.

use super::estimate::Estimate;
use crate::arguments::Size;
use anyhow::{Context, Result};
use eightfold_tracer::glam::DVec3;
use exr::prelude::{AnyChannel, AnyChannels, FlatSamples, Image, WritableImage};
use std::io::Cursor;

/// The channels of a colour.
const RGB: [&str; 3] = ["R", "G", "B"];

/// Encodes radiances as R, G and B, and half the width of their 95 % intervals as interval.R, interval.G and interval.B.
pub fn encode(size: Size, estimates: &[Estimate]) -> Result<Vec<u8>> {
    let channel = |name: String, i: usize, of: &dyn Fn(&Estimate) -> DVec3| {
        let numbers = estimates.iter().map(|estimate| of(estimate)[i] as f32);
        AnyChannel::new(name.as_str(), FlatSamples::F32(numbers.collect()))
    };
    let means = (0..3).map(|i| channel(RGB[i].to_owned(), i, &|estimate| estimate.mean));
    let intervals =
        (0..3).map(|i| channel(format!("interval.{}", RGB[i]), i, &Estimate::half_interval));
    let channels: Vec<_> = means.chain(intervals).collect();
    let image = Image::from_channels(
        (size.width, size.height),
        AnyChannels::sort(channels.into()),
    );
    let mut bytes = Cursor::new(Vec::new());
    let written = image.write().to_buffered(&mut bytes);
    written.context("cannot encode OpenEXR")?;
    Ok(bytes.into_inner())
}
