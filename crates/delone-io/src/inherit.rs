//! What a triangulation inherits from its domain: attributes and markers, along the lineage of
//! vertices and segments.
//!
//! An edge has the first marker that is not 0 among those of its segments, in the order of the
//! input; edges of the convex hull that refinement made segments of have marker 1. A vertex at a
//! crossing has the marker of the first of the two segments, and attributes interpolated along it. A
//! triangle has the attribute of its region, 0 outside of all, as in Triangle.
//!
//! Steiner points make no new data, they refine the old: attributes stay those of the surface that
//! is linear in every triangle of the constrained triangulation before refinement, so that breaklines
//! remain and no value leaves the range of the input's. On a segment that is interpolation between its
//! vertices next to the point. There the marker is that of the edge; where this has none, 1 on the
//! boundary and 0 elsewhere, as in Triangle. Free Steiner points have marker 0.
//!
//! *Cost*: O(n + s log s) for n points and triangles, and s constrained edges with multiplicity; if
//! there are attributes and free Steiner points, also that of triangulating the input once more.

mod markers;
mod steiner;
mod surface;

use crate::{Attribute, Constraints, DomainData, Error, cancel};
use delone::{ConstrainedTriangulation, Origin, Point, TriangleId, VertexId, Watch};
use std::ops::Range;
use steiner::Steiner;

/// The marker of hull edges that refinement made segments of: what Triangle gives a boundary.
const HULL: i32 = 1;

/// Data of the vertices, triangles and edges of a [`ConstrainedTriangulation`], to be
/// [viewed](crate::MeshView::constrained) with it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Inherited {
    /// Attributes of the vertices.
    pub attributes: Vec<Attribute>,
    /// Markers of the vertices, if the points had any.
    pub markers: Option<Vec<i32>>,
    /// Attributes of the triangles: that of their region, if there are regions.
    pub triangle_attributes: Vec<Attribute>,
    /// Constrained edges, holes and regions.
    pub constraints: Constraints,
}

impl Inherited {
    /// Hands the data of `domain` down to the triangulation of its graph, which may have been
    /// [taken out](DomainData::take_pslg).
    ///
    /// # Errors
    /// If the data are not those of this triangulation, or the watch cancels.
    pub fn new(
        result: &ConstrainedTriangulation,
        domain: DomainData,
        watch: &dyn Watch,
    ) -> Result<Self, Error> {
        Self::marked(result, domain, Marking::Sparing, watch)
    }

    /// Does the same, but gives every vertex a marker, as Triangle does: if its own is 0, the first that
    /// is not 0 among those of its segments or, if there is none, 1 on the boundary.
    ///
    /// # Errors
    /// Those of [`new`](Self::new).
    pub fn as_in_triangle(
        result: &ConstrainedTriangulation,
        domain: DomainData,
        watch: &dyn Watch,
    ) -> Result<Self, Error> {
        Self::marked(result, domain, Marking::Full, watch)
    }

    fn marked(
        result: &ConstrainedTriangulation,
        domain: DomainData,
        marking: Marking,
        watch: &dyn Watch,
    ) -> Result<Self, Error> {
        check_lengths(result, &domain)?;
        let of_segments = domain.segment_markers;
        let marker_of = |segment: usize| match &of_segments {
            _ if segment >= result.num_input_segments() => HULL,
            Some(markers) => markers[segment],
            None => 0,
        };
        let mut attributes = domain.vertices.attributes;
        let markers = marking.vertices(result, domain.vertices.markers, marker_of);
        for attribute in &mut attributes {
            add_crossings(result, &mut attribute.values, |at, segment, values| {
                let ends = result.segments()[segment];
                interpolate(result, ends, at, values)
            });
        }
        if result.num_steiner() > 0 {
            Steiner::of(result).add_attributes(&mut attributes, watch)?;
        }
        // Holes by parity are named too, so that a .poly means the same domain under its usual rule.
        let holes = match domain.holes {
            none if none.is_empty() => result.hole_seeds(),
            holes => holes,
        };
        let region_of = regions_of_triangles(result);
        let (edges, edge_markers) = edges(result, marker_of, watch)?;
        Ok(Self {
            attributes,
            markers,
            triangle_attributes: region_of
                .iter()
                .map(|of| region_attribute(result, of))
                .collect(),
            constraints: Constraints {
                edges,
                markers: of_segments.is_some().then_some(edge_markers),
                holes,
                regions: result.regions().to_vec(),
                region_of,
                crossings: crossings(result),
            },
        })
    }
}

/// Which vertices have markers that are not their own.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Marking {
    /// Those that were added, if the others have any.
    Sparing,
    /// All that have none.
    Full,
}

impl Marking {
    /// Gives every vertex its marker; `own` are those of the input.
    fn vertices(
        self,
        result: &ConstrainedTriangulation,
        own: Option<Vec<i32>>,
        marker_of: impl Fn(usize) -> i32,
    ) -> Option<Vec<i32>> {
        let mut markers = match self {
            Self::Sparing => own?,
            Self::Full => own.unwrap_or_default(),
        };
        let first = match self {
            Self::Sparing => {
                add_crossings(result, &mut markers, |_, segment, _| marker_of(segment));
                markers.len()
            }
            Self::Full => 0,
        };
        markers.resize(result.triangulation().points().len(), 0);
        markers::take_over(&mut markers, first, result, marker_of);
        Some(markers)
    }
}

