//! Folders, disks, names and pipes as they should not be: an error with a name, the old file as it was, nothing beside it.
//!
//! Messages of the system and limits of the shell are those of Linux.
#![cfg(target_os = "linux")]

mod support;

use std::ffi::{OsStr, OsString};
use std::fs;
use std::io::{Read, Write};
use std::os::unix::ffi::OsStrExt;
use std::os::unix::fs::{PermissionsExt, symlink};
use std::os::unix::process::CommandExt;
use std::path::Path;
use std::process::{Command, Stdio};
use support::Folder;

/// The user that systems call nobody.
const NOBODY: u32 = 65534;

fn program() -> Command {
    Command::new(assert_cmd::cargo::cargo_bin("delone"))
}

/// Runs a command line of the shell, in which `$D` is the program; returns code, output and messages.
fn shell(folder: &Folder, script: &str) -> (Option<i32>, String, String) {
    let output = Command::new("sh")
        .args(["-c", script])
        .env("D", assert_cmd::cargo::cargo_bin("delone"))
        .current_dir(folder.path())
        .stdin(Stdio::null())
        .output()
        .expect("a shell");
    let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
    (
        output.status.code(),
        text(&output.stdout),
        text(&output.stderr),
    )
}

/// Expects an exit code and the one message.
#[track_caller]
fn fails(folder: &Folder, script: &str, code: i32, message: &str) {
    let (found, _, said) = shell(folder, script);
    assert_eq!((found, said.trim_end()), (Some(code), message), "{script}");
}

#[track_caller]
fn works(folder: &Folder, script: &str) -> String {
    let (code, output, said) = shell(folder, script);
    assert_eq!(code, Some(0), "{script}: {said}");
    output
}

/// Many points, whose mesh takes more than a few blocks of a disk.
fn with_many() -> Folder {
    let folder = Folder::with_points();
    folder.run("sample uniform -n 20000 -o p.npy", 0);
    folder
}

#[test]
fn a_full_disk_is_named_and_the_old_file_stays() {
    let folder = with_many();
    folder.write("m.vtu", "old");
    folder.write("m.ele", "old");
    let before = folder.names();
    for (out, named) in [
        ("m.vtu", "m.vtu"),
        ("m.ele", "m.node"),
        ("m.geojson", "m.geojson"),
    ] {
        // Files may grow to 64 blocks of 512 bytes.
        let script = format!("ulimit -f 64; \"$D\" -q triangulate p.npy -o {out}");
        let message = format!("error: cannot write {named}: File too large (os error 27)");
        fails(&folder, &script, 4, &message);
        assert_eq!(folder.names(), before, "{out}");
    }
    assert_eq!(
        (folder.read("m.vtu"), folder.read("m.ele")),
        ("old".into(), "old".into())
    );
}

#[test]
fn a_full_device_is_named() {
    let folder = with_many();
    let full = "No space left on device (os error 28)";
    fails(
        &folder,
        "\"$D\" -q triangulate p.npy -o /dev/full --to vtu",
        4,
        &format!("error: cannot write /dev/full: {full}"),
    );
    fails(
        &folder,
        "\"$D\" -q triangulate p.npy -o - --to ele > /dev/full",
        4,
        &format!("error: cannot write -: {full}"),
    );
    fails(
        &folder,
        "\"$D\" -q triangulate p.npy --json > /dev/full",
        4,
        &format!(
            "{{\"error\":\"cannot write to standard output: {full}\",\"kind\":\"not_reached\",\"code\":4,\
             \"file\":null,\"line\":null}}"
        ),
    );
}

#[test]
fn the_files_of_a_run_appear_together_or_not_at_all() {
    let folder = Folder::new();
    folder.run("sample lake -o lake.poly", 0);
    folder.run("sample gauss -n 99 -o p.csv", 0);
    folder.write("h.csv", "x,y,z\n0,0,1\n4,0,9\n4,3,2\n0,3,1\n1,1,5\n");
    let links = ["full.html", "full.csv", "full.poly", "full.png", "full.svg"];
    for link in links {
        symlink("/dev/full", folder.path().join(link)).expect("a link");
    }
    let before = folder.names();
    for line in [
        "mesh lake.poly -o m.vtu --certificate --report full.html",
        "cover p.csv -d 3 -o m.vtu --data-out full.csv",
        "voronoi p.csv --lloyd 2 -o m.vtu --sites full.csv",
        "cluster p.csv -n 3 -o m.csv --centers full.csv",
        "interpolate h.csv --cell 1 -o m.asc --picture full.png",
        "contour h.csv -o m.geojson --picture full.svg",
        "doctor lake.poly --geojson m.geojson --repair full.poly",
        "algorithms run sweep p.csv -o m.ele --filmstrip full.png",
    ] {
        let output = folder.run(line, 4);
        output.says(&["cannot write full.", "No space left"]);
        assert_eq!(folder.names(), before, "{line}");
    }
}

