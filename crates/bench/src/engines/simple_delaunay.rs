//! `simple_delaunay_lib`: incremental insertion with flips, exact predicates, ghosts as we have.

use super::Contender;
use delone_samples::Drawing;
use simple_delaunay_lib::delaunay_2d::delaunay_struct_2d::DelaunayStructure2D;

/// Its batch insertion along a Hilbert curve.
pub struct SimpleDelaunay;

impl Contender for SimpleDelaunay {
    type Input = Vec<[f64; 2]>;
    type Output = DelaunayStructure2D;

    fn prepare(&self, drawing: Drawing) -> Self::Input {
        drawing.points
    }

    fn triangulate(&self, input: &mut Self::Input) -> Result<Self::Output, String> {
        let mut structure = DelaunayStructure2D::new();
        let inserted = structure.insert_vertices(input, true);
        inserted.map_err(|error| error.to_string())?;
        Ok(structure)
    }

    fn num_triangles(&self, output: &Self::Output) -> usize {
        let faces = output.get_simplicial();
        (0..faces.get_nb_triangles())
            .filter_map(|t| faces.get_triangle(t).ok())
            .filter(|t| !t.contains_infinity())
            .count()
    }
}
