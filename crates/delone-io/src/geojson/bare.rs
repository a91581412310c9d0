//! JSON that is no GeoJSON but a bare array: coordinates as libraries of triangulation take them.
//!
//! - `[[x, y], …]` are points, a third number of each is z, as Delaunator's files have them;
//! - `[x, y, x, y, …]` are the same without the inner brackets;
//! - `[[[x, y], …], …]` are the rings of one polygon, outline and holes, as Earcut's files have them. Rings
//!   close by themselves. A ring of one position is a loose point, one of two a line.

use super::tree::Pulse;
use crate::Problem;
use crate::shapes::{Position, Shapes};
use delone::Point;
use serde::de::{DeserializeSeed, Deserializer, Error, SeqAccess, Visitor};
use std::fmt;

/// Tells whether text begins like a bare array.
pub(super) fn sniff(text: &[u8]) -> bool {
    let Some(rest) = text.strip_prefix(b"[") else {
        return false;
    };
    let next = rest.iter().find(|b| !b.is_ascii_whitespace());
    next.is_none_or(|b| matches!(b, b'[' | b']' | b'-' | b'0'..=b'9'))
}

/// Reads the array that is the whole file.
pub(super) struct ArraySeed<'r, 'w> {
    pub shapes: &'r mut Shapes,
    pub pulse: &'r Pulse<'w>,
}

/// What stands in the array.
enum Item {
    Number(f64),
    Position(Position),
    Ring(Vec<Position>),
}

impl Item {
    fn name(&self) -> &'static str {
        match self {
            Self::Number(_) => "numbers",
            Self::Position(_) => "positions",
            Self::Ring(_) => "rings",
        }
    }
}

impl<'de> DeserializeSeed<'de> for ArraySeed<'_, '_> {
    type Value = ();

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<(), D::Error> {
        deserializer.deserialize_seq(self)
    }
}

impl<'de> Visitor<'de> for ArraySeed<'_, '_> {
    type Value = ();

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("an array")
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut seq: A) -> Result<(), A::Error> {
        let Self { shapes, pulse } = self;
        let mut first: Option<&'static str> = None;
        // The x whose y is still to come, and the rings so far.
        let mut x = None;
        let mut rings = Vec::new();
        while let Some(item) = seq.next_element_seed(ItemSeed { pulse, depth: 0 })? {
            let kind = *first.get_or_insert(item.name());
            if kind != item.name() {
                let text = format!("{kind} and {} in one array", item.name());
                return Err(A::Error::custom(text));
            }
            let added = match item {
                Item::Number(y) => match x.take() {
                    Some(x) => shapes.point(position(&[x, y])),
                    None => {
                        x = Some(y);
                        Ok(())
                    }
                },
                Item::Position(position) => shapes.point(position),
                Item::Ring(ring) => {
                    rings.push(ring);
                    Ok(())
                }
            };
            added.map_err(A::Error::custom)?;
        }
        if x.is_some() {
            let text = "an odd number of coordinates: the last x has no y";
            return Err(A::Error::custom(text));
        }
        add_rings(shapes, rings).map_err(A::Error::custom)?;
        shapes.end_feature(None);
        Ok(())
    }
}

/// Adds the rings of one polygon; those without area are what is left of them.
fn add_rings(shapes: &mut Shapes, mut rings: Vec<Vec<Position>>) -> Result<(), Problem> {
    for ring in &mut rings {
        close(ring);
    }
    let (whole, flat): (Vec<_>, Vec<_>) = rings.into_iter().partition(|ring| ring.len() > 3);
    shapes.polygon(whole.iter().map(Vec::as_slice))?;
    for ring in flat {
        match *ring.as_slice() {
            [] => {}
            [first, ..] if ring.len() < 3 => shapes.point(first)?,
            [first, second, ..] => shapes.line(&[first, second])?,
            _ => {}
        }
    }
    Ok(())
}

/// Makes the last position the first, unless it is.
fn close(ring: &mut Vec<Position>) {
    let ends = (ring.first().copied(), ring.last().copied());
    if let (Some(first), Some(last)) = ends
        && (ring.len() == 1 || first.point != last.point)
    {
        ring.push(first);
    }
}

/// Makes a position of two numbers or more; those beyond the third have no meaning.
fn position(numbers: &[f64]) -> Position {
    let z = numbers.get(2).copied().unwrap_or(f64::NAN);
    Position {
        point: Point::new(numbers[0], numbers[1]),
        extras: [z, f64::NAN],
    }
}

/// Reads what stands in the array, at most two levels deep.
#[derive(Clone, Copy)]
struct ItemSeed<'r, 'w> {
    pulse: &'r Pulse<'w>,
    depth: usize,
}

impl<'de> DeserializeSeed<'de> for ItemSeed<'_, '_> {
    type Value = Item;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<Item, D::Error> {
        deserializer.deserialize_any(self)
    }
}

impl<'de> Visitor<'de> for ItemSeed<'_, '_> {
    type Value = Item;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a number or an array of numbers")
    }

    fn visit_f64<E>(self, value: f64) -> Result<Item, E> {
        Ok(Item::Number(value))
    }

    fn visit_i64<E>(self, value: i64) -> Result<Item, E> {
        Ok(Item::Number(value as f64))
    }

    fn visit_u64<E>(self, value: u64) -> Result<Item, E> {
        Ok(Item::Number(value as f64))
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut seq: A) -> Result<Item, A::Error> {
        self.pulse.beat().map_err(A::Error::custom)?;
        if self.depth == 2 {
            let text = "arrays within arrays, deeper than those of one polygon";
            return Err(A::Error::custom(text));
        }
        let mut numbers = [f64::NAN; 3];
        let mut count = 0;
        let mut ring = Vec::new();
        let within = Self {
            depth: self.depth + 1,
            ..self
        };
        while let Some(item) = seq.next_element_seed(within)? {
            match item {
                Item::Number(number) => {
                    if let Some(place) = numbers.get_mut(count) {
                        *place = number;
                    }
                    count += 1;
                }
                Item::Position(position) => ring.push(position),
                Item::Ring(_) => {
                    return Err(A::Error::custom("an array where a position should be"));
                }
            }
            if count > 0 && !ring.is_empty() {
                return Err(A::Error::custom("numbers and arrays in one array"));
            }
        }
        match count {
            0 => Ok(Item::Ring(ring)),
            1 => Err(A::Error::custom("a position of one number; it needs two")),
            count => Ok(Item::Position(position(&numbers[..count.min(3)]))),
        }
    }
}
