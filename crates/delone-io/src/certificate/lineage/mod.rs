//! Lineage: which feature of the input each vertex, constrained edge and triangle comes from.
//!
//! The table has a row for every vertex, in the order of the mesh, but three for a free Steiner point; for every
//! constrained edge and segment that runs along it, segment by segment in the order of the way along it; and, if the
//! input has regions, for every triangle. All numbers count from 0, whatever the files do. A place on a segment is the
//! fraction of the way from its first end to its second: with t, the weights of the ends are 1 − t and t, and they sum
//! to 1 exactly, since t is a multiple of 2⁻⁵² ([`fraction_along`]).
//!
//! A free Steiner point lies in a triangle of the input's triangulation, before refinement, and has a row for each of
//! the corners, with its weight; two rows, if it lies on an edge. These weights, too, sum to 1 exactly
//! ([`corner_weights`](delone::predicates::corner_weights)).
//!
//! Which polygon of the input a triangle lies in is not said; regions tell.

mod read;
mod row;
mod verify;
mod within;
mod write;

use crate::{Error, cancel};
use delone::predicates::fraction_along;
use delone::{ConstrainedTriangulation, Origin, Triangulation, VertexId, Watch};
#[cfg(feature = "parquet")]
pub(crate) use row::{COLUMNS, ELEMENTS, ORIGINS, Row};
pub use within::Within;

/// A place on a segment of the input, or on an edge of its convex hull.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Along {
    /// The number of the segment; those of hull edges follow behind the segments of the input.
    pub segment: usize,
    /// How far along it: the weight of its second end.
    pub at: f64,
}

/// Where a vertex comes from.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum OfVertex {
    /// It is the point of the input of the same number.
    Input,
    /// Likewise, but it equals an earlier one, which stands for it.
    Duplicate(VertexId),
    /// Two segments cross there; the first pair, if more do.
    Crossing([Along; 2]),
    /// A Steiner point on a segment; the first one, if more run there.
    OnSegment(Along),
    /// A Steiner point on no segment, in a triangle of the input's triangulation or on an edge of it.
    Free(Within),
}

/// Where a constrained edge comes from: one segment that runs along it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OfEdge {
    /// The number of the segment; those of hull edges follow behind the segments of the input.
    pub segment: usize,
    /// Its ends, in the direction of the segment.
    pub ends: [VertexId; 2],
    /// How far along the segment they are.
    pub at: [f64; 2],
}

/// The table of lineage of a mesh.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Lineage {
    /// Of each vertex.
    pub vertices: Vec<OfVertex>,
    /// Of each constrained edge, once for each segment along it; grouped by segment, in the order of the way.
    pub edges: Vec<OfEdge>,
    /// The region of each triangle, if the input has regions.
    pub regions: Option<Vec<Option<usize>>>,
    /// How many segments the input has; the numbers from there on are edges of its convex hull.
    pub num_segments: usize,
}

impl Lineage {
    /// Takes the lineage of a triangulation of bare points. *Cost*: linear.
    pub fn of_points(triangulation: &Triangulation) -> Self {
        let mut vertices = vec![OfVertex::Input; triangulation.points().len()];
        for duplicate in triangulation.duplicates() {
            vertices[duplicate.dropped.index()] = OfVertex::Duplicate(duplicate.kept);
        }
        Self {
            vertices,
            ..Self::default()
        }
    }

