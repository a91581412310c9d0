//! Writing: meshes here, points and domains in [`plain`], which files the targets mean in [`files`].

mod cells;
mod files;
mod plain;
mod single;

pub use cells::write_cells;
pub use plain::{write_domain, write_points};

use crate::constraints::EdgeMarkers;
use crate::six_nodes::SixNodes;
use crate::target::{Output, Staging};
use crate::topology::Topology;
use crate::{Error, MeshView, Target};
use crate::{edge, ele, geojson, neigh, node, npy, png, poly, svg, voronoi, vtu};
use delone::Watch;
use files::{Content, OutFile};
use std::borrow::Cow;
use std::path::PathBuf;

/// How to write.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct WriteOptions {
    /// Numbers points and triangles from 1 instead of 0, in the formats of Triangle.
    pub one_based: bool,
    /// Of the formats of Triangle, writes the file that is named and not those that go with it; a
    /// `.poly` then has no points.
    pub one_by_one: bool,
    /// Writes also the Voronoi diagram of the triangles as Triangle does, to the files of this name with
    /// `.v.node` and `.v.edge` behind it.
    pub voronoi: Option<PathBuf>,
    /// Writes text in formats that can be text or bytes: `.ply`, `.stl`, `.vtk`.
    pub ascii: bool,
    /// Leaves markers out, in the formats of Triangle.
    pub without_markers: bool,
    /// How pictures look.
    pub picture: PictureOptions,
}

impl WriteOptions {
    /// Returns the markers, unless they are to be left out.
    fn marking<'m>(&self, markers: &'m [i32]) -> Option<&'m [i32]> {
        (!self.without_markers).then_some(markers)
    }
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

/// Writes a mesh to every target and returns the names of the files written.
///
/// - `.node`, `.ele`, `.edge`, `.neigh` and `.poly` each write the family `stem.node`, `stem.ele`,
///   `stem.edge` and `stem.neigh`, and if something is constrained also `stem.poly`, with the
///   constrained edges, holes and regions, and without points.
///   Such a file that is there already is replaced in any case, as the points that it is about are.
/// - `.npy` writes the triangles as `int32` (m, 3), and the points beside it as `stem.points.npy`,
///   `float64` (n, 2 + attributes), and the caller's markers, if any, as a last column; if something
///   is constrained, also `stem.segments.npy`, `int32` (k, 3), the ends of the edges and their markers.
/// - `.parquet` writes the same three tables with named columns, see the table of formats: corners `a`, `b`, `c` with
///   region and attributes, points with attributes and marker, and segments.
/// - `.geojson` and `.vtu` hold triangles with their regions and attributes, and constrained edges, as
///   lines, with their markers.
/// - Triangles of [six nodes](MeshView::quadratic) go into `.node`, `.ele` and `.vtu`.
/// - Standard output takes just the one file that the format names; for `.npy` the triangles, for
///   `.poly` the points too.
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
    stage_mesh(targets, mesh, options, 0, false, watch)?.commit()
}

/// Writes a mesh up to the point where files get their names; `more_rows` will follow.
pub(crate) fn stage_mesh<'w>(
    targets: &[Target],
    mesh: &MeshView<'_>,
    options: &WriteOptions,
    more_rows: u64,
    with_digests: bool,
    watch: &'w dyn Watch,
) -> Result<Staging<'w>, Error> {
    mesh.validate()?;
    let files = files::of_mesh(targets, mesh, options)?;
    let prepared = Prepared::new(mesh, &files, watch)?;
    let edges = prepared.topology.as_ref().map_or(0, |t| t.edges.len());
    let rows = |f: &OutFile| f.content.rows(mesh, edges);
    let rows: u64 = files.iter().map(rows).sum();
    let mut staging = Staging::new(rows + more_rows, watch);
    if with_digests {
        staging = staging.with_digests();
    }
    for OutFile { path, content } in &files {
        staging.write(path.as_deref(), |out| {
            prepared.write(out, *content, options, watch)
        })?;
    }
    Ok(staging)
}

