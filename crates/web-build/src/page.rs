//! The page: what npm makes of `web/`, in `web/dist/`.

use crate::failure::Failure;
use crate::node;
use crate::options::Options;
use crate::place::root;
use crate::stale::{below, is_fresh};
use crate::weight::Budget;
use std::fs;
use std::path::{Path, PathBuf};

/// What scripts and styles may weigh together. The module has a budget of its own.
const BUDGET: Budget = Budget {
    what: "scripts and styles",
    bytes: 250_000,
};

/// Below `web/`, what the page is not made of.
const APART: [&str; 4] = ["dist", "node_modules", "tests", "test-results"];

/// What it is made of besides: the guide.
const GUIDE: [&str; 2] = ["docs/algorithms", "REFERENCES.md"];

/// What keeps the folder in the repository, and its content out: `delone-cli` looks at the folder when it is built.
const KEEPER: &str = ".gitignore";

/// Builds the page; if it is to be opened, only if it is stale.
pub fn build(options: &Options) -> Result<(), Failure> {
    let web = root().join("web");
    let dist = web.join("dist");
    let start = dist.join("index.html");
    if !options.builds_all() && is_fresh(&start, sources(&web)?.iter().map(PathBuf::as_path)) {
        println!("page:      up to date");
    } else {
        println!("node:      {}", node::require()?);
        node::install(&web)?;
        empty(&dist)?;
        node::script(&web, "build")?;
    }
    if !start.is_file() {
        return Err(Failure::NoPage(start));
    }
    let files = below(&dist, &[])?;
    let sent = files.iter().map(PathBuf::as_path);
    BUDGET.weigh(sent.filter(|file| is_code(file)))?;
    println!("written:   {}", dist.display());
    Ok(())
}

/// Lists what the page is made of.
fn sources(web: &Path) -> Result<Vec<PathBuf>, Failure> {
    let mut sources = below(web, &APART)?;
    for name in GUIDE {
        let path = root().join(name);
        if path.is_dir() {
            sources.extend(below(&path, &[])?);
        }
        sources.push(path);
    }
    Ok(sources)
}

/// Tells whether a file is a script or a style.
fn is_code(file: &Path) -> bool {
    let extension = file.extension();
    extension.is_some_and(|e| ["js", "mjs", "css"].iter().any(|code| e == *code))
}

/// Removes what an earlier build has left, which the bundler would keep, under names of its own.
fn empty(dist: &Path) -> Result<(), Failure> {
    let unreadable = || Failure::file("cannot read", dist);
    fs::create_dir_all(dist).map_err(Failure::file("cannot create", dist))?;
    for entry in fs::read_dir(dist).map_err(unreadable())? {
        let entry = entry.map_err(unreadable())?;
        if entry.file_name() == KEEPER {
            continue;
        }
        let path = entry.path();
        let is_folder = entry.file_type().map_err(unreadable())?.is_dir();
        let removed = match is_folder {
            true => fs::remove_dir_all(&path),
            false => fs::remove_file(&path),
        };
        removed.map_err(Failure::file("cannot remove", &path))?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_earlier_build_goes_and_the_folder_stays() {
        let folder = tempfile::tempdir().expect("a folder");
        let dist = folder.path().join("dist");
        empty(&dist).expect("a new folder");
        fs::create_dir(dist.join("assets")).expect("a folder");
        for name in [KEEPER, "index.html", "assets/a.js"] {
            fs::write(dist.join(name), "").expect("a file");
        }
        empty(&dist).expect("it can be emptied");
        let left = fs::read_dir(&dist)
            .expect("the folder")
            .map(|e| e.expect("an entry").file_name());
        assert_eq!(left.collect::<Vec<_>>(), [KEEPER]);
    }

    #[test]
    fn scripts_and_styles_count() {
        for (name, expected) in [
            ("a.js", true),
            ("a.css", true),
            ("a.wasm", false),
            ("js", false),
        ] {
            assert_eq!(is_code(Path::new(name)), expected, "{name}");
        }
    }
}