#[test]
fn links_are_followed_and_stay_links() {
    let folder = Folder::with_points();
    let at = |name: &str| folder.path().join(name);
    fs::create_dir(at("far")).expect("a folder");
    folder.write("far/old.vtu", "old");
    symlink("far/old.vtu", at("link.vtu")).expect("a link");
    symlink("link.vtu", at("second.vtu")).expect("a link");
    symlink("far/new.vtu", at("dangling.vtu")).expect("a link");
    symlink("points.csv", at("input.csv")).expect("a link");
    folder.run("triangulate input.csv -o whole.vtu", 0);
    for out in ["second.vtu", "dangling.vtu"] {
        folder.run(&format!("triangulate input.csv -o {out}"), 0);
        assert!(at(out).is_symlink(), "{out}");
        assert_eq!(folder.read(out), folder.read("whole.vtu"));
    }
    assert_eq!(folder.read("far/old.vtu"), folder.read("whole.vtu"));
    assert!(at("far/new.vtu").is_file());
}

#[test]
fn links_that_lead_nowhere_are_named() {
    let folder = Folder::with_points();
    let at = |name: &str| folder.path().join(name);
    symlink("b.vtu", at("a.vtu")).expect("a link");
    symlink("a.vtu", at("b.vtu")).expect("a link");
    symlink("nowhere/new.vtu", at("c.vtu")).expect("a link");
    fails(
        &folder,
        "\"$D\" -q triangulate points.csv -o a.vtu",
        4,
        "error: cannot create a.vtu: Too many levels of symbolic links (os error 40)",
    );
    fails(
        &folder,
        "\"$D\" -q triangulate points.csv -o c.vtu",
        4,
        "error: cannot create c.vtu: No such file or directory (os error 2)",
    );
    fails(
        &folder,
        "\"$D\" -q triangulate a.vtu",
        3,
        "error: cannot read a.vtu: Too many levels of symbolic links (os error 40)",
    );
    assert!(at("a.vtu").is_symlink() && at("c.vtu").is_symlink());
}

#[test]
fn the_input_is_no_output_by_any_name() {
    let folder = Folder::with_points();
    symlink("points.csv", folder.path().join("other.csv")).expect("a link");
    let before = folder.read("points.csv");
    for line in [
        "convert points.csv points.csv",
        "convert points.csv other.csv",
        "convert other.csv points.csv",
        "convert points.csv ./points.csv",
    ] {
        let (code, _, said) = shell(&folder, &format!("\"$D\" {line}"));
        assert_eq!(code, Some(2), "{line}: {said}");
        assert!(
            said.contains("is the input; name another output"),
            "{line}: {said}"
        );
        assert_eq!(folder.read("points.csv"), before, "{line}");
    }
}

/// Runs the program as somebody whom permissions hold; where the tests run as such, as that one.
fn as_nobody(folder: &Folder, cwd: &Path, line: &str) -> (Option<i32>, String) {
    let mut command = program();
    command.current_dir(cwd).args(line.split_whitespace());
    // SAFETY: asking for the user cannot fail.
    if unsafe { libc::geteuid() } == 0 {
        command.uid(NOBODY).gid(NOBODY);
    }
    let output = match command.output() {
        Ok(output) => output,
        Err(error) => {
            return (
                None,
                format!("not started in {}: {error}", folder.path().display()),
            );
        }
    };
    (
        output.status.code(),
        String::from_utf8_lossy(&output.stderr)
            .trim_end()
            .to_owned(),
    )
}

fn permit(path: &Path, mode: u32) {
    fs::set_permissions(path, fs::Permissions::from_mode(mode)).expect("it is ours");
}