/// A mesh with all that its files need to know beyond it.
struct Prepared<'a> {
    mesh: &'a MeshView<'a>,
    topology: Option<Topology>,
    /// Markers of the vertices.
    markers: Cow<'a, [i32]>,
    /// Markers of all edges, and of the constrained ones.
    edge_markers: EdgeMarkers,
    /// The nodes with midpoints, if triangles are to have six.
    six_nodes: Option<SixNodes>,
}

impl<'a> Prepared<'a> {
    fn new(mesh: &'a MeshView<'a>, files: &[OutFile], watch: &dyn Watch) -> Result<Self, Error> {
        let needs_topology = files.iter().any(|f| f.content.needs_topology(mesh));
        let topology = needs_topology.then(|| mesh.topology(watch)).transpose()?;
        let markers = match (mesh.markers, &topology) {
            (Some(markers), _) => Cow::Borrowed(markers),
            (None, Some(topology)) => Cow::Owned(mesh.boundary_markers(topology)),
            (None, None) => Cow::default(),
        };
        let edge_markers = match &topology {
            Some(topology) => EdgeMarkers::new(mesh, topology, watch)?,
            None => EdgeMarkers::default(),
        };
        let six_nodes = match &topology {
            Some(topology) if mesh.is_quadratic => {
                let made = SixNodes::new(mesh, topology, &markers, &edge_markers, watch);
                Some(made?)
            }
            _ => None,
        };
        Ok(Self {
            mesh,
            topology,
            markers,
            edge_markers,
            six_nodes,
        })
    }

    fn write(
        &self,
        out: &mut Output<'_>,
        content: Content,
        options: &WriteOptions,
        watch: &dyn Watch,
    ) -> Result<(), Error> {
        let Self {
            mesh, edge_markers, ..
        } = self;
        let base = usize::from(options.one_based);
        let topology = || self.topology.as_ref().expect("bug: topology was needed");
        let with_midpoints = self.six_nodes.as_ref().map(|nodes| nodes.view(mesh));
        let nodes = with_midpoints.as_ref().unwrap_or(mesh);
        match content {
            Content::Node => {
                let markers = self.six_nodes.as_ref().map(|nodes| &nodes.markers[..]);
                node::write(
                    out,
                    nodes,
                    options.marking(markers.unwrap_or(&self.markers)),
                    base,
                )
            }
            Content::Ele => ele::write(out, nodes, base),
            Content::Edge => edge::write(out, topology(), options.marking(&edge_markers.all), base),
            Content::Neigh => neigh::write(out, topology(), base),
            Content::Poly => {
                let markers = options.marking(&edge_markers.constrained);
                poly::write_header(out, mesh, markers.is_some())?;
                poly::write_graph(out, mesh, markers, base)
            }
            Content::WholePoly => {
                node::write(out, mesh, options.marking(&self.markers), base)?;
                poly::write_graph(out, mesh, options.marking(&edge_markers.constrained), base)
            }
            Content::VoronoiVertices => voronoi::write_vertices(out, mesh, base),
            Content::VoronoiEdges => voronoi::write_edges(out, mesh, topology(), base),
            Content::NpyTriangles => npy::write_triangles(out, mesh),
            Content::NpyPoints => npy::write_points(out, mesh),
            Content::NpySegments => npy::write_segments(out, mesh, &edge_markers.constrained),
            Content::GeoJson => geojson::write_mesh(out, mesh, &edge_markers.constrained),
            Content::Vtu => vtu::write(out, nodes, &edge_markers.constrained),
            #[cfg(feature = "parquet")]
            Content::ParquetTriangles => crate::parquet::write_triangles(out, mesh),
            #[cfg(feature = "parquet")]
            Content::ParquetPoints => crate::parquet::write_points(out, mesh),
            #[cfg(feature = "parquet")]
            Content::ParquetSegments => {
                crate::parquet::write_segments(out, mesh, &edge_markers.constrained)
            }
            Content::Single(format) => {
                single::write(out, format, nodes, &edge_markers.constrained, options)
            }
            Content::Svg => svg::write(out, mesh, &options.picture, watch),
            Content::Png => png::write(out, mesh, &options.picture, watch),
        }
    }
}
