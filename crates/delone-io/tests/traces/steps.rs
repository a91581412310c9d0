//! Steps made up from random bits, whatever the vocabulary holds: it is asked through `serde`, so that a new
//! event is tested as soon as there is one.

use delone::{Event, Log, Point, Step};
use delone_io::Recording;
use serde::de::value::{Error, StrDeserializer};
use serde::de::{DeserializeSeed, Deserializer, EnumAccess, SeqAccess, VariantAccess, Visitor};
use serde::{Deserialize, forward_to_deserialize_any};

/// Makes values of any type of random bits.
pub struct Maker {
    state: u64,
    /// The variant to be taken of the next choice, else a random one.
    choose: Option<usize>,
    /// Vertices are numbered below this.
    pub vertices: u64,
    /// Whether numbers may be of any size.
    pub wild: bool,
}

impl Maker {
    pub fn new(seed: u64) -> Self {
        Self {
            state: seed,
            choose: None,
            vertices: 1 << 32,
            wild: true,
        }
    }

    /// Random bits (splitmix64).
    pub fn bits(&mut self) -> u64 {
        self.state = self.state.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.state;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    pub fn below(&mut self, bound: u64) -> u64 {
        self.bits() % bound
    }

    /// A finite number; wild ones are of any exponent.
    pub fn number(&mut self) -> f64 {
        let number = f64::from_bits(self.bits());
        match self.wild && number.is_finite() {
            true => number,
            false => self.below(100) as f64 / 10.0,
        }
    }

    /// An event of a kind; `None`: of any.
    pub fn event(&mut self, kind: Option<usize>) -> Event {
        self.choose = kind;
        Event::deserialize(self).expect("every event can be made up")
    }
}

/// One event of each kind, in their order.
pub fn one_of_each(seed: u64, adjust: impl Fn(&mut Maker)) -> Vec<Event> {
    let mut maker = Maker::new(seed);
    adjust(&mut maker);
    let number = kinds();
    (0..number).map(|kind| maker.event(Some(kind))).collect()
}

/// How many kinds of events there are.
fn kinds() -> usize {
    struct Names<'n>(&'n mut usize);
    impl<'de> Deserializer<'de> for Names<'_> {
        type Error = Error;
        fn deserialize_any<V: Visitor<'de>>(self, _: V) -> Result<V::Value, Error> {
            unreachable!("an event is one of several")
        }
        fn deserialize_enum<V: Visitor<'de>>(
            self,
            _: &'static str,
            names: &'static [&'static str],
            _: V,
        ) -> Result<V::Value, Error> {
            *self.0 = names.len();
            Err(serde::de::Error::custom("only asked"))
        }
        forward_to_deserialize_any! {
            bool i8 i16 i32 i64 i128 u8 u16 u32 u64 u128 f32 f64 char str string bytes byte_buf option unit
            unit_struct newtype_struct seq tuple tuple_struct map struct identifier ignored_any
        }
    }
    let mut number = 0;
    Event::deserialize(Names(&mut number)).expect_err("only asked");
    number
}

/// A log of events, over some points.
pub fn recording(points: Vec<Point>, events: impl IntoIterator<Item = Event>) -> Recording {
    let mut log = Log::new("made-up", points);
    let steps = events.into_iter().enumerate();
    log.steps.extend(steps.map(|(i, event)| Step {
        line: (i % 3 + 1) as u16,
        event,
    }));
    Recording {
        title: "a made-up run".to_owned(),
        source: "Müller & \"Söhne\" <1900>\n".to_owned(),
        code: ["first", "  then: a < b & c", "last"]
            .map(str::to_owned)
            .into(),
        log,
    }
}

impl<'de> Deserializer<'de> for &mut Maker {
    type Error = Error;

    fn deserialize_any<V: Visitor<'de>>(self, _: V) -> Result<V::Value, Error> {
        unreachable!("steps tell what they are made of")
    }

    fn deserialize_bool<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Error> {
        visitor.visit_bool(self.below(2) == 0)
    }

    fn deserialize_u32<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Error> {
        let small = self.below(1 << 32).min(self.vertices - 1);
        let number = match self.below(2) {
            0 => self.below(self.vertices),
            _ => small % 200,
        };
        visitor.visit_u64(number)
    }

    fn deserialize_u64<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Error> {
        visitor.visit_u64(self.bits())
    }

    fn deserialize_f64<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Error> {
        visitor.visit_f64(self.number())
    }

    fn deserialize_option<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Error> {
        match self.below(3) {
            0 => visitor.visit_none(),
            _ => visitor.visit_some(self),
        }
    }

    fn deserialize_newtype_struct<V: Visitor<'de>>(
        self,
        _: &'static str,
        visitor: V,
    ) -> Result<V::Value, Error> {
        visitor.visit_newtype_struct(self)
    }

    fn deserialize_tuple<V: Visitor<'de>>(
        self,
        length: usize,
        visitor: V,
    ) -> Result<V::Value, Error> {
        visitor.visit_seq(Fields(self, length))
    }

    fn deserialize_struct<V: Visitor<'de>>(
        self,
        _: &'static str,
        fields: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, Error> {
        visitor.visit_seq(Fields(self, fields.len()))
    }

    fn deserialize_enum<V: Visitor<'de>>(
        self,
        _: &'static str,
        names: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, Error> {
        let kind = self.choose.take();
        let kind = kind.unwrap_or_else(|| self.below(names.len() as u64) as usize);
        visitor.visit_enum(Choice(self, names[kind]))
    }

    forward_to_deserialize_any! {
        i8 i16 i32 i64 i128 u8 u16 u128 f32 char str string bytes byte_buf unit unit_struct seq tuple_struct map
        identifier ignored_any
    }
}

struct Fields<'m>(&'m mut Maker, usize);

impl<'de> SeqAccess<'de> for Fields<'_> {
    type Error = Error;

    fn next_element_seed<T: DeserializeSeed<'de>>(
        &mut self,
        seed: T,
    ) -> Result<Option<T::Value>, Error> {
        if self.1 == 0 {
            return Ok(None);
        }
        self.1 -= 1;
        seed.deserialize(&mut *self.0).map(Some)
    }
}

struct Choice<'m>(&'m mut Maker, &'static str);

impl<'de, 'm> EnumAccess<'de> for Choice<'m> {
    type Error = Error;
    type Variant = &'m mut Maker;

    fn variant_seed<V: DeserializeSeed<'de>>(
        self,
        seed: V,
    ) -> Result<(V::Value, &'m mut Maker), Error> {
        let name = StrDeserializer::<Error>::new(self.1);
        Ok((seed.deserialize(name)?, self.0))
    }
}

impl<'de> VariantAccess<'de> for &mut Maker {
    type Error = Error;

    fn unit_variant(self) -> Result<(), Error> {
        Ok(())
    }

    fn newtype_variant_seed<T: DeserializeSeed<'de>>(self, seed: T) -> Result<T::Value, Error> {
        seed.deserialize(self)
    }

    fn tuple_variant<V: Visitor<'de>>(self, length: usize, visitor: V) -> Result<V::Value, Error> {
        visitor.visit_seq(Fields(self, length))
    }

    fn struct_variant<V: Visitor<'de>>(
        self,
        fields: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, Error> {
        visitor.visit_seq(Fields(self, fields.len()))
    }
}

#[test]
fn events_of_every_kind_are_made_up() {
    let events = one_of_each(1, |_| {});
    let kinds: std::collections::HashSet<_> = events.iter().map(std::mem::discriminant).collect();
    assert_eq!(kinds.len(), events.len());
    assert!(kinds.len() > 30, "{events:?}");
}