#[test]
fn what_is_forbidden_is_named() {
    let folder = Folder::with_points();
    let at = |name: &str| folder.path().join(name);
    permit(&folder.path(), 0o755);
    permit(&at("points.csv"), 0o644);
    fs::create_dir(at("closed")).expect("a folder");
    folder.write("closed/m.vtu", "old");
    folder.write("secret.csv", support::POINTS);
    permit(&at("secret.csv"), 0);
    permit(&at("closed"), 0o555);
    let (code, said) = as_nobody(&folder, &folder.path(), "-q info points.csv");
    if code.is_none() || said.contains("Permission") {
        eprintln!("skipped: nobody cannot run the program here: {said}");
        permit(&at("closed"), 0o755);
        return;
    }
    for (line, code, message) in [
        (
            "-q triangulate points.csv -o closed/m.vtu",
            4,
            "error: cannot create closed/m.vtu: Permission denied (os error 13)",
        ),
        (
            "-q triangulate secret.csv",
            3,
            "error: cannot read secret.csv: Permission denied (os error 13)",
        ),
    ] {
        let found = as_nobody(&folder, &folder.path(), line);
        assert_eq!(found, (Some(code), message.to_owned()), "{line}");
    }
    assert_eq!(folder.read("closed/m.vtu"), "old");
    permit(&at("closed"), 0o755);
}

#[test]
fn a_file_that_is_read_only_is_replaced_in_a_folder_that_is_not() {
    // As `mv` and editors do: what is asked is whether the folder can be written to.
    let folder = Folder::with_points();
    folder.write("m.vtu", "old");
    permit(&folder.path().join("m.vtu"), 0o444);
    folder.run("triangulate points.csv -o m.vtu", 0);
    assert!(folder.read("m.vtu").starts_with("<?xml"));
}

#[test]
fn names_may_be_of_any_bytes() {
    let folder = Folder::with_points();
    let names: [&[u8]; 6] = [
        b"caf\xe9.csv",
        b"two\nlines.csv",
        b"-dash.csv",
        b" blank .csv",
        b"\x1b[31m.csv",
        "Größe \u{202e}.csv".as_bytes(),
    ];
    for bytes in names {
        let name = OsStr::from_bytes(bytes);
        folder.write("x", "");
        fs::copy(folder.path().join("points.csv"), folder.path().join(name)).expect("a copy");
        let out = OsString::from_iter([OsStr::new("./"), name, OsStr::new(".vtu")]);
        let output = program()
            .current_dir(folder.path())
            .args([
                OsStr::new("triangulate"),
                OsStr::new("-o"),
                &out,
                OsStr::new("--"),
                name,
            ])
            .output()
            .expect("the program starts");
        assert!(output.status.success(), "{name:?}: {output:?}");
        assert!(folder.path().join(&out).is_file(), "{name:?}");
    }
}

#[test]
fn names_may_be_as_long_as_the_system_takes() {
    let folder = Folder::with_points();
    for name in ["x".repeat(251), "é".repeat(125)] {
        folder.run(&format!("triangulate points.csv -o {name}.vtu"), 0);
        assert!(folder.path().join(format!("{name}.vtu")).is_file());
    }
    let long = "x".repeat(252);
    let script = format!("\"$D\" -q triangulate points.csv -o {long}.vtu");
    let (code, _, said) = shell(&folder, &script);
    assert_eq!(code, Some(4), "{said}");
    assert!(said.contains("File name too long (os error 36)"), "{said}");
    let deep = format!("{}p.csv", "d/".repeat(2100));
    let message = format!("error: cannot read {deep}: File name too long (os error 36)");
    fails(&folder, &format!("\"$D\" -q info {deep}"), 3, &message);
    assert_eq!(folder.names().len(), 3, "{:?}", folder.names());
}

#[test]
fn folders_are_no_files() {
    let folder = Folder::with_points();
    fs::create_dir(folder.path().join("m.vtu")).expect("a folder");
    fails(
        &folder,
        "\"$D\" -q triangulate m.vtu",
        3,
        "error: cannot read m.vtu: is a directory",
    );
    fails(
        &folder,
        "\"$D\" -q triangulate points.csv -o m.vtu",
        4,
        "error: cannot write m.vtu: it is a folder; name a file",
    );
    fails(
        &folder,
        "\"$D\" -q triangulate points.csv -o points.csv/m.vtu",
        4,
        "error: cannot write points.csv/m.vtu: there is no folder points.csv; create it first",
    );
}

#[test]
fn pipes_with_names_are_read_and_written() {
    let folder = Folder::with_points();
    works(&folder, "mkfifo in.csv out.vtu");
    works(
        &folder,
        "cat points.csv > in.csv & cat out.vtu > got.vtu & \"$D\" -q triangulate in.csv -o out.vtu; wait",
    );
    folder.run("triangulate points.csv -o whole.vtu", 0);
    assert_eq!(folder.read("got.vtu"), folder.read("whole.vtu"));
    works(&folder, "test -p out.vtu");
}

