//! What can be refined: a domain, or a mesh from before.
//!
//! Of a mesh its vertices are kept, its constrained edges if they are known, and its border, which
//! becomes the border of the domain; triangles between them are made anew, and are the same if the
//! mesh is constrained Delaunay.

mod ancestors;

use crate::exit::Failure;
use crate::files;
use crate::progress::Progress;
pub use ancestors::Ancestors;
use delone::sizing::Areas;
use delone::{DomainRule, VertexId};
use delone_io::{DomainData, MeshData, Source};
use std::path::PathBuf;

/// A domain, with what a mesh adds to it.
pub struct Refinable {
    /// The domain; a mesh is one, too.
    pub domain: DomainData,
    /// Largest areas, place by place.
    pub sizes: Option<Areas>,
    /// The triangles that are refined, if they hand attributes down.
    pub ancestors: Option<Ancestors>,
}

impl From<DomainData> for Refinable {
    fn from(domain: DomainData) -> Self {
        Self {
            domain,
            sizes: None,
            ancestors: None,
        }
    }
}

impl Refinable {
    /// Takes a mesh of `file`, with the `.area` file that bounds its triangles, if there is one.
    pub fn of_mesh(
        mut mesh: MeshData,
        file: &str,
        areas: Option<PathBuf>,
        progress: &Progress,
    ) -> Result<Self, Failure> {
        let sizes = areas.map(|path| self::areas(&mesh, path, progress));
        Ok(Self {
            sizes: sizes.transpose()?,
            ancestors: Ancestors::of(&mut mesh, file)?,
            domain: domain(mesh),
        })
    }
}

/// Reads the largest areas of the triangles of a mesh.
fn areas(mesh: &MeshData, path: PathBuf, progress: &Progress) -> Result<Areas, Failure> {
    let source = Source::Path(path.clone());
    let bounds = delone_io::read_areas(&source, mesh.triangles.len(), progress);
    let bounds = bounds.map_err(files::unreadable)?;
    let bounds: Vec<f64> = bounds.iter().map(|b| b.unwrap_or(-1.0)).collect();
    Areas::from_mesh(&mesh.vertices.points, &mesh.triangles, &bounds)
        .map_err(|error| Failure::BadInput(format!("{}: {error}", path.display())))
}

/// Makes a domain of a mesh: behind the segments comes its border, which alone decides what belongs
/// to it.
fn domain(mesh: MeshData) -> DomainData {
    let graph = mesh.constraints.unwrap_or_default();
    let mut segments = graph.edges;
    let mut markers = graph.markers;
    let first = segments.len();
    segments.extend(border(&mesh.triangles));
    if let Some(markers) = &mut markers {
        markers.resize(segments.len(), 0);
    }
    DomainData {
        vertices: mesh.vertices,
        polygons: Vec::from_iter((first < segments.len()).then_some(first..segments.len())),
        segments,
        segment_markers: markers,
        regions: graph.regions,
        usual_rule: DomainRule::EvenOdd,
        ..DomainData::default()
    }
}

/// Lists the edges that an odd number of triangles have, sorted. At every vertex their number is
/// even, so they are the closed border of what the triangles cover.
fn border(triangles: &[[VertexId; 3]]) -> Vec<[VertexId; 2]> {
    let sides = |&[a, b, c]: &[VertexId; 3]| [[a, b], [b, c], [c, a]];
    let mut edges: Vec<_> = triangles
        .iter()
        .flat_map(sides)
        .map(|[a, b]| [a.min(b), a.max(b)])
        .collect();
    edges.sort_unstable();
    let same = edges.chunk_by(|a, b| a == b);
    let odd = same.filter(|same| same.len() % 2 == 1);
    odd.map(|same| same[0]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use delone_io::Constraints;

    #[test]
    fn the_border_has_the_edges_of_single_triangles() {
        let triangles = [[0, 1, 2], [2, 1, 3]].map(|t| t.map(VertexId::new));
        let expected = [[0, 1], [0, 2], [1, 3], [2, 3]].map(|e| e.map(VertexId::new));
        assert_eq!(border(&triangles), expected);
        assert!(border(&[]).is_empty());
    }

    #[test]
    fn segments_of_a_mesh_come_before_its_border() {
        let triangles = vec![[0, 1, 2].map(VertexId::new)];
        let graph = Constraints {
            edges: vec![[1, 0].map(VertexId::new)],
            markers: Some(vec![9]),
            ..Constraints::default()
        };
        let mesh = MeshData {
            triangles,
            constraints: Some(graph),
            ..MeshData::default()
        };
        let domain = domain(mesh);
        assert_eq!(domain.segments.len(), 4);
        assert_eq!(domain.segment_markers, Some(vec![9, 0, 0, 0]));
        assert_eq!(domain.polygons, vec![1..4; 1]);
    }
}
