//! Places: the distinct positions of points, numbered from left to right.
//!
//! With places for vertices, equal points need no further thought, and the lexicographic order of
//! positions is the order of numbers.

use super::super::Corner;
use super::sort::sort;
use crate::pace::Pace;
use crate::{Error, Point, VertexId};

/// The number of a place, by x, then y.
pub(super) type Place = u32;

/// The distinct positions of points.
pub(super) struct Places<'a> {
    points: &'a [Point],
    /// The place of each point.
    of: Vec<Place>,
    /// For each place the point of lowest index.
    first: Vec<VertexId>,
}

impl<'a> Places<'a> {
    pub fn find(points: &'a [Point], pace: &mut Pace) -> Result<Self, Error> {
        let at = |v: VertexId| points[v.index()];
        let mut order: Vec<VertexId> = (0..points.len()).map(VertexId::new).collect();
        sort(&mut order, pace, |&v, &w| {
            at(v).lex_cmp(&at(w)).then(v.cmp(&w))
        })?;
        let mut places = Self {
            points,
            of: vec![0; points.len()],
            first: Vec::new(),
        };
        for v in order {
            pace.step()?;
            if places.first.last().is_none_or(|&last| at(last) != at(v)) {
                places.first.push(v);
            }
            places.of[v.index()] = places.first.len() as Place - 1;
        }
        Ok(places)
    }

    pub fn len(&self) -> usize {
        self.first.len()
    }

    pub fn all(&self) -> impl DoubleEndedIterator<Item = Place> + use<> {
        0..self.first.len() as Place
    }

    /// Returns the place of a point.
    pub fn of(&self, v: VertexId) -> Place {
        self.of[v.index()]
    }

    /// Returns the place of a vertex that need not be one.
    pub fn get(&self, v: VertexId) -> Option<Place> {
        self.of.get(v.index()).copied()
    }

    /// Returns the point of lowest index at a place.
    pub fn vertex(&self, place: Place) -> VertexId {
        self.first[place as usize]
    }

    /// Returns a place as a defect names it.
    pub fn corner(&self, place: Place) -> Corner {
        Corner::new(self.points, self.vertex(place))
    }

    pub fn at(&self, place: Place) -> Point {
        self.points[self.vertex(place).index()]
    }
}
