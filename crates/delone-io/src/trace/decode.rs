//! Bytes to values, as [`binary`](super::binary) describes them. Nothing is allocated but texts, and of
//! these only what is there.

use serde::de::value::StrDeserializer;
use serde::de::{
    DeserializeSeed, Deserializer, EnumAccess, Error, SeqAccess, VariantAccess, Visitor,
};
use std::fmt;

/// Bytes that are read, and the names that have come so far.
pub(super) struct Decoder<'de> {
    bytes: &'de [u8],
    /// The next byte.
    pub at: usize,
    names: Vec<&'de str>,
}

/// Why bytes are not what was expected.
#[derive(Debug)]
pub(super) struct Broken(pub String);

impl fmt::Display for Broken {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl std::error::Error for Broken {}

impl Error for Broken {
    fn custom<T: fmt::Display>(message: T) -> Self {
        Self(message.to_string())
    }
}

impl<'de> Decoder<'de> {
    /// Begins at a byte.
    pub fn new(bytes: &'de [u8], at: usize) -> Self {
        Self {
            bytes,
            at,
            names: Vec::new(),
        }
    }

    fn take(&mut self, number: u64) -> Result<&'de [u8], Broken> {
        let rest = &self.bytes[self.at..];
        let ended = || {
            Broken(format!(
                "the file ends {} bytes early",
                number - rest.len() as u64
            ))
        };
        if number > rest.len() as u64 {
            return Err(ended());
        }
        let taken = &rest[..number as usize];
        self.at += taken.len();
        Ok(taken)
    }

    fn byte(&mut self) -> Result<u8, Broken> {
        Ok(self.take(1)?[0])
    }

    fn natural(&mut self) -> Result<u64, Broken> {
        let mut value = 0;
        for shift in (0..).step_by(7) {
            let byte = self.byte()?;
            let part = u64::from(byte & 0x7f);
            if shift > 63 || (part << shift) >> shift != part {
                return Err(Broken("a number is larger than 64 bits".to_owned()));
            }
            value |= part << shift;
            if byte < 0x80 {
                break;
            }
        }
        Ok(value)
    }

    fn text(&mut self) -> Result<&'de str, Broken> {
        let length = self.natural()?;
        let bytes = self.take(length)?;
        std::str::from_utf8(bytes).map_err(|_| Broken("a text is not UTF-8".to_owned()))
    }

    fn name(&mut self) -> Result<&'de str, Broken> {
        let number = self.natural()?;
        let known = self.names.len() as u64;
        if number > known {
            return Err(Broken(format!("name {number} of {known} that are known")));
        }
        if number == known {
            let name = self.text()?;
            self.names.push(name);
        }
        Ok(self.names[number as usize])
    }

    fn flag(&mut self) -> Result<bool, Broken> {
        match self.byte()? {
            0 => Ok(false),
            1 => Ok(true),
            other => Err(Broken(format!("byte {other} where only 0 or 1 may stand"))),
        }
    }
}

/// Answers requests for numbers: the visitor refuses what is too large for it.
macro_rules! naturals {
    ($($name:ident)*) => {
        $(fn $name<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Broken> {
            visitor.visit_u64(self.natural()?)
        })*
    };
}

impl<'de> Deserializer<'de> for &mut Decoder<'de> {
    type Error = Broken;

    naturals! { deserialize_u8 deserialize_u16 deserialize_u32 deserialize_u64 }

    fn deserialize_any<V: Visitor<'de>>(self, _: V) -> Result<V::Value, Broken> {
        Err(Broken("a value of unknown kind".to_owned()))
    }

    fn deserialize_bool<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Broken> {
        visitor.visit_bool(self.flag()?)
    }

    fn deserialize_f64<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Broken> {
        let bytes = self.take(8)?.try_into().expect("bug: eight bytes");
        visitor.visit_f64(f64::from_le_bytes(bytes))
    }

    fn deserialize_str<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Broken> {
        visitor.visit_borrowed_str(self.text()?)
    }

    fn deserialize_string<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Broken> {
        self.deserialize_str(visitor)
    }

    fn deserialize_option<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Broken> {
        if self.flag()? {
            visitor.visit_some(self)
        } else {
            visitor.visit_none()
        }
    }

    fn deserialize_newtype_struct<V: Visitor<'de>>(
        self,
        _: &'static str,
        visitor: V,
    ) -> Result<V::Value, Broken> {
        visitor.visit_newtype_struct(self)
    }

    fn deserialize_tuple<V: Visitor<'de>>(
        self,
        length: usize,
        visitor: V,
    ) -> Result<V::Value, Broken> {
        visitor.visit_seq(Fields {
            decoder: self,
            left: length,
        })
    }

    fn deserialize_struct<V: Visitor<'de>>(
        self,
        _: &'static str,
        fields: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, Broken> {
        self.deserialize_tuple(fields.len(), visitor)
    }

    fn deserialize_enum<V: Visitor<'de>>(
        self,
        _: &'static str,
        _: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, Broken> {
        visitor.visit_enum(self)
    }

    serde::forward_to_deserialize_any! {
        i8 i16 i32 i64 i128 u128 f32 char bytes byte_buf unit unit_struct seq tuple_struct map identifier
        ignored_any
    }
}

/// So many values, one after the other.
struct Fields<'d, 'de> {
    decoder: &'d mut Decoder<'de>,
    left: usize,
}

impl<'de> SeqAccess<'de> for Fields<'_, 'de> {
    type Error = Broken;

    fn next_element_seed<T: DeserializeSeed<'de>>(
        &mut self,
        seed: T,
    ) -> Result<Option<T::Value>, Broken> {
        let Some(left) = self.left.checked_sub(1) else {
            return Ok(None);
        };
        self.left = left;
        seed.deserialize(&mut *self.decoder).map(Some)
    }
}

impl<'de> EnumAccess<'de> for &mut Decoder<'de> {
    type Error = Broken;
    type Variant = Self;

    fn variant_seed<V: DeserializeSeed<'de>>(self, seed: V) -> Result<(V::Value, Self), Broken> {
        let name = self.name()?;
        let variant = seed.deserialize(StrDeserializer::<Broken>::new(name))?;
        Ok((variant, self))
    }
}

impl<'de> VariantAccess<'de> for &mut Decoder<'de> {
    type Error = Broken;

    fn unit_variant(self) -> Result<(), Broken> {
        Ok(())
    }

    fn newtype_variant_seed<T: DeserializeSeed<'de>>(self, seed: T) -> Result<T::Value, Broken> {
        seed.deserialize(self)
    }

    fn tuple_variant<V: Visitor<'de>>(self, length: usize, visitor: V) -> Result<V::Value, Broken> {
        self.deserialize_tuple(length, visitor)
    }

    fn struct_variant<V: Visitor<'de>>(
        self,
        fields: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, Broken> {
        self.deserialize_tuple(fields.len(), visitor)
    }
}