    /// Takes the lineage of the triangulation of a domain. *Cost*: linear, about 60 ns a vertex on a segment; if
    /// there are free Steiner points, 2 to 3 µs for each, and one more triangulation of the input.
    ///
    /// # Errors
    /// If the watch cancels.
    pub fn of_domain(t: &ConstrainedTriangulation, watch: &dyn Watch) -> Result<Self, Error> {
        let triangulation = t.triangulation();
        let point = |v: VertexId| triangulation.point(v);
        let along = |segment: usize, v: VertexId| Along {
            segment,
            at: fraction_along(t.segments()[segment].map(point), point(v)),
        };
        let mut lineage = Self::of_points(triangulation);
        lineage.num_segments = t.num_input_segments();
        let mut weighed = free_places(t, watch)?.into_iter();
        for v in t.num_input_points()..triangulation.points().len() {
            cancel::check(watch, v)?;
            let id = VertexId::new(v);
            lineage.vertices[v] = match t.origin(id) {
                Origin::Crossing(pair) => OfVertex::Crossing(pair.map(|s| along(s, id))),
                Origin::OnSegment(segment) => OfVertex::OnSegment(along(segment, id)),
                Origin::Free => OfVertex::Free(weighed.next().expect("bug: a place is missing")),
                _ => OfVertex::Input,
            };
        }
        for segment in 0..t.segments().len() {
            cancel::check(watch, segment)?;
            let mut chain = t.chain(segment).iter();
            let Some(&first) = chain.next() else {
                continue;
            };
            let mut from = (first, along(segment, first).at);
            for &v in chain {
                let to = (v, along(segment, v).at);
                lineage.edges.push(OfEdge {
                    segment,
                    ends: [from.0, to.0],
                    at: [from.1, to.1],
                });
                from = to;
            }
        }
        if !t.regions().is_empty() {
            let triangles = (0..triangulation.num_triangles()).map(delone::TriangleId::new);
            lineage.regions = Some(triangles.map(|triangle| t.region(triangle)).collect());
        }
        Ok(lineage)
    }

    /// Lists the constrained edges that have rows, each once, for meshes in formats that hold none.
    pub fn constrained_edges(&self) -> Vec<[VertexId; 2]> {
        let ends = self.edges.iter().map(|row| row.ends);
        let mut edges: Vec<_> = ends.map(|[a, b]| [a.min(b), a.max(b)]).collect();
        edges.sort_unstable();
        edges.dedup();
        edges
    }

    /// Counts the rows of the table.
    pub fn num_rows(&self) -> usize {
        let of_vertices = self.vertices.iter().map(OfVertex::num_rows);
        of_vertices.sum::<usize>() + self.edges.len() + self.regions.as_ref().map_or(0, Vec::len)
    }
}

impl OfVertex {
    /// Counts the rows of the vertex.
    fn num_rows(&self) -> usize {
        match self {
            Self::Free(within) => within.len(),
            _ => 1,
        }
    }
}

