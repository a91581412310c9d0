//! This project.

use super::Contender;
use delone::check::DomainMesh;
use delone::{
    ConstrainedDelaunay, ConstrainedTriangulation, Delaunay, DomainRule, Point, Pslg,
    SegmentPolicy, Triangulation, VertexId, check,
};
use delone_samples::Drawing;

/// The default builder of points on a fixed number of threads.
pub struct Points {
    /// Number of threads.
    pub threads: usize,
}

impl Contender for Points {
    type Input = Vec<Point>;
    type Output = Triangulation;

    fn prepare(&self, drawing: Drawing) -> Self::Input {
        drawing.points.into_iter().map(Point::from).collect()
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

/// The builder of domains, which keeps the convex hull.
pub struct Segments {
    /// Number of threads.
    pub threads: usize,
    /// What to do where segments cross.
    pub crossings: SegmentPolicy,
}

impl Contender for Segments {
    type Input = Pslg;
    type Output = ConstrainedTriangulation;

    fn prepare(&self, drawing: Drawing) -> Self::Input {
        let ends = drawing.segments.into_iter();
        Pslg {
            segments: ends.map(|ends| ends.map(VertexId::from)).collect(),
            ..Pslg::from_points(drawing.points)
        }
    }

    fn triangulate(&self, input: &mut Self::Input) -> Result<Self::Output, String> {
        ConstrainedDelaunay::new()
            .crossings(self.crossings)
            .threads(self.threads)
            .triangulate(std::mem::take(input))
            .map_err(|error| error.to_string())
    }

    fn num_triangles(&self, output: &Self::Output) -> usize {
        output.triangulation().num_triangles()
    }

    fn num_constrained(&self, output: &Self::Output) -> Option<usize> {
        Some(output.constrained_edges().count())
    }

    fn hash(&self, output: &Self::Output) -> Option<String> {
        Some(output.triangulation().hash().to_string())
    }
    /// Holds the result against its own copy of the input, for the caller's has been taken over.
    fn verify(&self, output: &Self::Output) -> Result<(), String> {
        let triangulation = output.triangulation();
        let points = triangulation.points();
        let input = Pslg {
            points: points[..output.num_input_points()].to_vec(),
            segments: output.segments().to_vec(),
            ..Pslg::default()
        };
        let subsegments: Vec<_> = output.constrained_edges().collect();
        let chain = |segment| output.chain(segment);
        let mesh = DomainMesh::new(points, triangulation.triangles(), &subsegments);
        check::verify_domain(&input, DomainRule::Hull, &mesh.with_chains(&chain), &())
            .map_err(|error| error.to_string())?
            .into_result()
            .map(drop)
            .map_err(|defects| defects.to_string())
    }
}
