//! Serde formats of lists: as sequences, and letters as text.

use super::List;
use core::fmt;
use serde::de::{Deserialize, Deserializer, Error, SeqAccess, Visitor};
use serde::ser::{Serialize, Serializer};

impl<T: Serialize, const N: usize> Serialize for List<T, N> {
    fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        to.collect_seq(&**self)
    }
}

impl<'de, T: Copy + Default + Deserialize<'de>, const N: usize> Deserialize<'de> for List<T, N> {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
        from.deserialize_seq(Self::default())
    }
}

impl<'de, T: Copy + Default + Deserialize<'de>, const N: usize> Visitor<'de> for List<T, N> {
    type Value = Self;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "a list of at most {N} items")
    }

    fn visit_seq<A: SeqAccess<'de>>(mut self, mut items: A) -> Result<Self, A::Error> {
        let mut len = 0;
        while let Some(item) = items.next_element()? {
            len += 1;
            let _ = self.try_push(item);
        }
        if len > N {
            return Err(A::Error::invalid_length(len, &self));
        }
        Ok(self)
    }
}

pub(crate) mod text {
    use super::*;

    pub fn serialize<S: Serializer>(letters: &[u8], to: S) -> Result<S::Ok, S::Error> {
        let text = core::str::from_utf8(letters).map_err(serde::ser::Error::custom)?;
        to.serialize_str(text)
    }

    pub fn deserialize<'de, D: Deserializer<'de>, const N: usize>(
        from: D,
    ) -> Result<List<u8, N>, D::Error> {
        from.deserialize_str(Text)
    }

    struct Text<const N: usize>;

    impl<const N: usize> Visitor<'_> for Text<N> {
        type Value = List<u8, N>;

        fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
            write!(f, "text of at most {N} bytes")
        }

        fn visit_str<E: Error>(self, text: &str) -> Result<Self::Value, E> {
            let letters = text.as_bytes().try_into();
            letters.map_err(|_| E::invalid_length(text.len(), &self))
        }
    }
}
