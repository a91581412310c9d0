//! Holds the architecture: which room may use which, read from the sources and the manifests.
//!
//! The tables below are the rules. A room that is missing from them fails, so that whoever adds one
//! decides what it may use. Documentation and a file's tests (from `#[cfg(test)]` to its end) are
//! free.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

/// What each room of the library may use of the others: a whole room, or one item of it.
const ROOMS: &[(&str, &[&str])] = &[
    ("lib", &["*"]),
    ("point", &[]),
    ("error", &["point", "mesh::VertexId", "mesh::TriangleId"]),
    ("watch", &["error"]),
    ("clock", &[]),
    ("memory", &[]),
    ("parallel", &["error"]),
    ("pace", &["error", "watch"]),
    ("hash", &["point"]),
    // Geometry knows no topology: no ids here.
    ("predicates", &["point"]),
    // Topology knows no geometry: no points, no predicates.
    ("mesh", &[]),
    ("triangulation", &["point", "mesh", "hash"]),
    // Keys along a space-filling curve, and their sorting: for points of an input, and for queries.
    ("order", &["point", "watch", "memory", "parallel"]),
    (
        "locate",
        &[
            "point",
            "mesh",
            "predicates",
            "triangulation",
            "order",
            "error",
            "watch",
            "memory",
            "parallel",
            "pace",
        ],
    ),
    (
        "delaunay",
        &[
            "point",
            "mesh",
            "predicates",
            "triangulation",
            "locate",
            "error",
            "watch",
            "memory",
            "parallel",
            "order",
            "pace",
        ],
    ),
    (
        "pslg",
        &[
            "point",
            "mesh::VertexId",
            "predicates",
            "error",
            "watch",
            "memory",
            "parallel",
        ],
    ),
    (
        "constrained",
        &[
            "point",
            "mesh",
            "predicates",
            "triangulation",
            "pslg",
            // Where seeds lie.
            "locate",
            "delaunay",
            "error",
            "watch",
            "memory",
            "parallel",
            "pace",
            "order",
        ],
    ),
    // Seeds are asked of the domain as triangulation finds it.
    (
        "doctor",
        &[
            "point",
            "mesh::VertexId",
            "predicates",
            "pslg",
            "constrained",
            "error",
            "watch",
            "parallel",
        ],
    ),
    ("quality", &["error"]),
    (
        "observe",
        &[
            "point",
            "mesh::VertexId",
            "quality::Angle",
            "predicates",
            "hash",
        ],
    ),
    (
        "tables",
        &[
            "point",
            "mesh",
            "predicates",
            "constrained",
            "observe",
            "error",
        ],
    ),
    (
        "classic",
        &[
            "point",
            "mesh",
            "predicates",
            "triangulation",
            "hash",
            "observe",
            "quality",
            "pslg",
            "locate",
            "delaunay",
            "constrained",
            "tables",
            "refine",
            // Algorithms A, B and C, told of here.
            "scattered",
            "order",
            "error",
            "watch",
            "pace",
        ],
    ),
    (
        "refine",
        &[
            "point",
            "mesh",
            "predicates",
            "triangulation",
            "pslg",
            "quality",
            "observe",
            "delaunay",
            "constrained",
            "tables",
            // Measures only: refinement reports what its mesh is like.
            "check",
            "error",
            "watch",
            "memory",
            "parallel",
            "pace",
            "clock",
        ],
    ),
    (
        "nearest",
        &[
            "point",
            "mesh",
            "predicates",
            "triangulation",
            "locate",
            "delaunay",
            "constrained",
            "error",
            "watch",
            "parallel",
            "pace",
        ],
    ),
    (
        "proximity",
        &[
            "point",
            "mesh",
            "predicates",
            "triangulation",
            "locate",
            "delaunay",
            "constrained",
            "error",
            "watch",
            "parallel",
            "pace",
            "order",
            "clock",
        ],
    ),
    (
        "voronoi",
        &[
            "point",
            "memory",
            "mesh",
            "predicates",
            "triangulation",
            "locate",
            "delaunay",
            "constrained",
            "error",
            "watch",
            "parallel",
            "pace",
            "pslg",
            "regular",
        ],
    ),
    (
        "surface",
        &[
            "point",
            "mesh",
            "predicates",
            "triangulation",
            "locate",
            "delaunay",
            "constrained",
            "error",
            "watch",
            "parallel",
            "pace",
            "nearest",
            "pslg",
            // Polynomials are fitted to the data that its triangles hold.
            "scattered",
        ],
    ),
    (
        "scattered",
        &[
            "point",
            "mesh",
            "predicates",
            "triangulation",
            "quality",
            "observe",
            "pslg",
            "locate",
            "delaunay",
            "constrained",
            // Centers of clusters come and go.
            "edit",
            // Only to hand its word out to who asks: nothing depends on it.
            "check",
            "order",
            "error",
            "watch",
            "memory",
            "parallel",
            "pace",
        ],
    ),
    (
        "edit",
        &[
            "point",
            "mesh",
            "predicates",
            "triangulation",
            "locate",
            "delaunay",
            "constrained",
            "error",
            "watch",
            "parallel",
            "pace",
            "pslg",
            "hash",
        ],
    ),
    (
        "regular",
        &[
            "point",
            "mesh",
            "predicates",
            "triangulation",
            "locate",
            "delaunay",
            "constrained",
            "error",
            "watch",
            "parallel",
            "pace",
        ],
    ),
    // The verifier trusts no builder: of the mesh it has the ids, and nothing that holds twins.
    (
        "check",
        &[
            "point",
            "predicates",
            "hash",
            "error",
            "watch",
            "pslg::Pslg",
            "pslg::Region",
            "pslg::DomainRule",
            "quality",
            "mesh::VertexId",
            "mesh::HalfEdgeId",
            "mesh::TriangleId",
            "pace",
        ],
    ),
];

