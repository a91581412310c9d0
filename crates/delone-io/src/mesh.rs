//! Triangle meshes as files hold them, and how they are read and written.

use crate::points::{read_sibling, resolve, unsupported};
use crate::target::Staging;
use crate::topology::{self, Topology};
use crate::{Attribute, Error, Format, PointSet, ReadOptions, Source, Target};
use crate::{edge, ele, neigh, node, npy, png, svg, table, vtu};
use delone::{Point, Triangulation, VertexId, Watch};
use std::borrow::Cow;
use std::path::PathBuf;

/// A mesh read from files: not trusted to be a triangulation, but every corner is a vertex.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct MeshData {
    /// The vertices.
    pub vertices: PointSet,
    /// The corners of each triangle, as the file orders them.
    pub triangles: Vec<[VertexId; 3]>,
    /// Numbers that go with the triangles.
    pub triangle_attributes: Vec<Attribute>,
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
    /// Knows neighbours and edges without search, if there is one.
    triangulation: Option<&'a Triangulation>,
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
            triangulation: None,
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

    /// Finds neighbours, edges and boundary.
    fn topology(&self, watch: &dyn Watch) -> Result<Topology, Error> {
        match self.triangulation {
            Some(triangulation) => Topology::of_triangulation(triangulation, watch),
            None => Topology::of_triangles(self.triangles, watch),
        }
    }

    /// Marks each vertex: 1 on the boundary, 0 elsewhere. Duplicates are marked as the vertices that
    /// stand for them, if a triangulation tells which.
    fn boundary_markers(&self, topology: &Topology) -> Vec<i32> {
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
    fn validate(&self) -> Result<(), Error> {
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
        check("markers", self.markers.map_or(n, <[i32]>::len), n)
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
            ..Self::new(&mesh.vertices.points, &mesh.triangles).with_data(&mesh.vertices)
        }
    }
}

/// How to write.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct WriteOptions {
    /// Numbers points and triangles from 1 instead of 0, in the formats of Triangle.
    pub one_based: bool,
    /// How pictures look.
    pub picture: PictureOptions,
}

/// How pictures look.
#[derive(Clone, Debug, PartialEq)]
pub struct PictureOptions {
    /// Length of the longer side in pixels, from 16 to 8192; a PNG takes 20 bytes of memory a pixel.
    pub size: u32,
    /// Draws the scale of colours.
    pub legend: bool,
}

impl Default for PictureOptions {
    fn default() -> Self {
        Self {
            size: 1600,
            legend: true,
        }
    }
}

/// Reads a mesh: `.node` with `.ele` (either may be named), `.npy` with `.points.npy`, VTU.
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
    let file = source.to_string();
    let format = resolve(source, &bytes, options, Format::reads_mesh)?;
    let beside = |extension| read_sibling(source, format, extension, options, watch);
    match format {
        Format::Node => {
            let vertices = node::read_points(&file, &bytes, watch)?;
            let Source::Path(path) = source else {
                return Err(unsupported(
                    source,
                    format,
                    "hold triangles",
                    Format::reads_mesh,
                ));
            };
            let triangles = Source::Path(path.with_extension("ele"));
            let bytes = triangles.load(watch)?;
            ele::read_mesh(&triangles.to_string(), &bytes, vertices, watch)
        }
        Format::Ele => ele::read_mesh(&file, &bytes, beside("node")?, watch),
        Format::Npy => npy::read_mesh(&file, &bytes, beside("points.npy")?, watch),
        Format::Vtu => vtu::read_mesh(&file, &bytes, watch),
        format => Err(unsupported(
            source,
            format,
            "be read as a mesh",
            Format::reads_mesh,
        )),
    }
}

/// Writes a mesh to every target and returns the names of the files written.
///
/// - `.node`, `.ele`, `.edge`, `.neigh` and `.poly` each write the family `stem.node`, `stem.ele`,
///   `stem.edge` and `stem.neigh`.
/// - `.npy` writes the triangles as `int32` (m, 3), and the points beside it as `stem.points.npy`,
///   `float64` (n, 2 + attributes), and the caller's markers, if any, as a last column.
/// - Standard output takes just the one file that the format names; for `.npy` the triangles.
///
/// All files are complete under temporary names before the first is renamed; on an error before, or
/// cancellation, none is left. If a later one of several cannot be renamed, those before it stay, and
/// the error names them.
///
/// # Errors
/// If the view is no mesh, a format cannot be written, writing fails, or the watch cancels.
pub fn write_mesh(
    targets: &[Target],
    mesh: &MeshView<'_>,
    options: &WriteOptions,
    watch: &dyn Watch,
) -> Result<Vec<PathBuf>, Error> {
    mesh.validate()?;
    let files = files_of_mesh(targets)?;
    let needs_topology =
        |f: &OutFile| matches!(f.content, Content::Node | Content::Edge | Content::Neigh);
    let topology = match files.iter().any(needs_topology) {
        true => Some(mesh.topology(watch)?),
        false => None,
    };
    let markers = match mesh.markers {
        Some(markers) => Cow::Borrowed(markers),
        None => Cow::Owned(
            topology
                .as_ref()
                .map_or_else(Vec::new, |t| mesh.boundary_markers(t)),
        ),
    };
    let base = usize::from(options.one_based);
    let edges = topology.as_ref().map_or(0, |t| t.edges.len());
    let rows = |f: &OutFile| f.content.rows(mesh, edges);
    let mut staging = Staging::new(files.iter().map(rows).sum(), watch);
    for OutFile { path, content } in &files {
        staging.write(path.as_deref(), |out| match (content, &topology) {
            (Content::Node, _) => node::write(out, mesh, Some(&markers), base),
            (Content::Ele, _) => ele::write(out, mesh, base),
            (Content::Edge, Some(topology)) => edge::write(out, topology, base),
            (Content::Neigh, Some(topology)) => neigh::write(out, topology, base),
            (Content::NpyTriangles, _) => npy::write_triangles(out, mesh),
            (Content::NpyPoints, _) => npy::write_points(out, mesh),
            (Content::Vtu, _) => vtu::write(out, mesh),
            (Content::Svg, _) => svg::write(out, mesh, &options.picture, watch),
            (Content::Png, _) => png::write(out, mesh, &options.picture, watch),
            (Content::Edge | Content::Neigh, None) => unreachable!("bug: topology was needed"),
        })?;
    }
    staging.commit()
}