/// Finds the places of the free vertices of a mesh, in their order.
fn free_places(t: &ConstrainedTriangulation, watch: &dyn Watch) -> Result<Vec<Within>, Error> {
    let triangulation = t.triangulation();
    let first = t.num_input_points() + t.num_crossings();
    let added = (first..triangulation.points().len()).map(VertexId::new);
    let free: Vec<_> = added.filter(|&v| t.origin(v) == Origin::Free).collect();
    let chains = (0..t.num_input_segments()).map(|segment| t.chain(segment));
    let places = within::places(triangulation.points(), first, chains, &free, watch);
    let places = places.map_err(|error| match error {
        delone::Error::Cancelled => Error::Cancelled,
        other => Error::BadMesh(other.to_string()),
    })?;
    let found = places.into_iter().zip(free);
    let found = found.map(|(place, v)| {
        let nowhere = || Error::BadMesh(format!("vertex {v} lies in no triangle of the input"));
        Ok(place.ok_or_else(nowhere)?.within)
    });
    found.collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Format, MeshView, Papers, Source, WriteOptions, in_memory, write_certified};
    use std::path::Path;

    /// One of each kind.
    fn all_kinds() -> Lineage {
        let ids = |ends: [usize; 2]| ends.map(VertexId::new);
        let along = |segment, at| Along { segment, at };
        let edge = |segment, ends, at| OfEdge {
            segment,
            ends: ids(ends),
            at,
        };
        Lineage {
            vertices: vec![
                OfVertex::Input,
                OfVertex::Input,
                OfVertex::Duplicate(VertexId::new(0)),
                OfVertex::Crossing([along(0, 0.1), along(1, 1.0 - f64::EPSILON)]),
                OfVertex::OnSegment(along(1, 0.5)),
                OfVertex::Free(within([(0, 0.25), (1, 0.5), (3, 0.25)])),
                OfVertex::OnSegment(along(3, 1e-300)),
                OfVertex::Free(within([(1, f64::EPSILON), (3, 1.0 - f64::EPSILON)])),
                OfVertex::Free(within([(0, 0.0), (1, 1.0), (3, 0.0)])),
            ],
            edges: vec![edge(0, [0, 3], [0.0, 0.1]), edge(3, [5, 1], [1e-300, 1.0])],
            regions: Some(vec![Some(0), None, Some(7)]),
            num_segments: 2,
        }
    }

    fn within<const K: usize>(corners: [(usize, f64); K]) -> Within {
        let corners = corners.map(|(corner, weight)| (VertexId::new(corner), weight));
        let mut within = Within::first(corners[0].0, corners[0].1);
        for &(corner, weight) in &corners[1..] {
            within.push(corner, weight).expect("in order");
        }
        within
    }

    fn written(name: &str, lineage: &Lineage) -> Vec<u8> {
        let papers = Papers {
            lineage: Some((Path::new(name), lineage)),
            certificate: None,
        };
        let mesh = MeshView::new(&[], &[]);
        let options = WriteOptions::default();
        let write = || write_certified(&[], &mesh, &options, &papers, &());
        let (_, mut files) = in_memory(write).expect("a table");
        files.remove(0).bytes
    }

    fn read(bytes: Vec<u8>) -> Result<Lineage, Error> {
        let name = "table".to_owned();
        Lineage::read(&Source::Memory { name, bytes }, 2, &())
    }

    #[test]
    fn every_row_comes_back() {
        let formats = [Format::Table, Format::Parquet].into_iter();
        for format in formats.filter(|format| format.is_built()) {
            for lineage in [
                all_kinds(),
                Lineage {
                    num_segments: 2,
                    ..Lineage::default()
                },
            ] {
                let bytes = written(&format!("a.{format}"), &lineage);
                assert_eq!(read(bytes).expect("ours"), lineage, "{format}");
            }
        }
    }

    #[test]
    fn what_no_row_says_is_refused_by_its_line() {
        let text = String::from_utf8(written("a.csv", &all_kinds())).expect("text");
        for (from, to, words) in [
            (
                "element,",
                "elements,",
                "table:1: a table of lineage begins with",
            ),
            ("vertex,1,", "vertex,2,", "table:3: vertex 2 instead of 1"),
            (
                "crossing,0,0.1,",
                "crossing,0,1.5,",
                "at is 1.5, it must be a number from 0",
            ),
            (
                "crossing,0,0.1,",
                "crossing,0,,",
                "at is missing, it must be",
            ),
            ("segment,1,0.5", "segment,2,0.5", "segment 2 of 2"),
            ("segment,1,0.5", "street,1,0.5", "origin \"street\""),
            ("duplicate,0", "duplicate,-1", "feature is \"-1\""),
            ("5,free,0,0.25,,,,,", "5,free,0,0.25,,,,", "too few cells"),
            (
                "vertex,5,free,0,",
                "vertex,18446744073709551615,free,0,",
                "vertex 18446744073709551615 instead of 5",
            ),
            (
                "5,free,0,0.25,",
                "5,free,,,",
                "feature is missing, it must be",
            ),
            (
                "5,free,1,0.5,",
                "5,free,1,-0.5,",
                "at is -0.5, it must be a number from 0",
            ),
            (
                "5,free,1,0.5,",
                "5,free,0,0.5,",
                "table:8: corner 0 comes behind 0: the corners of a free vertex must be in order",
            ),
            (
                "vertex,6,hull,",
                "vertex,5,free,4,0,,,,,\nvertex,6,hull,",
                "table:10: a free vertex has three rows at most",
            ),
            (
                "vertex,5,free,1,",
                "vertex,7,free,1,",
                "table:8: vertex 7 instead of 6",
            ),
            ("triangle,2,", "tetrahedron,2,", "element \"tetrahedron\""),
        ] {
            assert!(text.contains(from), "{from} in {text}");
            let error = read(text.replacen(from, to, 1).into_bytes());
            let error = error.expect_err(from).to_string();
            assert!(error.contains(words), "{error}");
        }
    }
}
