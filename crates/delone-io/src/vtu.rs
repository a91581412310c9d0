//! `.vtu`: VTK's unstructured grid in XML, as ParaView, meshio and PyVista open it.
//!
//! *VTK File Formats*, <https://docs.vtk.org/en/latest/vtk_file_formats/index.html>. Written are the points
//! with z = 0, the triangles, attributes as point and cell data, all arrays inline in base64 without
//! compression; constrained edges follow as lines, with the cell data `marker` (0 for triangles) and
//! `region` (−1 where there is none). Read are triangles, also as polygons and in strips, and lines as constrained
//! edges, both also with the midpoints of their edges; arrays as text or bytes, inline or appended, raw or in base64, as
//! such or compressed by zlib; LZ4 and LZMA are refused. Cells that are vertices are passed over. A z that is not zero
//! everywhere becomes an attribute, as does each component of data that have several.

mod array;
mod cells;
mod elements;
mod grid;
mod packed;
mod read;
mod write;

pub(crate) use cells::write_cells;
pub(crate) use grid::{Data, Grid};
pub(crate) use read::{read_mesh, sniff};
pub(crate) use write::{Cell, cell, regions, write};

use crate::{Problem, cancel};
use delone::Watch;

/// VTK's number for a triangle.
const TRIANGLE: u8 = 5;

/// VTK's number for a line of two vertices.
const LINE: u8 = 3;

/// VTK's number for a polygon, which has no holes.
const POLYGON: u8 = 7;

/// VTK's number for a triangle with the midpoints of edge 01, 12 and 20.
const QUADRATIC_TRIANGLE: u8 = 22;

/// VTK's number for a line with its midpoint.
const QUADRATIC_LINE: u8 = 21;

/// Why reading stopped early.
pub(crate) enum Stop {
    Problem(Problem),
    Cancelled,
}

impl From<Problem> for Stop {
    fn from(problem: Problem) -> Self {
        Self::Problem(problem)
    }
}

fn other(text: impl Into<String>) -> Problem {
    Problem::Other(text.into())
}

/// Stops once the watch has cancelled; asks it in one of many rounds.
fn poll(watch: &dyn Watch, round: usize) -> Result<(), Stop> {
    cancel::check(watch, round).map_err(|_| Stop::Cancelled)
}
