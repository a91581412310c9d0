//! Every excuse is true.
//!
//! A triangle is excused when its shortest edge joins two segments of the input that meet at less than
//! 60 degrees, or it has their corner; when its shortest edge is below 2¹² units in the last place of
//! its largest coordinate; or when one of its edges is one that must not be split, or such an edge is
//! reached from longest edge to longer one. An excuse for an
//! angle is none for a size: only what makes a smaller triangle impossible is.

use super::structure::is_locked;
use super::{Job, Lines, Shape, Verdict, at, ensure, least_room};
use delone::{
    ConstrainedTriangulation, Outcome, Point, Reason, RefinedMesh, TriangleId, Unmet, VertexId,
};
use std::collections::BTreeSet;

pub(super) fn check_excuses(job: &Job, refined: &RefinedMesh, lines: &Lines) -> Verdict {
    for unmet in &refined.report.unmet {
        check_excuse(job, refined, lines, unmet).map_err(|why| {
            format!(
                "{unmet:?}: {why}\n{:?}",
                corners(&refined.mesh, unmet.triangle)
            )
        })?;
    }
    Ok(())
}

fn check_excuse(job: &Job, refined: &RefinedMesh, lines: &Lines, unmet: &Unmet) -> Verdict {
    let RefinedMesh { mesh, report, .. } = refined;
    match unmet.reason {
        Reason::SmallInputAngle {
            vertex,
            segments,
            angle,
        } => {
            let is_size = unmet.broken.edge || unmet.broken.area;
            ensure(!is_size, || {
                "a small angle does not forbid a small size".to_owned()
            })?;
            check_meeting(lines, vertex, segments, angle.to_degrees())?;
            check_touches(mesh, lines, unmet.triangle, vertex, segments)
        }
        Reason::LockedBoundary => {
            let mut edges = unmet.triangle.half_edges().into_iter();
            let is_true = edges.any(|h| is_locked(job, mesh, h))
                || hangs_on_locked(job, mesh, unmet.triangle);
            ensure(is_true, || "it does not hang on a locked edge".to_owned())
        }
        Reason::Precision => {
            let corners = corners(mesh, unmet.triangle);
            let least = least_room(mesh, corners);
            let shortest = Shape::of(corners).shortest();
            ensure(shortest < least, || {
                format!("its shortest edge {shortest} is not below {least}")
            })
        }
        Reason::Stopped => {
            let stops = [Outcome::BudgetExhausted, Outcome::Cancelled];
            ensure(stops.contains(&report.outcome), || {
                "nothing stopped".to_owned()
            })
        }
        _ => Ok(()),
    }
}

/// Going from a triangle across its longest edge, and on as long as edges get longer, one comes to a
/// locked edge. Any of several that are equally long, but for rounding, will do.
fn hangs_on_locked(job: &Job, mesh: &ConstrainedTriangulation, t: TriangleId) -> bool {
    let mut seen = BTreeSet::from([t]);
    let mut open = vec![t];
    while let Some(t) = open.pop() {
        let shape = Shape::of(corners(mesh, t));
        let least = shape.longest() * (1.0 - 1e-9);
        for k in (0..3).filter(|&k| shape.edges[k] >= least) {
            let h = t.half_edges()[k];
            let beyond = mesh.triangulation().mesh().twin(h).triangle();
            if is_locked(job, mesh, h) {
                return true;
            }
            let is_domain = beyond.index() < mesh.triangulation().num_triangles();
            if is_domain
                && Shape::of(corners(mesh, beyond)).longest() > least
                && seen.insert(beyond)
            {
                open.push(beyond);
            }
        }
    }
    false
}

/// The two segments meet in the vertex, at this angle, below 60 degrees.
fn check_meeting(lines: &Lines, vertex: VertexId, segments: [usize; 2], angle: f64) -> Verdict {
    let found = lines.angles(vertex, segments);
    let through = lines.through(vertex);
    let meet = segments.iter().all(|s| through.contains(s));
    let is_near = |found: &f64| (found - angle).abs() <= 1e-3 * angle + 1e-12;
    let is_true = meet && segments[0] != segments[1] && found.iter().any(is_near);
    ensure(is_true && angle < 60.0, || {
        format!("the segments meet there at {found:?}")
    })
}

/// The triangle has the corner, or a shortest edge that joins the two segments.
fn check_touches(
    mesh: &ConstrainedTriangulation,
    lines: &Lines,
    triangle: TriangleId,
    vertex: VertexId,
    [s, t]: [usize; 2],
) -> Verdict {
    let corners = mesh.triangulation().mesh().corners(triangle);
    let shape = Shape::of(corners.map(|v| at(mesh, v)));
    let is_on = |v: VertexId, segment: usize| lines.through(v).contains(&segment);
    let joins = |k: usize| {
        let [a, b] = [corners[(k + 1) % 3], corners[(k + 2) % 3]];
        let is_shortest = shape.edges[k] <= shape.shortest() * (1.0 + 1e-9);
        is_shortest && ((is_on(a, s) && is_on(b, t)) || (is_on(a, t) && is_on(b, s)))
    };
    ensure(corners.contains(&vertex) || (0..3).any(joins), || {
        "neither has it the corner, nor does its shortest edge join the segments".to_owned()
    })
}

fn corners(mesh: &ConstrainedTriangulation, t: TriangleId) -> [Point; 3] {
    mesh.triangulation().mesh().corners(t).map(|v| at(mesh, v))
}
