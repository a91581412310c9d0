//! `.asc`: ESRI's ASCII grid, in the corner or the centres of its cells, square or (as GDAL has it) not.
//!
//! Esri, *ASCII to Raster*: lines of header, `ncols`, `nrows`, `xllcorner` or `xllcenter`, `yllcorner` or
//! `yllcenter`, `cellsize` or `dx` and `dy`, `NODATA_value` (−9999 unless it is said), in any order and any case;
//! then the values, row after row from the top.
//!
//! Read are the centres of cells as points, with the attribute `z`; cells without value, or whose value is NaN, are
//! no points. A centre is the double nearest to what the decimals of the header say, see [`decimal`](crate::decimal).
//!
//! *Cost*: about 50 ns a cell.

mod read;
mod write;

pub(crate) use read::{read_points, sniff};
pub(crate) use write::write;