fn check_lengths(result: &ConstrainedTriangulation, domain: &DomainData) -> Result<(), Error> {
    let check = |what: &str, found: usize, expected: usize| match found == expected {
        true => Ok(()),
        false => Err(Error::BadMesh(format!(
            "{found} {what} for {expected}: not the domain that was triangulated"
        ))),
    };
    let (n, s) = (result.num_input_points(), result.num_input_segments());
    for attribute in &domain.vertices.attributes {
        check("attributes of points", attribute.values.len(), n)?;
    }
    let markers = |markers: &Option<Vec<i32>>, all| markers.as_ref().map_or(all, Vec::len);
    check("markers of points", markers(&domain.vertices.markers, n), n)?;
    check(
        "markers of segments",
        markers(&domain.segment_markers, s),
        s,
    )
}

/// Returns the vertices where segments cross.
fn crossings(result: &ConstrainedTriangulation) -> Range<usize> {
    let first = result.num_input_points();
    first..first + result.num_crossings()
}

/// Appends a value for each vertex that is a crossing; `value` gets its position, the first of its
/// segments and the values so far.
fn add_crossings<T: Copy>(
    result: &ConstrainedTriangulation,
    values: &mut Vec<T>,
    value: impl Fn(Point, usize, &[T]) -> T,
) {
    for v in crossings(result).map(VertexId::new) {
        if let Origin::Crossing([segment, _]) = result.origin(v) {
            values.push(value(result.triangulation().point(v), segment, values));
        }
    }
}

/// Interpolates between two vertices, for a point near their line.
fn interpolate(
    result: &ConstrainedTriangulation,
    ends: [VertexId; 2],
    at: Point,
    values: &[f64],
) -> f64 {
    let [a, b] = ends.map(|v| result.triangulation().point(v));
    let [low, high] = ends.map(|v| values[v.index()]);
    if low == high {
        return low;
    }
    let t = share(a, b, at);
    low * (1.0 - t) + high * t
}

/// Tells how far along ab, from 0 to 1, a point near it lies: along the longer side, halved so that
/// no difference overflows.
fn share(a: Point, b: Point, at: Point) -> f64 {
    let along = |a: f64, b: f64| b * 0.5 - a * 0.5;
    let (dx, dy) = (along(a.x, b.x), along(a.y, b.y));
    let t = if dx.abs() >= dy.abs() {
        along(a.x, at.x) / dx
    } else {
        along(a.y, at.y) / dy
    };
    t.clamp(0.0, 1.0)
}

/// Lists the constrained edges, sorted by their ends, with their markers.
fn edges(
    result: &ConstrainedTriangulation,
    marker_of: impl Fn(usize) -> i32,
    watch: &dyn Watch,
) -> Result<(Vec<[VertexId; 2]>, Vec<i32>), Error> {
    let mut owned = Vec::with_capacity(result.segments().len());
    for segment in 0..result.segments().len() {
        cancel::check(watch, segment)?;
        let marker = marker_of(segment);
        let edges = result.chain(segment).windows(2);
        // Those of marker 0 sort last: the first is then the first that is not 0.
        owned.extend(edges.map(|e| {
            (
                [e[0].min(e[1]), e[0].max(e[1])],
                marker == 0,
                segment,
                marker,
            )
        }));
    }
    owned.sort_unstable();
    owned.dedup_by_key(|edge| edge.0);
    Ok(owned
        .into_iter()
        .map(|(ends, .., marker)| (ends, marker))
        .unzip())
}

/// Lists the region of each triangle, if there are regions.
fn regions_of_triangles(result: &ConstrainedTriangulation) -> Option<Vec<Option<u32>>> {
    if result.regions().is_empty() {
        return None;
    }
    let triangles = (0..result.triangulation().num_triangles()).map(TriangleId::new);
    let region = |t| result.region(t).map(|region| region as u32);
    Some(triangles.map(region).collect())
}

fn region_attribute(result: &ConstrainedTriangulation, of: &[Option<u32>]) -> Attribute {
    let value =
        |region: &Option<u32>| region.map_or(0.0, |r| result.regions()[r as usize].attribute);
    Attribute {
        name: "attribute".to_owned(),
        values: of.iter().map(value).collect(),
    }
}

#[cfg(test)]
mod tests {
    use super::share;
    use delone::Point;

    #[test]
    fn shares_run_from_end_to_end_at_any_size() {
        let share = |a: (f64, f64), b: (f64, f64), at: (f64, f64)| {
            share(Point::from(a), Point::from(b), Point::from(at))
        };
        assert_eq!(share((0.0, 0.0), (4.0, 2.0), (1.0, 0.5)), 0.25);
        assert_eq!(share((1.0, 9.0), (0.0, 1.0), (0.5, 3.0)), 0.75);
        assert_eq!(share((f64::MIN, 0.0), (f64::MAX, 1.0), (0.0, 0.5)), 0.5);
        assert_eq!(share((0.0, 0.0), (4.0, 0.0), (5.0, 0.0)), 1.0);
    }
}
