//! `delone formats`, seen from the shell; the page of formats is what it prints.

mod support;

use serde_json::Value;
use std::path::Path;
use support::Folder;

#[test]
fn the_table_names_every_format() {
    let text = Folder::new().run("formats", 0).stdout;
    for name in ["node", "csv", "vtu", "ply", "html"] {
        assert!(
            text.lines().any(|line| line.starts_with(name)),
            "{name}: {text}"
        );
    }
    let off = text
        .lines()
        .find(|line| line.starts_with("off"))
        .expect("off");
    assert!(
        off.contains("p·t   p·t    z·········  decimals  Geomview: points and faces"),
        "{off}"
    );
}

#[test]
fn one_format_is_shown_in_full() {
    let text = Folder::new().run("formats .PLY", 0).stdout;
    for part in [
        "ply: Stanford: points, edges and faces",
        "reads        points, segments, mesh",
        "coordinates  f64",
        "delone mesh in.poly -o mesh.ply",
    ] {
        assert!(text.contains(part), "{part:?} in {text}");
    }
    Folder::new()
        .run("formats docx", 2)
        .says(&["unknown format \"docx\"", "known are node"]);
}

#[test]
fn json_has_the_same() {
    let one = Folder::new().run("formats obj --json", 0).json();
    assert_eq!(
        one["keeps"],
        serde_json::json!([
            "z",
            "segments",
            "markers of segments",
            "regions of triangles"
        ])
    );
    let all = Folder::new().run("formats --json", 0).json();
    let all = all.as_array().expect("an array");
    assert_eq!(all.iter().find(|f| f["name"] == "obj"), Some(&one));
    let gif = all.iter().find(|f| f["name"] == "gif").expect("gif");
    assert_eq!(
        (&gif["coordinates"], &gif["writes"]),
        (&Value::Null, &serde_json::json!(["animation"]))
    );
}

/// Run with `DELONE_BLESS=1` to write the page anew, and read the difference.
#[test]
fn the_page_of_formats_is_what_the_program_prints() {
    let page = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/formats.md");
    let text = Folder::new().run("formats --markdown", 0).stdout;
    if std::env::var_os("DELONE_BLESS").is_some() {
        std::fs::write(&page, &text).expect("the page can be written");
    }
    let there = std::fs::read_to_string(&page).expect("the page is there");
    assert!(
        there == text,
        "docs/formats.md is not what `delone formats --markdown` prints; DELONE_BLESS=1 writes it"
    );
}

/// What does not fit is said; what does, is not.
#[test]
fn what_is_left_out_is_said_in_a_note() {
    let folder = Folder::new();
    folder.write("survey.csv", "x,y,z,heat\n0,0,5,1\n1,0,6,2\n1,1,7,3\n");
    folder
        .run("convert survey.csv survey.off", 0)
        .says(&["note: survey.off: left out, for off has no place: attribute heat"]);
    let quiet = folder.run("convert survey.csv survey.ply", 0).stderr;
    assert!(!quiet.contains("left out"), "{quiet}");
}
