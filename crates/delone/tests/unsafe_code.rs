//! Every `unsafe` of the workspace is listed in `docs/hardening.md`, with its count, and none is anywhere else.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

/// Counts blocks, implementations and functions that are unsafe, outside of comments.
fn count(text: &str) -> usize {
    let code = text.lines().filter(|l| !l.trim_start().starts_with("//"));
    let kinds = ["{", "impl", "fn"].map(|kind| format!("unsafe {kind}"));
    code.map(|line| {
        kinds
            .iter()
            .map(|k| line.matches(k.as_str()).count())
            .sum::<usize>()
    })
    .sum()
}

fn walk(root: &Path, folder: &Path, found: &mut BTreeMap<String, usize>) {
    for entry in fs::read_dir(folder).expect("a folder") {
        let path = entry.expect("an entry").path();
        if path.is_dir() {
            if !path.ends_with("target") && !path.ends_with("node_modules") {
                walk(root, &path, found);
            }
        } else if path.extension().is_some_and(|e| e == "rs") && !path.ends_with("unsafe_code.rs") {
            let n = count(&fs::read_to_string(&path).expect("UTF-8"));
            if n > 0 {
                let name = path.strip_prefix(root).expect("it is below").display();
                found.insert(name.to_string().replace('\\', "/"), n);
            }
        }
    }
}

#[test]
fn all_unsafe_code_is_listed() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let mut found = BTreeMap::new();
    for folder in ["crates", "fuzz"] {
        walk(&root, &root.join(folder), &mut found);
    }
    let page = fs::read_to_string(root.join("docs/hardening.md")).expect("the page is there");
    // Rows look like `| crates/a/src/b.rs | 2 | …`, the name in backquotes.
    let rows = page.lines().filter_map(|line| {
        let (name, rest) = line.strip_prefix("| `")?.split_once("` | ")?;
        let count = rest.split(' ').next()?.parse().ok()?;
        name.ends_with(".rs").then(|| (name.to_owned(), count))
    });
    let listed: BTreeMap<String, usize> = rows.collect();
    assert_eq!(found, listed, "left: the code, right: docs/hardening.md");
}

#[test]
fn the_count_knows_code_from_comments() {
    let code = "// unsafe {\nunsafe impl Send for A {}\nlet a = unsafe { f(unsafe { g() }) };\nunsafe fn h() {}\n";
    assert_eq!(count(code), 4);
}