/// Foreign crates, each with the only rooms that may use it.
const FOREIGN: &[(&str, &[&str])] = &[
    ("num_bigint", &["predicates"]),
    // A drawing has a name of its own, as a set of triangles has.
    ("xxhash_rust", &["hash", "pslg"]),
    ("rayon", &["parallel"]),
    ("libc", &["memory"]),
    // Bounds in degrees become numbers that are the same on every machine.
    ("libm", &["refine", "check"]),
    // What is wrong with an edit names constraints, which the ground floor does not know.
    (
        "thiserror",
        &["error", "check", "mesh", "constrained", "edit", "observe"],
    ),
];

/// What no room may do: the library neither prints nor exits nor touches files.
const FORBIDDEN: &[&str] = &[
    "std::fs",
    "std::process",
    "std::net",
    "std::io",
    "println!",
    "eprintln!",
    "print!",
    "dbg!",
];

/// The crates of the workspace, each with those that it may depend on (tests may use more).
const CRATES: &[(&str, &[&str])] = &[
    ("delone", &[]),
    ("delone-io", &["delone"]),
    ("delone-samples", &[]),
    ("delone-cli", &["delone", "delone-io", "delone-samples"]),
    ("delone-wasm", &["delone", "delone-io", "delone-samples"]),
    ("delone-web-build", &[]),
    // Covers are measured on the data that tests make.
    (
        "delone-bench",
        &["delone", "delone-io", "delone-samples", "delone-testkit"],
    ),
    ("delone-testkit", &["delone"]),
    ("delone-filekit", &["delone", "delone-io"]),
];

