//! The contents of a scene file as a tree with the places of values.

use super::message::quoted;
use ron::error::SpannedError;
use ron::value::RawValue;
use serde::de::value::{MapDeserializer, SeqDeserializer, StrDeserializer};
use serde::de::{self, Deserializer, Error as _, Expected, IntoDeserializer};
use serde::de::{MapAccess, SeqAccess, Unexpected, Visitor};
use std::cmp::Reverse;
use std::fmt;

/// The fields of `Presentation`.
pub const PRESENTATION: [&str; 3] = ["sectors", "method", "captions"];

/// Follows the name of an unknown field.
pub const UNKNOWN: &str = " is unknown";

#[derive(Clone, Debug, Default, PartialEq)]
pub struct Node {
    /// The name of the field or entry, or the index of the item.
    pub name: String,
    /// The value's offset in the text.
    pub at: usize,
    pub kind: Kind,
    /// Fields, entries or items.
    pub parts: Vec<Node>,
}

#[derive(Clone, Debug, Default, PartialEq)]
pub enum Kind {
    Number(f32),
    /// A name, a boolean or quoted text, verbatim.
    Word(String),
    List,
    #[default]
    Struct,
}

impl Node {
    pub fn read(text: &str) -> Result<Self, SpannedError> {
        let mut from = ron::Deserializer::from_str(text)?;
        let node = from.deserialize_any(Reader(text));
        let node = node.and_then(|node| from.end().map(|()| node));
        node.map_err(|error| from.span_error(error))
    }

    fn new(name: String, at: usize, kind: Kind) -> Self {
        Self { name, at, kind, parts: Vec::new() }
    }

    pub fn set(&mut self, numbers: &[f32]) {
        let at = self.at;
        let number = |(i, &n): (usize, _)| Self::new(i.to_string(), at, Kind::Number(n));
        self.parts = numbers.iter().enumerate().map(number).collect();
        self.kind = Kind::List;
        if self.parts.len() == 1 {
            self.kind = self.parts.remove(0).kind;
        }
    }

    pub fn get(&self, name: &str) -> Option<&Self> {
        self.parts.iter().find(|part| part.name == name)
    }

    pub fn get_mut(&mut self, name: &str) -> Option<&mut Self> {
        self.parts.iter_mut().find(|part| part.name == name)
    }

    pub fn take(&mut self, name: &str) -> Option<Self> {
        let i = self.parts.iter().position(|part| part.name == name)?;
        Some(self.parts.remove(i))
    }

    /// Returns the value at a path such as `materials["gold"].colour[0]`, with a new place. Adds
    /// missing fields.
    pub fn place(&mut self, path: &str, at: usize) -> Option<&mut Self> {
        let place = steps(path).try_fold(self, |node, name| {
            let is_struct = node.kind == Kind::Struct && node.name != "materials";
            if is_struct && node.get(name).is_none() {
                let field = Self::new(name.to_owned(), at, Kind::Struct);
                node.parts.push(field);
            }
            node.get_mut(name)
        })?;
        place.at = at;
        Some(place)
    }

    /// Returns the value at a path, or the last existing one on it.
    pub fn nearest(&self, path: &str) -> &Self {
        let found = steps(path).try_fold(self, |node, name| node.get(name).ok_or(node));
        found.unwrap_or_else(|last| last)
    }
}

pub fn steps(path: &str) -> impl Iterator<Item = &str> {
    let steps = path.split(['.', '[']);
    steps.map(|step| step.trim_end_matches(']').trim_matches('"'))
}

#[derive(Clone, Copy)]
struct Reader<'a>(&'a str);

impl Reader<'_> {
    fn node(self, name: String, raw: &RawValue) -> Node {
        let text = raw.trim().get_ron();
        let number = ron::from_str(text).map(Kind::Number);
        let kind = number.unwrap_or_else(|_| Kind::Word(text.to_owned()));
        let at = text.as_ptr().addr() - self.0.as_ptr().addr();
        let mut node = Node::new(name, at, kind);
        if text.ends_with([')', ']', '}'])
            && let Ok(mut from) = ron::Deserializer::from_str(text)
            && let Ok(Node { kind, parts, .. }) = from.deserialize_any(self)
        {
            (node.kind, node.parts) = (kind, parts);
        }
        node
    }
}

impl<'de> Visitor<'de> for Reader<'_> {
    type Value = Node;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a scene")
    }

    fn visit_unit<E>(self) -> Result<Node, E> {
        Ok(Node::default())
    }

    fn visit_some<D: Deserializer<'de>>(self, from: D) -> Result<Node, D::Error> {
        from.deserialize_any(self)
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut items: A) -> Result<Node, A::Error> {
        let mut list = Node::new(String::new(), 0, Kind::List);
        while let Some(item) = items.next_element()? {
            list.parts.push(self.node(list.parts.len().to_string(), item));
        }
        Ok(list)
    }

    fn visit_map<A: MapAccess<'de>>(self, mut fields: A) -> Result<Node, A::Error> {
        let mut node = Node::default();
        while let Some((name, value)) = fields.next_entry()? {
            node.parts.push(self.node(name, value));
        }
        Ok(node)
    }
}