#[test]
fn closed_streams_are_no_failure_unless_something_goes_there() {
    let folder = Folder::with_points();
    for closed in ["<&-", "2>&-", ">&-", "<&- >&- 2>&-"] {
        works(
            &folder,
            &format!("\"$D\" triangulate points.csv -o m.vtu {closed}"),
        );
        assert!(folder.read("m.vtu").starts_with("<?xml"), "{closed}");
        fs::remove_file(folder.path().join("m.vtu")).expect("it goes");
    }
}

#[test]
fn an_empty_environment_is_enough() {
    let folder = Folder::with_points();
    let status = program()
        .env_clear()
        .current_dir(folder.path())
        .args([
            "-q",
            "mesh",
            "points.csv",
            "-o",
            "m.vtu",
            "-r",
            "m.html",
            "-p",
            "m.png",
        ])
        .status()
        .expect("the program starts");
    assert!(status.success());
    assert_eq!(folder.names(), ["m.html", "m.png", "m.vtu", "points.csv"]);
}

#[test]
fn a_folder_that_is_gone_is_named() {
    let folder = Folder::with_points();
    let points = folder.path().join("points.csv");
    let script = format!(
        "mkdir gone && cd gone && rmdir ../gone && \"$D\" -q triangulate {} -o m.vtu",
        points.display()
    );
    fails(
        &folder,
        &script,
        4,
        "error: cannot create m.vtu: No such file or directory (os error 2)",
    );
    let script = format!(
        "mkdir gone && cd gone && rmdir ../gone && \"$D\" triangulate {} --json",
        points.display()
    );
    assert!(works(&folder, &script).contains("\"triangles\""));
}

/// Reads text through a pipe, with memory and time within bounds; the shell has no measure of memory, so a limit it is.
fn survives(
    folder: &Folder,
    line: &str,
    megabytes: u64,
    mut feed: impl FnMut(&mut dyn Write),
) -> (Option<i32>, String) {
    let script = format!("ulimit -v {}; exec \"$D\" -q {line}", megabytes << 10);
    let mut child = Command::new("timeout")
        .args(["60", "sh", "-c", &script])
        .env("D", assert_cmd::cargo::cargo_bin("delone"))
        .env("RAYON_NUM_THREADS", "1")
        .current_dir(folder.path())
        .stdin(Stdio::piped())
        .stdout(Stdio::null())
        .stderr(Stdio::piped())
        .spawn()
        .expect("a shell");
    feed(&mut child.stdin.take().expect("a pipe"));
    let mut said = String::new();
    let mut stderr = child.stderr.take().expect("a pipe");
    stderr.read_to_string(&mut said).expect("text");
    (child.wait().expect("it ends").code(), said)
}

/// Formats of text, read from a pipe.
const TEXTS: [&str; 14] = [
    "node", "poly", "csv", "geojson", "wkt", "vtu", "vtk", "msh", "mesh", "obj", "off", "ply",
    "dxf", "svg",
];

#[test]
fn a_line_without_end_is_an_error_soon() {
    let folder = Folder::new();
    for format in TEXTS {
        for piece in ["0", "x", " ", "1 ", "(", "\u{0}"] {
            let chunk = piece.repeat(1 << 16);
            // The reader may be gone before all is written.
            let (code, said) = survives(
                &folder,
                &format!("triangulate - --from {format}"),
                1024,
                |pipe| {
                    for _ in 0..(16 << 20) / chunk.len() {
                        if pipe.write_all(chunk.as_bytes()).is_err() {
                            return;
                        }
                    }
                },
            );
            // A number of points may have many zeros, and blanks are an empty file, which some formats allow.
            let may_be_empty = code == Some(0) && ["0", " "].contains(&piece);
            assert!(
                may_be_empty || matches!(code, Some(3 | 4)),
                "{format} of {piece:?}: {code:?} {said}"
            );
            assert!(said.len() < 2000, "{format} of {piece:?}: {said}");
        }
    }
}

