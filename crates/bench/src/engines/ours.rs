//! This project.

use super::Contender;
use delone::{Delaunay, Point, Triangulation};

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

    /// The caller keeps the points: copying them is part of the time.
    fn triangulate(&self, input: &mut Self::Input) -> Result<Self::Output, String> {
        Delaunay::new()
            .threads(self.threads)
            .triangulate(input.iter().copied())
            .map_err(|error| error.to_string())
    }

    fn num_triangles(&self, output: &Self::Output) -> usize {
        output.num_triangles()
    }

    fn hash(&self, output: &Self::Output) -> Option<String> {
        Some(output.hash().to_string())
    }
}
