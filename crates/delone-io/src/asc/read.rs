//! Reading.

use crate::decimal::Axis;
use crate::scan::{self, Row, Scanner};
use crate::{Attribute, Error, Place, PointSet, Problem, cancel, node};
use delone::{Point, Watch};

/// Most columns or rows: twice as many half cells can be counted in 31 bits.
const MAX_SIDE: u64 = 1 << 29;

/// Tells whether text begins like a grid: with its number of columns or rows.
pub(crate) fn sniff(head: &[u8]) -> bool {
    let text = scan::without_mark(head).trim_ascii_start();
    let line = text.split(|b| b"\n\r".contains(b)).next();
    let mut words = line.unwrap_or(text).split(u8::is_ascii_whitespace);
    let mut words = words.by_ref().filter(|word| !word.is_empty());
    let is_name =
        |word: &[u8]| word.eq_ignore_ascii_case(b"ncols") || word.eq_ignore_ascii_case(b"nrows");
    words.next().is_some_and(is_name)
        && words.next().and_then(scan::integer).is_some()
        && words.next().is_none()
}

/// Reads the centres of all cells that have a value.
pub(crate) fn read_points(file: &str, bytes: &[u8], watch: &dyn Watch) -> Result<PointSet, Error> {
    let mut scanner = Scanner::new(file, bytes, watch);
    let mut header = Header::default();
    let mut pending = scanner.next_row()?;
    while let Some(row) = pending
        && header.take(row).map_err(|p| scanner.at(row, p))?
    {
        pending = scanner.next_row()?;
    }
    let grid = header
        .finish()
        .map_err(|p| scanner.malformed(Place::File, p))?;
    let mut points = Vec::new();
    let mut z = Vec::new();
    scanner.reserve(&mut points, 2, grid.cells);
    scanner.reserve(&mut z, 2, grid.cells);
    let mut cell = 0;
    while let Some(row) = pending {
        for word in row.words() {
            cancel::check(watch, cell as usize)?;
            if cell == grid.cells {
                let text = format!("more values than the {} of the header", grid.size());
                return Err(scanner.at(row, Problem::Other(text)));
            }
            let value = scan::number(word).ok_or_else(|| {
                let (what, text) = (format!("cell {cell}"), scan::show(word));
                scanner.at(row, Problem::NotANumber { what, text })
            })?;
            if value.is_infinite() {
                let text = format!("cell {cell} is {}: values must be finite", scan::show(word));
                return Err(scanner.at(row, Problem::Other(text)));
            }
            if !value.is_nan() && value != grid.missing {
                points.push(grid.center(cell));
                z.push(value);
            }
            cell += 1;
        }
        pending = scanner.next_row()?;
    }
    if cell < grid.cells {
        return Err(scanner.malformed(
            Place::File,
            Problem::Truncated {
                items: "values",
                declared: grid.cells,
                found: cell,
            },
        ));
    }
    points.shrink_to_fit();
    z.shrink_to_fit();
    Ok(PointSet {
        points,
        attributes: vec![Attribute {
            name: "z".to_owned(),
            values: z,
        }],
        ..PointSet::default()
    })
}

