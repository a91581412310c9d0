//! `.poly`: planar straight-line graphs of Triangle.
//!
//! A `.node` file without an end, then `s markers` and rows `number a b [marker]` for the segments,
//! then `h` and rows `number x y` for the holes, then perhaps `r` and rows `number x y attribute
//! [largest area]` for the regions. Zero points mean that they stand in the `.node` file of the same
//! stem. Segments, holes and regions may be numbered from 0 or 1, whatever the points are; a
//! largest area that is not positive is none. A region's single number is, as in Triangle, its attribute
//! and its largest area alike: who wants but one of them, leaves the other alone. Where a region has no
//! largest area, −1 is written.

use crate::scan::{self, Row, Scanner};
use crate::target::Output;
use crate::triangle_files::{self, Block, Header};
use crate::{Constraints, DomainData, Error, MeshView, PointSet, Problem, node};
use delone::{DomainRule, Point, Region, VertexId, Watch};
use std::fs::File;
use std::io::Read;
use std::path::Path;

/// Reads a domain; `elsewhere` reads the `.node` file if the points stand there.
pub(crate) fn read_domain(
    file: &str,
    bytes: &[u8],
    watch: &dyn Watch,
    elsewhere: impl FnOnce() -> Result<PointSet, Error>,
) -> Result<DomainData, Error> {
    let mut scanner = Scanner::new(file, bytes, watch);
    let header = Header::read(&mut scanner)?;
    let vertices = if header.get(0, 0) == 0 {
        elsewhere()?
    } else {
        node::read_block(&mut scanner, &header)?
    };
    let graph = read_sections(&mut scanner, &vertices)?;
    let usual_rule = match graph.edges.is_empty() {
        true => DomainRule::Hull,
        false => DomainRule::Carve,
    };
    Ok(DomainData {
        vertices,
        segments: graph.edges,
        segment_markers: graph.markers,
        polygons: Vec::new(),
        holes: graph.holes,
        regions: graph.regions,
        usual_rule,
    })
}

/// Tells whether text that begins like a `.node` file goes on behind its points with the header of segments: one or
/// two counts, where a further point would have three columns at least.
pub(crate) fn goes_on(text: &[u8]) -> bool {
    let mut scanner = Scanner::new("", text, &());
    let mut rows = std::iter::from_fn(|| scanner.next_row().ok().flatten());
    let counts = rows
        .next()
        .map(|header| Vec::from_iter(header.words().map_while(scan::integer)));
    let Some(&[points, _, attributes, markers]) = counts.as_deref() else {
        return false;
    };
    let width = attributes.saturating_add(markers).saturating_add(3);
    let is_point = |row: &Row<'_>| row.words().count() as i64 == width;
    let is_whole = (0..points).all(|_| rows.next().as_ref().is_some_and(is_point));
    let is_header = |row: Row<'_>| {
        matches!(row.words().count(), 1..=2) && row.words().all(|w| scan::integer(w).is_some())
    };
    is_whole && rows.next().is_some_and(is_header)
}

/// Bytes in which the header of any usual file is found.
const HEAD: u64 = 4096;

/// Tells whether there is a file without points of its own, which belongs to the `.node` file beside it.
pub(crate) fn is_graph(path: &Path) -> bool {
    let mut head = Vec::new();
    // Opening a pipe would wait for its writer.
    let is_read = path.is_file()
        && File::open(path).is_ok_and(|file| file.take(HEAD).read_to_end(&mut head).is_ok());
    let header = Header::read(&mut Scanner::new("", &head, &()));
    is_read && header.is_ok_and(|header| header.get(0, 0) == 0)
}

/// Reads what a file without points of its own says about those of its mesh; `None` if it has points,
/// or says nothing.
pub(crate) fn read_graph(
    file: &str,
    bytes: &[u8],
    vertices: &PointSet,
    watch: &dyn Watch,
) -> Result<Option<Constraints>, Error> {
    let mut scanner = Scanner::new(file, bytes, watch);
    match Header::read(&mut scanner)?.get(0, 0) {
        0 => {
            let graph = read_sections(&mut scanner, vertices)?;
            Ok((!graph.is_empty()).then_some(graph))
        }
        _ => Ok(None),
    }
}

/// Reads all that follows the points.
fn read_sections(scanner: &mut Scanner<'_>, vertices: &PointSet) -> Result<Constraints, Error> {
    let mut graph = Constraints::default();
    read_segments(scanner, vertices, &mut graph)?;
    read_holes(scanner, &mut graph.holes)?;
    read_regions(scanner, &mut graph.regions)?;
    Ok(graph)
}

