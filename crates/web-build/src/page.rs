//! The page: what npm makes of `web/`, in `web/dist/`.

use crate::failure::Failure;
use crate::node;
use crate::options::Options;
use crate::place::root;
use crate::stale::{below, is_fresh};
use crate::weight::Budget;
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

#[cfg(test)]
mod tests {
    use super::*;

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