/// What the lines of the header have said so far.
#[derive(Default)]
struct Header {
    columns: Option<u64>,
    rows: Option<u64>,
    /// For x and y the corner or the centre of the lower left cell, and which it is.
    low: [Option<(f64, Low)>; 2],
    /// Width and height of a cell.
    cell: [Option<f64>; 2],
    missing: Option<f64>,
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Low {
    Corner,
    Center,
}

impl Header {
    /// Takes a line; false if it is one of values.
    fn take(&mut self, row: Row<'_>) -> Result<bool, Problem> {
        let mut words = row.words();
        let name = words.next().unwrap_or_default();
        if scan::number(name).is_some() && !name.eq_ignore_ascii_case(b"nan") {
            return Ok(false);
        }
        let name = scan::show(&name.to_ascii_lowercase());
        let value = words.next().unwrap_or_default();
        let number = || match scan::number(value) {
            Some(number) => Ok(number),
            None => Err(not_a_number(&name, value)),
        };
        let finite = || {
            number()
                .ok()
                .filter(|n| n.is_finite())
                .ok_or_else(|| not_a_number(&name, value))
        };
        let length = || match finite()? {
            length if length > 0.0 => Ok(length),
            length => Err(Problem::Other(format!(
                "{name} is {length}: must be positive"
            ))),
        };
        let count = || match scan::integer(value) {
            Some(count @ 1..) => Ok(count as u64),
            _ => Err(Problem::Other(format!(
                "{name} is {:?}: must be a positive integer",
                scan::show(value)
            ))),
        };
        match name.as_str() {
            "ncols" => self.columns = Some(count()?),
            "nrows" => self.rows = Some(count()?),
            "xllcorner" => self.low[0] = Some((finite()?, Low::Corner)),
            "yllcorner" => self.low[1] = Some((finite()?, Low::Corner)),
            "xllcenter" => self.low[0] = Some((finite()?, Low::Center)),
            "yllcenter" => self.low[1] = Some((finite()?, Low::Center)),
            "cellsize" => self.cell = [Some(length()?); 2],
            "dx" => self.cell[0] = Some(length()?),
            "dy" => self.cell[1] = Some(length()?),
            "nodata_value" | "nodata" => self.missing = Some(number()?),
            // Rows of values may begin with NaN.
            "nan" => return Ok(false),
            _ => {
                return Err(Problem::Other(format!(
                    "{name:?} is no part of a header: known are ncols, nrows, xllcorner, xllcenter, yllcorner, \
                     yllcenter, cellsize, dx, dy and NODATA_value"
                )));
            }
        }
        match words.next() {
            None => Ok(true),
            Some(_) => Err(Problem::Other(format!("{name}: one value is expected"))),
        }
    }

    fn finish(self) -> Result<Grid, Problem> {
        let missing = |what: &str| Problem::Other(format!("the header names no {what}"));
        let columns = self.columns.ok_or_else(|| missing("ncols"))?;
        let rows = self.rows.ok_or_else(|| missing("nrows"))?;
        let cells = columns.checked_mul(rows);
        let fits = |&cells: &u64| cells <= node::MAX_POINTS && columns.max(rows) <= MAX_SIDE;
        let Some(cells) = cells.filter(fits) else {
            return Err(Problem::Other(format!(
                "a grid of {columns} by {rows} cells: at most {} are possible, {MAX_SIDE} in a row; split it into tiles",
                node::MAX_POINTS
            )));
        };
        let axis = |k: usize| {
            let name = ['x', 'y'][k];
            let (low, kind) =
                self.low[k].ok_or_else(|| missing(&format!("{name}llcorner or {name}llcenter")))?;
            let cell = self.cell[k].ok_or_else(|| missing(&format!("cellsize or d{name}")))?;
            let axis = Axis::new(cell / 2.0, low);
            let axis = axis.map_err(|why| {
                Problem::Other(format!("{name} begins at {low} in steps of {cell}: {why}"))
            })?;
            Ok((axis, i32::from(kind == Low::Corner)))
        };
        Ok(Grid {
            columns,
            rows,
            cells,
            axes: [axis(0)?, axis(1)?],
            missing: self.missing.unwrap_or(-9999.0),
        })
    }
}

fn not_a_number(name: &str, word: &[u8]) -> Problem {
    Problem::NotANumber {
        what: name.to_owned(),
        text: scan::show(word),
    }
}

/// A grid whose cells are counted along rows, from the top.
struct Grid {
    columns: u64,
    rows: u64,
    cells: u64,
    /// For x and y the map from half cells to coordinates, and where the first centre is, in half cells.
    axes: [(Axis, i32); 2],
    missing: f64,
}

impl Grid {
    fn size(&self) -> String {
        format!("{} by {} cells", self.columns, self.rows)
    }

