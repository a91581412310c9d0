//! Which triangles do not meet the bounds, and why.

use super::bounds::{Bounds, Shape};
use super::canvas::Canvas;
use super::corners::Corners;
use super::handing;
use super::longest::Paths;
use super::{Reason, Unmet};
use crate::check;
use crate::parallel::Workers;
use crate::{Angle, Broken, ConstrainedTriangulation, HalfEdgeId, Locked, TriangleId, VertexId};
use std::ops::Range;

/// Units in the last place of the largest coordinate below which a shortest edge leaves no room.
const ROOM: f64 = 4096.0;

/// The same where coordinates are next to nothing: 2⁻²⁴⁸, in those that are [scaled](super::handing::scale).
const LEAST_ROOM: f64 = f64::from_bits((1023 - 248) << 52);

/// The part by which an edge may be longer than the shortest one and count as that.
const SLACK: f64 = 1e-9;

/// Finds the triangles that break a bound, as they will be numbered: those of the domain in their order.
pub(super) fn unmet(
    canvas: &Canvas,
    bounds: &Bounds,
    workers: Workers,
) -> Vec<(TriangleId, Broken)> {
    let num_faces = canvas.mesh.num_faces();
    let len = workers.chunk_len(num_faces, 4);
    let chunks = (0..num_faces).step_by(len);
    let chunks = chunks.map(|start| start..num_faces.min(start + len));
    let mut unmet = Vec::new();
    let mut before = 0;
    for chunk in workers.map(chunks.collect(), |faces| Chunk::of(canvas, bounds, faces)) {
        let broken = chunk.broken.into_iter();
        unmet.extend(broken.map(|(i, broken)| (TriangleId::new(before + i), broken)));
        before += chunk.num_domain;
    }
    unmet
}

/// What is found among some faces.
struct Chunk {
    /// How many of them belong to the domain.
    num_domain: usize,
    /// Which of those break what.
    broken: Vec<(usize, Broken)>,
}

impl Chunk {
    fn of(canvas: &Canvas, bounds: &Bounds, faces: Range<usize>) -> Self {
        let mut chunk = Self {
            num_domain: 0,
            broken: Vec::new(),
        };
        let has_sizes = bounds.has_sizes();
        let is_inside = |&t: &TriangleId| !canvas.traits(t).is_outside();
        for t in faces.map(TriangleId::new).filter(is_inside) {
            let points = canvas.triangle(t);
            let shape = Shape::of(points);
            let [edge, area] = match has_sizes {
                true => bounds.oversizes(points, &shape, canvas.region(t)),
                false => [0.0; 2],
            };
            let broken = Broken {
                angle: bounds.is_skinny(shape.squares, shape.cross),
                edge: edge > 1.0,
                area: area > 1.0,
            };
            if broken != Broken::default() {
                chunk.broken.push((chunk.num_domain, broken));
            }
            chunk.num_domain += 1;
        }
        chunk
    }
}

/// Finds the reason of each.
pub(super) fn explain(
    mesh: &ConstrainedTriangulation,
    unmet: Vec<(TriangleId, Broken)>,
    locked: Locked,
    is_stopped: bool,
) -> Vec<Unmet> {
    if unmet.is_empty() {
        return Vec::new();
    }
    let mut why = Why {
        mesh,
        corners: Corners::of(mesh),
        paths: Paths::of(mesh),
        locked,
        is_stopped,
        least: LEAST_ROOM / handing::scale(mesh.triangulation().points()),
    };
    let explained = unmet.into_iter().map(|(triangle, broken)| {
        let corners = mesh.triangulation().triangles()[triangle.index()];
        let shape = check::Shape::of(corners.map(|v| mesh.triangulation().point(v)));
        Unmet {
            triangle,
            broken,
            min_angle: Angle::degrees(shape.min_angle()),
            reason: why.reason(triangle, broken, &shape),
        }
    });
    explained.collect()
}

struct Why<'a> {
    mesh: &'a ConstrainedTriangulation,
    corners: Corners<'a>,
    paths: Paths<'a>,
    locked: Locked,
    is_stopped: bool,
    /// Lengths below this leave no room, wherever they are.
    least: f64,
}

impl Why<'_> {
    fn reason(&mut self, t: TriangleId, broken: Broken, shape: &check::Shape) -> Reason {
        let corners = self.mesh.triangulation().triangles()[t.index()];
        if broken.angle
            && !broken.edge
            && !broken.area
            && let Some(reason) = self.small_input_angle(corners, shape)
        {
            return reason;
        }
        if self.is_locked_in(t) {
            return Reason::LockedBoundary;
        }
        let points = corners.map(|v| self.mesh.triangulation().point(v));
        let largest = points
            .iter()
            .fold(0.0, |m: f64, p| m.max(p.x.abs()).max(p.y.abs()));
        if shortest(shape) < (ROOM * unit(largest)).max(self.least) {
            return Reason::Precision;
        }
        match self.is_stopped {
            true => Reason::Stopped,
            false => Reason::Gradation,
        }
    }

    /// Tells whether an edge of a triangle is locked, or that at the end of its path of longest edges.
    fn is_locked_in(&mut self, t: TriangleId) -> bool {
        if self.locked == Locked::Nothing {
            return false;
        }
        let (mesh, locked) = (self.mesh, self.locked);
        let is_locked = |h| is_locked(mesh, locked, h);
        t.half_edges().into_iter().any(is_locked) || self.paths.ends_at(t, is_locked)
    }

    /// Looks for two segments that meet below 60 degrees: at a corner of the triangle, or through the ends
    /// of its shortest edge. Where edges are as short as rounding can tell, each may be the shortest.
    fn small_input_angle(
        &mut self,
        vertices: [VertexId; 3],
        shape: &check::Shape,
    ) -> Option<Reason> {
        let corner = vertices.into_iter().find_map(|v| self.corners.at(v));
        let most = shortest(shape) * (1.0 + SLACK);
        corner.or_else(|| {
            let mut slots = (0..3).filter(|&k| shape.edges[k] <= most);
            slots.find_map(|k| {
                let ends = [vertices[(k + 1) % 3], vertices[(k + 2) % 3]];
                self.corners.joined_by(ends)
            })
        })
    }
}

fn is_locked(mesh: &ConstrainedTriangulation, locked: Locked, h: HalfEdgeId) -> bool {
    let is_boundary = || {
        let twin = mesh.triangulation().mesh().twin(h);
        twin.triangle().index() >= mesh.triangulation().num_triangles()
    };
    match locked {
        Locked::Nothing => false,
        Locked::Boundary => mesh.is_constrained(h) && is_boundary(),
        Locked::Segments => mesh.is_constrained(h),
    }
}

fn shortest(shape: &check::Shape) -> f64 {
    shape.edges.into_iter().fold(f64::INFINITY, f64::min)
}

/// The unit in the last place of a number that is not negative.
fn unit(magnitude: f64) -> f64 {
    let next = magnitude.next_up();
    match next.is_finite() {
        true => next - magnitude,
        false => magnitude - magnitude.next_down(),
    }
}
