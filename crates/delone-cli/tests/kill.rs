//! `kill -9` at any moment: each file is the old one or the new one, byte for byte, and what is left
//! besides can be told by its name.
//!
//! Thirty trials, or as many as `DELONE_KILL_TRIALS` says; `DELONE_KILL_SEED` draws other moments.
//! `--nocapture` shows how they ended. A third of the moments lies anywhere in a run, a third within its writing, and
//! a third just behind the first file that got its name, where a family of files may be mixed.
#![cfg(unix)]

mod support;

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};
use support::Folder;

/// A command, and the files that it replaces.
type Family = (&'static str, &'static [&'static str]);

/// Every kind of writer. Reports tell how long the run took, so what is new in them is told apart by its ends.
const FAMILIES: &[Family] = &[
    (
        "triangulate p.npy -o o.ele",
        &["o.node", "o.ele", "o.edge", "o.neigh"],
    ),
    (
        "triangulate c.poly -o o.poly",
        &["o.node", "o.ele", "o.edge", "o.neigh", "o.poly"],
    ),
    (
        "mesh c.poly -o o.ele",
        &["o.node", "o.ele", "o.edge", "o.neigh", "o.poly"],
    ),
    (
        "triangulate c.poly -o o.npy",
        &["o.npy", "o.points.npy", "o.segments.npy"],
    ),
    (
        "triangulate c.poly -o o.parquet",
        &["o.parquet", "o.points.parquet", "o.segments.parquet"],
    ),
    (
        "triangulate c.poly -o o.vtu -o o.geojson --certificate=o.cert --lineage o.csv",
        &["o.vtu", "o.geojson", "o.cert", "o.csv"],
    ),
    (
        "mesh c.poly -o o.vtu -p o.svg -r o.html",
        &["o.vtu", "o.svg", "o.html"],
    ),
    ("triangulate p.npy -o o.vtk", &["o.vtk"]),
    ("triangulate p.npy -o o.vtk --ascii", &["o.vtk"]),
    ("triangulate c.poly -o o.msh", &["o.msh"]),
    ("triangulate c.poly -o o.msh --to msh2", &["o.msh"]),
    ("triangulate c.poly -o o.mesh", &["o.mesh"]),
    ("triangulate p.npy -o o.ply -o o.obj", &["o.ply", "o.obj"]),
    ("triangulate p.npy -o o.off -o o.stl", &["o.off", "o.stl"]),
    ("triangulate c.poly -o o.dxf", &["o.dxf"]),
    ("triangulate c.poly -o o.tikz", &["o.tikz"]),
    ("triangulate p.npy -o o.png --size 400", &["o.png"]),
    ("convert p.npy o.csv", &["o.csv"]),
    ("convert p.npy o.node", &["o.node"]),
    ("convert c.poly o.geojson", &["o.geojson"]),
    ("voronoi p.npy -o o.vtu", &["o.vtu"]),
    ("voronoi p.npy -o o.v.node", &["o.v.node", "o.v.edge"]),
    ("graph p.npy --kind mst -o o.csv", &["o.csv"]),
    ("interpolate z.csv --cell 0.005 -o o.asc", &["o.asc"]),
    ("contour z.csv --interval 0.01 -o o.geojson", &["o.geojson"]),
    (
        "cover p.npy -d 3 -o o.ele --data-out o.csv",
        &["o.node", "o.ele", "o.edge", "o.neigh", "o.csv"],
    ),
    ("cluster p.npy -n 20 -o o.csv", &["o.csv"]),
    ("sample uniform -n 30000 -o o.csv", &["o.csv"]),
];

fn number(name: &str, default: u64) -> u64 {
    match std::env::var(name) {
        Ok(text) => text.parse().unwrap_or_else(|e| panic!("{name}: {e}")),
        Err(_) => default,
    }
}

fn start(folder: &Path, line: &str) -> Child {
    Command::new(assert_cmd::cargo::cargo_bin("delone"))
        .current_dir(folder)
        .args(line.split_whitespace())
        .args(["-q"])
        .stdin(Stdio::null())
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .expect("the program starts")
}

/// What a run that nobody disturbs makes, and how long it takes.
struct Model {
    files: BTreeMap<String, Vec<u8>>,
    /// Until the first temporary file, and from there to the end.
    times: [Duration; 2],
}

/// How a trial ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum End {
    Old,
    Mixed,
    New,
    /// The program was done before.
    Done,
}

fn entries(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).expect("the folder is there");
    let name = |e: std::io::Result<fs::DirEntry>| e.expect("an entry").file_name();
    entries
        .map(|e| name(e).into_string().expect("UTF-8"))
        .collect()
}

fn is_temporary(name: &str, family: &[&str]) -> bool {
    family.iter().any(|file| {
        let middle = name.strip_prefix('.').and_then(|n| {
            n.strip_prefix(file)?
                .strip_prefix('.')?
                .strip_suffix(".tmp")
        });
        middle.is_some_and(|m| m.len() == 6 && m.bytes().all(|b| b.is_ascii_alphanumeric()))
    })
}

/// Waits for a temporary file, or the end; looks often.
fn await_writing(child: &mut Child, folder: &Path) {
    while child.try_wait().expect("a child").is_none() {
        if entries(folder).iter().any(|name| name.ends_with(".tmp")) {
            return;
        }
        sleep(Duration::from_micros(100));
    }
}

/// Waits until one of the files is not the old one any more, or the end; does not sleep, for all get their names at once.
fn await_naming(child: &mut Child, folder: &Path, family: &[&str]) {
    while child.try_wait().expect("a child").is_none() {
        for _ in 0..100 {
            for file in family {
                let length = fs::metadata(folder.join(file)).map(|m| m.len());
                if length.ok() != Some(old(file).len() as u64) {
                    return;
                }
            }
        }
    }
}

