//! Airfoils, `.dat`.

use crate::{area, data, domain, file, places, refuses};
use delone::DomainRule;
use delone_io::{Format, ReadOptions, Source, read_domain};
use std::path::{Path, PathBuf};

#[test]
fn both_forms_of_airfoils_are_read() {
    let wedge = file("lednicer.dat", &ReadOptions::default());
    let found = places(&wedge);
    // Around from the trailing edge, the leading edge once; the open trailing edge is closed.
    assert_eq!(found.len(), 9);
    assert_eq!(
        (found[0], found[4], found[8]),
        ([1.0, 0.001], [0.0, 0.0], [1.0, -0.001])
    );
    assert_eq!(
        (wedge.segments.len(), wedge.usual_rule),
        (9, DomainRule::EvenOdd)
    );
    assert_eq!((wedge.polygons.len(), wedge.polygons[0].clone()), (1, 0..9));
    let both = file("elements.dat", &ReadOptions::default());
    assert_eq!(both.polygons, [0..4, 4..8]);
    assert_eq!(both.segment_markers, Some(vec![1, 1, 1, 1, 2, 2, 2, 2]));
    for name in ["lednicer.dat", "elements.dat"] {
        let head = std::fs::read(data(name)).unwrap();
        assert_eq!(
            Format::detect(Some(Path::new(name)), &head),
            Some(Format::Airfoil),
            "{name}"
        );
    }
}

#[test]
fn broken_airfoils_name_the_line() {
    let foil = |text: &str| format!("A NAME\n1.0 0.0\n0.5 0.1\n{text}");
    refuses(
        "a.dat",
        &foil("0 0 0\n"),
        "a.dat:4: expected 2 columns, found 3",
    );
    refuses("a.dat", &foil("nan 0\n"), "a.dat:4: point 2: x is NaN");
    refuses("a.airfoil", "A NAME\n", "a.airfoil: the file is empty");
    refuses(
        "a.dat",
        &foil("0.5 0.1\n1 0\n"),
        "a.dat: an outline of 2 distinct points; at least 3",
    );
    refuses(
        "a.dat",
        "A NAME\n3. 3.\n0 0\n.5 .1\n1 0\n0 0\n",
        "a.dat: truncated: header says 6 points, file has 4",
    );
    refuses(
        "a.dat",
        "A NAME\n3. 3.\n0 0\n.5 .1\nend\n",
        "a.dat:5: x and y of a point is not a number: \"end\"",
    );
    let noted = domain("a.dat", &foil("0 0\n0.5 -0.1\nDrawn by\nsomebody 3 4\n"));
    assert_eq!(
        noted.vertices.notes,
        ["the text from line 6 on is left out: \"Drawn by\" …"]
    );
}

#[test]
fn tables_are_no_airfoils() {
    for text in [
        "x y\n1 0\n0.5 0.1\n",
        "lon,lat\n1,0\n0,0\n",
        "1 0\n0.5 0.1\n0 0\n",
        "# 3 points\n1 0\n0.5 0.1\n0 0\n",
        "survey of 1999\n1234.5 99.25\n1240 93\n",
        "A NAME\n1 0 3\n0.5 0.1 3\n",
    ] {
        let format = Format::detect(Some(Path::new("a.dat")), text.as_bytes());
        assert_eq!(format, Some(Format::Table), "{text:?}");
    }
}

#[test]
fn every_airfoil_of_the_collection_is_read() {
    let root = std::env::var_os("DELONE_SHARED").map_or_else(
        || Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../shared"),
        PathBuf::from,
    );
    let dat = |folder: &str| {
        let entries = std::fs::read_dir(root.join("data").join(folder)).ok()?;
        let paths = entries.map(|entry| entry.unwrap().path());
        Some(
            paths
                .filter(|p| p.extension().is_some_and(|e| e == "dat"))
                .collect::<Vec<_>>(),
        )
    };
    let (Some(airfoils), Some(tables)) = (dat("airfoil"), dat("poly2tri")) else {
        eprintln!("skipped: the shared data are absent (set DELONE_SHARED)");
        return;
    };
    assert!(airfoils.len() == 35 && tables.len() == 12);
    for path in airfoils {
        let bytes = std::fs::read(&path).unwrap();
        assert_eq!(
            Format::detect(Some(&path), &bytes),
            Some(Format::Airfoil),
            "{}",
            path.display()
        );
        let domain = read_domain(&Source::Path(path.clone()), &ReadOptions::default(), &());
        let domain = domain.unwrap_or_else(|error| panic!("{error}"));
        let is_text = |l: &&str| {
            l.split_whitespace()
                .filter_map(|w| w.parse::<f64>().ok())
                .count()
                != 2
        };
        let rows = String::from_utf8_lossy(&bytes)
            .lines()
            .filter(|l| !is_text(l))
            .count();
        let n = domain.vertices.points.len();
        assert!(
            n + 3 >= rows && n <= rows,
            "{}: {n} of {rows}",
            path.display()
        );
        assert_eq!(domain.polygons.len(), 1, "{}", path.display());
        let area = area(domain);
        assert!((0.01..0.3).contains(&area), "{}: {area}", path.display());
    }
    for path in tables {
        let bytes = std::fs::read(&path).unwrap();
        assert_eq!(
            Format::detect(Some(&path), &bytes),
            Some(Format::Table),
            "{}",
            path.display()
        );
    }
}
