//! Where free Steiner points lie: weights of the corners of a triangle of the input's triangulation, before refinement.
//!
//! That triangulation is the constrained one of all vertices that are no Steiner points, with the pieces of segments
//! between them, up to the convex hull whatever belongs to the domain. There is one, so threads and order play no
//! part; and whoever checks a table can make it anew.
//!
//! Subsegments bend by rounding, and a vertex beside one on the convex hull might lie outside of that. None has been
//! seen to: a vertex so near to a subsegment would have been refused. It would be a place on the edge that it
//! lies outside of.
//!
//! *Cost*: that of the triangulation on one thread, and 2 to 3 µs a free vertex.

use crate::unrefined;
use delone::check::{CROSSING_DRIFT, STEINER_DRIFT};
use delone::locate::{Location, Locator};
use delone::predicates::{corner_weights, fraction_along};
use delone::{ConstrainedDelaunay, Error, HalfEdgeId, Point, Triangulation, VertexId, Watch};
use std::fmt;

/// Units in the last place by which a weighted sum of corners may miss the vertex that it stands for, the unit of an
/// axis being that of the largest coordinate: what [`corner_weights`] promises.
const ROUNDING: f64 = 6.0;

/// Units by which a vertex outside the convex hull may miss it: as far as any Steiner point of a chain on the hull.
const OUTSIDE: f64 = CROSSING_DRIFT + 64.0 * STEINER_DRIFT;

/// A place among vertices: those around it, and their weights, multiples of 2⁻⁵² that sum to 1.
///
/// Three vertices are the corners of a triangle of the input's triangulation, two the ends of an edge of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Within {
    corners: [VertexId; 3],
    weights: [f64; 3],
    count: u8,
}

impl Within {
    /// Takes the first of the vertices.
    pub(super) fn first(corner: VertexId, weight: f64) -> Self {
        Self {
            corners: [corner, VertexId::new(0), VertexId::new(0)],
            weights: [weight, 0.0, 0.0],
            count: 1,
        }
    }

    /// Adds a vertex; the problem is in words.
    pub(super) fn push(&mut self, corner: VertexId, weight: f64) -> Result<(), String> {
        let next = usize::from(self.count);
        if next == self.corners.len() {
            return Err("a free vertex has three rows at most, one for each corner".to_owned());
        }
        if corner <= self.corners[next - 1] {
            return Err(format!(
                "corner {corner} comes behind {}: the corners of a free vertex must be in order",
                self.corners[next - 1]
            ));
        }
        (self.corners[next], self.weights[next]) = (corner, weight);
        self.count += 1;
        Ok(())
    }

    /// Puts vertices in the order of their numbers.
    fn sorted<const K: usize>(mut corners: [(VertexId, f64); K]) -> Self {
        corners.sort_unstable_by_key(|&(corner, _)| corner);
        let mut within = Self::first(corners[0].0, corners[0].1);
        for &(corner, weight) in &corners[1..] {
            let pushed = within.push(corner, weight);
            pushed.expect("bug: a corner twice");
        }
        within
    }

    /// Visits the vertices, in the order of their numbers, with their weights.
    pub fn corners(&self) -> impl Iterator<Item = (VertexId, f64)> {
        let corners = self.corners.into_iter().zip(self.weights);
        corners.take(self.count.into())
    }

    /// Counts the vertices.
    pub(super) fn len(&self) -> usize {
        self.count.into()
    }

    /// Adds the vertices up with their weights, in the order of their numbers; returns also the unit in the last place
    /// of their largest coordinate on each axis.
    fn sum(&self, points: &[Point]) -> (Point, [f64; 2]) {
        let mut sum = [0.0; 2];
        let mut largest = [0.0_f64; 2];
        for (corner, weight) in self.corners() {
            let at: [f64; 2] = points[corner.index()].into();
            for k in 0..2 {
                sum[k] += weight * at[k];
                largest[k] = largest[k].max(at[k].abs());
            }
        }
        let unit = |largest: f64| largest - largest.next_down();
        // What rounds beyond the largest number is as good as that.
        let sum = sum.map(|c| c.clamp(-f64::MAX, f64::MAX));
        (sum.into(), largest.map(unit))
    }
}

impl fmt::Display for Within {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (i, (corner, weight)) in self.corners().enumerate() {
            let separator = if i == 0 { "" } else { " + " };
            write!(f, "{separator}{weight:?} of {corner}")?;
        }
        Ok(())
    }
}

/// The place of a free vertex, as it should be.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Place {
    pub within: Within,
    /// Units in the last place by which it may miss the vertex.
    drift: f64,
}

