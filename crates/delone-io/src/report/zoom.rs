//! The surroundings of a triangle, enlarged.

use super::clip;
use crate::picture::domain::REGION_COLORS;
use crate::picture::sheet::Sheet;
use crate::picture::{Color, INK, PAPER, scale};
use delone::check::Shape;
use delone::{Point, Reason, RefinedMesh, TriangleId, Unmet, VertexId};
use std::collections::{BTreeSet, VecDeque};

/// Width and height of a picture, in pixels.
pub(super) const SIZE: f32 = 240.0;

/// What is shown around the middle of a triangle on each side, as a multiple of its longest edge.
const REACH: f64 = 1.1;

/// Most triangles that are drawn.
const MOST: usize = 500;

/// Outline of the triangle that it is about.
const FOCUS: Color = REGION_COLORS[0];

/// Maps the surroundings of a triangle to the square from -1 to 1.
struct Lens {
    middle: Point,
    reach: f64,
}

impl Lens {
    fn new(corners: [Point; 3]) -> Self {
        let longest = Shape::of(corners).edges.into_iter().fold(0.0, f64::max);
        let [p, q, r] = corners.map(|c| [c.x / 3.0, c.y / 3.0]);
        Self {
            middle: Point::new(p[0] + q[0] + r[0], p[1] + q[1] + r[1]),
            reach: (REACH * longest).clamp(f64::MIN_POSITIVE, f64::MAX),
        }
    }

    fn at(&self, p: Point) -> [f64; 2] {
        let [x, y] = [p.x - self.middle.x, p.y - self.middle.y];
        // What is beyond the largest number is far outside in any case.
        [x, y].map(|c| (c / self.reach).clamp(-1e15, 1e15))
    }

    /// Returns what of a polygon is seen, in pixels.
    fn cut(&self, corners: &[Point]) -> Vec<[f32; 2]> {
        let corners: Vec<_> = corners.iter().map(|&p| self.at(p)).collect();
        let seen = clip::to_window(&corners).into_iter();
        seen.map(|[x, y]| [1.0 + x, 1.0 - y].map(|c| c as f32 * SIZE / 2.0))
            .collect()
    }
}

/// Draws a triangle and what surrounds it.
pub(super) fn zoom(refined: &RefinedMesh, unmet: &Unmet) -> Sheet {
    let triangulation = refined.mesh.triangulation();
    let corners =
        |t: TriangleId| triangulation.triangles()[t.index()].map(|v| triangulation.point(v));
    let focus = corners(unmet.triangle);
    let lens = Lens::new(focus);
    let mut sheet = Sheet::default();
    sheet.bar([0.0; 2], [SIZE; 2], PAPER);
    let seen = surroundings(refined, unmet.triangle, |t| {
        !lens.cut(&corners(t)).is_empty()
    });
    for &t in &seen {
        let corners = corners(t);
        let angle = Shape::of(corners).min_angle() as f32;
        sheet.area(lens.cut(&corners), scale((angle / 60.0).min(1.0)));
    }
    let mut line = |ends: [Point; 2], width, color| {
        if let [a, b, ..] = lens.cut(&ends)[..] {
            sheet.line([a, b], width, color, 1.0);
        }
    };
    for (is_segment, width) in [(false, 0.8), (true, 3.0)] {
        let sides = seen.iter().flat_map(|t| t.half_edges());
        for h in sides.filter(|&h| refined.mesh.is_constrained(h) == is_segment) {
            let mesh = triangulation.mesh();
            let ends = [mesh.origin(h), mesh.dest(h)];
            line(ends.map(|v| triangulation.point(v)), width, INK);
        }
    }
    let [a, b, c] = focus;
    for side in [[a, b], [b, c], [c, a]] {
        line(side, 2.2, FOCUS);
    }
    mark_corner(&mut sheet, &lens, unmet.reason, |v| triangulation.point(v));
    sheet
}

/// Rings the vertex where two segments meet, if it is seen.
fn mark_corner(sheet: &mut Sheet, lens: &Lens, reason: Reason, point: impl Fn(VertexId) -> Point) {
    if let Reason::SmallInputAngle { vertex, .. } = reason {
        let corner = point(vertex);
        if let Some(&center) = lens.cut(&[corner]).first() {
            sheet.ring(center, 6.0);
        }
    }
}

/// Collects the triangles that are seen, from one outwards across their sides.
fn surroundings(
    refined: &RefinedMesh,
    start: TriangleId,
    is_seen: impl Fn(TriangleId) -> bool,
) -> Vec<TriangleId> {
    let mut found = BTreeSet::from([start]);
    let mut queue = VecDeque::from([start]);
    while let Some(t) = queue.pop_front()
        && found.len() < MOST
    {
        let neighbors = refined.mesh.triangulation().neighbors(t);
        for next in neighbors.into_iter().flatten() {
            if !found.contains(&next) && is_seen(next) {
                found.insert(next);
                queue.push_back(next);
            }
        }
    }
    found.into_iter().collect()
}
