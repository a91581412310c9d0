//! `.poly`: planar straight-line graphs of Triangle; only the points are handed out.
//!
//! A `.node` file without an end, then `s markers` and rows `number a b [marker]` for the segments,
//! then `h` and rows `number x y` for the holes, then perhaps regions. Zero points mean that they
//! stand in the `.node` file of the same stem. Segments are checked, so that a broken file is not
//! taken for a good one; holes and regions are not looked at.

use crate::scan::Scanner;
use crate::triangle_files::{self, Block, Header};
use crate::{Error, PointSet, Problem, node};
use delone::Watch;

/// Reads the points; `elsewhere` reads the `.node` file if the points stand there.
pub(crate) fn read_points(
    file: &str,
    bytes: &[u8],
    watch: &dyn Watch,
    elsewhere: impl FnOnce() -> Result<PointSet, Error>,
) -> Result<PointSet, Error> {
    let mut scanner = Scanner::new(file, bytes, watch);
    let header = Header::read(&mut scanner)?;
    let points = if header.get(0, 0) == 0 {
        elsewhere()?
    } else {
        node::read_block(&mut scanner, &header)?
    };
    check_segments(&mut scanner, &points)?;
    Ok(points)
}

fn check_segments(scanner: &mut Scanner<'_>, points: &PointSet) -> Result<(), Error> {
    let header = Header::read(scanner).map_err(|error| match error {
        Error::Malformed {
            problem: Problem::Empty,
            ..
        } => scanner.here(Problem::Other(
            "truncated: no header of segments".to_owned(),
        )),
        other => other,
    })?;
    let block = Block {
        items: "segments",
        declared: header.count(scanner, 0, "segments")?,
        columns: 3 + usize::from(header.count(scanner, 1, "markers")? > 0),
        base: (!points.points.is_empty()).then_some(points.base),
    };
    block.read(scanner, |number, cells| {
        for cell in &cells[..2] {
            let item = ("segment", number);
            triangle_files::vertex(cell, item, points.base, points.points.len())?;
        }
        Ok(())
    })?;
    Ok(())
}
