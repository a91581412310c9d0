//! `delaunator`: radial sweep with flips; exact orientation, rounded in-circle.

use super::Contender;
use delaunator::{Point, Triangulation, triangulate};

/// The one function it has.
pub struct Delaunator;

impl Contender for Delaunator {
    type Input = Vec<Point>;
    type Output = Triangulation;

    fn prepare(&self, points: Vec<[f64; 2]>) -> Self::Input {
        points.into_iter().map(|[x, y]| Point { x, y }).collect()
    }

    fn triangulate(&self, input: &mut Self::Input) -> Result<Self::Output, String> {
        Ok(triangulate(input))
    }

    fn num_triangles(&self, output: &Self::Output) -> usize {
        output.len()
    }
}
