//! Which files the targets of a mesh mean.

use crate::points::unsupported;
use crate::{Error, Format, MeshView, Target, WriteOptions, poly};
use std::path::{Path, PathBuf};

/// One file to be written, and what goes into it.
#[derive(Debug, PartialEq, Eq)]
pub(super) struct OutFile {
    /// `None` is standard output.
    pub path: Option<PathBuf>,
    pub content: Content,
}

/// What goes into one file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Content {
    Node,
    Ele,
    Edge,
    Neigh,
    /// Constrained edges, holes and regions over the points of a `.node` file.
    Poly,
    /// The same with the points.
    WholePoly,
    NpyTriangles,
    NpyPoints,
    NpySegments,
    #[cfg(feature = "parquet")]
    ParquetTriangles,
    #[cfg(feature = "parquet")]
    ParquetPoints,
    #[cfg(feature = "parquet")]
    ParquetSegments,
    GeoJson,
    Vtu,
    /// A format whose file holds all of it.
    Single(Format),
    Svg,
    Png,
    /// Triangle's `.v.node` and `.v.edge`.
    VoronoiVertices,
    VoronoiEdges,
}

impl Content {
    /// Counts the rows that will be reported as written.
    pub fn rows(self, mesh: &MeshView<'_>, edges: usize) -> u64 {
        let (n, m) = (mesh.points.len(), mesh.triangles.len());
        let k = mesh.constraints.map_or(0, |c| c.edges.len());
        let rows = match self {
            Self::Node | Self::NpyPoints => n,
            Self::Ele | Self::Neigh | Self::NpyTriangles | Self::VoronoiVertices => m,
            Self::Edge | Self::VoronoiEdges => edges,
            Self::Poly | Self::NpySegments => k,
            Self::WholePoly => n + k,
            Self::GeoJson => m + k,
            #[cfg(feature = "parquet")]
            Self::ParquetTriangles => m,
            #[cfg(feature = "parquet")]
            Self::ParquetPoints => n,
            #[cfg(feature = "parquet")]
            Self::ParquetSegments => k,
            Self::Single(_) => n + m + k,
            Self::Vtu => {
                n * (1 + mesh.attributes.len()) + (m + k) * (5 + mesh.triangle_attributes.len())
            }
            Self::Svg | Self::Png => 0,
        };
        rows as u64
    }

    /// Tells whether neighbours and boundary must be known, for markers or more.
    pub fn needs_topology(self, mesh: &MeshView<'_>) -> bool {
        match self {
            Self::Node | Self::Edge | Self::Neigh | Self::Poly | Self::WholePoly => true,
            Self::VoronoiEdges => true,
            Self::Vtu | Self::Single(_) => mesh.is_quadratic || mesh.constraints.is_some(),
            #[cfg(feature = "parquet")]
            Self::ParquetSegments => true,
            #[cfg(feature = "parquet")]
            Self::ParquetTriangles | Self::ParquetPoints => false,
            Self::Ele => mesh.is_quadratic,
            Self::NpySegments | Self::GeoJson => mesh.constraints.is_some(),
            Self::NpyTriangles | Self::NpyPoints | Self::Svg | Self::Png => false,
            Self::VoronoiVertices => false,
        }
    }
}

/// Triangle's family of files: extensions and contents; the last one only if something is
/// constrained, or was.
const FAMILY: [(&str, Content); 5] = [
    ("node", Content::Node),
    ("ele", Content::Ele),
    ("edge", Content::Edge),
    ("neigh", Content::Neigh),
    ("poly", Content::Poly),
];

/// Lists the files that the targets mean, each once.
pub(super) fn of_mesh(
    targets: &[Target],
    mesh: &MeshView<'_>,
    options: &WriteOptions,
) -> Result<Vec<OutFile>, Error> {
    let mut files = Vec::new();
    for target in targets {
        let format = target.format()?;
        if mesh.is_quadratic && !format.writes_quadratic_mesh() {
            let action = "hold triangles of six nodes";
            return Err(unsupported(target, format, action, |f| {
                f.writes_quadratic_mesh() && !f.is_picture()
            }));
        }
        for file in of_target(target, mesh.constraints.is_some(), options.one_by_one)? {
            if !files.contains(&file) {
                files.push(file);
            }
        }
    }
    if let Some(stem) = &options.voronoi {
        files.extend(of_voronoi(stem));
    }
    Ok(files)
}

/// Names the two files of a Voronoi diagram.
fn of_voronoi(stem: &Path) -> [OutFile; 2] {
    [
        (".v.node", Content::VoronoiVertices),
        (".v.edge", Content::VoronoiEdges),
    ]
    .map(|(extension, content)| {
        let mut name = stem.as_os_str().to_owned();
        name.push(extension);
        let path = Some(name.into());
        OutFile { path, content }
    })
}

/// Lists the files that one target means.
fn of_target(
    target: &Target,
    is_constrained: bool,
    one_by_one: bool,
) -> Result<Vec<OutFile>, Error> {
    let format = target.format()?;
    let contents = match (&target.path, format) {
        (Some(_), Format::Poly) if one_by_one => vec![("", Content::Poly)],
        (Some(path), Format::Node | Format::Ele | Format::Edge | Format::Neigh | Format::Poly)
            if !one_by_one =>
        {
            // What was constrained in a mesh of this name must not seem to be so in the new one.
            let has_graph = is_constrained || poly::is_graph(&path.with_extension("poly"));
            FAMILY[..if has_graph { 5 } else { 4 }].to_vec()
        }
        (Some(path), Format::Npy) => {
            let mut family = vec![
                ("", Content::NpyTriangles),
                ("points.npy", Content::NpyPoints),
            ];
            // As for the `.poly` above.
            let has_segments = is_constrained || path.with_extension("segments.npy").is_file();
            family.extend(has_segments.then_some(("segments.npy", Content::NpySegments)));
            family
        }
        #[cfg(feature = "parquet")]
        (Some(path), Format::Parquet) => {
            let mut family = vec![
                ("", Content::ParquetTriangles),
                ("points.parquet", Content::ParquetPoints),
            ];
            let has_segments = is_constrained || path.with_extension("segments.parquet").is_file();
            family.extend(has_segments.then_some(("segments.parquet", Content::ParquetSegments)));
            family
        }
        (_, format) => match alone(format, is_constrained) {
            Some(content) => vec![("", content)],
            None => {
                return Err(unsupported(
                    target,
                    format,
                    "hold a mesh",
                    Format::writes_mesh,
                ));
            }
        },
    };
    let file = |(extension, content): (&str, Content)| OutFile {
        path: target.path.as_ref().map(|path| match extension {
            "" => path.clone(),
            _ => path.with_extension(extension),
        }),
        content,
    };
    Ok(contents.into_iter().map(file).collect())
}

/// Returns what a format holds in a file that has no others beside it.
fn alone(format: Format, is_constrained: bool) -> Option<Content> {
    match format {
        Format::Node => Some(Content::Node),
        Format::Ele => Some(Content::Ele),
        Format::Edge => Some(Content::Edge),
        Format::Neigh => Some(Content::Neigh),
        Format::Poly => is_constrained.then_some(Content::WholePoly),
        Format::Npy => Some(Content::NpyTriangles),
        Format::GeoJson => Some(Content::GeoJson),
        Format::Vtu => Some(Content::Vtu),
        Format::Svg => Some(Content::Svg),
        Format::Png => Some(Content::Png),
        #[cfg(feature = "parquet")]
        Format::Parquet => Some(Content::ParquetTriangles),
        format if format.writes_mesh() => Some(Content::Single(format)),
        _ => None,
    }
}
