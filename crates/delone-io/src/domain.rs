//! Domains as files hold them, and how they are read.

#[cfg(feature = "las")]
use crate::las;
use crate::points::{self, read_sibling, resolve};
use crate::{
    Error, Format, MeshData, PointSet, ReadOptions, Source, airfoil, dxf, geojson, jigsaw, mesh,
    outline, poly, shp, svg, wkt,
};
use delone::{DomainRule, Point, Pslg, Region, VertexId, Watch};
use std::ops::Range;

/// A domain read from files: points and segments, and what lies between them. Not trusted to be
/// clean, but every segment joins two of the points, and every coordinate is finite.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct DomainData {
    /// The points, ends of segments and loose ones alike.
    pub vertices: PointSet,
    /// The segments, as indices of their ends.
    pub segments: Vec<[VertexId; 2]>,
    /// A marker for each segment, if the file has them.
    pub segment_markers: Option<Vec<i32>>,
    /// For each polygon the segments that bound it, outline and holes together.
    pub polygons: Vec<Range<usize>>,
    /// A point in each hole.
    pub holes: Vec<Point>,
    /// Regions, each named by a point in it.
    pub regions: Vec<Region>,
    /// Which triangles belong to the domain, unless the user knows better: the hull if there are no
    /// segments, or lines without polygons; `Carve` for the segments of a `.poly` file, as Triangle
    /// has it; `EvenOdd` for the polygons of GeoJSON and WKT.
    pub usual_rule: DomainRule,
}

impl DomainData {
    /// Makes a domain of points, the ends of segments as indices of points, and a point in each hole.
    ///
    /// # Errors
    /// If a segment names no point.
    pub fn from_rows(
        points: Vec<[f64; 2]>,
        segments: Vec<[u32; 2]>,
        holes: Vec<[f64; 2]>,
    ) -> Result<Self, Error> {
        let n = points.len();
        let is_bad = |ends: &[u32; 2]| ends.iter().any(|&v| v as usize >= n);
        if let Some(bad) = segments.iter().position(is_bad) {
            let [a, b] = segments[bad];
            let mesh = format!("segment {bad} joins {a} and {b} of {n} points (numbered from 0)");
            return Err(Error::BadMesh(mesh));
        }
        let vertex = |v: u32| VertexId::new(v as usize);
        let segments = segments.into_iter().map(|ends| ends.map(vertex));
        let pslg = Pslg {
            segments: segments.collect(),
            holes: holes.into_iter().map(Point::from).collect(),
            ..Pslg::from_points(points)
        };
        Ok(pslg.into())
    }

    /// Moves points, segments and polygons out, for triangulation; holes and regions are copied.
    ///
    /// What stays are the attributes and markers that the result is to [inherit](crate::Inherited).
    pub fn take_pslg(&mut self) -> Pslg {
        Pslg {
            points: std::mem::take(&mut self.vertices.points),
            segments: std::mem::take(&mut self.segments),
            polygons: std::mem::take(&mut self.polygons),
            holes: self.holes.clone(),
            regions: self.regions.clone(),
        }
    }
}

impl From<PointSet> for DomainData {
    /// Makes a domain without segments.
    fn from(vertices: PointSet) -> Self {
        Self {
            vertices,
            ..Self::default()
        }
    }
}

impl From<Pslg> for DomainData {
    /// Takes over a graph; its usual rule is that of its polygons, if there are any, otherwise that
    /// of a `.poly` file.
    fn from(pslg: Pslg) -> Self {
        let usual_rule = match (pslg.segments.is_empty(), pslg.polygons.is_empty()) {
            (true, _) => DomainRule::Hull,
            (false, true) => DomainRule::Carve,
            (false, false) => DomainRule::EvenOdd,
        };
        Self {
            vertices: PointSet {
                points: pslg.points,
                ..PointSet::default()
            },
            segments: pslg.segments,
            segment_markers: None,
            polygons: pslg.polygons,
            holes: pslg.holes,
            regions: pslg.regions,
            usual_rule,
        }
    }
}

impl From<MeshData> for DomainData {
    /// Takes the vertices of a mesh and what is constrained in it, and leaves its triangles.
    ///
    /// If there are only lines, they say what belongs to the domain: what rings enclose, by parity; where rings share
    /// sides, all that the outside cannot reach; the hull if no ring is closed.
    fn from(mesh: MeshData) -> Self {
        let are_lines = mesh.triangles.is_empty();
        let constraints = mesh.constraints.unwrap_or_default();
        let mut domain = Self {
            usual_rule: match constraints.edges.is_empty() {
                true => DomainRule::Hull,
                false => DomainRule::Carve,
            },
            segments: constraints.edges,
            segment_markers: constraints.markers,
            holes: constraints.holes,
            regions: constraints.regions,
            ..Self::from(mesh.vertices)
        };
        if are_lines && !domain.segments.is_empty() {
            outline::settle(&mut domain);
        }
        domain
    }
}

/// Reads a domain: points with all that a file says about the segments between them.
///
/// Every format of points is one of domains too, without segments.
///
/// # Errors
/// If the file cannot be read, is malformed (message with file and line), or the watch cancels.
///
/// *Cost*: time and memory proportional to the file.
pub fn read_domain(
    source: &Source,
    options: &ReadOptions,
    watch: &dyn Watch,
) -> Result<DomainData, Error> {
    #[cfg(feature = "las")]
    if las::is_one(source, options) {
        return las::read_points(source, options, watch).map(DomainData::from);
    }
    let bytes = source.load(watch)?;
    let format = resolve(source, &bytes, options, Format::reads_points)?;
    read_loaded(source, &bytes, format, options, watch)
}

/// Reads a domain from the content of a source, whose format is known.
pub(crate) fn read_loaded(
    source: &Source,
    bytes: &[u8],
    format: Format,
    options: &ReadOptions,
    watch: &dyn Watch,
) -> Result<DomainData, Error> {
    let file = source.to_string();
    match format {
        Format::Poly => poly::read_domain(&file, bytes, watch, || {
            read_sibling(source, format, "node", options, watch)
        }),
        Format::GeoJson => geojson::read_domain(&file, bytes, watch),
        Format::Wkt => wkt::read_domain(&file, bytes, watch),
        Format::Svg => svg::read_domain(&file, bytes, options, watch),
        Format::Airfoil => airfoil::read_domain(&file, bytes, options, watch),
        Format::Dxf => dxf::read_domain(&file, bytes, options, watch),
        Format::Shp => shp::read_domain(source, bytes, options, watch),
        #[cfg(feature = "parquet")]
        Format::Parquet => crate::parquet::read_domain(&file, bytes, options, watch),
        Format::Jigsaw => jigsaw::read_domain(&file, bytes, options, watch),
        format if format.reads_mesh() && format.reads_segments() => {
            mesh::read_loaded(source, bytes, format, options, watch).map(DomainData::from)
        }
        _ => points::read_loaded(source, bytes, format, options, watch).map(DomainData::from),
    }
}
