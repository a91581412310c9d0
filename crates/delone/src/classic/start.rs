//! A triangulation to begin with: the triangles that a caller hands over.
//!
//! They need not fill the convex hull. All their edges are inserted as segments into a triangulation of all
//! points: then each triangle is a face of it if, and only if, none overlaps another and no point lies in
//! one. Faces that are no triangle of the caller's are carved away; they close the sphere, and nobody is told
//! of them.
//!
//! *Cost*: that of a constrained Delaunay triangulation with all edges as segments.

use super::{Board, Input, ascending, sides, smallest_first, sweep};
use crate::predicates::{Orientation, orient2d};
use crate::{
    ConstrainedDelaunay, ConstrainedTriangulation, Error, Observer, Pslg, TriangleId,
    Triangulation, VertexId,
};
use std::collections::{BTreeMap, BTreeSet};

impl<'r, O: Observer> Board<'r, O> {
    /// Begins with the triangles of the input, or else with those of the [sweep](super::sweep), told in steps of
    /// line 0.
    ///
    /// # Errors
    /// As [`from_triangles`](Self::from_triangles), or as the sweep.
    pub fn begin(input: &Input<'r>, observer: &'r mut O) -> Result<Self, Error> {
        match input.start.is_empty() {
            true => sweep::lay_out(input, observer),
            false => Self::from_triangles(input, observer),
        }
    }

    /// Begins with the triangles of `input.start`, the segments of the input locked, and tells of them in
    /// steps of line 0.
    ///
    /// # Errors
    /// [`Error::BadTriangle`], [`Error::BadStart`] name the triangle; [`Error::BadSegment`],
    /// [`Error::Crossing`] what is wrong with segments; and what every builder refuses.
    fn from_triangles(input: &Input<'r>, observer: &'r mut O) -> Result<Self, Error> {
        let mut nobody = ();
        let (mut board, _) = Board::new(input, &mut nobody)?;
        let all = triangulate(input)?;
        let outside = find_outside(all.triangulation(), &input.start)?;
        let segments = 0..input.pslg.segments.len();
        let edges = segments.flat_map(|segment| all.chain(segment).windows(2));
        let locked: BTreeSet<_> = edges.map(|e| ascending([e[0], e[1]])).collect();
        board.take(all.into_triangulation().mesh().clone(), locked, outside);
        Ok(Board::lay_out(board, input, observer))
    }
}

/// Triangulates all points, with segments and all sides of triangles as edges.
fn triangulate(input: &Input) -> Result<ConstrainedTriangulation, Error> {
    let Pslg {
        points, segments, ..
    } = &input.pslg;
    for (triangle, corners) in input.start.iter().enumerate() {
        if let Some(&vertex) = corners.iter().find(|v| v.index() >= points.len()) {
            let points = points.len();
            return Err(Error::BadTriangle {
                triangle,
                vertex,
                points,
            });
        }
    }
    let sides = input.start.iter().flat_map(|&t| sides(t));
    let pslg = Pslg {
        points: points.clone(),
        segments: segments.iter().copied().chain(sides).collect(),
        ..Pslg::default()
    };
    let builder = ConstrainedDelaunay::new().threads(1).watch(input.watch);
    builder.triangulate(pslg).map_err(|error| match error {
        Error::Crossing {
            segments: [_, side],
            ..
        } if side >= segments.len() => Error::BadStart {
            triangle: (side - segments.len()) / 3,
            why: "another triangle overlaps it, or a segment crosses it",
        },
        other => other,
    })
}

