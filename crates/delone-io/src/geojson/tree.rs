//! The member `coordinates`: arrays of arrays of numbers, taken as they come, since the type that says
//! how deep they must be may stand behind them.

use crate::shapes::Position;
use crate::{Error, Problem, cancel};
use delone::{Point, Watch};
use serde::de::{DeserializeSeed, Deserializer, Error as _, SeqAccess, Visitor};
use std::cell::Cell;
use std::fmt;

/// What stands at a place of `coordinates`.
pub(super) enum Tree {
    Number(f64),
    Position(Position),
    List(Vec<Tree>),
}

impl Tree {
    /// Takes this as a list of lists, however deep.
    pub fn into_list(self) -> Result<Vec<Self>, Problem> {
        match self {
            Self::List(list) => Ok(list),
            Self::Position(_) => Err(Problem::Other(
                "a position where an array of positions should be".to_owned(),
            )),
            Self::Number(_) => Err(Problem::Other(
                "a number where an array should be".to_owned(),
            )),
        }
    }

    /// Takes this as a list of positions.
    pub fn into_line(self) -> Result<Vec<Position>, Problem> {
        let list = self.into_list()?;
        list.into_iter().map(Self::into_position).collect()
    }

    /// Takes this as a position.
    pub fn into_position(self) -> Result<Position, Problem> {
        match self {
            Self::Position(position) => Ok(position),
            Self::List(_) => Err(Problem::Other(
                "an array of arrays where a position should be".to_owned(),
            )),
            Self::Number(_) => Err(Problem::Other(
                "a number where a position should be".to_owned(),
            )),
        }
    }
}

/// Looks at the watch now and then.
pub(super) struct Pulse<'w> {
    watch: &'w dyn Watch,
    rounds: Cell<usize>,
}

impl<'w> Pulse<'w> {
    pub fn new(watch: &'w dyn Watch) -> Self {
        let rounds = Cell::new(0);
        Self { watch, rounds }
    }

    /// Fails once the watch has cancelled.
    pub fn beat(&self) -> Result<(), Error> {
        let round = self.rounds.get();
        self.rounds.set(round + 1);
        cancel::check(self.watch, round)
    }
}

/// Reads one value of `coordinates`. The depth is bounded by the parser, which refuses more than 127
/// levels.
#[derive(Clone, Copy)]
pub(super) struct TreeSeed<'p, 'w>(pub &'p Pulse<'w>);

impl<'de> DeserializeSeed<'de> for TreeSeed<'_, '_> {
    type Value = Tree;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<Tree, D::Error> {
        deserializer.deserialize_any(self)
    }
}

impl<'de> Visitor<'de> for TreeSeed<'_, '_> {
    type Value = Tree;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a number or an array")
    }

    fn visit_f64<E>(self, value: f64) -> Result<Tree, E> {
        Ok(Tree::Number(value))
    }

    fn visit_i64<E>(self, value: i64) -> Result<Tree, E> {
        Ok(Tree::Number(value as f64))
    }

    fn visit_u64<E>(self, value: u64) -> Result<Tree, E> {
        Ok(Tree::Number(value as f64))
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut seq: A) -> Result<Tree, A::Error> {
        self.0.beat().map_err(A::Error::custom)?;
        // Numbers beyond the third have no meaning in GeoJSON.
        let mut numbers = [f64::NAN; 3];
        let mut count = 0;
        let mut list = Vec::new();
        while let Some(item) = seq.next_element_seed(self)? {
            match item {
                Tree::Number(number) => {
                    if let Some(place) = numbers.get_mut(count) {
                        *place = number;
                    }
                    count += 1;
                }
                item => list.push(item),
            }
            if count > 0 && !list.is_empty() {
                return Err(A::Error::custom("numbers and arrays in one array"));
            }
        }
        let [x, y, z] = numbers;
        match count {
            0 => Ok(Tree::List(list)),
            1 => Err(A::Error::custom("a position of one number; it needs two")),
            _ => Ok(Tree::Position(Position {
                point: Point::new(x, y),
                extras: [z, f64::NAN],
            })),
        }
    }
}
