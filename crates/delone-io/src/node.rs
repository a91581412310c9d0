//! `.node`: points of Triangle.
//!
//! Header `n 2 attributes markers` (markers 0 or 1), then a row `number x y [attributes] [marker]`
//! for each point. As in Triangle, a header may stop after `n`.

use crate::scan::{self, Scanner};
use crate::target::Output;
use crate::triangle_files::{self, Block, Header};
use crate::{Attribute, Error, MeshView, PointSet, Problem, points};
use delone::{Point, Watch};

/// Most points that one mesh can number.
pub(crate) const MAX_POINTS: u64 = u32::MAX as u64 - 1;

/// Tells whether text begins like a `.node` file: a full header, and a row numbered 0 or 1 of the
/// width that it declares.
pub(crate) fn sniff(head: &[u8]) -> bool {
    let mut scanner = Scanner::new("", head, &());
    let (Ok(Some(header)), Ok(Some(row))) = (scanner.next_row(), scanner.next_row()) else {
        return false;
    };
    let counts: Vec<_> = header.words().map_while(scan::integer).collect();
    let &[_, 2, attributes, markers @ 0..=1] = counts.as_slice() else {
        return false;
    };
    let width = row.words().count() as i64;
    header.words().count() == 4
        && attributes.checked_add(3 + markers) == Some(width)
        && row
            .words()
            .next()
            .and_then(scan::integer)
            .is_some_and(|n| n == 0 || n == 1)
}

/// Reads a whole `.node` file.
pub(crate) fn read_points(file: &str, bytes: &[u8], watch: &dyn Watch) -> Result<PointSet, Error> {
    let mut scanner = Scanner::new(file, bytes, watch);
    let header = Header::read(&mut scanner)?;
    let points = read_block(&mut scanner, &header)?;
    let declared = header.count(&scanner, 0, "points")?;
    triangle_files::expect_end(&mut scanner, "points", declared)?;
    Ok(points)
}

/// Reads the rows of points that follow `header`, in a `.node` or `.poly` file.
pub(crate) fn read_block(
    scanner: &mut Scanner<'_>,
    header: &Header<'_>,
) -> Result<PointSet, Error> {
    let declared = header.count(scanner, 0, "points")?;
    let dimension = header.get(1, 2);
    if dimension != 2 {
        return Err(header.problem(scanner, Problem::Dimension(dimension)));
    }
    let attributes = header.count(scanner, 2, "attributes")?;
    let attributes = points::check_columns(attributes).map_err(|p| header.problem(scanner, p))?;
    let has_markers = match header.count(scanner, 3, "markers")? {
        0 => false,
        1 => true,
        n => {
            let problem = Problem::Other(format!("{n} markers a point: must be 0 or 1"));
            return Err(header.problem(scanner, problem));
        }
    };
    let block = Block {
        items: "points",
        declared,
        columns: attributes + 3 + usize::from(has_markers),
        base: None,
    };
    let mut set = PointSet {
        markers: has_markers.then(Vec::new),
        attributes: (1..=attributes).map(unnamed).collect(),
        ..PointSet::default()
    };
    scanner.reserve(&mut set.points, 2 * block.columns, declared);
    let (base, lines) = block.read(scanner, |number, cells| push(&mut set, number, cells))?;
    (set.base, set.lines) = (base, lines);
    Ok(set)
}

/// Adds a point from the cells `x y [attributes] [marker]`.
fn push(set: &mut PointSet, number: u64, cells: &[&[u8]]) -> Result<(), Problem> {
    if set.points.len() as u64 == MAX_POINTS {
        return Err(too_many(MAX_POINTS + 1));
    }
    let x = scan::coordinate(cells[0], 'x', number)?;
    let y = scan::coordinate(cells[1], 'y', number)?;
    let mut rest = &cells[2..];
    if let Some(markers) = &mut set.markers
        && let Some((last, others)) = rest.split_last()
    {
        markers.push(triangle_files::marker(last)?);
        rest = others;
    }
    for (attribute, cell) in set.attributes.iter_mut().zip(rest) {
        attribute
            .values
            .push(triangle_files::number(cell, "attribute")?);
    }
    set.points.push(Point::new(x, y));
    Ok(())
}

/// Makes an empty attribute, named by its place from 1.
pub(crate) fn unnamed(place: usize) -> Attribute {
    Attribute {
        name: format!("attribute{place}"),
        values: Vec::new(),
    }
}

/// Makes the problem of too many points.
pub(crate) fn too_many(given: u64) -> Problem {
    Problem::TooMany {
        items: "points",
        given,
        limit: MAX_POINTS,
    }
}

/// Writes the vertices, numbered from `base`.
pub(crate) fn write(
    out: &mut Output<'_>,
    mesh: &MeshView<'_>,
    markers: Option<&[i32]>,
    base: usize,
) -> Result<(), Error> {
    let attributes = mesh.attributes;
    let has_markers = usize::from(markers.is_some());
    out.text(format_args!(
        "{} 2 {} {has_markers}\n",
        mesh.points.len(),
        attributes.len()
    ))?;
    for (i, p) in mesh.points.iter().enumerate() {
        out.integer((i + base) as i64);
        for value in [p.x, p.y]
            .into_iter()
            .chain(attributes.iter().map(|a| a.values[i]))
        {
            out.blank();
            out.number(value);
        }
        if let Some(marker) = markers.map(|markers| markers[i]) {
            out.blank();
            out.integer(marker.into());
        }
        out.end_line()?;
    }
    Ok(())
}