fn allowed(table: &[(&str, &'static [&str])], name: &str) -> Option<&'static [&'static str]> {
    table
        .iter()
        .find(|(row, _)| *row == name)
        .map(|&(_, allowed)| allowed)
}

/// Which room hands out each name at the root of the crate: `Point` → `point`.
type Exports = BTreeMap<String, String>;

fn exports(lib: &str) -> Exports {
    let statements = code_of(lib);
    let uses = statements
        .split(';')
        .filter_map(|s| s.trim().strip_prefix("pub use "));
    let names = |text: &str| paths_after("", text);
    let rooms = uses.flat_map(names).filter_map(|path| {
        let (room, name) = path.split_once("::")?;
        Some((name.to_owned(), room.to_owned()))
    });
    rooms.collect()
}

/// Removes comments, the content of strings, and tests.
fn code_of(source: &str) -> String {
    let mut code = String::new();
    let mut rest = source;
    while let Some(at) = rest.find(['/', '"', '\'']) {
        let (before, special) = rest.split_at(at);
        code.push_str(before);
        rest = if special.starts_with("//") {
            &special[special.find('\n').unwrap_or(special.len())..]
        } else if let Some(content) = special.strip_prefix('"') {
            after_string(content)
        } else {
            // A quote as a character opens no string.
            let length = if special.starts_with("'\"'") { 3 } else { 1 };
            code.push(' ');
            &special[length..]
        };
    }
    code.push_str(rest);
    let end = code.find("#[cfg(test)]").unwrap_or(code.len());
    code[..end].to_owned()
}

fn after_string(text: &str) -> &str {
    let mut escaped = false;
    let end = text.find(|c| {
        let closes = c == '"' && !escaped;
        escaped = c == '\\' && !escaped;
        closes
    });
    end.map_or("", |end| &text[end + 1..])
}

/// Lists the paths that follow `root` wherever it occurs, groups in braces spread out.
fn paths_after(root: &str, code: &str) -> Vec<String> {
    let mut paths = Vec::new();
    if root.is_empty() {
        read_tree("", code, &mut paths);
        return paths;
    }
    for (at, _) in code.match_indices(root) {
        let before = code[..at].chars().next_back();
        if !before.is_some_and(|c| c.is_alphanumeric() || c == '_' || c == '$') {
            read_tree("", &code[at + root.len()..], &mut paths);
        }
    }
    paths
}

/// Reads `a::b`, `{a, b::{c, d}}` or `*` and returns the rest of the text.
fn read_tree<'c>(prefix: &str, code: &'c str, paths: &mut Vec<String>) -> &'c str {
    let code = code.trim_start();
    if let Some(mut rest) = code.strip_prefix('{') {
        while !rest.trim_start().starts_with('}') {
            rest = read_tree(prefix, rest, paths).trim_start();
            rest = rest.strip_prefix(',').unwrap_or(rest);
        }
        return &rest.trim_start()[1..];
    }
    let end = code
        .find(|c: char| !(c.is_alphanumeric() || c == '_'))
        .unwrap_or(code.len());
    let (word, rest) = code.split_at(if code.starts_with('*') { 1 } else { end });
    assert!(
        !word.is_empty(),
        "the scanner does not understand: {:.60}",
        code
    );
    let path = if word == "self" {
        prefix.to_owned()
    } else {
        join(prefix, word)
    };
    match rest.strip_prefix("::") {
        Some(more) if !more.starts_with('<') => read_tree(&path, more, paths),
        _ => {
            paths.push(path);
            skip_alias(rest)
        }
    }
}

fn join(prefix: &str, word: &str) -> String {
    if prefix.is_empty() {
        word.to_owned()
    } else {
        format!("{prefix}::{word}")
    }
}

fn skip_alias(rest: &str) -> &str {
    let Some(alias) = rest.trim_start().strip_prefix("as ") else {
        return rest;
    };
    let alias = alias.trim_start();
    alias.trim_start_matches(|c: char| c.is_alphanumeric() || c == '_')
}

/// One file of the library: the room it belongs to, and how deep below the root it lies.
struct Source {
    name: String,
    room: String,
    depth: usize,
    code: String,
}

impl Source {
    fn new(name: &str, text: &str) -> Self {
        let parts: Vec<&str> = name.trim_end_matches(".rs").split('/').collect();
        let is_door = parts.last() == Some(&"mod");
        Self {
            name: name.to_owned(),
            room: parts[0].to_owned(),
            depth: parts.len() - usize::from(is_door),
            code: code_of(text),
        }
    }

    /// Lists what the file uses of other rooms, as `room::item`.
    fn uses(&self, exports: &Exports) -> BTreeSet<String> {
        let out = "super::".repeat(self.depth);
        let mut paths = paths_after("crate::", &self.code);
        paths.extend(paths_after(&out, &self.code));
        let full = |path: &String| {
            let first = path.split("::").next().unwrap_or("");
            exports
                .get(first)
                .map_or(path.clone(), |room| format!("{room}::{path}"))
        };
        let is_foreign = |path: &String| path.split("::").next() != Some(&self.room);
        paths.iter().map(full).filter(is_foreign).collect()
    }

    /// Lists what the file does that it must not.
    fn violations(&self, exports: &Exports) -> Vec<String> {
        let Some(rooms) = allowed(ROOMS, &self.room) else {
            return vec![format!(
                "{}: room {} has no row in the table",
                self.name, self.room
            )];
        };
        let permits = |path: &str| {
            let within = |room: &str| path == room || path.starts_with(&format!("{room}::"));
            rooms.iter().any(|&room| room == "*" || within(room))
        };
        let uses = self.uses(exports);
        let rooms = uses.into_iter().filter(|path| !permits(path));
        let foreign = FOREIGN
            .iter()
            .filter(|(_, users)| !users.contains(&self.room.as_str()))
            .map(|(name, _)| format!("{name}::"));
        let forbidden = FORBIDDEN.iter().map(|word| (*word).to_owned());
        let words = foreign
            .chain(forbidden)
            .filter(|word| self.code.contains(word));
        rooms
            .chain(words)
            .map(|what| format!("{} uses {what}", self.name))
            .collect()
    }
}

fn library() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("src")
}

