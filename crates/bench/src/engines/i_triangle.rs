//! `i_triangle`: monotone partition by a sweep over integers, then flips.

use super::Contender;
use delone_samples::Drawing;
use i_triangle::float::delaunay::Delaunay;
use i_triangle::float::triangulatable::Triangulatable;

/// Its triangulation of one ring, snapped to a lattice of 32 bits; the vertices come back reordered.
pub struct ITriangle;

impl Contender for ITriangle {
    type Input = Vec<Vec<[f64; 2]>>;
    type Output = Delaunay<[f64; 2]>;

    fn prepare(&self, drawing: Drawing) -> Self::Input {
        vec![drawing.points]
    }

    fn triangulate(&self, input: &mut Self::Input) -> Result<Self::Output, String> {
        Ok(input.triangulate().into_delaunay())
    }

    fn num_triangles(&self, output: &Self::Output) -> usize {
        output.triangle_indices::<u32>().len() / 3
    }
}
