//! Domains of one size, each there to show something.

use super::{grid, lake, thesis};
use delone::{Point, Pslg, Region, VertexId};
use delone_io::DomainData;
use std::fmt;

/// A domain to try things on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
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
}

impl Scene {
    /// All of them, in the order of the list.
    pub const ALL: [Self; 4] = [
        Self::Lake,
        Self::Thesis,
        Self::ThesisTwo,
        Self::DegenerateGrid,
    ];

    /// Returns the name by which commands call it.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Lake => "lake",
            Self::Thesis => "thesis",
            Self::ThesisTwo => "thesis-two",
            Self::DegenerateGrid => "degenerate-grid",
        }
    }

    /// Says in a few words what it is.
    pub const fn about(self) -> &'static str {
        match self {
            Self::Lake => "a lake: islands, one with a pond, a river, deep and shallow water",
            Self::Thesis => "an outline with a triangular hole (thesis, Ulm 2012, example 1.16)",
            Self::ThesisTwo => "the same and a second outline beside it (example 1.33)",
            Self::DegenerateGrid => "a lattice, segments along, through and across: some cross",
        }
    }

    /// Draws it, the same on every machine.
    pub fn draw(self) -> DomainData {
        match self {
            Self::Lake => lake::draw(),
            Self::Thesis => thesis::draw(),
            Self::ThesisTwo => thesis::draw_two(),
            Self::DegenerateGrid => grid::draw(),
        }
        .finish()
    }
}

impl fmt::Display for Scene {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}

/// What scenes are drawn on.
#[derive(Default)]
pub(super) struct Sheet {
    pub points: Vec<[f64; 2]>,
    pub segments: Vec<[u32; 2]>,
    /// One for each segment: tells what it is.
    pub markers: Vec<i32>,
    pub holes: Vec<[f64; 2]>,
    /// Places and attributes.
    pub regions: Vec<([f64; 2], f64)>,
}

impl Sheet {
    /// Adds a polyline with points of its own.
    pub fn add_line(&mut self, marker: i32, points: impl IntoIterator<Item = [f64; 2]>) {
        let first = self.points.len() as u32;
        self.points.extend(points);
        let last = self.points.len() as u32;
        for to in first + 1..last {
            self.add_segment(marker, [to - 1, to]);
        }
    }

    /// Adds a closed ring with points of its own.
    pub fn add_ring(&mut self, marker: i32, points: impl IntoIterator<Item = [f64; 2]>) {
        let first = self.points.len() as u32;
        self.add_line(marker, points);
        let last = self.points.len() as u32 - 1;
        self.add_segment(marker, [last, first]);
    }

    /// Adds a segment between points that are there.
    pub fn add_segment(&mut self, marker: i32, ends: [u32; 2]) {
        self.segments.push(ends);
        self.markers.push(marker);
    }

    fn finish(self) -> DomainData {
        let vertex = |v: u32| VertexId::new(v as usize);
        let segments = self.segments.into_iter().map(|ends| ends.map(vertex));
        let region = |(at, attribute): ([f64; 2], f64)| Region {
            at: at.into(),
            attribute,
            max_area: None,
        };
        let pslg = Pslg {
            segments: segments.collect(),
            holes: self.holes.into_iter().map(Point::from).collect(),
            regions: self.regions.into_iter().map(region).collect(),
            ..Pslg::from_points(self.points)
        };
        DomainData {
            segment_markers: Some(self.markers),
            ..pslg.into()
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_segment_has_ends_and_a_marker() {
        for scene in Scene::ALL {
            let domain = scene.draw();
            let markers = domain.segment_markers.expect("markers");
            assert_eq!(domain.segments.len(), markers.len(), "{scene}");
            let n = domain.vertices.points.len();
            assert!(domain.segments.iter().flatten().all(|v| v.index() < n));
        }
    }

    #[test]
    fn coordinates_have_three_decimals_at_most() {
        for scene in Scene::ALL {
            for p in scene.draw().vertices.points {
                let short = |c: f64| (c * 1e3).round() / 1e3 == c;
                assert!(short(p.x) && short(p.y), "{scene}: {p:?}");
            }
        }
    }

    #[test]
    fn the_rings_of_the_thesis_are_closed() {
        for (scene, n) in [(Scene::Thesis, 9), (Scene::ThesisTwo, 14)] {
            let domain = scene.draw();
            assert_eq!(domain.vertices.points.len(), n);
            for v in 0..n {
                let ends = domain.segments.iter().flatten();
                assert_eq!(ends.filter(|end| end.index() == v).count(), 2, "{scene}");
            }
        }
    }

    #[test]
    fn the_lake_is_always_the_same() {
        let lake = Scene::Lake.draw();
        let points = &lake.vertices.points;
        assert_eq!((lake.segments.len(), points.len()), (522, 628));
        assert_eq!((lake.holes.len(), lake.regions.len()), (6, 3));
        let markers = lake.segment_markers.expect("markers");
        assert!((1..=6).all(|marker| markers.contains(&marker)));
        // Pictures and hashes in the documentation rest on it.
        let sum: f64 = points.iter().map(|p| p.x + 2.0 * p.y).sum();
        assert_eq!(format!("{sum:.3}"), "10860.733");
    }
}
