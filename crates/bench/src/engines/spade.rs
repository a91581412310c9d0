//! `spade`: half-edges with exact predicates, bulk load along circles about a centre.

use super::Contender;
use spade::{DelaunayTriangulation, Point2, Triangulation};

/// Which of its two bulk loads.
pub enum Spade {
    /// The one that may reorder vertices.
    Bulk,
    /// The one that keeps the caller's numbering.
    Stable,
}

impl Contender for Spade {
    type Input = Vec<Point2<f64>>;
    type Output = DelaunayTriangulation<Point2<f64>>;

    fn prepare(&self, points: Vec<[f64; 2]>) -> Self::Input {
        points.into_iter().map(|[x, y]| Point2::new(x, y)).collect()
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