    fn center(&self, cell: u64) -> Point {
        let (column, row) = (cell % self.columns, cell / self.columns);
        let [x, y] = self.axes;
        // Both are below 2²⁹.
        let place =
            |(axis, first): (Axis, i32), step: u64| axis.coordinate(2 * step as i32 + first);
        Point::new(place(x, column), place(y, self.rows - 1 - row))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> Result<PointSet, Error> {
        assert!(sniff(text.as_bytes()), "{text}");
        read_points("g.asc", text.as_bytes(), &())
    }

    fn places(set: &PointSet) -> Vec<(f64, f64, f64)> {
        let z = &set.attributes[0].values;
        let places = set.points.iter().zip(z);
        places.map(|(p, &z)| (p.x, p.y, z)).collect()
    }

    #[test]
    fn centres_of_cells_are_points() {
        let text = "NCOLS 3\nnrows 2\nxllcorner 10\nyllcorner 20.5\ncellsize 0.1\nNODATA_value -1\n1 2 -1\n4\n5 6\n";
        let expected = [
            (10.05, 20.65, 1.0),
            (10.15, 20.65, 2.0),
            (10.05, 20.55, 4.0),
            (10.15, 20.55, 5.0),
            (10.25, 20.55, 6.0),
        ];
        assert_eq!(places(&read(text).unwrap()), expected);
        let text = "nrows 1\nncols 2\nxllcenter 10\nyllcenter 20\ndx 2\ndy 3\n-9999 nan\n";
        assert_eq!(places(&read(text).unwrap()), []);
        let text = "nrows 1\nncols 2\nxllcenter 10\nyllcenter 20\ndx 2\ndy 3\nnan 7";
        assert_eq!(places(&read(text).unwrap()), [(12.0, 20.0, 7.0)]);
    }

    #[test]
    fn tables_are_no_grids() {
        for text in [
            "x y\n1 2\n",
            "ncols nrows\n1 2\n",
            "ncols 3 4\n",
            "",
            "1 2 3",
        ] {
            assert!(!sniff(text.as_bytes()), "{text}");
        }
    }

    #[test]
    fn what_is_wrong_is_said_with_its_line() {
        let head = "ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 1\n";
        for (text, message) in [
            (
                format!("{head}1 2\n3\n"),
                "g.asc: truncated: header says 4 values, file has 3",
            ),
            (
                format!("{head}1 2\n3 4 5\n"),
                "g.asc:7: more values than the 2 by 2 cells of the header",
            ),
            (
                format!("{head}1 2\n3 x\n"),
                "g.asc:7: cell 3 is not a number: \"x\"",
            ),
            (
                format!("{head}1 2\n3 inf\n"),
                "g.asc:7: cell 3 is inf: values must be finite",
            ),
            (
                "ncols 0\n".to_owned(),
                "g.asc:1: ncols is \"0\": must be a positive integer",
            ),
            (
                "ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize -1\n1 2 3 4".to_owned(),
                "g.asc:5: cellsize is -1: must be positive",
            ),
            (
                "ncols 2\nnrows 2\nxllcorner 0\ncellsize 1\n1 2 3 4".to_owned(),
                "g.asc: the header names no yllcorner or yllcenter",
            ),
            (
                "ncols 100000\nnrows 100000\nxllcorner 0\nyllcorner 0\ncellsize 1\n1 2 3 4"
                    .to_owned(),
                "g.asc: a grid of 100000 by 100000 cells: at most 4294967294 are possible, 536870912 in a row; \
                 split it into tiles",
            ),
            (
                "ncols 2\nnorth 3\n".to_owned(),
                "g.asc:2: \"north\" is no part of a header: known are ncols, nrows, xllcorner, xllcenter, yllcorner, \
                 yllcenter, cellsize, dx, dy and NODATA_value",
            ),
            (
                "ncols 2\nnrows 2\nxllcorner 1e300\nyllcorner 0\ncellsize 1e-300\n1 2 3 4"
                    .to_owned(),
                "g.asc: x begins at 1e300 in steps of 1e-300: scale and offset are too far apart",
            ),
        ] {
            let found = read(&text).unwrap_err().to_string();
            // Numbers beyond text are printed in full.
            let found = found.replace(&format!("{}", 1e300), "1e300");
            let found = found.replace(&format!("{}", 1e-300), "1e-300");
            assert_eq!(found, message);
        }
    }
}
