//! Reads the text of a scene file as a tree with all fields, those too that it leaves out.

use super::earlier;
use super::motion::Motion;
use super::tree::{self, NamedShape, TURN};
use eightfold_tracer::scene::{Fields, Items, Material, Scene, Value as Place};
use ron::error::SpannedError;
use ron::extensions::Extensions;
use serde::Deserialize;
use serde::de::{DeserializeSeed, Deserializer, Error, MapAccess, SeqAccess, Visitor};
use serde_json::{Map, Value, json};
use std::collections::BTreeMap;
use std::fmt;

/// The tree of a file, without the motions, and these.
///
/// # Errors
/// Text that is no RON, or a field that a scene does not have, and where it is.
pub fn read(text: &str) -> Result<(Value, Vec<Motion>), SpannedError> {
    let options = ron::Options::default().with_default_extension(Extensions::IMPLICIT_SOME);
    let mut motions = Vec::new();
    let file = Struct {
        fields: &mut Scene::default(),
        file: Some(&mut motions),
    };
    let tree = options.from_str_seed(text, file)?;
    Ok((tree, motions))
}

/// A struct of the library that is read, and with `file` what else is in a file beside a scene's fields.
struct Struct<'a> {
    fields: &'a mut dyn Fields,
    file: Option<&'a mut Vec<Motion>>,
}

/// The ways in which a field is read.
enum Seed<'a> {
    /// A place of the library's scene.
    Place(Place<'a>),
    /// Three numbers of a file's own.
    Turn,
    /// Materials by name.
    Materials,
}

impl Struct<'_> {
    /// How a field is read; `None` if there is none of that name.
    fn seed(&mut self, name: &str) -> Option<Seed<'_>> {
        let mut seed = None;
        self.fields.visit(&mut |field| {
            if field.name == name {
                seed = Some(Seed::Place(field.value));
            } else if name == TURN && matches!(field.value, Place::Axes(_)) {
                seed = Some(Seed::Turn);
            }
        });
        seed.or((self.file.is_some() && name == "materials").then_some(Seed::Materials))
    }

    /// The message about a field of a name that none has.
    fn unknown(&self, name: &str, tree: &Value) -> String {
        let names = tree.as_object().into_iter().flatten();
        let mut names: Vec<&str> = names.map(|(name, _)| name.as_str()).collect();
        names.extend(self.file.as_ref().map(|_| "motions"));
        let (kind, names) = (self.fields.name(), names.join("`, `"));
        format!("`{kind}` has no field `{name}`, and takes `{names}`")
    }

    /// A field that has to be there, and is not said.
    fn missing(&mut self, said: &[String]) -> Option<&'static str> {
        let mut missing = None;
        self.fields.visit(&mut |field| {
            if field.is_needed && !said.iter().any(|name| name == field.name) {
                missing = Some(field.name);
            }
        });
        missing
    }
}

impl<'de> DeserializeSeed<'de> for Struct<'_> {
    type Value = Value;

    fn deserialize<D: Deserializer<'de>>(self, from: D) -> Result<Value, D::Error> {
        from.deserialize_struct(self.fields.name(), &[], self)
    }
}

impl<'de> Visitor<'de> for Struct<'_> {
    type Value = Value;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "struct {}", self.fields.name())
    }

    fn visit_map<A: MapAccess<'de>>(mut self, mut map: A) -> Result<Value, A::Error> {
        let kind = self.fields.name();
        let mut tree = match self.file {
            Some(_) => tree::standard(),
            None => tree::of(self.fields),
        };
        let mut said = Vec::new();
        while let Some(name) = map.next_key()? {
            let name = earlier::field(kind, name);
            if said.contains(&name) {
                return Err(A::Error::custom(format!("`{name}` is twice in `{kind}`")));
            }
            match (name.as_str(), &mut self.file) {
                ("motions", Some(motions)) => **motions = map.next_value()?,
                ("length", Some(_)) => tree["length"] = json!(map.next_value::<f32>()?),
                _ => {
                    let Some(seed) = self.seed(&name) else {
                        return Err(A::Error::custom(self.unknown(&name, &tree)));
                    };
                    tree[&name] = map.next_value_seed(seed)?;
                }
            }
            said.push(name);
        }
        match self.missing(&said) {
            None => Ok(tree),
            Some(name) => Err(A::Error::custom(format!("`{kind}` takes a field `{name}`"))),
        }
    }
}

impl<'de> DeserializeSeed<'de> for Seed<'_> {
    type Value = Value;

    fn deserialize<D: Deserializer<'de>>(self, from: D) -> Result<Value, D::Error> {
        let place = match self {
            Self::Place(place) => place,
            Self::Turn => return Ok(json!(<[f32; 3]>::deserialize(from)?)),
            Self::Materials => return from.deserialize_map(Materials),
        };
        Ok(match place {
            Place::Number(_) => json!(f32::deserialize(from)?),
            Place::Vector(_) => json!(<[f32; 3]>::deserialize(from)?),
            Place::Axes(_) => json!(<[[f32; 3]; 3]>::deserialize(from)?),
            Place::Flag(_) => json!(bool::deserialize(from)?),
            Place::Letters(_) | Place::Material(_) => json!(String::deserialize(from)?),
            Place::Shape(_) => {
                let mut shape = NamedShape::deserialize(from)?;
                tree::value(Place::Shape(&mut shape))
            }
            Place::Struct(fields) => Struct { fields, file: None }.deserialize(from)?,
            Place::Optional(items) => from.deserialize_option(Several(items))?,
            Place::List(items) => from.deserialize_seq(Several(items))?,
        })
    }
}

/// A struct as an item of others is by default.
struct Item<'a>(&'a mut dyn Items);

impl<'de> DeserializeSeed<'de> for Item<'_> {
    type Value = Value;

    fn deserialize<D: Deserializer<'de>>(self, from: D) -> Result<Value, D::Error> {
        self.0.reset(1);
        let mut item = None;
        self.0
            .each(&mut |fields| item = Some(Struct { fields, file: None }));
        let item = item.ok_or_else(|| D::Error::custom("there is room for none"))?;
        item.deserialize(from)
    }
}

/// Structs in a list, or one that may be there.
struct Several<'a>(&'a mut dyn Items);

impl<'de> Visitor<'de> for Several<'_> {
    type Value = Value;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a list, or a struct or None")
    }

    fn visit_none<E>(self) -> Result<Value, E> {
        Ok(Value::Null)
    }

    fn visit_some<D: Deserializer<'de>>(self, from: D) -> Result<Value, D::Error> {
        Item(self.0).deserialize(from)
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut items: A) -> Result<Value, A::Error> {
        let mut list = Vec::new();
        while let Some(item) = items.next_element_seed(Item(&mut *self.0))? {
            list.push(item);
        }
        Ok(Value::Array(list))
    }
}

/// The table of materials.
struct Materials;

impl<'de> Visitor<'de> for Materials {
    type Value = Value;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("materials by name")
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Value, A::Error> {
        // In the order of their names.
        let mut table = BTreeMap::new();
        while let Some(name) = map.next_key::<String>()? {
            let material = map.next_value_seed(Struct {
                fields: &mut Material::default(),
                file: None,
            })?;
            table.insert(name, material);
        }
        Ok(Value::Object(table.into_iter().collect::<Map<_, _>>()))
    }
}
