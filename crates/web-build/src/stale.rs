//! What has been built already: files, their times, and which came later.
//!
//! Only asked where somebody waits for the theatre to open. Times are no proof, so that whoever builds without opening
//! gets everything anew.

use crate::failure::Failure;
use std::fs;
use std::path::{Path, PathBuf};
use std::time::SystemTime;

/// Lists files and folders below a folder, sorted, leaving out what is hidden or has one of some names.
pub fn below(root: &Path, without: &[&str]) -> Result<Vec<PathBuf>, Failure> {
    let mut found = Vec::new();
    let mut folders = vec![root.to_owned()];
    while let Some(folder) = folders.pop() {
        let unreadable = || Failure::file("cannot read", &folder);
        for entry in fs::read_dir(&folder).map_err(unreadable())? {
            let entry = entry.map_err(unreadable())?;
            let name = entry.file_name();
            let is_hidden = name.as_encoded_bytes().starts_with(b".");
            if is_hidden || without.iter().any(|left_out| name == *left_out) {
                continue;
            }
            // A link is followed by nobody: it could lead back here.
            if entry.file_type().map_err(unreadable())?.is_dir() {
                folders.push(entry.path());
            }
            found.push(entry.path());
        }
    }
    found.sort();
    Ok(found)
}

/// Tells whether a file is there, and none of its sources has changed after it.
pub fn is_fresh<'f>(built: &Path, sources: impl IntoIterator<Item = &'f Path>) -> bool {
    let is_older = |built| move |source| changed(source).is_some_and(|source| source <= built);
    changed(built).is_some_and(|built| sources.into_iter().all(is_older(built)))
}

fn changed(path: &Path) -> Option<SystemTime> {
    fs::metadata(path).and_then(|m| m.modified()).ok()
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::time::Duration;

    #[test]
    fn folders_are_listed_without_what_is_left_out() {
        let folder = tempfile::tempdir().expect("a folder");
        let root = folder.path();
        for name in ["src/b", "dist", "deep/dist"] {
            fs::create_dir_all(root.join(name)).expect("a folder");
        }
        for name in ["src/b/c.ts", ".hidden", "dist/x.js", "deep/dist/y.js"] {
            fs::write(root.join(name), "").expect("a file");
        }
        let found = below(root, &["dist"]).expect("folders that can be read");
        let expected = ["deep", "src", "src/b", "src/b/c.ts"].map(|name| root.join(name));
        assert_eq!(found, expected);
        below(&root.join("nowhere"), &[]).expect_err("no folder");
    }

    #[test]
    fn what_is_older_than_its_sources_is_stale() {
        let folder = tempfile::tempdir().expect("a folder");
        let at = |name: &str, seconds| {
            let path = folder.path().join(name);
            let file = fs::File::create(&path).expect("a file");
            let time = SystemTime::UNIX_EPOCH + Duration::from_secs(seconds);
            file.set_modified(time).expect("a time");
            path
        };
        let (old, built, new) = (at("old", 1000), at("built", 2000), at("new", 3000));
        assert!(is_fresh(&built, [old.as_path(), &built]));
        assert!(!is_fresh(&built, [old.as_path(), &new]));
        assert!(!is_fresh(&built, [folder.path().join("nowhere").as_path()]));
        assert!(!is_fresh(&folder.path().join("nowhere"), []));
    }
}
