//! `poly2tri-rs`: the sweep of Domiter and Žalik with tolerances.

use super::Contender;
use delone_samples::Drawing;
use poly2tri_rs::{Point, SweeperBuilder};

/// Its triangulation of one ring.
pub struct Poly2Tri;

impl Contender for Poly2Tri {
    type Input = Vec<Point>;
    type Output = Vec<[Point; 3]>;

    fn prepare(&self, drawing: Drawing) -> Self::Input {
        let points = drawing.points.into_iter();
        points.map(|[x, y]| Point::new(x, y)).collect()
    }

    fn triangulate(&self, input: &mut Self::Input) -> Result<Self::Output, String> {
        let sweeper = SweeperBuilder::new(std::mem::take(input)).build();
        Ok(sweeper
            .triangulate()
            .map(|triangle| triangle.points)
            .collect())
    }

    fn num_triangles(&self, output: &Self::Output) -> usize {
        output.len()
    }
}
