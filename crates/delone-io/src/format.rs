//! The formats, and how a file tells which one it is.

use crate::{geojson, node, npy, table, vtu, wkt};
use std::fmt;
use std::path::Path;
use std::str::FromStr;

/// Bytes of the content that are looked at.
const SNIFFED: usize = 4096;

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
    /// GeoJSON: points, lines and polygons of geography.
    GeoJson,
    /// Well-known text: points, lines and polygons of databases, also with SRID.
    Wkt,
    /// VTK's unstructured grid in XML, for ParaView and its kin.
    Vtu,
    /// Picture of lines and areas.
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
    pub const ALL: [Self; 14] = [
        Self::Node,
        Self::Ele,
        Self::Edge,
        Self::Neigh,
        Self::Poly,
        Self::Npy,
        Self::Table,
        Self::GeoJson,
        Self::Wkt,
        Self::Vtu,
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
            Self::GeoJson => &["geojson", "json"],
            Self::Wkt => &["wkt", "ewkt"],
            Self::Vtu => &["vtu"],
            Self::Svg => &["svg"],
            Self::Png => &["png"],
            Self::Gif => &["gif"],
            Self::Html => &["html", "htm"],
        }
    }

    /// Tells the format from the extension of a file name; case does not matter.
    pub fn from_path(path: &Path) -> Option<Self> {
        path.extension()?.to_str()?.parse().ok()
    }

    /// Tells the format from the first bytes of the content, as far as they betray it.
    ///
    /// Text that begins like a `.node` file (`n 2 attributes markers`, followed by rows numbered from
    /// 0 or 1) is one; other text that holds numbers is a [`Table`](Self::Table).
    pub fn sniff(head: &[u8]) -> Option<Self> {
        if npy::sniff(head) {
            return Some(Self::Npy);
        }
        let head = &head[..head.len().min(SNIFFED)];
        if vtu::sniff(head) {
            return Some(Self::Vtu);
        }
        if geojson::sniff(head) {
            return Some(Self::GeoJson);
        }
        if wkt::sniff(head) {
            return Some(Self::Wkt);
        }
        if node::sniff(head) {
            return Some(Self::Node);
        }
        table::sniff(head).then_some(Self::Table)
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
        !matches!(
            self,
            Self::Edge | Self::Neigh | Self::Svg | Self::Png | Self::Gif | Self::Html
        )
    }

    /// Tells whether the format can hold segments, for [`read_domain`](crate::read_domain); all other
    /// formats of points are read as domains without.
    pub const fn reads_segments(self) -> bool {
        matches!(self, Self::Poly | Self::GeoJson | Self::Wkt)
    }

    /// Tells whether [`read_mesh`](crate::read_mesh) understands the format.
    pub const fn reads_mesh(self) -> bool {
        matches!(self, Self::Node | Self::Ele | Self::Npy | Self::Vtu)
    }

    /// Tells whether [`write_mesh`](crate::write_mesh) can write the format.
    pub const fn writes_mesh(self) -> bool {
        !matches!(self, Self::Table | Self::Wkt | Self::Gif | Self::Html)
    }

    /// Tells whether [`write_mesh`](crate::write_mesh) can write triangles of six nodes in the format,
    /// or shows them as triangles: pictures and files of edges do.
    pub const fn writes_quadratic_mesh(self) -> bool {
        self.writes_mesh() && !matches!(self, Self::Npy | Self::GeoJson)
    }

    /// Tells whether [`write_points`](crate::write_points) can write the format.
    pub const fn writes_points(self) -> bool {
        !matches!(
            self,
            Self::Ele
                | Self::Edge
                | Self::Neigh
                | Self::Poly
                | Self::GeoJson
                | Self::Wkt
                | Self::Gif
                | Self::Html
        )
    }

    /// Tells whether [`write_domain`](crate::write_domain) can write segments in the format.
    pub const fn writes_segments(self) -> bool {
        matches!(self, Self::Poly | Self::GeoJson | Self::Svg | Self::Png)
    }

    /// Tells whether [`write_cells`](crate::write_cells) can write the format.
    pub const fn writes_cells(self) -> bool {
        matches!(self, Self::GeoJson | Self::Vtu | Self::Svg | Self::Png)
    }

    /// Tells whether [`write_links`](crate::write_links) can write the format.
    pub const fn writes_links(self) -> bool {
        matches!(
            self,
            Self::Table | Self::Npy | Self::GeoJson | Self::Svg | Self::Png
        )
    }

    /// Tells whether [`write_relief`](crate::write_relief) can write a raster in the format; of tables, only
    /// `.asc` is one.
    pub const fn writes_raster(self) -> bool {
        matches!(self, Self::Table | Self::Npy | Self::Svg | Self::Png)
    }

    /// Tells whether [`write_relief`](crate::write_relief) can write contour lines in the format.
    pub const fn writes_contours(self) -> bool {
        matches!(self, Self::GeoJson | Self::Svg | Self::Png)
    }

    /// Tells whether [`write_report`](crate::write_report) can write the format.
    pub const fn writes_report(self) -> bool {
        matches!(self, Self::Svg | Self::Png | Self::Html)
    }

    /// Tells whether [`write_animation`](crate::write_animation) can write the format.
    pub const fn writes_animation(self) -> bool {
        matches!(self, Self::Svg | Self::Gif | Self::Png)
    }

    /// Tells whether the format is a picture that does not move.
    pub const fn is_picture(self) -> bool {
        matches!(self, Self::Svg | Self::Png)
    }
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
