//! `ghx_constrained_delaunay`: the incremental algorithm of Sloan with tolerances.

use super::Contender;
use delone_samples::Drawing;
use ghx_constrained_delaunay::Triangulation;
use ghx_constrained_delaunay::constrained_triangulation::{
    ConstrainedTriangulationConfiguration, constrained_triangulation_from_2d_vertices,
};
use ghx_constrained_delaunay::glam::DVec2;
use ghx_constrained_delaunay::types::Edge;

/// Its triangulation of points and segments; keeps what lies inside of clockwise rings.
pub struct Ghx;

impl Contender for Ghx {
    type Input = (Vec<DVec2>, Vec<Edge>);
    type Output = Triangulation;

    fn prepare(&self, drawing: Drawing) -> Self::Input {
        let points = drawing.points.into_iter().map(DVec2::from);
        // Turned round: our rings run counter-clockwise.
        let segments = drawing.segments.into_iter();
        let segments = segments.map(|[to, from]| Edge { from, to });
        (points.collect(), segments.collect())
    }

    fn triangulate(&self, (points, segments): &mut Self::Input) -> Result<Self::Output, String> {
        let options = ConstrainedTriangulationConfiguration::default();
        constrained_triangulation_from_2d_vertices(points, segments, options)
            .map_err(|error| format!("{error:?}"))
    }

    fn num_triangles(&self, output: &Self::Output) -> usize {
        output.triangles.len()
    }
}
