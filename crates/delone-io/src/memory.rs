//! Files in memory: for browsers, which have no others, and for whoever wants bytes.

use crate::Error;
use std::cell::RefCell;
use std::path::{Path, PathBuf};

/// A file that was written into memory.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct MemoryFile {
    /// The name that the file would have had.
    pub name: PathBuf,
    /// Its content.
    pub bytes: Vec<u8>,
}

thread_local! {
    /// What takes the files of this thread, innermost last.
    static SHELVES: RefCell<Vec<Vec<MemoryFile>>> = const { RefCell::new(Vec::new()) };
}

/// Keeps in memory every file that `work` writes on this thread, instead of the file system: whatever the
/// [target](crate::Target) names. Returns the files in the order in which they were written, those of one name
/// once, as they were last.
///
/// ```
/// use delone_io::{MeshView, Target, WriteOptions, in_memory, write_mesh};
///
/// let t = delone::triangulate([(0.0, 0.0), (1.0, 0.0), (0.0, 1.0)])?;
/// let targets = [Target::from_arg("three.ele", None)];
/// let options = WriteOptions::default();
/// let work = || write_mesh(&targets, &MeshView::from(&t), &options, &());
/// let (written, files) = in_memory(work)?;
/// assert_eq!(written.len(), files.len()); // three.node, .ele, .edge and .neigh
/// assert!(files[0].bytes.starts_with(b"3 2 0 1\n"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// Those of `work`; then nothing is kept.
pub fn in_memory<T>(
    work: impl FnOnce() -> Result<T, Error>,
) -> Result<(T, Vec<MemoryFile>), Error> {
    let shelf = Shelf::put_up();
    let done = work()?;
    Ok((done, shelf.take_down()))
}

/// A place for files, which is taken away in any case.
struct Shelf;

impl Shelf {
    fn put_up() -> Self {
        SHELVES.with_borrow_mut(|shelves| shelves.push(Vec::new()));
        Self
    }

    fn take_down(self) -> Vec<MemoryFile> {
        SHELVES
            .with_borrow_mut(|shelves| shelves.last_mut().map(std::mem::take).unwrap_or_default())
    }
}

impl Drop for Shelf {
    fn drop(&mut self) {
        SHELVES.with_borrow_mut(Vec::pop);
    }
}

/// Tells whether files of this thread stay in memory.
pub(crate) fn is_wanted() -> bool {
    SHELVES.with_borrow(|shelves| !shelves.is_empty())
}

/// Keeps a complete file.
pub(crate) fn keep(name: &Path, bytes: Vec<u8>) {
    SHELVES.with_borrow_mut(|shelves| {
        let Some(shelf) = shelves.last_mut() else {
            return;
        };
        shelf.retain(|file| file.name != name);
        shelf.push(MemoryFile {
            name: name.to_owned(),
            bytes,
        });
    });
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{PointSet, Target, WriteOptions, write_points};
    use delone::Point;

    fn write(name: &str) -> Result<Vec<PathBuf>, Error> {
        let set = PointSet {
            points: vec![Point::new(1.0, 2.0)],
            ..PointSet::default()
        };
        let target = Target::from_arg(name, None);
        write_points(&[target], &set, &WriteOptions::default(), &())
    }

    #[test]
    fn files_stay_in_memory_and_the_last_of_a_name_counts() {
        let twice = || write("nowhere/at/all.csv").and_then(|_| write("nowhere/at/all.csv"));
        let (written, files) = in_memory(twice).expect("files in memory");
        assert_eq!(written, [PathBuf::from("nowhere/at/all.csv")]);
        assert_eq!(files.len(), 1);
        assert_eq!(files[0].bytes, b"x,y\n1,2\n");
        write("nowhere/at/all.csv").unwrap_err(); // the file system has no such folder
    }

    #[test]
    fn what_fails_leaves_nothing() {
        let failing = || write("a.csv").and_then(|_| write("a.unknown"));
        in_memory(failing).unwrap_err();
        assert!(!is_wanted());
    }

    #[test]
    fn inner_files_are_not_outer_ones() {
        let nested = || {
            let (_, inner) = in_memory(|| write("inner.csv"))?;
            write("outer.csv").map(|_| inner)
        };
        let (inner, outer) = in_memory(nested).expect("files in memory");
        let names = |files: &[MemoryFile]| files.iter().map(|f| f.name.clone()).collect::<Vec<_>>();
        assert_eq!(names(&inner), [PathBuf::from("inner.csv")]);
        assert_eq!(names(&outer), [PathBuf::from("outer.csv")]);
    }
}
