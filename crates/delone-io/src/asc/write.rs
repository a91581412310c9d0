//! Writing.
//!
//! Six lines of header and the rows from the top. Cells that are not square have `dx` and `dy` instead of
//! `cellsize`, as GDAL writes and reads them.

use crate::Error;
use crate::target::Output;
use delone::surface::Raster;

/// Writes a raster.
pub(crate) fn write(out: &mut Output<'_>, raster: &Raster) -> Result<(), Error> {
    let grid = raster.grid();
    let missing = missing_value(raster);
    let integers = [("ncols", grid.columns()), ("nrows", grid.rows())];
    for (name, number) in integers {
        out.text(format_args!("{name} {number}\n"))?;
    }
    let [dx, dy] = grid.cell();
    let low = grid.low();
    let mut numbers = vec![("xllcorner", low.x), ("yllcorner", low.y)];
    match dx == dy {
        true => numbers.push(("cellsize", dx)),
        false => numbers.extend([("dx", dx), ("dy", dy)]),
    }
    numbers.push(("NODATA_value", missing));
    for (name, number) in numbers {
        out.text(format_args!("{name} "))?;
        out.number(number);
        out.separator(b'\n');
    }
    for row in raster.rows() {
        for (i, &value) in row.iter().enumerate() {
            if i > 0 {
                out.blank();
            }
            out.number(if value.is_nan() { missing } else { value });
        }
        out.end_line()?;
    }
    Ok(())
}

/// Returns −9999, or with more nines, which no cell has.
fn missing_value(raster: &Raster) -> f64 {
    let mut missing = -9999.0;
    while raster.rows().flatten().any(|&value| value == missing) {
        missing = missing * 10.0 - 9.0;
    }
    missing
}
