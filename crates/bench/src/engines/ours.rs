//! This project.

use super::Contender;
use delone::{Delaunay, Point, Triangulation, check};

/// The default builder on a fixed number of threads.
pub struct Ours {
    /// Number of threads.
    pub threads: usize,
}

impl Contender for Ours {
    type Input = Vec<Point>;
    type Output = Triangulation;

    fn prepare(&self, points: Vec<[f64; 2]>) -> Self::Input {
        points.into_iter().map(Point::from).collect()
    }

    /// The result takes the points over, as spade's does.
    fn triangulate(&self, input: &mut Self::Input) -> Result<Self::Output, String> {
        Delaunay::new()
            .threads(self.threads)
            .triangulate(std::mem::take(input))
            .map_err(|error| error.to_string())
    }

    fn num_triangles(&self, output: &Self::Output) -> usize {
        output.num_triangles()
    }

    fn hash(&self, output: &Self::Output) -> Option<String> {
        Some(output.hash().to_string())
    }

    fn verify(&self, output: &Self::Output) -> Result<(), String> {
        check::verify(output.points(), output.triangles(), &())
            .map_err(|error| error.to_string())?
            .into_result()
            .map(drop)
            .map_err(|defects| defects.to_string())
    }
}
