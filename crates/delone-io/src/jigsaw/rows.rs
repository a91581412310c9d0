//! The sections of a file, row by row.

use crate::scan::{self, Row, Scanner};
use crate::triangle_files::{marker, number, vertex};
use crate::{Attribute, Error, Lines, Place, Problem, node, points};
use delone::{Point, VertexId};

/// What a file holds.
#[derive(Default)]
pub(super) struct Rows {
    pub has_points: bool,
    pub points: Vec<Point>,
    pub point_tags: Vec<i32>,
    /// The lines that points stand on.
    pub lines: Lines,
    pub edges: Vec<[VertexId; 2]>,
    pub edge_tags: Vec<i32>,
    pub triangles: Vec<[VertexId; 3]>,
    pub triangle_tags: Vec<i32>,
    pub bounds: Vec<Bound>,
    pub values: Vec<Attribute>,
    pub notes: Vec<String>,
}

/// An edge that bounds a part.
pub(super) struct Bound {
    pub part: i32,
    pub edge: usize,
}

impl Rows {
    /// Reads all sections.
    pub fn read(scanner: &mut Scanner<'_>) -> Result<Self, Error> {
        let mut rows = Self::default();
        let mut bounds = Vec::new();
        while let Some(row) = scanner.next_row()? {
            let at = |problem| Err(scanner.at(row, problem));
            let Some(equals) = memchr::memchr(b'=', row.text) else {
                let text = scan::show(row.text);
                return at(Problem::Other(format!("expected KEYWORD=, found {text:?}")));
            };
            let (key, value) = (row.text[..equals].trim_ascii(), &row.text[equals + 1..]);
            let key = String::from_utf8_lossy(key).to_ascii_uppercase();
            let cells = cells(value);
            match key.as_str() {
                "MSHID" => check_kind(&cells).map_err(|problem| scanner.at(row, problem))?,
                "NDIMS" => match cells.first().copied().and_then(scan::integer) {
                    Some(2) => {}
                    other => return at(Problem::Dimension(other.unwrap_or(0))),
                },
                "POINT" => rows.read_points(scanner, row, &cells)?,
                "EDGE2" => {
                    let n = rows.points.len();
                    let (corners, tags) = read_cells(scanner, row, &cells, "edge", n)?;
                    (rows.edges, rows.edge_tags) = (corners, tags);
                }
                "TRIA3" => {
                    let n = rows.points.len();
                    let (corners, tags) = read_cells(scanner, row, &cells, "triangle", n)?;
                    (rows.triangles, rows.triangle_tags) = (corners, tags);
                }
                "BOUND" => read_bounds(scanner, row, &cells, &mut bounds)?,
                "VALUE" => rows.read_values(scanner, row, &cells)?,
                "POWER" => {
                    let (count, _) = count(scanner, row, &cells)?;
                    skip(scanner, count)?;
                    rows.notes
                        .push("weights of points (POWER) are not kept".to_owned());
                }
                _ => {
                    let (count, _) = count(scanner, row, &cells)?;
                    if count > 0 {
                        let key = scan::show(key.as_bytes());
                        return at(Problem::Other(format!(
                            "{key} is not understood: only POINT, EDGE2, TRIA3, BOUND and VALUE are"
                        )));
                    }
                }
            }
        }
        for (row, bound) in bounds {
            if bound.edge >= rows.edges.len() {
                let (index, limit) = (bound.edge as i64, rows.edges.len() as u64);
                let (item, target) = ("bound", "edge");
                let row = row as u64;
                return Err(scanner.malformed(
                    Place::File,
                    Problem::BadIndex {
                        item,
                        row,
                        target,
                        index,
                        limit,
                        base: 0,
                    },
                ));
            }
            rows.bounds.push(bound);
        }
        Ok(rows)
    }

    fn read_points(
        &mut self,
        scanner: &mut Scanner<'_>,
        header: Row<'_>,
        cells: &[&[u8]],
    ) -> Result<(), Error> {
        if self.has_points {
            return Err(scanner.at(header, Problem::Other("a second POINT".to_owned())));
        }
        self.has_points = true;
        let (count, _) = count(scanner, header, cells)?;
        if count > node::MAX_POINTS {
            return Err(scanner.at(header, node::too_many(count)));
        }
        scanner.reserve(&mut self.points, 6, count);
        each(scanner, "points", count, 3, |index, row, cells| {
            let [x, y] = [('x', cells[0]), ('y', cells[1])]
                .map(|(axis, cell)| scan::coordinate(cell, axis, index));
            self.points.push(Point::new(x?, y?));
            self.point_tags.push(marker(cells[2])?);
            self.lines.push(row.line);
            Ok(())
        })
    }

    fn read_values(
        &mut self,
        scanner: &mut Scanner<'_>,
        header: Row<'_>,
        cells: &[&[u8]],
    ) -> Result<(), Error> {
        let (count, width) = count(scanner, header, cells)?;
        let width = points::check_columns(width.unwrap_or(1)).map_err(|p| scanner.at(header, p))?;
        let n = self.points.len() as u64;
        if count != n {
            return Err(scanner.at(
                header,
                Problem::Other(format!("{count} values for {n} points")),
            ));
        }
        let name = |k| match width {
            1 => "value".to_owned(),
            _ => format!("value_{k}"),
        };
        let empty = |k| Attribute {
            name: name(k),
            values: Vec::new(),
        };
        self.values = (0..width).map(empty).collect();
        each(scanner, "values", count, width, |_, _, cells| {
            for (attribute, cell) in self.values.iter_mut().zip(cells) {
                attribute.values.push(number(cell, "value")?);
            }
            Ok(())
        })
    }
}