/// Something in something in something: name, beginning, what is repeated, what comes behind as often, end.
const NESTED: [(&str, &str, &str, &str, &str); 12] = [
    ("a.geojson", "", "[", "]", ""),
    (
        "b.geojson",
        "{\"type\":\"Polygon\",\"coordinates\":",
        "[",
        "]",
        "}",
    ),
    (
        "c.geojson",
        "",
        "{\"type\":\"GeometryCollection\",\"geometries\":[",
        "]}",
        "",
    ),
    (
        "d.geojson",
        "",
        "{\"type\":\"Feature\",\"geometry\":",
        "}",
        "",
    ),
    (
        "e.geojson",
        "{\"type\":\"Point\",\"coordinates\":[0,0],\"x\":",
        "{\"x\":",
        "}",
        "}",
    ),
    ("a.wkt", "", "GEOMETRYCOLLECTION(", ")", ""),
    ("b.wkt", "POLYGON", "(", ")", ""),
    (
        "a.vtu",
        "<?xml version=\"1.0\"?>",
        "<VTKFile>",
        "</VTKFile>",
        "",
    ),
    (
        "b.vtu",
        "<VTKFile type=\"UnstructuredGrid\">",
        "<DataArray>",
        "</DataArray>",
        "</VTKFile>",
    ),
    (
        "a.svg",
        "<svg xmlns=\"http://www.w3.org/2000/svg\">",
        "<g>",
        "</g>",
        "</svg>",
    ),
    ("a.toml", "a=", "[", "]", ""),
    ("b.toml", "a=", "{b=", "}", ""),
];

#[test]
fn nesting_without_end_is_an_error() {
    let folder = Folder::new();
    for (name, begin, open, close, end) in NESTED {
        let depth = 200_000;
        let text = [begin, &open.repeat(depth), "0", &close.repeat(depth), end].concat();
        folder.write(name, text);
        let command = if name.ends_with("toml") {
            "run"
        } else {
            "info"
        };
        let (code, said) = survives(&folder, &format!("{command} {name}"), 1024, |_| ());
        // What a feature has besides its geometry is of no interest, however deep.
        if (name, code) == ("e.geojson", Some(0)) {
            continue;
        }
        assert!(matches!(code, Some(2..=4)), "{name}: {code:?} {said}");
        assert!(
            said.starts_with("error: ") && said.contains(name) && said.len() < 2000,
            "{name}: {said}"
        );
    }
    let deep = format!("{}1{}", "(".repeat(20_000), ")".repeat(20_000));
    folder.write("p.csv", support::POINTS);
    let line = format!("mesh p.csv --sizing '{deep}'");
    let (code, said) = survives(&folder, &line, 1024, |_| ());
    assert!(matches!(code, Some(2..=4)), "{code:?} {said}");
}

#[test]
fn blocks_of_blocks_are_counted_before_they_are_drawn() {
    // Each block holds ten of the next: 10¹² lines, if they were drawn.
    let folder = Folder::new();
    let mut text = String::from("0\nSECTION\n2\nBLOCKS\n");
    for i in 0..12 {
        text += &format!("0\nBLOCK\n2\nB{i}\n10\n0\n20\n0\n");
        for _ in 0..10 {
            text += &format!("0\nINSERT\n2\nB{}\n10\n0\n20\n0\n", i + 1);
        }
        text += "0\nENDBLK\n";
    }
    text += "0\nBLOCK\n2\nB12\n10\n0\n20\n0\n0\nLINE\n10\n0\n20\n0\n11\n1\n21\n1\n0\nENDBLK\n0\nENDSEC\n";
    text += "0\nSECTION\n2\nENTITIES\n0\nINSERT\n2\nB0\n10\n0\n20\n0\n0\nENDSEC\n0\nEOF\n";
    folder.write("bomb.dxf", text);
    let (code, said) = survives(&folder, "info bomb.dxf", 1024, |_| ());
    assert!(matches!(code, Some(3 | 4)), "{code:?} {said}");
    assert!(said.contains("bomb.dxf"), "{said}");
    // The same of uses in a picture.
    let mut text = String::from(
        "<svg xmlns=\"http://www.w3.org/2000/svg\"><defs><path id=\"u12\" d=\"M0 0L1 1\"/>",
    );
    for i in (0..12).rev() {
        let uses = format!("<use href=\"#u{}\"/>", i + 1).repeat(10);
        text += &format!("<g id=\"u{i}\">{uses}</g>");
    }
    text += "</defs><use href=\"#u0\"/></svg>";
    folder.write("bomb.svg", text);
    let (code, said) = survives(&folder, "info bomb.svg", 1024, |_| ());
    assert!(matches!(code, Some(3 | 4)), "{code:?} {said}");
    assert!(said.contains("bomb.svg"), "{said}");
}
