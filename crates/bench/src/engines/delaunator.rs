//! `delaunator`: radial sweep with flips; exact orientation, rounded in-circle.

use super::Contender;
use delaunator::{Point, Triangulation, triangulate};
use delone_samples::Drawing;

/// The one function it has.
pub struct Delaunator;

impl Contender for Delaunator {
    type Input = Vec<Point>;
    type Output = Triangulation;

    fn prepare(&self, drawing: Drawing) -> Self::Input {
        let points = drawing.points.into_iter();
        points.map(|[x, y]| Point { x, y }).collect()
    }

    fn triangulate(&self, input: &mut Self::Input) -> Result<Self::Output, String> {
        Ok(triangulate(input))
    }

    fn num_triangles(&self, output: &Self::Output) -> usize {
        output.len()
    }
}
