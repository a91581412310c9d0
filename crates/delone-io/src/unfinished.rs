//! Temporary files of this process, listed so that it may end at any moment and leave none.
//!
//! Ordinarily a temporary file goes when its owner is dropped. A program that is asked to end while
//! a thread is deep in other work cannot wait for that: [`discard_unfinished_files`] is for it.

use std::collections::BTreeSet;
use std::fs::{self, File, OpenOptions};
use std::io;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};
use tempfile::TempPath;

/// Most bytes of a name that are part of a temporary one; file systems take 255.
const LONGEST: usize = 200;

static FILES: Mutex<BTreeSet<PathBuf>> = Mutex::new(BTreeSet::new());

fn files() -> MutexGuard<'static, BTreeSet<PathBuf>> {
    // Whoever panicked while holding the lock left a list that is still right.
    FILES.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Removes every temporary file of this process and lets it make no more; then end the process.
///
/// Files that are being renamed just now are all renamed before. Threads that go on to write files
/// block for ever, so this is for programs about to exit, from a handler of Ctrl-C for example.
pub fn discard_unfinished_files() {
    let files = files();
    for file in files.iter() {
        // Nobody is left to be told of a failure.
        drop(fs::remove_file(file));
    }
    std::mem::forget(files);
}

/// A temporary file; dropping it removes it.
pub(crate) struct Unfinished(Option<TempPath>);

impl Unfinished {
    /// Creates a file with a temporary name in the directory of `place`.
    pub fn create_beside(place: &Path) -> io::Result<(File, Self)> {
        let mut files = files();
        let (file, path) = create_beside(place)?;
        files.insert(path.to_path_buf());
        Ok((file, Self(Some(path))))
    }
}

impl Drop for Unfinished {
    fn drop(&mut self) {
        if let Some(path) = self.0.take() {
            let mut files = files();
            files.remove(path.as_ref() as &Path);
            // Within the lock: a process that ends now must not leave it behind.
            drop(path);
        }
    }
}

/// A file that could not get its name.
#[derive(Debug)]
pub(crate) struct NotRenamed {
    pub place: PathBuf,
    pub source: io::Error,
    /// Those that have got theirs before.
    pub replaced: Vec<PathBuf>,
}

/// Gives every file its name; stops at the first that cannot be renamed, and removes the rest.
pub(crate) fn persist_all(unfinished: Vec<(Unfinished, PathBuf)>) -> Result<(), NotRenamed> {
    let mut files = files();
    let paths: Vec<(TempPath, PathBuf)> = unfinished
        .into_iter()
        .filter_map(|(mut file, place)| file.0.take().map(|path| (path, place)))
        .collect();
    for (path, _) in &paths {
        files.remove(path.as_ref() as &Path);
    }
    let mut replaced = Vec::new();
    for (path, place) in paths {
        if let Err(error) = path.persist(&place) {
            let source = error.error;
            return Err(NotRenamed {
                place,
                source,
                replaced,
            });
        }
        replaced.push(place);
    }
    Ok(())
}

fn create_beside(place: &Path) -> io::Result<(File, TempPath)> {
    let directory = match place.parent() {
        Some(parent) if !parent.as_os_str().is_empty() => parent,
        _ => Path::new("."),
    };
    let mut prefix = std::ffi::OsString::from(".");
    let name = place.file_name().unwrap_or_default();
    if name.len() <= LONGEST {
        prefix.push(name);
    } else {
        // A name that is as long as names may be leaves no room for what comes before and behind.
        let text = name.to_string_lossy();
        prefix.push(&text[..text.floor_char_boundary(LONGEST)]);
    }
    prefix.push(".");
    let mut builder = tempfile::Builder::new();
    builder.prefix(&prefix).suffix(".tmp");
    let mut reason = None;
    let created = builder.make_in(directory, |path| {
        // On Unix, what the umask leaves of the permissions is what any program would have created.
        let file = OpenOptions::new().write(true).create_new(true).open(path);
        file.inspect_err(|error| reason = error.raw_os_error())
    });
    // The other error tells the temporary name, which says nothing to anybody.
    let without_name = |error| reason.map_or(error, io::Error::from_raw_os_error);
    Ok(created.map_err(without_name)?.into_parts())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_failed_rename_names_the_files_before_it() {
        let folder = tempfile::tempdir().expect("a temporary folder");
        let places = ["a", "b", "c"].map(|name| folder.path().join(name));
        let files = places.clone().map(|place| {
            let (_, file) = Unfinished::create_beside(&place).expect("the folder is writable");
            (file, place)
        });
        // A file cannot replace a folder.
        fs::create_dir(&places[1]).expect("the folder is writable");
        let error = persist_all(files.into()).expect_err("b is a folder");
        assert_eq!(error.place, places[1]);
        assert_eq!(error.replaced, places[..1]);
        let entries = fs::read_dir(folder.path()).expect("the folder is there");
        assert_eq!(entries.count(), 2, "c is not left under any name");
    }

    #[test]
    fn files_are_listed_until_they_are_dropped_or_have_their_names() {
        let folder = tempfile::tempdir().expect("a temporary folder");
        let place = folder.path().join("a.txt");
        let [kept, dropped] = [(); 2].map(|()| {
            let (_, file) = Unfinished::create_beside(&place).expect("the folder is writable");
            file
        });
        let here = || {
            files()
                .iter()
                .filter(|f| f.starts_with(folder.path()))
                .count()
        };
        assert_eq!(here(), 2);
        drop(dropped);
        assert_eq!(here(), 1);
        persist_all(vec![(kept, place.clone())]).expect("the folder is writable");
        assert_eq!(here(), 0);
        let entries = fs::read_dir(folder.path()).expect("the folder is there");
        assert_eq!(entries.count(), 1);
        assert!(place.is_file());
    }
}