/// Writes points to every target and returns the names of the files written.
///
/// `.node`, tables and VTU carry attributes and markers; so does `.npy`, a `float64` array
/// (n, 2 + attributes) with the markers, if any, as a last column. Pictures show bare points.
///
/// # Errors
/// As [`write_mesh`].
pub fn write_points(
    targets: &[Target],
    points: &PointSet,
    options: &WriteOptions,
    watch: &dyn Watch,
) -> Result<Vec<PathBuf>, Error> {
    let mesh = MeshView::new(&points.points, &[]).with_data(points);
    mesh.validate()?;
    let rows = points.points.len() as u64 * targets.len() as u64;
    let mut staging = Staging::new(rows, watch);
    let base = usize::from(options.one_based);
    for target in targets {
        let format = target.format()?;
        staging.write(target.path.as_deref(), |out| match format {
            Format::Node => node::write(out, &mesh, mesh.markers, base),
            Format::Npy => npy::write_points(out, &mesh),
            Format::Table => table::write_points(out, target.path.as_deref(), points),
            Format::Vtu => vtu::write(out, &mesh),
            Format::Svg => svg::write(out, &mesh, &options.picture, watch),
            Format::Png => png::write(out, &mesh, &options.picture, watch),
            _ => Err(unsupported(
                target,
                format,
                "hold bare points",
                Format::writes_points,
            )),
        })?;
    }
    staging.commit()
}

/// One file to be written, and what goes into it.
#[derive(Debug, PartialEq, Eq)]
struct OutFile {
    /// `None` is standard output.
    path: Option<PathBuf>,
    content: Content,
}

/// What goes into one file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Content {
    Node,
    Ele,
    Edge,
    Neigh,
    NpyTriangles,
    NpyPoints,
    Vtu,
    Svg,
    Png,
}

impl Content {
    /// Counts the rows that will be reported as written.
    fn rows(self, mesh: &MeshView<'_>, edges: usize) -> u64 {
        let (n, m) = (mesh.points.len(), mesh.triangles.len());
        let rows = match self {
            Self::Node | Self::NpyPoints => n,
            Self::Ele | Self::Neigh | Self::NpyTriangles => m,
            Self::Edge => edges,
            Self::Vtu => n * (1 + mesh.attributes.len()) + m * (5 + mesh.triangle_attributes.len()),
            Self::Svg | Self::Png => 0,
        };
        rows as u64
    }
}

/// Triangle's family of files: extensions and contents.
const FAMILY: [(&str, Content); 4] = [
    ("node", Content::Node),
    ("ele", Content::Ele),
    ("edge", Content::Edge),
    ("neigh", Content::Neigh),
];

/// Lists the files that the targets mean, each once.
fn files_of_mesh(targets: &[Target]) -> Result<Vec<OutFile>, Error> {
    let mut files = Vec::new();
    for target in targets {
        let add = |files: &mut Vec<OutFile>, path: Option<PathBuf>, content| {
            let file = OutFile { path, content };
            if !files.contains(&file) {
                files.push(file);
            }
        };
        let format = target.format()?;
        let path = target.path.clone();
        match (format, path) {
            (
                Format::Node | Format::Ele | Format::Edge | Format::Neigh | Format::Poly,
                Some(path),
            ) => {
                for (extension, content) in FAMILY {
                    add(&mut files, Some(path.with_extension(extension)), content);
                }
            }
            (Format::Npy, Some(path)) => {
                let points = path.with_extension("points.npy");
                add(&mut files, Some(path), Content::NpyTriangles);
                add(&mut files, Some(points), Content::NpyPoints);
            }
            (Format::Node, None) => add(&mut files, None, Content::Node),
            (Format::Ele, None) => add(&mut files, None, Content::Ele),
            (Format::Edge, None) => add(&mut files, None, Content::Edge),
            (Format::Neigh, None) => add(&mut files, None, Content::Neigh),
            (Format::Npy, None) => add(&mut files, None, Content::NpyTriangles),
            (Format::Vtu, path) => add(&mut files, path, Content::Vtu),
            (Format::Svg, path) => add(&mut files, path, Content::Svg),
            (Format::Png, path) => add(&mut files, path, Content::Png),
            (format, _) => {
                return Err(unsupported(
                    target,
                    format,
                    "hold a mesh",
                    Format::writes_mesh,
                ));
            }
        }
    }
    Ok(files)
}
