//! What excuses a triangle that breaks a bound.

use super::super::drift::unit;
use super::super::graph::Dart;
use super::corners::Corners;
use super::paths::Paths;
use super::{Found, SLACK, Shape};
use crate::pace::Pace;
use crate::{Angle, Broken, Error, Locked, Point, TriangleId, VertexId};

/// Units in the last place of the largest coordinate below which a shortest edge leaves no room.
const ROOM: f64 = 4096.0;

/// The same where coordinates are next to nothing, as part of the extent: 2⁻²⁴⁸.
const LEAST_ROOM: f64 = f64::from_bits((1023 - 248) << 52);

/// Why a triangle could not be better.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Excuse {
    /// Two segments meet at less than 60 degrees; the triangle has their corner, or its shortest edge
    /// joins them.
    SmallInputAngle {
        /// The corner where they meet.
        vertex: VertexId,
        /// The two segments; numbers behind those of the input stand for edges of its convex hull.
        segments: [usize; 2],
        /// The angle between them.
        angle: Angle,
    },
    /// An edge lies on a segment that must not be split, or such an edge is the end of the
    /// [path of longest edges](crate::Reason::LockedBoundary) that begins in the triangle.
    Locked,
    /// The shortest edge is below 2¹² units in the last place of the largest coordinate, or
    /// [below 2⁻²⁴⁸](crate::Reason::Precision).
    Precision,
}

/// Returns the largest coordinate where that is far from 1, else 1.
fn extent(points: &[Point]) -> f64 {
    let sizes = points.iter().map(|p| p.x.abs().max(p.y.abs()));
    match sizes.fold(0.0, f64::max) {
        usual if (1e-30..1e30).contains(&usual) => 1.0,
        largest => largest,
    }
}

/// Looks for excuses in a mesh.
pub(super) struct Excuses<'e> {
    found: &'e Found<'e>,
    locked: Locked,
    corners: Corners<'e>,
    paths: Paths<'e>,
    /// Lengths below this leave no room, wherever they are.
    least: f64,
}

impl<'e> Excuses<'e> {
    pub fn new(found: &'e Found<'e>, locked: Locked) -> Self {
        Self {
            found,
            locked,
            corners: Corners::new(found),
            paths: Paths::new(found),
            least: LEAST_ROOM * extent(found.points),
        }
    }

    /// Finds what excuses all that a triangle breaks.
    pub fn find(
        &mut self,
        triangle: TriangleId,
        broken: Broken,
        shape: &Shape,
        pace: &mut Pace,
    ) -> Result<Option<Excuse>, Error> {
        let vertices = self.found.triangles[triangle.index()];
        if !broken.edge && !broken.area {
            let excuse = self.small_input_angle(vertices, shape, pace)?;
            if excuse.is_some() {
                return Ok(excuse);
            }
        }
        if self.is_locked_in(triangle, pace)? {
            return Ok(Some(Excuse::Locked));
        }
        let shortest = shape.edges.into_iter().fold(f64::INFINITY, f64::min);
        let lacks_room = self.lacks_room(&vertices, shortest);
        Ok(lacks_room.then_some(Excuse::Precision))
    }

    /// Tells whether an edge of a triangle must not be split, or that at the end of its path.
    fn is_locked_in(&mut self, triangle: TriangleId, pace: &mut Pace) -> Result<bool, Error> {
        if self.locked == Locked::Nothing {
            return Ok(false);
        }
        let [a, b, c] = self.found.triangles[triangle.index()];
        let (found, locked) = (self.found, self.locked);
        let is_locked = |ends| is_locked_between(found, locked, ends);
        Ok([[a, b], [b, c], [c, a]].into_iter().any(is_locked)
            || self.paths.ends_at_locked(triangle, is_locked, pace)?)
    }

    /// Finds what excuses a subsegment for not having been split, with a vertex inside its circle.
    pub fn of_subsegment(&self, ends: [VertexId; 2], apex: VertexId) -> Option<Excuse> {
        if is_locked_between(self.found, self.locked, ends) {
            return Some(Excuse::Locked);
        }
        let vertices = [apex, ends[0], ends[1]];
        // The longest edge is the subsegment, so the height upon it is how near the vertex is.
        let shape = Shape::of(vertices.map(|v| self.found.points[v.index()]));
        let height = shape.edges[0] / shape.aspect;
        self.lacks_room(&vertices, height)
            .then_some(Excuse::Precision)
    }

    /// Tells whether a dart must not be split.
    pub fn is_locked(&self, dart: Dart) -> bool {
        is_locked(self.found, self.locked, dart)
    }

    fn lacks_room(&self, vertices: &[VertexId], length: f64) -> bool {
        let points = vertices.iter().map(|v| self.found.points[v.index()]);
        let largest = points.fold(0.0_f64, |m, p| m.max(p.x.abs()).max(p.y.abs()));
        length < self.least.max(ROOM * unit(largest))
    }

    /// Looks at the corners, and then at each edge that may be the shortest one.
    fn small_input_angle(
        &mut self,
        vertices: [VertexId; 3],
        shape: &Shape,
        pace: &mut Pace,
    ) -> Result<Option<Excuse>, Error> {
        for v in vertices {
            let excuse = self.corners.at(v, pace)?;
            if excuse.is_some() {
                return Ok(excuse);
            }
        }
        let shortest = shape.edges.into_iter().fold(f64::INFINITY, f64::min);
        for k in (0..3).filter(|&k| shape.edges[k] <= shortest * (1.0 + SLACK)) {
            let ends = [vertices[(k + 1) % 3], vertices[(k + 2) % 3]];
            let excuse = self.corners.joined_by(ends, pace)?;
            if excuse.is_some() {
                return Ok(excuse);
            }
        }
        Ok(None)
    }
}

fn is_locked(found: &Found, locked: Locked, dart: Dart) -> bool {
    let Found { graph, area, .. } = *found;
    match locked {
        Locked::Nothing => false,
        Locked::Boundary => area.is_left_of(dart) != area.is_left_of(dart.twin()),
        Locked::Segments => graph.edges()[dart.edge()].is_subsegment,
    }
}

fn is_locked_between(found: &Found, locked: Locked, ends: [VertexId; 2]) -> bool {
    let graph = found.graph;
    let [a, b] = ends.map(|v| graph.places.of(v));
    let dart = graph.find(a, b);
    dart.is_some_and(|dart| is_locked(found, locked, dart))
}