/// A mistake and its offset in the text.
#[derive(Debug)]
pub struct Mistake {
    pub at: Option<usize>,
    /// Begins with a dot, bracket or space until the path is complete.
    pub message: String,
}

impl Mistake {
    pub fn new(at: usize, message: impl Into<String>) -> Self {
        let (at, message) = (Some(at), message.into());
        Self { at, message }
    }

    /// Adds a node to the path. The innermost one is the place.
    fn inside(self, node: &Node) -> Self {
        let Self { at, message } = self;
        let field = message.split(' ').next().unwrap_or_default();
        let part = node.get(field.trim_start_matches('.')).unwrap_or(node);
        let at = at.unwrap_or(part.at);
        let name = &node.name;
        if name.is_empty() || !message.starts_with(['.', '[', ' ']) {
            return Self::new(at, message);
        }
        let path = match name.parse::<usize>() {
            Ok(_) => format!("[{name}]"),
            Err(_) => format!(".{name}"),
        };
        Self::new(at, path + &message)
    }
}

impl std::error::Error for Mistake {}

impl fmt::Display for Mistake {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.message)
    }
}

/// Translates serde's words for a type.
fn plain(expected: &dyn Expected) -> String {
    let text = expected.to_string().replace("struct ", "fields of ").replace("a map", "a table");
    let text = text.replace("f32 values", "numbers").replace("f32", "a number");
    let text = text.replace("a boolean", "true or false");
    text.replace("elements in sequence", "items").replace("sequence", "list")
}

impl de::Error for Mistake {
    fn custom<T: fmt::Display>(message: T) -> Self {
        let (at, message) = (None, message.to_string());
        Self { at, message }
    }

    fn invalid_type(found: Unexpected<'_>, expected: &dyn Expected) -> Self {
        let found = match found {
            Unexpected::Float(number) => number.to_string(),
            Unexpected::Seq => "a list".to_owned(),
            Unexpected::Other(text) => quoted(text),
            other => other.to_string(),
        };
        Self::custom(format_args!(" is {found}; must be {}", plain(expected)))
    }

    fn invalid_length(length: usize, expected: &dyn Expected) -> Self {
        let expected = plain(expected);
        Self::custom(format_args!(" has length {length}; must be {expected}"))
    }

    fn unknown_variant(name: &str, known: &'static [&'static str]) -> Self {
        let (name, known) = (quoted(name), known.join(", "));
        Self::custom(format_args!(" is {name}; must be one of {known}"))
    }

    fn unknown_field(name: &str, known: &'static [&'static str]) -> Self {
        let own: &[&str] = match known {
            ["camera", ..] => &["length", "materials", "motions", "sectors", "method", "captions"],
            ["of", ..] => &["keys"],
            ["shape", ..] => &["turn"],
            _ => &[],
        };
        let mut known: Vec<&str> = known.iter().chain(own).copied().collect();
        // The most alike first: the end of a long list is cut.
        known.sort_by_key(|known| {
            let letters = known.chars().zip(name.chars());
            Reverse(letters.take_while(|(a, b)| a == b).count())
        });
        let known = known.join(", ");
        Self::custom(format_args!(".{name}{UNKNOWN}; must be one of {known}"))
    }

    fn missing_field(name: &'static str) -> Self {
        Self::custom(format_args!(".{name} is missing"))
    }

    fn duplicate_field(name: &'static str) -> Self {
        Self::custom(format_args!(".{name} is set twice"))
    }
}

impl IntoDeserializer<'_, Mistake> for &Node {
    type Deserializer = Self;

    fn into_deserializer(self) -> Self {
        self
    }
}

impl<'de> Deserializer<'de> for &Node {
    type Error = Mistake;

    fn deserialize_any<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Mistake> {
        let value = match &self.kind {
            Kind::Number(number) => visitor.visit_f32(*number),
            Kind::Word(word) => match (word.as_str(), ron::from_str::<String>(word)) {
                ("true" | "false", _) => visitor.visit_bool(word == "true"),
                (_, Ok(text)) => visitor.visit_string(text),
                (_, Err(_)) => Err(Mistake::invalid_type(Unexpected::Other(word), &visitor)),
            },
            Kind::List => SeqDeserializer::new(self.parts.iter()).deserialize_any(visitor),
            Kind::Struct => {
                let fields = self.parts.iter().map(|part| (part.name.as_str(), part));
                MapDeserializer::new(fields).deserialize_any(visitor)
            }
        };
        value.map_err(|mistake| mistake.inside(self))
    }

    fn deserialize_option<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Mistake> {
        match &self.kind {
            Kind::Word(word) if word == "None" => visitor.visit_none(),
            _ => visitor.visit_some(self),
        }
    }

    fn deserialize_enum<V: Visitor<'de>>(
        self,
        _: &'static str,
        _: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, Mistake> {
        let name = match &self.kind {
            Kind::Word(name) => name,
            _ => "not a name",
        };
        let value = visitor.visit_enum(StrDeserializer::new(name));
        value.map_err(|mistake: Mistake| mistake.inside(self))
    }

    serde::forward_to_deserialize_any! {
        bool i8 i16 i32 i64 u8 u16 u32 u64 f32 f64 char str string bytes byte_buf unit unit_struct
        newtype_struct seq tuple tuple_struct map struct identifier ignored_any
    }
}