/// Checks what stands behind `MSHID=`.
fn check_kind(cells: &[&[u8]]) -> Result<(), Problem> {
    let version = cells.first().copied().and_then(scan::integer);
    if !version.is_some_and(|v| (1..=3).contains(&v)) {
        let text = cells.first().map_or_else(String::new, |c| scan::show(c));
        return Err(Problem::Other(format!(
            "version {text:?}: only 1, 2 and 3 are understood"
        )));
    }
    match cells.get(1) {
        Some(kind) if !kind.eq_ignore_ascii_case(b"EUCLIDEAN-MESH") => {
            let kind = scan::show(kind);
            Err(Problem::Other(format!(
                "{kind} is not understood: only EUCLIDEAN-MESH is"
            )))
        }
        _ => Ok(()),
    }
}

/// Reads a count, and what may stand behind it.
fn count(
    scanner: &Scanner<'_>,
    header: Row<'_>,
    cells: &[&[u8]],
) -> Result<(u64, Option<u64>), Error> {
    let read = |cell: &&[u8]| {
        let found = scan::integer(cell).and_then(|n| u64::try_from(n).ok());
        found.ok_or_else(|| {
            let (what, text) = ("count".to_owned(), scan::show(cell));
            scanner.at(header, Problem::NotANumber { what, text })
        })
    };
    let first = cells.first().copied().unwrap_or(b"");
    let further = cells.get(1).map(read).transpose()?;
    Ok((read(&first)?, further))
}

/// Reads so many rows of so many cells.
fn each<'a>(
    scanner: &mut Scanner<'a>,
    items: &'static str,
    declared: u64,
    columns: usize,
    mut take: impl FnMut(u64, Row<'a>, &[&'a [u8]]) -> Result<(), Problem>,
) -> Result<(), Error> {
    for found in 0..declared {
        let Some(row) = scanner.next_row()? else {
            let problem = Problem::Truncated {
                items,
                declared,
                found,
            };
            return Err(scanner.here(problem));
        };
        let cells = cells(row.text);
        if cells.len() != columns {
            let (expected, found) = (columns, cells.len());
            return Err(scanner.at(row, Problem::Columns { expected, found }));
        }
        take(found, row, &cells).map_err(|problem| scanner.at(row, problem))?;
    }
    Ok(())
}

fn skip(scanner: &mut Scanner<'_>, count: u64) -> Result<(), Error> {
    for _ in 0..count {
        if scanner.next_row()?.is_none() {
            break;
        }
    }
    Ok(())
}

/// Corners and tags of elements.
type Cells<const N: usize> = (Vec<[VertexId; N]>, Vec<i32>);

fn read_cells<const N: usize>(
    scanner: &mut Scanner<'_>,
    header: Row<'_>,
    cells: &[&[u8]],
    item: &'static str,
    num_vertices: usize,
) -> Result<Cells<N>, Error> {
    let (count, _) = count(scanner, header, cells)?;
    let (mut all, mut tags) = (Vec::new(), Vec::new());
    scanner.reserve(&mut all, 2 * N + 2, count);
    let items = if N == 2 { "edges" } else { "triangles" };
    each(scanner, items, count, N + 1, |index, _, cells| {
        let mut corners = [VertexId::new(0); N];
        for (corner, cell) in corners.iter_mut().zip(cells) {
            *corner = VertexId::from(vertex(cell, (item, index), 0, num_vertices)?);
        }
        all.push(corners);
        tags.push(marker(cells[N])?);
        Ok(())
    })?;
    Ok((all, tags))
}

/// Reads rows of part, edge and the kind of what bounds it; 20 is an edge.
fn read_bounds(
    scanner: &mut Scanner<'_>,
    header: Row<'_>,
    cells: &[&[u8]],
    bounds: &mut Vec<(usize, Bound)>,
) -> Result<(), Error> {
    const EDGE2: i32 = 20;
    let (count, _) = count(scanner, header, cells)?;
    each(scanner, "bounds", count, 3, |index, _, cells| {
        let kind = marker(cells[2])?;
        if kind != EDGE2 {
            let text = format!("bound {index} is of kind {kind}: only edges ({EDGE2}) bound areas");
            return Err(Problem::Other(text));
        }
        let edge = scan::integer(cells[1]).and_then(|e| usize::try_from(e).ok());
        let Some(edge) = edge else {
            let (what, text) = ("edge of a bound".to_owned(), scan::show(cells[1]));
            return Err(Problem::NotANumber { what, text });
        };
        bounds.push((
            index as usize,
            Bound {
                part: marker(cells[0])?,
                edge,
            },
        ));
        Ok(())
    })
}

fn cells(text: &[u8]) -> Vec<&[u8]> {
    text.split(|&b| b == b';').map(<[u8]>::trim_ascii).collect()
}
