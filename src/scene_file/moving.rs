//! A scene that changes with time.

use super::motion::Motion;
use super::node::{Kind, Mistake, Node, PRESENTATION, steps};
use eightfold_tracer::RangeError;
use eightfold_tracer::glam::{EulerRot, Mat3};
use eightfold_tracer::presentation::{Moment, Presentation};
use eightfold_tracer::scene::Scene;
use serde::Deserialize;

#[derive(Clone, Debug, Default, PartialEq)]
pub struct Moving {
    /// The contents of a file without the length and the motions.
    pub tree: Node,
    pub motions: Vec<Motion>,
    /// A path in the scene, and its path in the file, if the tree is a part of a file.
    pub alias: [String; 2],
}

impl Moving {
    pub fn moment(&self, time: f32) -> Result<Moment, Mistake> {
        let mut scene = self.tree_at(time)?;
        let presentation = PRESENTATION.iter().filter_map(|name| scene.take(name)).collect();
        let presentation = Node { parts: presentation, ..Node::default() };
        Ok(Moment {
            scene: Scene::deserialize(&scene)?,
            presentation: Presentation::deserialize(&presentation)?,
        })
    }

    pub fn valid(&self, time: f32) -> Result<Scene, Mistake> {
        let moment = self.moment(time)?;
        match moment.validate() {
            Ok(()) => Ok(moment.scene),
            Err(error) => Err(self.mistake(time, &error)),
        }
    }

    /// Blames a motion, or at the start the value in the file if it has no motion.
    pub fn mistake(&self, time: f32, error: &RangeError) -> Mistake {
        let text = error.to_string();
        let path = text.split(" is ").next().unwrap_or_default();
        let [from, to] = &self.alias;
        let path = path.strip_prefix(from.as_str());
        let path = path.map_or(String::new(), |rest| to.clone() + rest);
        let is_set = |motion: &&Motion| steps(&motion.of).zip(steps(&path)).all(|(a, b)| a == b);
        let is_cause = |motion: &&Motion| {
            let mut other = self.clone();
            let mut motions = other.motions.iter_mut();
            if let Some(it) = motions.find(|it| it.index == motion.index) {
                *it = motion.frozen();
            }
            let moment = other.moment(time);
            moment.is_ok_and(|moment| moment.validate().is_ok())
        };
        let motions = self.motions.iter();
        let motions = motions.filter(|motion| time != 0.0 || is_set(motion));
        let Some(motion) = motions.min_by_key(|it| (!is_set(it), !is_cause(it))) else {
            let at = |tree: Node| Mistake::new(tree.nearest(&path).at, text);
            return self.tree_at(time).map_or_else(|mistake| mistake, at);
        };
        let (at, numbers) = motion.at(time);
        let numbers: Vec<String> = numbers.iter().map(f32::to_string).collect();
        let (i, range) = (motion.index, error.range);
        let (value, rule) = match (is_set(&motion), &numbers[..]) {
            (true, _) => (format!("{path} to {}", error.found), String::new()),
            (_, [number]) => (format!("{} to {number}", motion.of), path + " "),
            _ => (format!("{} to [{}]", motion.of, numbers.join(", ")), path + " "),
        };
        let millisecond = (time * 1e3).round() / 1e3;
        let message =
            format!("motions[{i}] sets {value} at {millisecond} s; {rule}must be {range}");
        Mistake::new(at, message)
    }

    /// Returns the tree at a time, with materials in place of their names.
    fn tree_at(&self, time: f32) -> Result<Node, Mistake> {
        let mut tree = self.tree.clone();
        for motion in &self.motions {
            let of = &motion.of;
            let message = format!("path is {of:?}; must lead to a value of the scene");
            let (at, numbers) = motion.at(time);
            let is_outside =
                ["", "length", "motions"].contains(&steps(of).next().unwrap_or_default());
            let place = Some(&mut tree).filter(|_| !is_outside && of != "materials");
            let place = place.and_then(|tree| tree.place(of, at));
            place.ok_or(Mistake::new(at, message))?.set(&numbers);
        }
        let materials = tree.take("materials").unwrap_or_default();
        for list in ["spheres", "planes", "blocks"] {
            let objects = tree.get_mut(list).map(|list| &mut list.parts);
            for object in objects.into_iter().flatten() {
                if let Some(material) = object.get_mut("material")
                    && let Kind::Word(_) = material.kind
                {
                    let name = String::deserialize(&*material)?;
                    let message = format!("material is {name:?}; must be in materials");
                    let mistake = Mistake::new(material.at, message);
                    let named = materials.get(&name).ok_or(mistake)?.clone();
                    *material = Node { name: "material".to_owned(), ..named };
                }
                if list == "blocks" {
                    turn(object)?;
                }
            }
        }
        Ok(tree)
    }
}

/// Rotates a block's axes by its `turn` in radians: about its z axis, then x, then y.
fn turn(block: &mut Node) -> Result<(), Mistake> {
    if let Some(axes) = block.get_mut("axes")
        && axes.parts.len() == 3
    {
        // A file has a list per axis, serde one for all.
        let numbers = axes.parts.iter().flat_map(|axis| axis.parts.clone());
        axes.parts = numbers.collect();
    }
    if let Some(turn) = block.take("turn") {
        let [x, y, z] = <[f32; 3]>::deserialize(&turn)?;
        let mut axes = Mat3::from_euler(EulerRot::YXZ, y, x, z);
        // A product with the identity loses the signs of zeros.
        if let Some(before) = block.get("axes") {
            axes = Mat3::deserialize(before)? * axes;
        }
        if let Some(place) = block.place("axes", turn.at) {
            place.set(&axes.to_cols_array());
        }
    }
    Ok(())
}