fn old(file: &str) -> Vec<u8> {
    format!("old {file}\n").repeat(500).into_bytes()
}

fn model(folder: &Folder, (line, family): Family) -> Model {
    let path = folder.path();
    let begin = Instant::now();
    let mut child = start(&path, line);
    await_writing(&mut child, &path);
    let first = begin.elapsed();
    let status = child.wait().expect("the program ends");
    let all = begin.elapsed();
    assert!(matches!(status.code(), Some(0 | 5)), "{line}: {status}");
    let files = family.iter().map(|file| {
        assert_ne!(folder.bytes(file), old(file), "{line} writes {file}");
        ((*file).to_owned(), folder.bytes(file))
    });
    Model {
        files: files.collect(),
        times: [first, all.saturating_sub(first)],
    }
}

/// Tells whether a file is new: the same bytes, but for pages, which tell times.
fn is_new(file: &str, bytes: &[u8], model: &[u8]) -> bool {
    if !file.ends_with(".html") && !file.ends_with(".cert") {
        return bytes == model;
    }
    let ends = |b: &[u8]| [b[..16].to_vec(), b[b.len() - 16..].to_vec()];
    bytes.len() > 32 && bytes.len().abs_diff(model.len()) < 200 && ends(bytes) == ends(model)
}

/// Kills one run and judges the files; also returns how many temporary ones are left.
fn trial(folder: &Folder, given: Family, model: &Model, kind: u64, part: f64) -> (End, usize) {
    let (line, family) = given;
    let path = folder.path();
    for file in family {
        fs::write(path.join(file), old(file)).expect("the folder is writable");
    }
    let mut child = start(&path, line);
    let [before, writing] = model.times;
    match kind {
        0 => sleep((before + writing).mul_f64(1.1 * part)),
        1 => {
            await_writing(&mut child, &path);
            sleep(writing.mul_f64(part));
        }
        _ => await_naming(&mut child, &path, family),
    }
    // On Unix this is signal 9.
    child.kill().expect("a child");
    let status = child.wait().expect("the program ends");
    let mut counts = [0, 0];
    for file in family {
        let bytes = folder.bytes(file);
        let fresh = is_new(file, &bytes, &model.files[*file]);
        assert!(
            fresh || bytes == old(file),
            "{line}: {file} is neither old nor new: {} bytes of {}",
            bytes.len(),
            model.files[*file].len()
        );
        counts[usize::from(fresh)] += 1;
    }
    let mut temporary = 0;
    for name in entries(&path) {
        if is_temporary(&name, family) {
            fs::remove_file(path.join(&name)).expect("it goes");
            temporary += 1;
        } else {
            let known = ["p.npy", "c.poly", "z.csv"].contains(&&name[..]);
            assert!(known || family.contains(&&name[..]), "{line} left {name}");
        }
    }
    let end = match (status.code(), counts) {
        (Some(_), _) => End::Done,
        (None, [_, 0]) => End::Old,
        (None, [0, _]) => End::New,
        (None, _) => End::Mixed,
    };
    assert!(
        end != End::Done || (counts[0] == 0 && temporary == 0),
        "{line}: done, but {counts:?}"
    );
    (end, temporary)
}

#[test]
fn a_killed_run_leaves_each_file_old_or_new() {
    let folder = Folder::new();
    folder.run("sample uniform -n 5000 -o p.npy", 0);
    folder.run("sample coast -n 1500 -o c.poly", 0);
    folder.write("z.csv", heights());
    let trials = number("DELONE_KILL_TRIALS", 30);
    let mut state = number("DELONE_KILL_SEED", 1);
    let mut ends = BTreeMap::new();
    let mut models = BTreeMap::new();
    let mut mixed = BTreeMap::new();
    let mut temporary = 0;
    for i in 0..trials {
        let index = usize::try_from(i).expect("few trials") % FAMILIES.len();
        let given = FAMILIES[index];
        for (line, family) in FAMILIES {
            // Those of the command before.
            if *line != given.0 {
                family
                    .iter()
                    .for_each(|f| drop(fs::remove_file(folder.path().join(f))));
            }
        }
        for file in given.1 {
            folder.write(file, old(file));
        }
        let model = models.entry(index).or_insert_with(|| model(&folder, given));
        state = state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        let part = (state >> 11) as f64 / (1_u64 << 53) as f64;
        let kind = (i + i / FAMILIES.len() as u64) % 3;
        let (end, left) = trial(&folder, given, model, kind, part);
        let kinds = ["anywhere", "in writing", "in naming"];
        *ends.entry((kinds[kind as usize], end)).or_insert(0) += 1;
        temporary += left;
        if end == End::Mixed {
            let count: &mut [u32; 3] = mixed.entry(given.0).or_default();
            count[kind as usize] += 1;
        }
    }
    for (line, counts) in mixed {
        println!("mixed: {line}: {counts:?}");
    }
    println!("{trials} trials, {temporary} temporary files left");
    for ((kind, end), count) in &ends {
        println!("killed {kind}: {end:?} {count}");
    }
    let killed = ends.iter().filter(|((_, end), _)| *end != End::Done);
    assert!(
        killed.map(|(_, count)| count).sum::<i32>() > 0,
        "never in time"
    );
}

/// Points with heights, as text.
fn heights() -> String {
    let mut text = String::from("x,y,z\n");
    for i in 0..70 {
        for j in 0..70 {
            let [x, y] = [i, j].map(|k| f64::from(k) / 69.0);
            text += &format!("{x},{y},{}\n", (7.0 * x).sin() * (5.0 * y).cos());
        }
    }
    text
}
