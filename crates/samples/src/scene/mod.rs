//! Domains of one size, each there to show something.

mod gallery;
mod grid;
mod lake;
mod thesis;

use crate::{UnknownName, names};
use std::fmt;
use std::str::FromStr;

/// A domain to try things on.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Scene {
    /// A lake with a river, islands, a pond on one of them, deep and shallow water.
    Lake,
    /// The domain of a thesis' worked example: an outline with corners that point inwards, and a
    /// triangular hole.
    Thesis,
    /// The same beside a second outline: two components.
    ThesisTwo,
    /// A lattice with segments along, across and through its points; some repeat, overlap or cross.
    DegenerateGrid,
    /// All points that integer coordinates have on one circle.
    Cocircular,
    /// Points on one line, unevenly spaced.
    Collinear,
    /// A gallery of degenerate point sets, side by side.
    Gallery,
}

impl Scene {
    /// All of them, in the order of the list.
    pub const ALL: [Self; 7] = [
        Self::Lake,
        Self::Thesis,
        Self::ThesisTwo,
        Self::DegenerateGrid,
        Self::Cocircular,
        Self::Collinear,
        Self::Gallery,
    ];

    /// Returns the name by which commands call it.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Lake => "lake",
            Self::Thesis => "thesis",
            Self::ThesisTwo => "thesis-two",
            Self::DegenerateGrid => "degenerate-grid",
            Self::Cocircular => "cocircular",
            Self::Collinear => "collinear",
            Self::Gallery => "gallery",
        }
    }

    /// Says in a few words what it is.
    pub const fn about(self) -> &'static str {
        match self {
            Self::Lake => "a lake: islands, one with a pond, a river, deep and shallow water",
            Self::Thesis => "an outline with a triangular hole (thesis, Ulm 2012, example 1.16)",
            Self::ThesisTwo => "the same and a second outline beside it (example 1.33)",
            Self::DegenerateGrid => "a lattice, segments along, through and across: some cross",
            Self::Cocircular => "60 points, exactly on one circle: every in-circle test is zero",
            Self::Collinear => "points on one line: no triangle at all",
            Self::Gallery => "a lattice, a line, a circle, equal points, a fan: side by side",
        }
    }

    /// Draws it, the same on every machine.
    pub fn draw(self) -> Sheet {
        match self {
            Self::Lake => lake::draw(),
            Self::Thesis => thesis::draw(),
            Self::ThesisTwo => thesis::draw_two(),
            Self::DegenerateGrid => grid::draw(),
            Self::Cocircular => gallery::cocircular(),
            Self::Collinear => gallery::collinear(),
            Self::Gallery => gallery::draw(),
        }
    }
}

impl fmt::Display for Scene {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}

impl FromStr for Scene {
    type Err = UnknownName;

    fn from_str(name: &str) -> Result<Self, Self::Err> {
        names::find("scene", &Self::ALL, Self::name, name)
    }
}

/// What scenes are drawn on: a drawing that says of each segment what it is, and of regions what they are.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Sheet {
    /// The points, ends of segments and loose ones alike.
    pub points: Vec<[f64; 2]>,
    /// The two ends of each segment, as indices of points.
    pub segments: Vec<[u32; 2]>,
    /// One for each segment: tells what it is.
    pub markers: Vec<i32>,
    /// A point in each hole.
    pub holes: Vec<[f64; 2]>,
    /// A point in each region, and its attribute.
    pub regions: Vec<([f64; 2], f64)>,
}

impl Sheet {
    /// Adds a polyline with points of its own.
    fn add_line(&mut self, marker: i32, points: impl IntoIterator<Item = [f64; 2]>) {
        let first = self.points.len() as u32;
        self.points.extend(points);
        let last = self.points.len() as u32;
        for to in first + 1..last {
            self.add_segment(marker, [to - 1, to]);
        }
    }

    /// Adds a closed ring with points of its own.
    fn add_ring(&mut self, marker: i32, points: impl IntoIterator<Item = [f64; 2]>) {
        let first = self.points.len() as u32;
        self.add_line(marker, points);
        let last = self.points.len() as u32 - 1;
        self.add_segment(marker, [last, first]);
    }

    /// Adds a segment between points that are there.
    fn add_segment(&mut self, marker: i32, ends: [u32; 2]) {
        self.segments.push(ends);
        self.markers.push(marker);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_segment_has_ends_and_a_marker() {
        for scene in Scene::ALL {
            let sheet = scene.draw();
            assert_eq!(sheet.segments.len(), sheet.markers.len(), "{scene}");
            let n = sheet.points.len() as u32;
            assert!(sheet.segments.iter().flatten().all(|&v| v < n));
            assert_eq!(scene.name().parse(), Ok(scene));
        }
    }

    #[test]
    fn coordinates_have_three_decimals_at_most() {
        for scene in Scene::ALL {
            for p in scene.draw().points {
                let is_short = |c: f64| (c * 1e3).round() / 1e3 == c;
                assert!(p.into_iter().all(is_short), "{scene}: {p:?}");
            }
        }
    }

    #[test]
    fn the_rings_of_the_thesis_are_closed() {
        for (scene, n) in [(Scene::Thesis, 9), (Scene::ThesisTwo, 14)] {
            let sheet = scene.draw();
            assert_eq!(sheet.points.len(), n as usize);
            for v in 0..n {
                let ends = sheet.segments.iter().flatten();
                assert_eq!(ends.filter(|&&end| end == v).count(), 2, "{scene}");
            }
        }
    }

    #[test]
    fn the_lake_is_always_the_same() {
        let lake = Scene::Lake.draw();
        assert_eq!((lake.segments.len(), lake.points.len()), (522, 628));
        assert_eq!((lake.holes.len(), lake.regions.len()), (6, 3));
        assert!((1..=6).all(|marker| lake.markers.contains(&marker)));
        // Pictures and hashes in the documentation rest on it.
        let sum: f64 = lake.points.iter().map(|[x, y]| x + 2.0 * y).sum();
        assert_eq!(format!("{sum:.3}"), "10860.733");
    }

    #[test]
    fn cocircular_points_are_all_that_there_are() {
        let points = Scene::Cocircular.draw().points;
        assert_eq!(points.len(), 60);
        assert!(points.iter().all(|[x, y]| x * x + y * y == 325.0 * 325.0));
    }
}
