//! How many data each triangle of a mesh holds.

use crate::Error;
use delone::Point;

/// How many data each triangle of a mesh holds, and the data: for pictures, which then show that in place of angles.
///
/// ```
/// use delone::scattered::cover;
/// use delone_io::{Counts, MeshView, Target, WriteOptions};
///
/// # let folder = tempfile::tempdir()?;
/// let lattice = (0..100).map(|i| (f64::from(i % 10), f64::from(i / 10)));
/// let cover = cover(lattice, 5)?;
/// let held = cover.counts();
/// let counts = Counts { held: &held, range: [cover.least(), cover.most()], data: cover.data() };
/// let mesh = MeshView::new(cover.points(), cover.triangles()).with_counts(&counts);
/// let target = Target::from_arg(folder.path().join("cover.svg"), None);
/// assert_eq!(delone_io::write_mesh(&[target], &mesh, &WriteOptions::default(), &())?.len(), 1);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Counts<'a> {
    /// One number for each triangle.
    pub held: &'a [usize],
    /// Fewest and most that a triangle should hold: the ends of the scale of colours. Triangles that hold more have
    /// a colour of their own.
    pub range: [usize; 2],
    /// The data.
    pub data: &'a [Point],
}

impl Counts<'_> {
    /// Checks that there is one number for each of so many triangles.
    pub(crate) fn validate(&self, triangles: usize) -> Result<(), Error> {
        let [least, most] = self.range;
        if self.held.len() != triangles {
            let found = self.held.len();
            return Err(Error::BadMesh(format!(
                "the table of data held has {found} values for {triangles}"
            )));
        }
        if least > most {
            return Err(Error::BadMesh(format!(
                "triangles should hold from {least} to {most} data: that is none"
            )));
        }
        Ok(())
    }
}
