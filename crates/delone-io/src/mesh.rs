//! Triangle meshes as files hold them, and how they are read.

use crate::points::{read_sibling, resolve, unsupported};
use crate::six_nodes::Middles;
use crate::topology::{self, Topology};
use crate::{
    Attribute, Constraints, Counts, Error, Format, Inherited, PointSet, ReadOptions, Source,
};
use crate::{ele, jigsaw, medit, msh, node, npy, obj, off, ply, poly, vtk, vtu};
use delone::{ConstrainedTriangulation, Point, Triangulation, VertexId, Watch};

/// A mesh read from files: not trusted to be a triangulation, but every corner is a vertex.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct MeshData {
    /// The vertices.
    pub vertices: PointSet,
    /// The corners of each triangle, as the file orders them.
    pub triangles: Vec<[VertexId; 3]>,
    /// Numbers that go with the triangles.
    pub triangle_attributes: Vec<Attribute>,
    /// What is constrained, if the files say so.
    pub constraints: Option<Constraints>,
    /// Whether the triangles had six nodes; the midpoints of edges are not among the vertices.
    pub quadratic: bool,
}

/// A mesh to be written: borrowed from a [`Triangulation`], a [`MeshData`] or arrays.
#[derive(Clone, Copy, Debug)]
pub struct MeshView<'a> {
    /// The vertices.
    pub points: &'a [Point],
    /// The corners of each triangle, counter-clockwise.
    pub triangles: &'a [[VertexId; 3]],
    /// Numbers that go with the vertices.
    pub attributes: &'a [Attribute],
    /// Boundary markers of the vertices; `None` means 1 on the boundary and 0 elsewhere.
    pub markers: Option<&'a [i32]>,
    /// Numbers that go with the triangles.
    pub triangle_attributes: &'a [Attribute],
    /// What is constrained, if the mesh is one of a domain.
    pub constraints: Option<&'a Constraints>,
    /// What triangles hold, if pictures are to show it.
    pub counts: Option<&'a Counts<'a>>,
    /// Knows neighbours and edges without search, if there is one.
    pub(crate) triangulation: Option<&'a Triangulation>,
    /// Whether triangles are to have six nodes, where that is possible.
    pub(crate) is_quadratic: bool,
    /// The midpoints among the nodes, once they have been made.
    pub(crate) middles: Option<&'a Middles>,
}

impl<'a> MeshView<'a> {
    /// Makes a view of points and triangles.
    pub fn new(points: &'a [Point], triangles: &'a [[VertexId; 3]]) -> Self {
        Self {
            points,
            triangles,
            attributes: &[],
            markers: None,
            triangle_attributes: &[],
            constraints: None,
            counts: None,
            triangulation: None,
            is_quadratic: false,
            middles: None,
        }
    }

    /// Makes a view of the triangulation of a domain, with what it has inherited.
    pub fn constrained(result: &'a ConstrainedTriangulation, inherited: &'a Inherited) -> Self {
        Self {
            attributes: &inherited.attributes,
            markers: inherited.markers.as_deref(),
            triangle_attributes: &inherited.triangle_attributes,
            constraints: Some(&inherited.constraints),
            ..Self::from(result.triangulation())
        }
    }

    /// Adds attributes and markers, as they were read with the points.
    ///
    /// Markers of the input mark nothing about the hull, but they are the caller's and are kept.
    pub fn with_data(self, data: &'a PointSet) -> Self {
        Self {
            attributes: &data.attributes,
            markers: data.markers.as_deref(),
            ..self
        }
    }

    /// Adds constrained edges, holes and regions.
    pub fn with_constraints(self, constraints: &'a Constraints) -> Self {
        Self {
            constraints: Some(constraints),
            ..self
        }
    }

    /// Has pictures show how many data the triangles hold, and the data.
    pub fn with_counts(self, counts: &'a Counts<'a>) -> Self {
        Self {
            counts: Some(counts),
            ..self
        }
    }

    /// Makes triangles of six nodes, with the midpoints of their edges, for quadratic elements: in
    /// `.node`, `.ele`, `.vtu`, `.vtk` and `.msh`. Pictures and files of edges stay the same; other formats refuse.
    pub fn quadratic(self) -> Self {
        Self {
            is_quadratic: true,
            ..self
        }
    }

    /// Finds neighbours, edges and boundary.
    pub(crate) fn topology(&self, watch: &dyn Watch) -> Result<Topology, Error> {
        match self.triangulation {
            Some(triangulation) => Topology::of_triangulation(triangulation, watch),
            None => Topology::of_triangles(self.triangles, watch),
        }
    }

    /// Marks each vertex: 1 on the boundary, 0 elsewhere. Duplicates are marked as the vertices that
    /// stand for them, if a triangulation tells which.
    pub(crate) fn boundary_markers(&self, topology: &Topology) -> Vec<i32> {
        let mut markers = topology.boundary_markers(self.points.len());
        for duplicate in self
            .triangulation
            .map_or(&[][..], Triangulation::duplicates)
        {
            markers[duplicate.dropped.index()] = markers[duplicate.kept.index()];
        }
        markers
    }

    /// Visits the edges of a triangulation whose points all lie on one line.
    pub(crate) fn collinear_edges(&self) -> impl Iterator<Item = [VertexId; 2]> {
        self.triangulation
            .into_iter()
            .flat_map(Triangulation::edges)
    }