fn read_segments(
    scanner: &mut Scanner<'_>,
    vertices: &PointSet,
    graph: &mut Constraints,
) -> Result<(), Error> {
    let header = section(scanner, "segments")?;
    let has_markers = header.count(scanner, 1, "markers")? > 0;
    let block = Block {
        items: "segments",
        declared: header.count(scanner, 0, "segments")?,
        columns: 3 + usize::from(has_markers),
        base: None,
    };
    let (base, num_vertices) = (vertices.base, vertices.points.len());
    let end = |cell, number| triangle_files::vertex(cell, ("segment", number), base, num_vertices);
    let mut markers = Vec::new();
    scanner.reserve(&mut graph.edges, 2 * block.columns, block.declared);
    block.read(scanner, |number, cells| {
        let ends = [end(cells[0], number)?, end(cells[1], number)?];
        graph.edges.push(ends.map(VertexId::from));
        if let Some(cell) = cells.get(2) {
            markers.push(triangle_files::marker(cell)?);
        }
        Ok(())
    })?;
    graph.markers = has_markers.then_some(markers);
    Ok(())
}

fn read_holes(scanner: &mut Scanner<'_>, holes: &mut Vec<Point>) -> Result<(), Error> {
    let header = section(scanner, "holes")?;
    let block = Block {
        items: "holes",
        declared: header.count(scanner, 0, "holes")?,
        columns: 3,
        base: None,
    };
    block.read(scanner, |number, cells| {
        holes.push(seed(cells, ("hole", number))?);
        Ok(())
    })?;
    Ok(())
}

/// Reads the regions, if the file goes on to them; nothing may follow.
fn read_regions(scanner: &mut Scanner<'_>, regions: &mut Vec<Region>) -> Result<(), Error> {
    let Some(header) = Header::read_if_any(scanner)? else {
        return Ok(());
    };
    let declared = header.count(scanner, 0, "regions")?;
    let block = Block {
        items: "regions",
        declared,
        columns: 5,
        base: None,
    };
    block.read_ragged(scanner, 4, |number, cells| {
        let number_of = |cell| finite(cell, ("region", number), "attribute or area");
        let max_area = number_of(cells.get(3).unwrap_or(&cells[2]))?;
        regions.push(Region {
            at: seed(cells, ("region", number))?,
            attribute: number_of(cells[2])?,
            max_area: (max_area > 0.0).then_some(max_area),
        });
        Ok(())
    })?;
    triangle_files::expect_end(scanner, "regions", declared)
}

/// Reads the header of a section that must come.
fn section<'a>(scanner: &mut Scanner<'a>, items: &str) -> Result<Header<'a>, Error> {
    match Header::read_if_any(scanner)? {
        Some(header) => Ok(header),
        None => Err(scanner.here(Problem::Other(format!(
            "truncated: no header of {items}; write 0 if there are none"
        )))),
    }
}

/// Reads the point of a hole or region.
fn seed(cells: &[&[u8]], item: (&str, u64)) -> Result<Point, Problem> {
    Ok(Point::new(
        finite(cells[0], item, "x")?,
        finite(cells[1], item, "y")?,
    ))
}

fn finite(cell: &[u8], (item, number): (&str, u64), what: &str) -> Result<f64, Problem> {
    let value = triangle_files::number(cell, what)?;
    if value.is_finite() {
        return Ok(value);
    }
    let text = scan::show(cell);
    Err(Problem::Other(format!(
        "{item} {number}: {what} is {text}, it must be finite"
    )))
}

/// Writes the header that says that the points stand elsewhere.
pub(crate) fn write_header(
    out: &mut Output<'_>,
    mesh: &MeshView<'_>,
    has_markers: bool,
) -> Result<(), Error> {
    let has_markers = usize::from(has_markers);
    out.text(format_args!(
        "0 2 {} {has_markers}\n",
        mesh.attributes.len()
    ))
}

/// Writes the constrained edges as segments, holes and regions, everything numbered from `base`.
pub(crate) fn write_graph(
    out: &mut Output<'_>,
    mesh: &MeshView<'_>,
    markers: Option<&[i32]>,
    base: usize,
) -> Result<(), Error> {
    let none = Constraints::default();
    let constraints = mesh.constraints.unwrap_or(&none);
    let has_markers = usize::from(markers.is_some());
    out.text(format_args!("{} {has_markers}\n", constraints.edges.len()))?;
    for (e, ends) in constraints.edges.iter().enumerate() {
        out.integer((e + base) as i64);
        for v in ends {
            out.blank();
            out.integer((v.index() + base) as i64);
        }
        if let Some(markers) = markers {
            out.blank();
            out.integer(markers[e].into());
        }
        out.end_line()?;
    }
    out.text(format_args!("{}\n", constraints.holes.len()))?;
    for (h, hole) in constraints.holes.iter().enumerate() {
        write_numbers(out, h + base, &[hole.x, hole.y])?;
    }
    if constraints.regions.is_empty() {
        return Ok(());
    }
    out.text(format_args!("{}\n", constraints.regions.len()))?;
    for (r, region) in constraints.regions.iter().enumerate() {
        let Region { at, attribute, .. } = *region;
        // Without it, Triangle would take the attribute for the area.
        let area = region.max_area.unwrap_or(-1.0);
        write_numbers(out, r + base, &[at.x, at.y, attribute, area])?;
    }
    Ok(())
}

fn write_numbers(out: &mut Output<'_>, row: usize, numbers: &[f64]) -> Result<(), Error> {
    out.integer(row as i64);
    for &number in numbers {
        out.blank();
        out.number(number);
    }
    out.end_line()
}