fn collect_sources(folder: &Path, sources: &mut Vec<Source>) {
    for entry in fs::read_dir(folder).expect("a source folder") {
        let path = entry.expect("an entry").path();
        if path.is_dir() {
            collect_sources(&path, sources);
        } else {
            let name = path
                .strip_prefix(library())
                .expect("below src")
                .to_string_lossy();
            let text = fs::read_to_string(&path).expect("a source file");
            sources.push(Source::new(&name.replace('\\', "/"), &text));
        }
    }
}

fn library_exports() -> Exports {
    exports(&fs::read_to_string(library().join("lib.rs")).expect("lib.rs"))
}

#[test]
fn every_room_keeps_to_its_layer() {
    let mut sources = Vec::new();
    collect_sources(&library(), &mut sources);
    assert!(sources.len() > 15, "only {} files", sources.len());
    let exports = library_exports();
    let violations: Vec<String> = sources
        .iter()
        .flat_map(|s| s.violations(&exports))
        .collect();
    assert!(violations.is_empty(), "{}", violations.join("\n"));
}

#[test]
fn the_tables_permit_no_circle_among_ground_floor_rooms() {
    for (room, uses) in ROOMS.iter().filter(|(room, _)| *room != "lib") {
        for used in uses
            .iter()
            .map(|path| path.split("::").next().unwrap_or(""))
        {
            let back = allowed(ROOMS, used).unwrap_or_else(|| panic!("{room}: no room {used}"));
            assert!(!back.contains(room), "{room} and {used} may use each other");
        }
    }
}

/// Lists the crates of this workspace in the `[dependencies]` of a manifest.
fn workspace_dependencies(manifest: &str) -> Vec<&str> {
    let mut section = "";
    let mut found = Vec::new();
    for line in manifest.lines().map(str::trim) {
        if line.starts_with('[') {
            section = line;
        } else if section.ends_with("dependencies]") && !section.contains("dev-dependencies") {
            let name = line.split(['.', '=', ' ']).next().unwrap_or("");
            found.extend(allowed(CRATES, name).map(|_| name));
        }
    }
    found
}