impl Place {
    /// Says what is wrong with a `given` place of vertex `v` if it is not this one, of `points` of which the
    /// first `num_corners` are no Steiner points.
    pub fn problem(
        &self,
        given: &Within,
        v: VertexId,
        points: &[Point],
        num_corners: usize,
    ) -> Option<String> {
        if let Some((corner, _)) = given.corners().find(|(c, _)| c.index() >= num_corners) {
            return Some(format!(
                "corner {corner} of vertex {v} is a Steiner point, or none"
            ));
        }
        let whole: f64 = given.corners().map(|(_, weight)| weight).sum();
        let is_step = |weight: f64| (weight * 2_f64.powi(52)).fract() == 0.0;
        if whole != 1.0 || !given.corners().all(|(_, weight)| is_step(weight)) {
            return Some(format!(
                "the weights of vertex {v} are no multiples of 2^-52 that sum to 1: {given}"
            ));
        }
        let (sum, unit) = given.sum(points);
        let at = points[v.index()];
        let misses = [
            (sum.x - at.x).abs() / unit[0],
            (sum.y - at.y).abs() / unit[1],
        ];
        if misses.iter().any(|&miss| miss > self.drift) {
            return Some(format!(
                "vertex {v} is at ({}, {}), not at ({}, {}), which is {given}",
                at.x, at.y, sum.x, sum.y
            ));
        }
        (*given != self.within)
            .then(|| format!("vertex {v} is said to be {given}, it is {}", self.within))
    }
}

/// Finds the places of free vertices, which `free` lists; `None` for one that is a vertex of the input, or has no
/// triangle to be in, as there is none in a mesh. The first `num_corners` of `points` are no Steiner points.
///
/// # Errors
/// If the pieces of chains between these cross, or the watch cancels.
pub(super) fn places<'c>(
    points: &[Point],
    num_corners: usize,
    chains: impl Iterator<Item = &'c [VertexId]>,
    free: &[VertexId],
    watch: &dyn Watch,
) -> Result<Vec<Option<Place>>, Error> {
    if free.is_empty() {
        return Ok(Vec::new());
    }
    let drawing = unrefined::drawing(&points[..num_corners], chains);
    let triangulating = ConstrainedDelaunay::new().threads(1).watch(watch);
    let before = triangulating.triangulate(drawing)?.into_triangulation();
    let goals: Vec<Point> = free.iter().map(|v| points[v.index()]).collect();
    let locator = Locator::new(&before).threads(1);
    let locations = locator.locate_all(&goals, watch)?;
    let found = goals.iter().zip(locations);
    Ok(found
        .map(|(&p, location)| place(&before, p, location))
        .collect())
}