    /// Checks that corners are vertices and that every table has the right length.
    pub(crate) fn validate(&self) -> Result<(), Error> {
        let (n, m) = (self.points.len(), self.triangles.len());
        topology::check_num_triangles(m)?;
        for (t, corners) in self.triangles.iter().enumerate() {
            if let Some(v) = corners.iter().find(|v| v.index() >= n) {
                return Err(Error::BadMesh(format!(
                    "triangle {t} names vertex {v} of {n} (numbered from 0)"
                )));
            }
        }
        let check = |what: &str, found: usize, expected: usize| match found == expected {
            true => Ok(()),
            false => Err(Error::BadMesh(format!(
                "{what} has {found} values for {expected}"
            ))),
        };
        for attribute in self.attributes {
            check(
                &format!("attribute {:?}", attribute.name),
                attribute.values.len(),
                n,
            )?;
        }
        for attribute in self.triangle_attributes {
            check(
                &format!("attribute {:?}", attribute.name),
                attribute.values.len(),
                m,
            )?;
        }
        check("markers", self.markers.map_or(n, <[i32]>::len), n)?;
        self.counts.map_or(Ok(()), |counts| counts.validate(m))?;
        self.constraints.map_or(Ok(()), |c| c.validate(n, m))
    }
}

impl<'a> From<&'a Triangulation> for MeshView<'a> {
    fn from(triangulation: &'a Triangulation) -> Self {
        Self {
            triangulation: Some(triangulation),
            ..Self::new(triangulation.points(), triangulation.triangles())
        }
    }
}

impl<'a> From<&'a MeshData> for MeshView<'a> {
    fn from(mesh: &'a MeshData) -> Self {
        Self {
            triangle_attributes: &mesh.triangle_attributes,
            constraints: mesh.constraints.as_ref(),
            is_quadratic: mesh.quadratic,
            ..Self::new(&mesh.vertices.points, &mesh.triangles).with_data(&mesh.vertices)
        }
    }
}

/// Reads a mesh: `.node` with `.ele` (either may be named), `.npy` with `.points.npy`, VTU, and other formats whose file
/// holds all of it; these may hold points or lines alone, and then there are no triangles.
///
/// A `.poly` file beside an `.ele` adds constrained edges, holes and regions, provided that it has no
/// points of its own: with points it is a domain, not part of a mesh.
///
/// # Errors
/// If a file cannot be read, is malformed (message with file and line), or the watch cancels.
///
/// *Cost*: time and memory proportional to the files.
pub fn read_mesh(
    source: &Source,
    options: &ReadOptions,
    watch: &dyn Watch,
) -> Result<MeshData, Error> {
    let bytes = source.load(watch)?;
    let format = resolve(source, &bytes, options, Format::reads_mesh)?;
    read_loaded(source, &bytes, format, options, watch)
}

/// Reads a mesh from the content of a source, whose format is known.
pub(crate) fn read_loaded(
    source: &Source,
    bytes: &[u8],
    format: Format,
    options: &ReadOptions,
    watch: &dyn Watch,
) -> Result<MeshData, Error> {
    let file = source.to_string();
    let beside = |extension| read_sibling(source, format, extension, options, watch);
    match format {
        Format::Node => {
            let vertices = node::read_points(&file, bytes, watch)?;
            let alone = || unsupported(source, format, "hold triangles", Format::reads_mesh);
            let triangles = source.beside("ele", alone)?;
            let bytes = triangles.load(watch)?;
            let mesh = ele::read_mesh(&triangles.to_string(), &bytes, vertices, watch)?;
            with_graph_beside(mesh, source, watch)
        }
        Format::Ele => {
            let mesh = ele::read_mesh(&file, bytes, beside("node")?, watch)?;
            with_graph_beside(mesh, source, watch)
        }
        Format::Npy => {
            let mesh = npy::read_mesh(&file, bytes, beside("points.npy")?, watch)?;
            with_segments_beside(mesh, source, watch)
        }
        #[cfg(feature = "parquet")]
        Format::Parquet => {
            let segments = source.beside_if_any("segments.parquet");
            crate::parquet::read_mesh(&file, bytes, beside("points.parquet")?, segments, watch)
        }
        Format::Vtu => vtu::read_mesh(&file, bytes, watch),
        Format::Vtk => vtk::read_mesh(&file, bytes, options, watch),
        Format::Msh | Format::Msh2 => msh::read_mesh(&file, bytes, options, watch),
        Format::Jigsaw => jigsaw::read_mesh(&file, bytes, options, watch),
        Format::Obj => obj::read_mesh(&file, bytes, options, watch),
        Format::Off => off::read_mesh(&file, bytes, options, watch),
        Format::Ply => ply::read_mesh(&file, bytes, options, watch),
        Format::Medit => medit::read_mesh(&file, bytes, watch),
        format => Err(unsupported(
            source,
            format,
            "be read as a mesh",
            Format::reads_mesh,
        )),
    }
}

/// Adds the constrained edges of a `.segments.npy` beside `source`, if there is one.
fn with_segments_beside(
    mesh: MeshData,
    source: &Source,
    watch: &dyn Watch,
) -> Result<MeshData, Error> {
    let Some(segments) = source.beside_if_any("segments.npy") else {
        return Ok(mesh);
    };
    let (file, bytes) = (segments.to_string(), segments.load(watch)?);
    let constraints = npy::read_segments(&file, &bytes, mesh.vertices.points.len(), watch)?;
    Ok(MeshData {
        constraints,
        ..mesh
    })
}

/// Adds what a `.poly` file beside `source` says, if it is one of the mesh.
fn with_graph_beside(
    mesh: MeshData,
    source: &Source,
    watch: &dyn Watch,
) -> Result<MeshData, Error> {
    let Some(graph) = source.beside_if_any("poly") else {
        return Ok(mesh);
    };
    let bytes = graph.load(watch)?;
    let constraints = poly::read_graph(&graph.to_string(), &bytes, &mesh.vertices, watch)?;
    Ok(MeshData {
        constraints,
        ..mesh
    })
}
