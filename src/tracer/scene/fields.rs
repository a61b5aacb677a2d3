//! How a scene's structs are described: each field once, with its documentation, what it is where nothing is said, and the numbers
//! that it takes. The struct, its default, its check and the visit of its fields follow from that.

use super::list::List;
use super::{MAX_LETTERS, Material, Shape};
use crate::flaw::{Checked, Flaw};
use glam::{Mat3A, Vec3A};

/// The numbers that a field takes; of a vector, each of its components.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Range {
    /// The least one.
    pub least: f32,
    /// The largest one.
    pub most: f32,
    /// The same in words; empty if it may be anything, NaN included, for all that is known without other fields.
    pub takes: &'static str,
}

impl Range {
    /// Any number.
    pub const ANY: Self = Self::new(f32::NEG_INFINITY, f32::INFINITY, "");

    pub(super) const fn new(least: f32, most: f32, takes: &'static str) -> Self {
        Self { least, most, takes }
    }

    /// No number unless other fields allow it.
    pub(super) fn allowed(is_allowed: bool, takes: &'static str) -> Self {
        if is_allowed {
            Self::ANY
        } else {
            Self::new(f32::INFINITY, f32::NEG_INFINITY, takes)
        }
    }

    /// Whether it takes a number.
    #[must_use]
    pub fn holds(&self, number: f32) -> bool {
        self.takes.is_empty() || (self.least..=self.most).contains(&number)
    }
}

/// A struct of a scene, whose fields can be visited.
pub trait Fields {
    /// The name of the struct.
    fn name(&self) -> &'static str;

    /// Whether later versions have more fields, so that a program says `..` behind those that it means.
    fn grows(&self) -> bool;

    /// Visits its fields in their order.
    fn visit<'a>(&'a mut self, visitor: &mut dyn FnMut(Field<'a>));
}

/// A field of a struct, to be read or changed.
pub struct Field<'a> {
    /// Its name.
    pub name: &'static str,
    /// Whether a scene file has to say it. Where it says nothing of others, they are as in the struct's default.
    pub is_needed: bool,
    /// The numbers that it takes, whatever other fields say.
    pub range: Range,
    /// The value that it has.
    pub value: Value<'a>,
}

