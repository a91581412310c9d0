//! The formats, and how a file tells which one it is.

mod abilities;
mod keeps;

use crate::{
    airfoil, dxf, geojson, jigsaw, las, medit, msh, node, npy, obj, off, parquet, ply, poly, shp,
    svg, table, vtk, vtu, wkt,
};
use abilities::*;
pub use keeps::{Keeps, Precision, Trait};
use std::fmt;
use std::path::Path;
use std::str::FromStr;

/// Bytes of the content that are looked at.
const SNIFFED: usize = 4096;

/// Tells whether bytes begin like a format.
type Sniff = fn(&[u8]) -> bool;

/// Those that know their format by its beginning, the surest first.
const SNIFFERS: [(Format, Sniff); 17] = [
    (Format::Npy, npy::sniff),
    (Format::Las, las::sniff),
    (Format::Shp, shp::sniff),
    (Format::Parquet, parquet::sniff),
    (Format::Ply, ply::sniff),
    (Format::Msh, msh::sniff),
    (Format::Vtk, vtk::sniff),
    (Format::Vtu, vtu::sniff),
    (Format::Svg, svg::sniff),
    (Format::Dxf, dxf::sniff),
    (Format::Jigsaw, jigsaw::sniff),
    (Format::Off, off::sniff),
    (Format::GeoJson, geojson::sniff),
    (Format::Wkt, wkt::sniff),
    (Format::Medit, medit::sniff),
    (Format::Obj, obj::sniff),
    (Format::Node, node::sniff),
];

/// A file format.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Format {
    /// Triangle's `.node`: points with attributes and markers.
    Node,
    /// Triangle's `.ele`: triangles; goes with a `.node` of the same stem.
    Ele,
    /// Triangle's `.edge`: edges; goes with a `.node` of the same stem.
    Edge,
    /// Triangle's `.neigh`: neighbours of triangles; goes with an `.ele` of the same stem.
    Neigh,
    /// Triangle's `.poly`: points, segments, holes, regions.
    Poly,
    /// NumPy's `.npy`: one array.
    Npy,
    /// Text table: CSV, TSV, XYZ, columns set apart by commas, semicolons, tabs or blanks.
    Table,
    /// Apache Parquet: tables of columns, also GeoParquet.
    Parquet,
    /// GeoJSON: points, lines and polygons of geography; also bare arrays of coordinates.
    GeoJson,
    /// Well-known text: points, lines and polygons of databases, also with SRID.
    Wkt,
    /// Shapefile: points, lines or polygons, with their table in a `.dbf` beside it.
    Shp,
    /// LAS and LAZ: point clouds of laser scanners.
    Las,
    /// VTK's unstructured grid in XML, for ParaView and its kin.
    Vtu,
    /// VTK's legacy format.
    Vtk,
    /// Gmsh's mesh, version 4.1; read are 2.2, too.
    Msh,
    /// Gmsh's mesh, version 2.2.
    Msh2,
    /// JIGSAW's `.msh`: points, edges and triangles.
    Jigsaw,
    /// Outline of an airfoil as in UIUC's collection, `.dat`.
    Airfoil,
    /// Medit's `.mesh`, for FreeFem and Mmg.
    Medit,
    /// Wavefront's `.obj`: points, lines and faces.
    Obj,
    /// Geomview's `.off`: points and faces.
    Off,
    /// Stanford's `.ply`: points, edges and faces.
    Ply,
    /// Stereolithography: triangles for printers.
    Stl,
    /// AutoCAD's exchange format: drawings.
    Dxf,
    /// Picture for LaTeX.
    Tikz,
    /// Picture of lines and areas, whose paths can be read.
    Svg,
    /// Picture of pixels.
    Png,
    /// Moving picture of pixels.
    Gif,
    /// Page for the browser: a report.
    Html,
}

impl Format {
    /// Every format.
    pub const ALL: [Self; 29] = [
        Self::Node,
        Self::Ele,
        Self::Edge,
        Self::Neigh,
        Self::Poly,
        Self::Npy,
        Self::Table,
        Self::Parquet,
        Self::GeoJson,
        Self::Wkt,
        Self::Shp,
        Self::Las,
        Self::Vtu,
        Self::Vtk,
        Self::Msh,
        Self::Msh2,
        Self::Jigsaw,
        Self::Airfoil,
        Self::Medit,
        Self::Obj,
        Self::Off,
        Self::Ply,
        Self::Stl,
        Self::Dxf,
        Self::Tikz,
        Self::Svg,
        Self::Png,
        Self::Gif,
        Self::Html,
    ];