/// Tells where a point lies, given its location.
fn place(before: &Triangulation, p: Point, location: Location) -> Option<Place> {
    let mesh = before.mesh();
    let weighed = |h: HalfEdgeId| {
        let corners = [mesh.apex(h), mesh.origin(h), mesh.dest(h)];
        let weights = corner_weights(corners.map(|v| before.point(v)), p)?;
        Some([0, 1, 2].map(|k| (corners[k], weights[k])))
    };
    let inside = |within| Place {
        within,
        drift: ROUNDING,
    };
    match location {
        Location::Face(t) | Location::Carved(t) => {
            let all = weighed(t.half_edges()[0])?;
            Some(inside(Within::sorted(all)))
        }
        Location::Edge(h) => {
            // Beyond an edge of the hull there is no triangle.
            let is_ghost = mesh.is_ghost(h.triangle());
            let [_, from, to] = weighed(if is_ghost { mesh.twin(h) } else { h })?;
            Some(inside(Within::sorted([from, to])))
        }
        Location::Outside(h) => {
            let ends = [mesh.origin(h), mesh.dest(h)];
            let t = fraction_along(ends.map(|v| before.point(v)), p);
            Some(Place {
                within: Within::sorted([(ends[0], 1.0 - t), (ends[1], t)]),
                drift: OUTSIDE,
            })
        }
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Lineage, OfVertex};
    use super::*;
    use delone::{Angle, DomainRule, Pslg, Quality, RefinedMesh, Refinement, SegmentPolicy};

    fn refined(drawing: &Pslg, rule: DomainRule, max_edge: f64) -> RefinedMesh {
        let quality = Quality {
            min_angle: Some(Angle::degrees(25.0)),
            max_edge: Some(max_edge),
            ..Quality::default()
        };
        let refinement = Refinement::new(quality).crossings(SegmentPolicy::Split);
        let refinement = refinement.domain(rule).threads(1);
        refinement.mesh(drawing.clone()).expect("a mesh")
    }

    /// A slanted star with segments across, whose hull is cut where coordinates are rounded.
    fn star(turn: u32) -> Pslg {
        let corner = |k: u32| {
            let angle = 0.1 * f64::from(turn) + std::f64::consts::TAU * f64::from(k) / 7.0;
            let reach = 1.0 + 0.3 * f64::from((k * 5 + turn) % 3);
            (40.0 + reach * angle.cos(), 0.5 * reach * angle.sin() - 3.0)
        };
        let mut star = Pslg::from_points((0..7).map(corner));
        star.add_ring((0..7).map(VertexId::new));
        for [a, b] in [[0, 3], [1, 4]] {
            star.add_segment(a, b);
        }
        star
    }

    /// Finds places, and says where their corners lie, sorted; requires that none is outside.
    fn corners_at(
        points: &[Point],
        first: usize,
        chains: &[Vec<VertexId>],
        free: &[VertexId],
    ) -> Vec<Vec<(Point, f64)>> {
        let chains = chains.iter().map(Vec::as_slice);
        let places = places(points, first, chains, free, &()).expect("planar");
        let places = places.into_iter().map(|place| {
            let Place { within, drift } = place.expect("a place");
            assert_eq!(drift, ROUNDING, "outside");
            let corners = within.corners();
            let mut corners: Vec<_> = corners.map(|(c, w)| (points[c.index()], w)).collect();
            corners.sort_by(|a, b| a.0.lex_cmp(&b.0));
            corners
        });
        places.collect()
    }

    #[test]
    fn free_vertices_lie_in_triangles_of_the_input_whatever_its_order() {
        for turn in 0..6 {
            for rule in [DomainRule::Hull, DomainRule::Carve] {
                let drawing = star(turn);
                let RefinedMesh { mesh, .. } = refined(&drawing, rule, 0.1);
                let points = mesh.triangulation().points();
                let lineage = Lineage::of_domain(&mesh, &()).expect("a table");
                let edges: Vec<_> = mesh.constrained_edges().collect();
                let wrong = lineage.disagreements(&drawing, points, &edges, None, &());
                assert_eq!(wrong.expect("nobody cancels"), [""; 0], "{turn} {rule:?}");
                let first = mesh.num_input_points() + mesh.num_crossings();
                let free = (0..).map(VertexId::new).zip(&lineage.vertices);
                let free = free.filter(|(_, of)| matches!(of, OfVertex::Free(_)));
                let free: Vec<_> = free.map(|(v, _)| v).collect();
                assert!(free.len() > 20, "{turn} {rule:?}: {}", free.len());
                let chains: Vec<_> = (0..drawing.segments.len())
                    .map(|segment| mesh.chain(segment).to_vec())
                    .collect();
                let found = corners_at(points, first, &chains, &free);
                // The other way round, but for the Steiner points.
                let mut points = points.to_vec();
                points[..first].reverse();
                let reversed = |v: &VertexId| match v.index() {
                    i if i < first => VertexId::new(first - 1 - i),
                    i => VertexId::new(i),
                };
                let chains = chains.iter().rev();
                let chains: Vec<_> = chains.map(|c| c.iter().map(reversed).collect()).collect();
                assert_eq!(corners_at(&points, first, &chains, &free), found);
            }
        }
    }

    #[test]
    fn beyond_the_hull_a_vertex_is_a_place_on_its_edge() {
        let corners = [(0.0, 1.0), (4.0, 1.0), (0.0, 5.0)];
        let at = |p: (f64, f64)| {
            let points: Vec<Point> = corners.into_iter().chain([p]).map(Point::from).collect();
            let found = places(&points, 3, std::iter::empty(), &[VertexId::new(3)], &());
            let place = found.expect("planar")[0]?;
            let problem = place.problem(&place.within, VertexId::new(3), &points, 3);
            Some((place.within.to_string(), problem.is_none()))
        };
        let found = |text: &str, is_near| Some((text.to_owned(), is_near));
        assert_eq!(
            at((1.0, 3.0)),
            found("0.25 of 0 + 0.25 of 1 + 0.5 of 2", true)
        );
        assert_eq!(at((1.0, 1.0)), found("0.75 of 0 + 0.25 of 1", true));
        assert_eq!(at((1.0, 1.0 - 1e-14)), found("0.75 of 0 + 0.25 of 1", true));
        assert_eq!(at((1.0, 0.999)), found("0.75 of 0 + 0.25 of 1", false));
        assert_eq!(at((4.0, 1.0)), None, "a vertex of the input");
    }
}