/// The value of a field.
pub enum Value<'a> {
    /// A number.
    Number(&'a mut f32),
    /// A point, a direction or a colour.
    Vector(&'a mut Vec3A),
    /// Three directions.
    Axes(&'a mut Mat3A),
    /// Whether something is so.
    Flag(&'a mut bool),
    /// The shape of a block.
    Shape(&'a mut Shape),
    /// Text.
    Letters(&'a mut List<u8, MAX_LETTERS>),
    /// A material, which objects may share.
    Material(&'a mut Material),
    /// Another struct.
    Struct(&'a mut dyn Fields),
    /// A struct that may be there or not.
    Optional(&'a mut dyn Items),
    /// Several structs.
    List(&'a mut dyn Items),
}

/// Visits each number of a struct, and of all that is in it, with the name and the range of the field that it is in.
pub fn numbers<'a>(
    fields: &'a mut dyn Fields,
    visitor: &mut dyn FnMut(&'static str, Range, &'a mut f32),
) {
    fields.visit(&mut |field| {
        let (name, range) = (field.name, field.range);
        let mut vector = |vector: &'a mut Vec3A| {
            let all: &mut [f32; 3] = vector.as_mut();
            all.iter_mut()
                .for_each(|number| visitor(name, range, number));
        };
        match field.value {
            Value::Number(number) => visitor(name, range, number),
            Value::Vector(place) => vector(place),
            Value::Axes(axes) => {
                vector(&mut axes.x_axis);
                vector(&mut axes.y_axis);
                vector(&mut axes.z_axis);
            }
            Value::Material(material) => numbers(material, visitor),
            Value::Struct(fields) => numbers(fields, visitor),
            Value::Optional(items) | Value::List(items) => {
                items.each(&mut |item| numbers(item, visitor));
            }
            Value::Flag(_) | Value::Shape(_) | Value::Letters(_) => {}
        }
    });
}

/// Structs of one kind, up to some number.
pub trait Items {
    /// The most that there may be.
    fn capacity(&self) -> usize;
    /// Replaces them by so many that are as in the struct's default. Those beyond the capacity are left out.
    fn reset(&mut self, count: usize);
    /// Visits each.
    fn each<'a>(&'a mut self, visitor: &mut dyn FnMut(&'a mut dyn Fields));
}

impl<T: Fields + Copy + Default, const N: usize> Items for List<T, N> {
    fn capacity(&self) -> usize {
        N
    }

    fn reset(&mut self, count: usize) {
        self.clear();
        for _ in 0..count.min(N) {
            self.push(T::default());
        }
    }

    fn each<'a>(&'a mut self, visitor: &mut dyn FnMut(&'a mut dyn Fields)) {
        self.iter_mut().for_each(|item| visitor(item));
    }
}

impl<T: Fields + Default> Items for Option<T> {
    fn capacity(&self) -> usize {
        1
    }

    fn reset(&mut self, count: usize) {
        *self = (count > 0).then(T::default);
    }

    fn each<'a>(&'a mut self, visitor: &mut dyn FnMut(&'a mut dyn Fields)) {
        self.iter_mut().for_each(|item| visitor(item));
    }
}

/// The type of a field.
pub(super) trait Part: Sized {
    /// All zeros.
    const ZERO: Self;

    /// Whether all its numbers are in their ranges.
    fn check(&self, of: Checked, name: &'static str, range: Range) -> Result<(), Flaw>;

    fn value(&mut self) -> Value<'_>;
}

impl Part for f32 {
    const ZERO: Self = 0.0;

    fn check(&self, of: Checked, name: &'static str, range: Range) -> Result<(), Flaw> {
        of.field(name, *self, range.takes, range.holds(*self))
    }

    fn value(&mut self) -> Value<'_> {
        Value::Number(self)
    }
}

impl Part for Vec3A {
    const ZERO: Self = Vec3A::ZERO;

    fn check(&self, of: Checked, name: &'static str, range: Range) -> Result<(), Flaw> {
        let is_in_range = self.to_array().into_iter().all(|c| range.holds(c));
        of.field(name, *self, range.takes, is_in_range)
    }

    fn value(&mut self) -> Value<'_> {
        Value::Vector(self)
    }
}

impl Part for Mat3A {
    const ZERO: Self = Mat3A::ZERO;

    fn check(&self, of: Checked, _: &'static str, range: Range) -> Result<(), Flaw> {
        let [x, y, z] = [0, 1, 2].map(|i| self.col(i));
        for (name, axis, next) in [
            ("axes.x_axis", x, y),
            ("axes.y_axis", y, z),
            ("axes.z_axis", z, x),
        ] {
            of.field(name, axis, range.takes, is_unit(axis))?;
            let takes = "a direction square to the other axes";
            of.field(name, axis, takes, axis.dot(next).abs() < 1e-4)?;
        }
        Ok(())
    }

    fn value(&mut self) -> Value<'_> {
        Value::Axes(self)
    }
}

/// Whether a direction has the length 1.
pub(super) fn is_unit(v: Vec3A) -> bool {
    (v.length() - 1.0).abs() < 1e-4
}

/// Types that have no numbers to check.
macro_rules! unchecked {
    ($($type:ty, $zero:expr, $kind:ident;)*) => {
        $(impl Part for $type {
            const ZERO: Self = $zero;

            fn check(&self, _: Checked, _: &'static str, _: Range) -> Result<(), Flaw> {
                Ok(())
            }

            fn value(&mut self) -> Value<'_> {
                Value::$kind(self)
            }
        })*
    };
}

unchecked! {
    bool, false, Flag;
    Shape, Shape::Box, Shape;
    List<u8, MAX_LETTERS>, Self::over(0), Letters;
}

impl<T: Fields + Part + Copy + Default, const N: usize> Part for List<T, N> {
    const ZERO: Self = Self::over(T::ZERO);

    fn check(&self, _: Checked, name: &'static str, range: Range) -> Result<(), Flaw> {
        let mut items = self.iter().enumerate();
        items.try_for_each(|(i, item)| item.check(Checked::item(name, i), name, range))
    }

    fn value(&mut self) -> Value<'_> {
        Value::List(self)
    }
}

impl<T: Fields + Part + Default> Part for Option<T> {
    const ZERO: Self = None;

    fn check(&self, of: Checked, name: &'static str, range: Range) -> Result<(), Flaw> {
        self.iter().try_for_each(|item| item.check(of, name, range))
    }

    fn value(&mut self) -> Value<'_> {
        Value::Optional(self)
    }
}

/// Declares a struct of a scene.
///
/// After its name stands what messages put before the names of its fields where they do not name it, such as "material." for a
/// sphere's. After the type of a field stands what it is by default, if a scene file may leave it out; the numbers that it takes;
/// and what has to be so with regard to other fields, each with words for what it takes.
///
/// A struct that is going to have more fields ends with `.. _more;`, a field of no size that documentation leaves out. With it the
/// compiler asks programs elsewhere for `..`, as `#[non_exhaustive]` would, which however forbids them to build the struct at all.
macro_rules! fields {
    (
        $(#[$meta:meta])*
        pub struct $name:ident in $prefix:literal $(as $kind:ident)? {
            $(
                $(#[$doc:meta])*
                $field:ident: $type:ty $(= $default:expr)? $(, in $range:expr)? $(, if $rule:expr => $takes:literal)*;
            )*
            $(.. $more:ident;)?
        }
    ) => {
        $(#[$meta])*
        #[derive(Clone, Copy, Debug, PartialEq)]
        #[cfg_attr(
            feature = "serde",
            derive(serde::Serialize, serde::Deserialize),
            serde(default, deny_unknown_fields)
        )]
        pub struct $name {
            $($(#[$doc])* pub $field: $type,)*
            $(
                #[doc(hidden)]
                #[cfg_attr(feature = "serde", serde(skip))]
                pub $more: (),
            )?
        }

        impl $name {
            /// The value where nothing is said.
            pub(super) const STANDARD: Self = Self {
                $($field: fields!(@default $($default)?),)*
                $($more: (),)?
            };
        }

        impl Default for $name {
            fn default() -> Self {
                Self::STANDARD
            }
        }

        impl $crate::scene::fields::Fields for $name {
            fn name(&self) -> &'static str {
                stringify!($name)
            }

            fn grows(&self) -> bool {
                fields!(@grows $($more)?)
            }

            fn visit<'a>(&'a mut self, visitor: &mut dyn FnMut($crate::scene::fields::Field<'a>)) {
                $(visitor($crate::scene::fields::Field {
                    name: stringify!($field),
                    is_needed: fields!(@is_needed $($default)?),
                    range: fields!(@range $($range)?),
                    value: $crate::scene::fields::Part::value(&mut self.$field),
                });)*
            }
        }

        impl $crate::scene::fields::Part for $name {
            const ZERO: Self = Self {
                $($field: $crate::scene::fields::Part::ZERO,)*
                $($more: (),)?
            };

            fn check(
                &self,
                of: $crate::flaw::Checked,
                name: &'static str,
                _: $crate::scene::fields::Range,
            ) -> Result<(), $crate::flaw::Flaw> {
                let of = of.or_one(name);
                $(
                    let name = concat!($prefix, stringify!($field));
                    self.$field.check(of, name, fields!(@range $($range)?))?;
                    $(
                        let rule: fn(&Self) -> bool = $rule;
                        self.$field.check(of, name, $crate::scene::fields::Range::allowed(rule(self), $takes))?;
                    )*
                )*
                Ok(())
            }

            fn value(&mut self) -> $crate::scene::fields::Value<'_> {
                fields!(@value self $($kind)?)
            }
        }
    };
    (@default) => { $crate::scene::fields::Part::ZERO };
    (@default $default:expr) => { $default };
    (@grows) => { false };
    (@grows $more:ident) => { true };
    (@is_needed) => { true };
    (@is_needed $default:expr) => { false };
    (@range) => { $crate::scene::fields::Range::ANY };
    (@range $range:expr) => { $range };
    (@value $self:ident) => { $crate::scene::fields::Value::Struct($self) };
    (@value $self:ident $kind:ident) => { $crate::scene::fields::Value::$kind($self) };
}
