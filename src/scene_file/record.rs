//! Scene files of the scenes that are compiled in.

use super::keys::linear;
use super::motion::{Between, Motion, Numbers};
use super::path::leaves;
use super::{ron_text, tree};
use anyhow::{Result, bail};
use eightfold_tracer::scene::{Caption, Scene};
use serde_json::Value;

/// The text of a file that plays for some seconds, and shows scenes at their times, to the bit, and between them what lies between;
/// its name is for errors.
///
/// # Errors
/// If the scenes differ by more than their numbers.
pub fn text_of(name: &str, length: f32, mut scenes: Vec<(f32, Scene)>) -> Result<String> {
    hold_captions(&mut scenes);
    let names = tree::material_names(scenes.iter().map(|(_, scene)| scene));
    let times: Vec<f32> = scenes.iter().map(|(time, _)| *time).collect();
    let mut trees = scenes
        .iter()
        .map(|(_, scene)| tree::named(scene, length, &names));
    let Some(first) = trees.next() else {
        bail!("{name} has no frames");
    };
    let mut tracks = Vec::new();
    leaves(&first, String::new(), &mut |path, value| {
        tracks.push((path, vec![value.clone()]))
    });
    for (tree, time) in trees.zip(&times[1..]) {
        let (mut track, mut is_alike) = (tracks.iter_mut(), true);
        leaves(
            &tree,
            String::new(),
            &mut |path, value| match track.next() {
                Some((known, values)) if *known == path => values.push(value.clone()),
                _ => is_alike = false,
            },
        );
        if !is_alike || track.next().is_some() {
            bail!("{name} has other objects at {time} s than before: a scene file can't say that");
        }
    }
    let mut motions = Vec::new();
    for (path, values) in tracks {
        if values.iter().any(|value| !is_same(value, &values[0])) {
            motions.push(motion(path, &times, &values)?);
        }
    }
    Ok(ron_text::text(first, &motions))
}

/// The motion of a value through the times of the frames, without the keys between equal ones.
fn motion(path: String, times: &[f32], values: &[Value]) -> Result<Motion> {
    let mut keys: Vec<(f32, Numbers)> = Vec::new();
    for (i, value) in values.iter().enumerate() {
        let Some(numbers) = Numbers::of(value) else {
            bail!("{path} changes at {} s, and is no number", times[i]);
        };
        let is_still = |j: usize| values.get(j).is_none_or(|other| is_same(other, value));
        // What lies between two keys that are the same is the same, but for -0.
        let between = linear(&[(0.0, numbers), (1.0, numbers)], 0.5);
        let is_kept = format!("{between:?}") == format!("{numbers:?}");
        if i > 0 && is_still(i - 1) && is_still(i + 1) && is_kept {
            continue;
        }
        keys.push((times[i], numbers));
    }
    Ok(Motion {
        of: path,
        between: Between::Linear,
        repeat: false,
        keys,
    })
}

/// Whether two values are the same to the bit: 0 is not -0.
fn is_same(a: &Value, b: &Value) -> bool {
    let text = |value: &Value| value.to_string();
    a == b && text(a) == text(b)
}

/// Has every scene all captions of all scenes; those that it has not are dark.
fn hold_captions(scenes: &mut [(f32, Scene)]) {
    let mut all: Vec<Caption> = Vec::new();
    for (_, scene) in scenes.iter() {
        for caption in scene.captions.iter() {
            if !all.iter().any(|known| *known.letters == *caption.letters) {
                all.push(Caption {
                    brightness: 0.0,
                    ..*caption
                });
            }
        }
    }
    for (_, scene) in scenes {
        let shown = scene.captions;
        scene.captions.clear();
        for caption in &all {
            let shown = shown
                .iter()
                .find(|shown| *shown.letters == *caption.letters);
            scene.captions.push(*shown.unwrap_or(caption));
        }
    }
}
