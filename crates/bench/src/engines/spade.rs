//! `spade`: half-edges with exact predicates, bulk load along circles about a centre.

use super::Contender;
use delone_samples::Drawing;
use spade::handles::FixedVertexHandle;
use spade::{ConstrainedDelaunayTriangulation, DelaunayTriangulation, Point2, Triangulation};

/// Which of its two bulk loads of points.
pub enum Spade {
    /// The one that may reorder vertices.
    Bulk,
    /// The one that keeps the caller's numbering.
    Stable,
}

impl Contender for Spade {
    type Input = Vec<Point2<f64>>;
    type Output = DelaunayTriangulation<Point2<f64>>;

    fn prepare(&self, drawing: Drawing) -> Self::Input {
        points(drawing.points)
    }

    fn triangulate(&self, input: &mut Self::Input) -> Result<Self::Output, String> {
        let points = std::mem::take(input);
        match self {
            Self::Bulk => DelaunayTriangulation::bulk_load(points),
            Self::Stable => DelaunayTriangulation::bulk_load_stable(points),
        }
        .map_err(|error| error.to_string())
    }

    fn num_triangles(&self, output: &Self::Output) -> usize {
        output.num_inner_faces()
    }
}

/// What it does with segments.
pub enum Constrained {
    /// Bulk load of points and segments; panics where segments cross.
    Bulk,
    /// Bulk load of the points, then one segment after the other, split where it crosses another.
    Split,
}

impl Contender for Constrained {
    type Input = (Vec<Point2<f64>>, Vec<[usize; 2]>);
    type Output = ConstrainedDelaunayTriangulation<Point2<f64>>;

    fn prepare(&self, drawing: Drawing) -> Self::Input {
        let segments = drawing.segments.into_iter();
        let segments = segments.map(|ends| ends.map(|v| v as usize)).collect();
        (points(drawing.points), segments)
    }

    fn triangulate(&self, input: &mut Self::Input) -> Result<Self::Output, String> {
        let (points, segments) = std::mem::take(input);
        match self {
            Self::Bulk => ConstrainedDelaunayTriangulation::bulk_load_cdt(points, segments),
            Self::Split => {
                let loaded = ConstrainedDelaunayTriangulation::bulk_load_cdt(points, Vec::new());
                loaded.map(|mut triangulation| {
                    for ends in segments {
                        let [from, to] = ends.map(FixedVertexHandle::from_index);
                        triangulation.add_constraint_and_split(from, to, |vertex| vertex);
                    }
                    triangulation
                })
            }
        }
        .map_err(|error| error.to_string())
    }

    fn num_triangles(&self, output: &Self::Output) -> usize {
        output.num_inner_faces()
    }

    fn num_constrained(&self, output: &Self::Output) -> Option<usize> {
        Some(output.num_constraints())
    }
}

fn points(points: Vec<[f64; 2]>) -> Vec<Point2<f64>> {
    points.into_iter().map(|[x, y]| Point2::new(x, y)).collect()
}
