//! `.area`: the largest area of each triangle of a mesh, of Triangle; read only.
//!
//! Header `m`, then a row `number area` for each triangle of the `.ele` file of the same stem,
//! numbered as it is; an area that is not positive is no bound.

use crate::scan::Scanner;
use crate::triangle_files::{self, Block, Header};
use crate::{Error, Problem, Source};
use delone::Watch;

/// Reads the bounds on the areas of the `triangles` triangles of a mesh; `None` where there is none.
///
/// # Errors
/// If the file cannot be read, is malformed or speaks of another number of triangles (message with
/// file and line), or the watch cancels.
///
/// *Cost*: time and memory proportional to the file.
///
/// ```
/// use delone_io::{Source, read_areas};
/// let (name, bytes) = ("mesh.area".to_owned(), b"2\n1 0.5\n2 -1\n".to_vec());
/// let source = Source::Memory { name, bytes };
/// assert_eq!(read_areas(&source, 2, &())?, [Some(0.5), None]);
/// assert!(read_areas(&source, 3, &()).is_err());
/// # Ok::<(), delone_io::Error>(())
/// ```
pub fn read_areas(
    source: &Source,
    triangles: usize,
    watch: &dyn Watch,
) -> Result<Vec<Option<f64>>, Error> {
    let bytes = source.load(watch)?;
    let file = source.to_string();
    let mut scanner = Scanner::new(&file, &bytes, watch);
    let header = Header::read(&mut scanner)?;
    let declared = header.count(&scanner, 0, "triangles")?;
    if declared != triangles as u64 {
        let problem = format!("bounds for {declared} triangles, but the mesh has {triangles}");
        return Err(header.problem(&scanner, Problem::Other(problem)));
    }
    let block = Block {
        items: "triangles",
        declared,
        columns: 2,
        base: None,
    };
    let mut areas = Vec::new();
    scanner.reserve(&mut areas, 2 * block.columns, declared);
    block.read(&mut scanner, |number, cells| {
        let area = triangle_files::number(cells[0], "largest area")?;
        if area.is_nan() {
            let problem =
                format!("the largest area of triangle {number} is NaN; write -1 for none");
            return Err(Problem::Other(problem));
        }
        areas.push((area > 0.0).then_some(area));
        Ok(())
    })?;
    triangle_files::expect_end(&mut scanner, "triangles", declared)?;
    Ok(areas)
}
