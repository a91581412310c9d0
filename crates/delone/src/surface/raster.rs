//! Cells in rows and columns, and values at their centres.

use crate::{Error, Point};

/// Cells in rows and columns over a box, rows counted downwards from the top.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Grid {
    low: Point,
    cell: [f64; 2],
    columns: usize,
    rows: usize,
}

/// Most cells of one raster: 8 GiB of values.
const MOST_CELLS: f64 = (1_u64 << 30) as f64;

impl Grid {
    /// Covers the box from `low` to `high` with square cells; the last row and column may reach beyond
    /// its top and its right side.
    ///
    /// # Errors
    /// [`Error::BadGrid`] unless the corners are finite, the box and the cells have a positive size, and there are
    /// at most 2³⁰ cells.
    pub fn with_cells(low: Point, high: Point, cell: f64) -> Result<Self, Error> {
        require("side of a cell", cell, cell > 0.0 && cell.is_finite())?;
        let [width, height] = extent(low, high)?;
        // Less than the box by rounding is not worth a row.
        let number = |length: f64| (length / cell * (1.0 - 1e-12)).ceil().max(1.0);
        Self::of(low, [cell; 2], number(width), number(height))
    }

    /// Divides the box from `low` to `high` into columns and rows.
    ///
    /// # Errors
    /// [`Error::BadGrid`] unless the corners are finite, the box has a positive size, and there are at least one
    /// and at most 2³⁰ cells.
    pub fn with_size(low: Point, high: Point, columns: usize, rows: usize) -> Result<Self, Error> {
        let [width, height] = extent(low, high)?;
        let cell = [width / columns as f64, height / rows as f64];
        Self::of(low, cell, columns as f64, rows as f64)
    }

    fn of(low: Point, cell: [f64; 2], columns: f64, rows: f64) -> Result<Self, Error> {
        let total = columns * rows;
        let fits = (1.0..=MOST_CELLS).contains(&total);
        require_that(
            "number of cells",
            total,
            fits,
            "from 1 to 2^30 are possible",
        )?;
        for side in cell {
            require("side of a cell", side, side > 0.0 && side.is_finite())?;
        }
        Ok(Self {
            low,
            cell,
            columns: columns as usize,
            rows: rows as usize,
        })
    }

    /// Returns the lower left corner.
    pub fn low(&self) -> Point {
        self.low
    }

    /// Returns width and height of a cell.
    pub fn cell(&self) -> [f64; 2] {
        self.cell
    }

    /// Counts the columns.
    pub fn columns(&self) -> usize {
        self.columns
    }

    /// Counts the rows.
    pub fn rows(&self) -> usize {
        self.rows
    }

    /// Returns the centre of a cell, rounded; row 0 is the top one.
    pub fn center(&self, column: usize, row: usize) -> Point {
        let upwards = (self.rows as f64 - row as f64) - 0.5;
        Point::new(
            self.low.x + (column as f64 + 0.5) * self.cell[0],
            self.low.y + upwards * self.cell[1],
        )
    }
}

fn extent(low: Point, high: Point) -> Result<[f64; 2], Error> {
    let extent = [high.x - low.x, high.y - low.y];
    for (what, side) in ["width", "height"].into_iter().zip(extent) {
        require(what, side, side > 0.0 && side.is_finite())?;
    }
    Ok(extent)
}

fn require(what: &'static str, given: f64, holds: bool) -> Result<(), Error> {
    require_that(what, given, holds, "it must be positive and finite")
}

fn require_that(
    what: &'static str,
    given: f64,
    holds: bool,
    must: &'static str,
) -> Result<(), Error> {
    match holds {
        true => Ok(()),
        false => Err(Error::BadGrid { what, given, must }),
    }
}

/// The values of a surface at the centres of the cells of a grid.
#[derive(Clone, Debug)]
pub struct Raster {
    grid: Grid,
    /// Row by row from the top; NaN where there is none.
    values: Vec<f64>,
}

impl Raster {
    pub(super) fn new(grid: Grid, values: Vec<f64>) -> Self {
        debug_assert_eq!(values.len(), grid.columns * grid.rows);
        Self { grid, values }
    }

    /// Returns the cells.
    pub fn grid(&self) -> &Grid {
        &self.grid
    }

    /// Returns the value of a cell; `None` where the surface has none. Row 0 is the top one.
    ///
    /// # Panics
    /// If there is no such cell.
    pub fn value(&self, column: usize, row: usize) -> Option<f64> {
        assert!(column < self.grid.columns, "no column {column}");
        let value = self.values[row * self.grid.columns + column];
        (!value.is_nan()).then_some(value)
    }

    /// Visits the rows from the top, NaN where there is no value: as files of rasters have it.
    pub fn rows(&self) -> impl ExactSizeIterator<Item = &[f64]> {
        self.values.chunks(self.grid.columns)
    }

    /// Returns the least and the largest value; `None` if there is none.
    pub fn range(&self) -> Option<[f64; 2]> {
        let values = self.values.iter().filter(|value| !value.is_nan());
        let values = values.map(|&value| [value; 2]);
        values.reduce(|[low, high], [value, _]| [low.min(value), high.max(value)])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const LOW: Point = Point::new(1.0, 2.0);
    const HIGH: Point = Point::new(4.0, 4.0);

    #[test]
    fn cells_cover_the_box() {
        let grid = Grid::with_cells(LOW, HIGH, 0.1).expect("a grid");
        assert_eq!((grid.columns(), grid.rows()), (30, 20));
        let grid = Grid::with_cells(LOW, HIGH, 0.8).expect("a grid");
        assert_eq!((grid.columns(), grid.rows()), (4, 3));
        let grid = Grid::with_size(LOW, HIGH, 3, 4).expect("a grid");
        assert_eq!(grid.cell(), [1.0, 0.5]);
        assert_eq!(grid.center(0, 0), Point::new(1.5, 3.75));
        assert_eq!(grid.center(2, 3), Point::new(3.5, 2.25));
    }

    #[test]
    fn what_makes_no_sense_is_refused() {
        let text = |result: Result<Grid, Error>| result.expect_err("refused").to_string();
        for cell in [0.0, -1.0, f64::NAN, f64::INFINITY] {
            assert!(text(Grid::with_cells(LOW, HIGH, cell)).contains("side of a cell"));
        }
        assert!(text(Grid::with_cells(LOW, HIGH, 1e-9)).contains("number of cells"));
        assert!(text(Grid::with_size(LOW, HIGH, 0, 4)).contains("number of cells"));
        assert!(text(Grid::with_size(LOW, HIGH, usize::MAX, 4)).contains("number of cells"));
        assert!(text(Grid::with_size(HIGH, LOW, 4, 4)).contains("width"));
        let far = Point::new(f64::MAX, f64::MAX);
        assert!(text(Grid::with_size(Point::new(-f64::MAX, 0.0), far, 4, 4)).contains("width"));
    }
}
