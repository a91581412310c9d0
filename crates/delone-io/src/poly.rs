//! `.poly`: planar straight-line graphs of Triangle.
//!
//! A `.node` file without an end, then `s markers` and rows `number a b [marker]` for the segments,
//! then `h` and rows `number x y` for the holes, then perhaps `r` and rows `number x y attribute
//! [largest area]` for the regions. Zero points mean that they stand in the `.node` file of the same
//! stem. Segments, holes and regions may be numbered from 0 or 1, whatever the points are; a
//! largest area that is not positive is none. Of a region's single number Triangle makes the
//! attribute or the area, as its switches say; here it is the attribute.

use crate::scan::{self, Scanner};
use crate::triangle_files::{self, Block, Header};
use crate::{DomainData, Error, PointSet, Problem, node};
use delone::{DomainRule, Point, Region, VertexId, Watch};

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
    let mut domain = DomainData::from(vertices);
    read_segments(&mut scanner, &mut domain)?;
    read_holes(&mut scanner, &mut domain)?;
    read_regions(&mut scanner, &mut domain)?;
    if !domain.segments.is_empty() {
        domain.usual_rule = DomainRule::Carve;
    }
    Ok(domain)
}

fn read_segments(scanner: &mut Scanner<'_>, domain: &mut DomainData) -> Result<(), Error> {
    let header = section(scanner, "segments")?;
    let has_markers = header.count(scanner, 1, "markers")? > 0;
    let block = Block {
        items: "segments",
        declared: header.count(scanner, 0, "segments")?,
        columns: 3 + usize::from(has_markers),
        base: None,
    };
    let (base, num_vertices) = (domain.vertices.base, domain.vertices.points.len());
    let end = |cell, number| triangle_files::vertex(cell, ("segment", number), base, num_vertices);
    let mut markers = Vec::new();
    scanner.reserve(&mut domain.segments, 2 * block.columns, block.declared);
    block.read(scanner, |number, cells| {
        let ends = [end(cells[0], number)?, end(cells[1], number)?];
        domain.segments.push(ends.map(VertexId::from));
        if let Some(cell) = cells.get(2) {
            markers.push(triangle_files::marker(cell)?);
        }
        Ok(())
    })?;
    domain.segment_markers = has_markers.then_some(markers);
    Ok(())
}

fn read_holes(scanner: &mut Scanner<'_>, domain: &mut DomainData) -> Result<(), Error> {
    let header = section(scanner, "holes")?;
    let block = Block {
        items: "holes",
        declared: header.count(scanner, 0, "holes")?,
        columns: 3,
        base: None,
    };
    block.read(scanner, |number, cells| {
        domain.holes.push(seed(cells, ("hole", number))?);
        Ok(())
    })?;
    Ok(())
}

/// Reads the regions, if the file goes on to them; nothing may follow.
fn read_regions(scanner: &mut Scanner<'_>, domain: &mut DomainData) -> Result<(), Error> {
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
        let max_area = cells.get(3).map(|cell| number_of(cell)).transpose()?;
        domain.regions.push(Region {
            at: seed(cells, ("region", number))?,
            attribute: number_of(cells[2])?,
            max_area: max_area.filter(|&area| area > 0.0),
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
