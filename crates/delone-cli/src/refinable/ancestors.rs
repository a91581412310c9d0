//! What the triangles of a mesh that is refined hand down to those made in their place.
//!
//! A triangle has the attributes of the old one in which its centroid lies. Where a segment parts old
//! triangles of different attributes, as those of regions do, that is right for every new one; elsewhere
//! the border between attributes follows the new edges.

use crate::exit::Failure;
use delone::sizing::Areas;
use delone::{ConstrainedTriangulation, Point, SizingField};
use delone_io::{Attribute, MeshData};

/// The triangles of an old mesh, to be found by place.
pub struct Ancestors {
    places: Areas,
    attributes: Vec<Attribute>,
}

impl Ancestors {
    /// Takes the attributes of the triangles of a mesh, if there are any.
    pub fn of(mesh: &mut MeshData, file: &str) -> Result<Option<Self>, Failure> {
        let attributes = std::mem::take(&mut mesh.triangle_attributes);
        if attributes.is_empty() {
            return Ok(None);
        }
        // Ranks instead of areas: the field then answers with the first triangle at a place.
        let ranks: Vec<f64> = (1..=mesh.triangles.len()).map(|rank| rank as f64).collect();
        let places = Areas::from_mesh(&mesh.vertices.points, &mesh.triangles, &ranks);
        let places = places.map_err(|error| Failure::BadInput(format!("{file}: {error}")))?;
        Ok(Some(Self { places, attributes }))
    }

    /// Returns the attributes of new triangles; 0 for those beside all old ones.
    pub fn hand_down(&self, mesh: &ConstrainedTriangulation) -> Vec<Attribute> {
        let triangulation = mesh.triangulation();
        let triangles = triangulation.triangles().iter();
        let ranks = triangles.map(|t| {
            let corners = t.map(|v| triangulation.point(v));
            self.places.max_area(centroid(corners))
        });
        let ranks: Vec<f64> = ranks.collect();
        let handed = |attribute: &Attribute| Attribute {
            name: attribute.name.clone(),
            values: ranks.iter().map(|&rank| at(attribute, rank)).collect(),
        };
        self.attributes.iter().map(handed).collect()
    }
}

/// Returns the value of the triangle of a rank; there is none of infinite rank.
fn at(attribute: &Attribute, rank: f64) -> f64 {
    match rank.is_finite() {
        true => attribute.values[rank as usize - 1],
        false => 0.0,
    }
}

fn centroid(corners: [Point; 3]) -> Point {
    let mean = |of: fn(&Point) -> f64| corners.iter().map(|p| of(p) / 3.0).sum::<f64>();
    Point::new(mean(|p| p.x), mean(|p| p.y))
}
