//! `cdt` of the Foxtrot project: radial sweep with exact predicates.

use super::Contender;
use delone_samples::Drawing;

/// Its triangulation of points, or of what lies inside closed borders. Duplicates are its own affair.
pub enum Cdt {
    /// Points alone.
    Points,
    /// Points and segments; everything outside of them is erased.
    Inside,
}

impl Contender for Cdt {
    type Input = (Vec<(f64, f64)>, Vec<(usize, usize)>);
    type Output = Vec<(usize, usize, usize)>;

    fn prepare(&self, drawing: Drawing) -> Self::Input {
        let points = drawing.points.into_iter().map(|[x, y]| (x, y));
        let segments = drawing.segments.into_iter();
        let segments = segments.map(|[from, to]| (from as usize, to as usize));
        (points.collect(), segments.collect())
    }

    fn triangulate(&self, (points, segments): &mut Self::Input) -> Result<Self::Output, String> {
        match self {
            Self::Points => cdt::triangulate_points(points),
            Self::Inside => cdt::triangulate_with_edges(points, &*segments),
        }
        .map_err(|error| error.to_string())
    }

    fn num_triangles(&self, output: &Self::Output) -> usize {
        output.len()
    }
}
