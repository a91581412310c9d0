//! `cdt` of the Foxtrot project: radial sweep with exact predicates.

use super::Contender;

/// Its triangulation of points; duplicates are its own affair.
pub struct Cdt;

impl Contender for Cdt {
    type Input = Vec<(f64, f64)>;
    type Output = Vec<(usize, usize, usize)>;

    fn prepare(&self, points: Vec<[f64; 2]>) -> Self::Input {
        points.into_iter().map(|[x, y]| (x, y)).collect()
    }

    fn triangulate(&self, input: &mut Self::Input) -> Result<Self::Output, String> {
        cdt::triangulate_points(input).map_err(|error| error.to_string())
    }

    fn num_triangles(&self, output: &Self::Output) -> usize {
        output.len()
    }
}
