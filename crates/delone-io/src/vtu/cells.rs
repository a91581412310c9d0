//! Writing Voronoi cells: polygons, and triangles where a polygon would need holes, which VTK's have not.

use super::write::{array, integers};
use super::{POLYGON, TRIANGLE};
use crate::target::Output;
use crate::{CellsView, Error, cancel};
use delone::voronoi::Part;
use delone::{ConstrainedDelaunay, DomainRule, Point, Pslg, SegmentPolicy, VertexId, Watch};

/// All parts of all cells, as VTK has them.
#[derive(Default)]
struct Grid {
    points: Vec<Point>,
    nodes: Vec<u64>,
    /// Where each element ends in `nodes`.
    ends: Vec<u64>,
    kinds: Vec<u8>,
    /// The site of each element.
    sites: Vec<VertexId>,
}

impl Grid {
    fn of(cells: &CellsView<'_>, watch: &dyn Watch) -> Result<Self, Error> {
        let mut grid = Self::default();
        for (i, (site, part)) in cells.parts().enumerate() {
            cancel::check(watch, i)?;
            match part.holes().len() {
                0 => grid.add_polygon(site, part.outline()),
                _ => grid.add_triangles(site, &part)?,
            }
        }
        Ok(grid)
    }

    fn add_polygon(&mut self, site: VertexId, outline: &[Point]) {
        let first = self.points.len() as u64;
        self.points.extend_from_slice(outline);
        self.add_element(site, POLYGON, first..first + outline.len() as u64);
    }

    fn add_triangles(&mut self, site: VertexId, part: &Part<'_>) -> Result<(), Error> {
        let mut pslg = Pslg::from_points(part.rings().flatten().copied());
        let mut first = 0;
        for ring in part.rings() {
            let end = first + ring.len() as u32;
            pslg.add_ring(first..end);
            first = end;
        }
        // Corners of cells are rounded, so rings may meet where they come close.
        let builder = ConstrainedDelaunay::new()
            .threads(1)
            .domain(DomainRule::EvenOdd)
            .crossings(SegmentPolicy::Split);
        let t = builder.triangulate(pslg);
        let t = t.map_err(|error| Error::BadMesh(error.to_string()))?;
        let t = t.triangulation();
        let first = self.points.len() as u64;
        self.points.extend_from_slice(t.points());
        for corners in t.triangles() {
            let nodes = corners.map(|v| first + v.index() as u64);
            self.add_element(site, TRIANGLE, nodes.into_iter());
        }
        Ok(())
    }

    fn add_element(&mut self, site: VertexId, kind: u8, nodes: impl Iterator<Item = u64>) {
        self.nodes.extend(nodes);
        self.ends.push(self.nodes.len() as u64);
        self.kinds.push(kind);
        self.sites.push(site);
    }
}

/// Writes each part of a cell, with the number of its site, the area of its cell and what goes with the
/// site.
pub(crate) fn write_cells(
    out: &mut Output<'_>,
    cells: &CellsView<'_>,
    base: usize,
    watch: &dyn Watch,
) -> Result<(), Error> {
    let grid = Grid::of(cells, watch)?;
    let (n, m) = (grid.points.len(), grid.kinds.len());
    out.text(format_args!(
        "<?xml version=\"1.0\"?>\n\
         <VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n\
         <UnstructuredGrid>\n<Piece NumberOfPoints=\"{n}\" NumberOfCells=\"{m}\">\n<Points>\n"
    ))?;
    let coordinates = grid.points.iter().flat_map(|p| [p.x, p.y, 0.0]);
    let coordinates = coordinates.map(f64::to_le_bytes);
    array(out, "Float64", "Points", 3, 3 * n, coordinates)?;
    out.text(format_args!("</Points>\n<Cells>\n"))?;
    let k = grid.nodes.len();
    array(out, "Int64", "connectivity", 1, k, wide(&grid.nodes))?;
    array(out, "Int64", "offsets", 1, m, wide(&grid.ends))?;
    let kinds = grid.kinds.iter().map(|&kind| [kind]);
    array(out, "UInt8", "types", 1, m, kinds)?;
    out.text(format_args!("</Cells>\n<CellData>\n"))?;
    let sites = || grid.sites.iter().copied();
    let numbers = sites().map(|v| (v.index() + base) as i32);
    integers(out, "site", Some((numbers, m)))?;
    let areas = sites().map(|v| cells.clipped.measure(v).area.to_le_bytes());
    array(out, "Float64", "area", 1, m, areas)?;
    for attribute in cells.attributes {
        let values = sites().map(|v| attribute.values[v.index()].to_le_bytes());
        array(out, "Float64", &attribute.name, 1, m, values)?;
    }
    let markers = cells.markers;
    let markers = markers.map(|markers| (sites().map(|v| markers[v.index()]), m));
    integers(out, "marker", markers)?;
    out.text(format_args!(
        "</CellData>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n"
    ))
}

fn wide(numbers: &[u64]) -> impl Iterator<Item = [u8; 8]> {
    numbers.iter().map(|number| number.to_le_bytes())
}