/// Tells for each face whether it is none of the triangles; there are no answers if all are.
fn find_outside(all: &Triangulation, start: &[[VertexId; 3]]) -> Result<Vec<bool>, Error> {
    let faces = all.mesh().triangles();
    let mut faces: BTreeMap<_, TriangleId> = faces
        .map(|t| (smallest_first(all.mesh().corners(t)), t))
        .collect();
    for (triangle, corners) in start.iter().enumerate() {
        let corners = corners.map(|v| all.representative(v));
        let [a, b, c] = corners.map(|v| all.point(v));
        let why = if orient2d(a, b, c) != Orientation::Left {
            "it does not turn counter-clockwise"
        } else if faces.remove(&smallest_first(corners)).is_none() {
            "it is there twice, overlaps another, or holds a point"
        } else {
            continue;
        };
        return Err(Error::BadStart { triangle, why });
    }
    let mut outside = vec![
        false;
        if faces.is_empty() {
            0
        } else {
            all.mesh().num_faces()
        }
    ];
    faces.into_values().for_each(|t| outside[t.index()] = true);
    Ok(outside)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Log, Point};

    /// A square with a notch from above, and a loose point in the notch.
    const NOTCHED: [(f64, f64); 6] = [
        (0.0, 0.0),
        (4.0, 0.0),
        (4.0, 4.0),
        (2.0, 1.0),
        (0.0, 4.0),
        (2.0, 3.0),
    ];

    const AROUND_THE_NOTCH: [[usize; 3]; 3] = [[0, 1, 3], [1, 2, 3], [0, 3, 4]];

    fn input(points: &[(f64, f64)], start: &[[usize; 3]]) -> Input<'static> {
        let mut input = Input::from_points(points.iter().copied());
        input.start = start.iter().map(|t| t.map(VertexId::new)).collect();
        input
    }

    fn refused(points: &[(f64, f64)], start: &[[usize; 3]]) -> Error {
        let input = input(points, start);
        let refused = Board::from_triangles(&input, &mut ()).map(|_| ());
        refused.expect_err("it cannot be part of a triangulation")
    }

    #[test]
    fn what_is_told_and_handed_out_are_the_triangles() {
        let mut input = input(&NOTCHED, &AROUND_THE_NOTCH);
        input.pslg.add_segment(1, 3);
        input.pslg.add_segment(2, 5);
        let mut log = Log::new("start", input.pslg.points.clone());
        let board = Board::from_triangles(&input, &mut log).expect("a triangulation");
        board.mesh().validate().expect("a sphere");
        let output = board.finish();
        assert_eq!(output.triangles.len(), 3);
        assert_eq!(
            output.constrained,
            [[1, 3], [2, 5]].map(|e| e.map(VertexId::new))
        );
        let scene = log.last_scene().expect("a scene");
        assert_eq!(scene.hash(), output.hash());
        // Seven edges of the triangles, and the constraint across the notch.
        assert_eq!(scene.edges().count(), 8);
        assert!(log.steps.iter().all(|step| step.line == 0));
    }

    #[test]
    fn edges_beside_carved_faces_may_stay() {
        let input = input(&NOTCHED, &AROUND_THE_NOTCH);
        let mut nobody = ();
        let mut board = Board::from_triangles(&input, &mut nobody).expect("a triangulation");
        for h in board.mesh().half_edges() {
            let is_inner =
                board.is_inside(h.triangle()) && board.is_inside(board.mesh().twin(h).triangle());
            assert!(is_inner || board.is_locally_delaunay(h));
        }
    }

    #[test]
    fn an_edge_between_domain_and_carved_faces_can_be_split() {
        let input = input(&NOTCHED, &AROUND_THE_NOTCH);
        let mut log = Log::new("start", input.pslg.points.clone());
        let mut board = Board::from_triangles(&input, &mut log).expect("a triangulation");
        let [a, b] = [2, 3].map(VertexId::new);
        let h = board.mesh().half_edges().find(|&h| board.ends(h) == [a, b]);
        let h = h.expect("an edge of the notch");
        assert!(board.is_inside(h.triangle()) && board.is_visible(h));
        let w = board.create_vertex(Point::new(3.0, 2.5)).expect("room");
        board.split_edge(h, w);
        let output = board.finish();
        assert_eq!(output.triangles.len(), 4);
        let scene = log.last_scene().expect("a scene");
        assert_eq!(scene.hash(), output.hash());
        assert_eq!(scene.edges().count(), 7 + 2);
    }

    #[test]
    fn what_overlaps_is_named() {
        let square = &NOTCHED[..3];
        let named = |points, start: &[[usize; 3]], expected: usize| {
            let error = refused(points, start);
            let is_right =
                matches!(error, Error::BadStart { triangle, .. } if triangle == expected);
            assert!(is_right, "{error}");
        };
        named(square, &[[0, 2, 1]], 0);
        named(square, &[[0, 1, 1]], 0);
        named(square, &[[0, 1, 2], [1, 2, 0]], 1);
        // A point within, or on a side.
        named(&NOTCHED, &[[0, 1, 2]], 0);
        named(
            &[(0.0, 0.0), (2.0, 0.0), (0.0, 2.0), (1.0, 0.0)],
            &[[0, 1, 2]],
            0,
        );
        // Sides that cross.
        named(&NOTCHED, &[[0, 1, 3], [0, 3, 4], [0, 1, 5]], 2);
        let error = refused(square, &[[0, 1, 3]]);
        assert!(
            matches!(error, Error::BadTriangle { triangle: 0, .. }),
            "{error}"
        );
    }

    #[test]
    fn a_sweep_is_laid_out_with_its_segments() {
        let mut input = input(&NOTCHED, &[]);
        input.pslg.add_ring([0, 1, 2, 3, 4]);
        input.domain = crate::DomainRule::Carve;
        let mut log = Log::new("lay out", input.pslg.points.clone());
        let output = sweep::lay_out(&input, &mut log).expect("a domain").finish();
        assert_eq!((output.triangles.len(), output.constrained.len()), (3, 5));
        assert!(log.steps.iter().all(|step| step.line == 0));
        assert_eq!(log.last_scene().expect("a scene").hash(), output.hash());
    }
}