#[test]
fn every_crate_keeps_to_its_layer() {
    let crates = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    for entry in fs::read_dir(crates).expect("the crates") {
        let Ok(manifest) = fs::read_to_string(entry.expect("an entry").path().join("Cargo.toml"))
        else {
            continue;
        };
        let mut fields = manifest
            .lines()
            .filter_map(|line| line.strip_prefix("name = "));
        let name = fields.next().expect("a name").trim_matches('"');
        let may = allowed(CRATES, name).unwrap_or_else(|| panic!("{name} has no row in the table"));
        for used in workspace_dependencies(&manifest) {
            assert!(may.contains(&used), "{name} must not depend on {used}");
        }
    }
}

// The scanner sees what it must.

fn violations_of(name: &str, text: &str) -> Vec<String> {
    Source::new(name, text).violations(&library_exports())
}

#[test]
fn the_scanner_sees_violations() {
    let cases = [
        ("mesh/edit.rs", "use crate::Point;", "point::Point"),
        (
            "mesh/edit.rs",
            "use crate::{\n    Error,\n    HalfEdgeId,\n};",
            "error::Error",
        ),
        ("mesh/edit.rs", "fn f(p: crate::Point) {}", "point::Point"),
        (
            "mesh/edit.rs",
            "use super::super::predicates::orient2d;",
            "predicates::orient2d",
        ),
        ("mesh/mod.rs", "use super::{ids, predicates};", "predicates"),
        (
            "predicates/filter.rs",
            "use crate::mesh::ids::VertexId;",
            "mesh::ids::VertexId",
        ),
        (
            "predicates/filter.rs",
            "use crate::{Point, VertexId as V};",
            "mesh::VertexId",
        ),
        ("check/mod.rs", "use crate::{VertexId, Mesh};", "mesh::Mesh"),
        (
            "check/stars.rs",
            "use crate::{Error, delaunay::{self, order}};",
            "delaunay",
        ),
        ("check/stars.rs", "use crate::*;", "*"),
        ("check/stars.rs", "fn f() { println!() }", "println!"),
        ("check/stars.rs", "use num_bigint::BigInt;", "num_bigint::"),
        ("hash.rs", "use super::Mesh;", "mesh::Mesh"),
        (
            "hash.rs",
            "const Q: char = '\"'; const U: &str = \"//\\\"\"; use super::Mesh;",
            "mesh::Mesh",
        ),
        ("attic/mod.rs", "", "no row"),
    ];
    for (name, text, culprit) in cases {
        let found = violations_of(name, text).join("\n");
        assert!(found.contains(culprit), "{name}: {text}\n{found:?}");
    }
}

#[test]
fn the_scanner_permits_what_is_right() {
    let cases = [
        ("mesh/edit.rs", "use super::{HalfEdgeId, ids::VertexId};"),
        (
            "mesh/edit.rs",
            "//! Never uses [`Point`](crate::Point).\nuse crate::mesh::Mesh;",
        ),
        (
            "mesh/edit.rs",
            "fn f() {}\n#[cfg(test)]\nmod tests { use crate::Point; }",
        ),
        (
            "check/mod.rs",
            "use crate::predicates::{Orientation, orient2d};\nmod stars;",
        ),
        (
            "check/mod.rs",
            "use crate::{Point, VertexId, hash_triangles, Phase};",
        ),
        (
            "predicates/mod.rs",
            "use crate::Point;\nuse num_bigint::BigInt;",
        ),
        ("mesh/edit.rs", "const S: &str = \"crate::Point\";"),
    ];
    for (name, text) in cases {
        assert_eq!(violations_of(name, text), [""; 0], "{name}: {text}");
    }
}

#[test]
fn the_scanner_reads_manifests() {
    let manifest = "[dependencies]\ndelone-io.workspace = true\nrayon = \"1\"\n\
                    [dev-dependencies]\ndelone-testkit = { path = \"x\" }\n\
                    [build-dependencies]\ndelone = \"1\"\n";
    assert_eq!(workspace_dependencies(manifest), ["delone-io", "delone"]);
}