    /// Returns the name by which the format is asked for: `node`, `csv` …
    pub const fn name(self) -> &'static str {
        self.extensions()[0]
    }

    /// Returns the file name extensions that mean this format, without dot, lower case.
    pub const fn extensions(self) -> &'static [&'static str] {
        match self {
            Self::Node => &["node"],
            Self::Ele => &["ele"],
            Self::Edge => &["edge"],
            Self::Neigh => &["neigh"],
            Self::Poly => &["poly"],
            Self::Npy => &["npy"],
            Self::Table => &["csv", "tsv", "txt", "xyz", "xy", "tab", "dat", "asc", "pts"],
            Self::Parquet => &["parquet", "geoparquet", "pq"],
            Self::GeoJson => &["geojson", "json"],
            Self::Wkt => &["wkt", "ewkt"],
            Self::Shp => &["shp"],
            Self::Las => &["las", "laz"],
            Self::Vtu => &["vtu"],
            Self::Vtk => &["vtk"],
            Self::Msh => &["msh", "msh4"],
            Self::Msh2 => &["msh2", "msh22"],
            Self::Jigsaw => &["jigsaw", "jig"],
            Self::Airfoil => &["airfoil"],
            Self::Medit => &["mesh"],
            Self::Obj => &["obj"],
            Self::Off => &["off"],
            Self::Ply => &["ply"],
            Self::Stl => &["stl"],
            Self::Dxf => &["dxf"],
            Self::Tikz => &["tikz", "tex"],
            Self::Svg => &["svg"],
            Self::Png => &["png"],
            Self::Gif => &["gif"],
            Self::Html => &["html", "htm"],
        }
    }

    /// Says in a few words what the format is.
    pub const fn about(self) -> &'static str {
        match self {
            Self::Node => "Triangle: points",
            Self::Ele => "Triangle: mesh, with its .node",
            Self::Edge => "Triangle: edges of a mesh, with its .node",
            Self::Neigh => "Triangle: neighbours of triangles, with its .ele",
            Self::Poly => "Triangle: points, segments, holes and regions",
            Self::Npy => "NumPy: arrays",
            Self::Table => "table: columns of text",
            Self::Parquet => "Parquet: tables of columns, also GeoParquet",
            Self::GeoJson => "GeoJSON: points, lines and polygons",
            Self::Wkt => "well-known text: points, lines and polygons",
            Self::Shp => "Shapefile: points, lines or polygons",
            Self::Las => "point cloud of a laser scanner",
            Self::Vtu => "VTK: mesh for ParaView",
            Self::Vtk => "VTK, legacy: mesh",
            Self::Msh => "Gmsh 4.1: mesh with physical groups",
            Self::Msh2 => "Gmsh 2.2: mesh with physical groups",
            Self::Jigsaw => "JIGSAW: points, edges and triangles",
            Self::Airfoil => "outline of an airfoil",
            Self::Medit => "Medit: mesh for FreeFem and Mmg",
            Self::Obj => "Wavefront: points, lines and faces",
            Self::Off => "Geomview: points and faces",
            Self::Ply => "Stanford: points, edges and faces",
            Self::Stl => "stereolithography: triangles for printers",
            Self::Dxf => "drawing of AutoCAD and its kin",
            Self::Tikz => "picture for LaTeX",
            Self::Svg => "picture of lines and areas",
            Self::Png => "picture of pixels",
            Self::Gif => "moving picture",
            Self::Html => "report as a page",
        }
    }

    /// Returns the feature of this crate without which the format is known by name only, if it has one.
    pub const fn feature(self) -> Option<&'static str> {
        match self {
            Self::Parquet => Some("parquet"),
            Self::Las => Some("las"),
            _ => None,
        }
    }

    /// Tells whether this build knows more of the format than its name.
    pub const fn is_built(self) -> bool {
        match self {
            Self::Parquet => cfg!(feature = "parquet"),
            Self::Las => cfg!(feature = "las"),
            _ => true,
        }
    }

    /// Tells whether something can be done with the format, here.
    const fn can(self, what: u32) -> bool {
        self.is_built() && abilities::of(self) & what != 0
    }

    /// Tells the format from the extension of a file name; case does not matter.
    pub fn from_path(path: &Path) -> Option<Self> {
        path.extension()?.to_str()?.parse().ok()
    }

    /// Tells the format from name and content: the name decides, and the content between formats that share an
    /// extension (`.msh`: Gmsh and JIGSAW; `.dat`: tables and airfoils) or where the name says nothing.
    pub fn detect(path: Option<&Path>, content: &[u8]) -> Option<Self> {
        let head = &content[..content.len().min(SNIFFED)];
        match path.and_then(Self::from_path) {
            Some(Self::Msh) if jigsaw::sniff(head) => Some(Self::Jigsaw),
            Some(Self::Table) if has_extension(path, "dat") && airfoil::sniff(head) => {
                Some(Self::Airfoil)
            }
            Some(format) => Some(format),
            None => Self::sniff(content),
        }
    }

    /// Tells the format from the content, or its first bytes, as far as they betray it.
    ///
    /// Text that begins like a `.node` file (`n 2 attributes markers`, followed by rows numbered from
    /// 0 or 1) is one, or a `.poly` if all of it is here and segments follow the points; other text that holds
    /// numbers is a [`Table`](Self::Table).
    pub fn sniff(content: &[u8]) -> Option<Self> {
        let head = &content[..content.len().min(SNIFFED)];
        let begins = SNIFFERS.iter().find(|(_, sniff)| sniff(head));
        match begins.map(|&(format, _)| format) {
            Some(Self::Node) if poly::goes_on(content) => Some(Self::Poly),
            None if table::sniff(head) => Some(Self::Table),
            found => found,
        }
    }

    /// Lists the names of the formats that can do something, for messages.
    pub(crate) fn names(can: fn(Self) -> bool) -> String {
        let names: Vec<_> = Self::ALL
            .into_iter()
            .filter(|&f| can(f))
            .map(Self::name)
            .collect();
        names.join(", ")
    }

    /// Tells whether [`read_points`](crate::read_points) understands the format.
    pub const fn reads_points(self) -> bool {
        self.can(POINTS_IN)
    }

    /// Tells whether the format can hold segments, for [`read_domain`](crate::read_domain); all other
    /// formats of points are read as domains without.
    pub const fn reads_segments(self) -> bool {
        self.can(SEGMENTS_IN)
    }

    /// Tells whether [`read_mesh`](crate::read_mesh) understands the format.
    pub const fn reads_mesh(self) -> bool {
        self.can(MESH_IN)
    }

    /// Tells whether [`write_mesh`](crate::write_mesh) can write the format.
    pub const fn writes_mesh(self) -> bool {
        self.can(MESH_OUT)
    }

    /// Tells whether [`write_mesh`](crate::write_mesh) can write triangles of six nodes in the format,
    /// or shows them as triangles: pictures and files of edges do.
    pub const fn writes_quadratic_mesh(self) -> bool {
        self.can(QUADRATIC_OUT)
    }

    /// Tells whether [`write_points`](crate::write_points) can write the format.
    pub const fn writes_points(self) -> bool {
        self.can(POINTS_OUT)
    }

    /// Tells whether [`write_domain`](crate::write_domain) can write segments in the format.
    pub const fn writes_segments(self) -> bool {
        self.can(SEGMENTS_OUT)
    }

    /// Tells whether [`write_cells`](crate::write_cells) can write the format.
    pub const fn writes_cells(self) -> bool {
        self.can(CELLS_OUT)
    }

    /// Tells whether [`write_links`](crate::write_links) can write the format.
    pub const fn writes_links(self) -> bool {
        self.can(LINKS_OUT)
    }

    /// Tells whether [`write_relief`](crate::write_relief) can write a raster in the format; of tables, only
    /// `.asc` is one.
    pub const fn writes_raster(self) -> bool {
        self.can(RASTER_OUT)
    }

    /// Tells whether [`write_relief`](crate::write_relief) can write contour lines in the format.
    pub const fn writes_contours(self) -> bool {
        self.can(CONTOURS_OUT)
    }

    /// Tells whether [`write_report`](crate::write_report) can write the format.
    pub const fn writes_report(self) -> bool {
        self.can(REPORT_OUT)
    }

    /// Tells whether [`write_animation`](crate::write_animation) can write the format.
    pub const fn writes_animation(self) -> bool {
        self.can(ANIMATION_OUT)
    }

    /// Tells whether the format is a picture that does not move.
    pub const fn is_picture(self) -> bool {
        matches!(self, Self::Svg | Self::Png)
    }
}

fn has_extension(path: Option<&Path>, wanted: &str) -> bool {
    let extension = path.and_then(Path::extension);
    extension.is_some_and(|e| e.eq_ignore_ascii_case(wanted))
}

impl fmt::Display for Format {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}

impl FromStr for Format {
    type Err = String;

    /// Takes any of the extensions, with or without a dot, in any case.
    fn from_str(text: &str) -> Result<Self, String> {
        let wanted = text.trim_start_matches('.').to_ascii_lowercase();
        let known = |f: &Self| f.extensions().contains(&wanted.as_str());
        Self::ALL.into_iter().find(known).ok_or_else(|| {
            let names = Self::ALL.map(Self::name).join(", ");
            format!("unknown format {text:?}; known are {names}")
        })
    }
}
