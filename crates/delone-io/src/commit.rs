//! Files of several writers that get their names together.

use crate::Error;
use crate::target::give_names;
use crate::unfinished::Unfinished;
use std::cell::RefCell;
use std::marker::PhantomData;
use std::path::PathBuf;

/// A complete file and the name that it is going to have.
pub(crate) type Complete = (Unfinished, PathBuf);

thread_local! {
    /// Files of this thread that wait for others, those of the innermost commit last.
    static WAITING: RefCell<Vec<Vec<Complete>>> = const { RefCell::new(Vec::new()) };
}

/// Lets all files that are written on this thread get their names together, whoever writes them: all appear, or none.
/// Dropping it leaves none.
///
/// What goes to standard output, or to devices, is written at once.
///
/// ```
/// use delone_io::{Commit, MeshView, PictureOptions, Target, WriteOptions, write_mesh, write_points, PointSet};
///
/// let folder = tempfile::tempdir()?;
/// let t = delone::triangulate([(0.0, 0.0), (1.0, 0.0), (0.0, 1.0)])?;
/// let at = |name: &str| [Target::from_arg(folder.path().join(name), None)];
/// let options = WriteOptions::default();
/// let commit = Commit::begin();
/// write_mesh(&at("mesh.vtu"), &MeshView::from(&t), &options, &())?;
/// let points = PointSet { points: t.points().to_vec(), ..PointSet::default() };
/// write_points(&at("points.csv"), &points, &options, &())?;
/// assert!(!folder.path().join("mesh.vtu").exists());
/// commit.finish()?;
/// assert!(folder.path().join("mesh.vtu").exists() && folder.path().join("points.csv").exists());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[must_use = "without `finish` no file gets its name"]
pub struct Commit {
    /// The files are those of one thread.
    _of_thread: PhantomData<*const ()>,
}

impl Commit {
    /// Begins: from now on files wait.
    pub fn begin() -> Self {
        WAITING.with_borrow_mut(|waiting| waiting.push(Vec::new()));
        Self {
            _of_thread: PhantomData,
        }
    }

    /// Gives all files their names.
    ///
    /// # Errors
    /// If one cannot be renamed: those before it stay, the error names them, and the others are gone.
    pub fn finish(self) -> Result<(), Error> {
        let files = WAITING.with_borrow_mut(|waiting| waiting.last_mut().map(std::mem::take));
        give_names(files.unwrap_or_default())
    }
}

impl Drop for Commit {
    fn drop(&mut self) {
        let files = WAITING.with_borrow_mut(Vec::pop);
        // Removed here, where nothing is borrowed.
        drop(files);
    }
}

/// Lets files wait if others of this thread do; returns them if not.
pub(crate) fn wait(files: Vec<Complete>) -> Option<Vec<Complete>> {
    WAITING.with_borrow_mut(|waiting| match waiting.last_mut() {
        Some(others) => {
            others.extend(files);
            None
        }
        None => Some(files),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{PointSet, Target, WriteOptions, write_points};
    use delone::Point;
    use std::path::Path;

    fn write(folder: &Path, name: &str) -> Result<Vec<PathBuf>, Error> {
        let set = PointSet {
            points: vec![Point::new(1.0, 2.0)],
            ..PointSet::default()
        };
        let target = Target::from_arg(folder.join(name), None);
        write_points(&[target], &set, &WriteOptions::default(), &())
    }

    fn names(folder: &Path) -> Vec<String> {
        let entries = folder.read_dir().expect("a folder");
        let name = |e: std::io::Result<std::fs::DirEntry>| e.expect("an entry").file_name();
        let mut names: Vec<_> = entries
            .map(|e| name(e).into_string().expect("UTF-8"))
            .collect();
        names.sort();
        names
    }

    #[test]
    fn all_files_appear_or_none() {
        let folder = tempfile::tempdir().expect("a temporary folder");
        let at = folder.path();
        let commit = Commit::begin();
        write(at, "a.csv").expect("it is writable");
        write(at, "b.csv").expect("it is writable");
        write(at, "c.unknown").unwrap_err();
        drop(commit);
        assert_eq!(names(at), [""; 0], "not even temporary files");
        let commit = Commit::begin();
        write(at, "a.csv").expect("it is writable");
        write(at, "b.csv").expect("it is writable");
        assert!(names(at).iter().all(|name| name.ends_with(".tmp")));
        commit.finish().expect("they can be renamed");
        assert_eq!(names(at), ["a.csv", "b.csv"]);
        // Then all is as it was.
        write(at, "c.csv").expect("it is writable");
        assert_eq!(names(at).len(), 3);
    }

    #[test]
    fn files_of_other_threads_do_not_wait() {
        let folder = tempfile::tempdir().expect("a temporary folder");
        let at = folder.path();
        let commit = Commit::begin();
        std::thread::scope(|scope| {
            scope.spawn(|| write(at, "other.csv").expect("it is writable"));
        });
        assert_eq!(names(at), ["other.csv"]);
        drop(commit);
    }
}
