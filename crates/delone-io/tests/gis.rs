//! Shapefiles, GeoParquet and hexadecimal geometries: files made by others, and broken ones.

use delone::{DomainRule, Point};
use delone_io::{DomainData, Error, MemoryFile, ReadOptions, Source, read_domain};
use std::path::{Path, PathBuf};

fn fixture(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/gis");
    folder.join(name)
}

fn domain(name: &str) -> DomainData {
    let source = Source::from_arg(fixture(name));
    read_domain(&source, &ReadOptions::default(), &()).unwrap_or_else(|error| panic!("{error}"))
}

/// Reads files that lie beside each other in memory, the first of them.
fn together(files: &[(&str, Vec<u8>)]) -> Result<DomainData, Error> {
    let file = |(name, bytes): &(&str, Vec<u8>)| MemoryFile {
        name: name.into(),
        bytes: bytes.clone(),
    };
    let source = Source::Together {
        files: files.iter().map(file).collect(),
        opened: 0,
    };
    read_domain(&source, &ReadOptions::default(), &())
}

fn bytes(name: &str) -> Vec<u8> {
    std::fs::read(fixture(name)).expect("a fixture")
}

fn message(result: Result<DomainData, Error>) -> String {
    result.expect_err("an error").to_string()
}

/// Returns names and values of the attributes; NaN reads as such.
fn attributes(domain: &DomainData) -> Vec<(&str, String)> {
    let attributes = domain.vertices.attributes.iter();
    attributes
        .map(|a| (a.name.as_str(), format!("{:?}", a.values)))
        .collect()
}

fn left_out(domain: &DomainData) -> Vec<&str> {
    let left_out = domain.vertices.left_out.iter();
    left_out.map(|column| column.name.as_str()).collect()
}

/// The kinds of files that hold the same layers.
const KINDS: &[&str] = &[
    "shp",
    #[cfg(feature = "parquet")]
    "parquet",
];

#[test]
fn polygons_keep_their_holes_and_markers() {
    for kind in KINDS {
        let domain = domain(&format!("fields.{kind}"));
        assert_eq!(domain.vertices.points.len(), 7 + 7, "{kind}");
        assert_eq!(domain.usual_rule, DomainRule::EvenOdd);
        let markers = domain.segment_markers.as_deref().expect("markers");
        assert_eq!(markers, [[7; 7], [-3; 7]].concat(), "{kind}");
        let sizes: Vec<_> = domain.polygons.iter().map(ExactSizeIterator::len).collect();
        // All rings of a record of a shapefile are one polygon.
        let expected: &[usize] = if *kind == "shp" { &[7, 7] } else { &[7, 3, 4] };
        assert_eq!(sizes, expected, "{kind}");
        let mut left_out = left_out(&domain);
        left_out.sort_unstable();
        assert_eq!(left_out, ["crop", "yield"], "{kind}");
        assert!(domain.vertices.attributes.is_empty());
    }
}

#[test]
fn contour_lines_give_their_points_heights() {
    for kind in KINDS {
        let domain = domain(&format!("contours.{kind}"));
        assert_eq!(domain.segments.len(), 3, "{kind}");
        assert_eq!(
            domain.segment_markers.as_deref(),
            Some(&[4, 4, 9][..]),
            "{kind}"
        );
        let mut attributes = attributes(&domain);
        attributes.sort();
        let expected = [
            ("elev", "[10.5, 10.5, 10.5, 20.0, 20.0]".to_owned()),
            ("id", "[4.0, 4.0, 4.0, 9.0, 9.0]".to_owned()),
        ];
        assert_eq!(attributes, expected, "{kind}");
        assert_eq!(domain.usual_rule, DomainRule::Hull);
    }
}

#[test]
fn places_have_heights_and_columns() {
    let native = cfg!(feature = "parquet").then_some("places-native.parquet");
    let files = KINDS.iter().map(|kind| format!("places.{kind}"));
    for name in files.chain(native.map(str::to_owned)) {
        let domain = domain(&name);
        let expected = [(1.0, 2.0), (-0.5, 0.25), (7.0, 8.0)].map(|(x, y)| Point::new(x, y));
        assert_eq!(domain.vertices.points, expected, "{name}");
        let expected = [
            ("z", "[3.0, 4.0, 5.0]".to_owned()),
            ("pop", "[100.0, 250.0, 0.0]".to_owned()),
            ("rank", "[1.5, NaN, -2.0]".to_owned()),
        ];
        assert_eq!(attributes(&domain), expected, "{name}");
        assert_eq!(left_out(&domain), ["name"], "{name}");
    }
}

#[test]
fn measures_are_read_beside_heights() {
    let domain = domain("measured.shp");
    assert_eq!(
        domain.vertices.points,
        [Point::new(0.0, 0.0), Point::new(3.0, 4.0)]
    );
    let [z, m] = &domain.vertices.attributes[..2] else {
        panic!("{:?}", domain.vertices.attributes);
    };
    assert_eq!((&z.name[..], &z.values[..]), ("z", &[1.0, 2.0][..]));
    assert_eq!((&m.name[..], &m.values[..]), ("m", &[10.0, 20.0][..]));
    // Measures may be missing behind heights.
    let mut short = bytes("measured.shp");
    short.truncate(220);
    short[24..28].copy_from_slice(&110u32.to_be_bytes());
    short[104..108].copy_from_slice(&56u32.to_be_bytes());
    let short = together(&[("a.shp", short)]).expect("a line");
    assert_eq!(attributes(&short), [("z", "[1.0, 2.0]".to_owned())]);
    // Only what is less than this is no measure.
    let mut shp = bytes("measured.shp");
    replace(&mut shp, 10.0, -1e38);
    replace(&mut shp, 20.0, -1.1e38);
    let domain = together(&[("a.shp", shp)]).expect("a line");
    let m = &domain.vertices.attributes[1].values;
    assert!(m[0] == -1e38 && m[1].is_nan(), "{m:?}");
}

/// A table of so many columns of one digit, and so many rows.
fn table(columns: usize, rows: usize) -> Vec<u8> {
    let mut dbf = vec![0; 32];
    dbf[4..8].copy_from_slice(&(rows as u32).to_le_bytes());
    dbf[8..10].copy_from_slice(&(33 + 32 * columns as u16).to_le_bytes());
    dbf[10..12].copy_from_slice(&(1 + columns as u16).to_le_bytes());
    for column in 0..columns {
        let mut field = [0; 32];
        field[..4].copy_from_slice(format!("c{column:03}").as_bytes());
        (field[11], field[16]) = (b'N', 1);
        dbf.extend(field);
    }
    dbf.push(b'\r');
    dbf.extend(format!(" {}", "7".repeat(columns)).repeat(rows).bytes());
    dbf
}

#[test]
fn lines_of_many_points_have_few_columns() {
    // Two points a line are no more than the table has itself.
    for (name, rows, left_out_of) in [("measured.shp", 1, &[][..]), ("contours.shp", 2, &["c064"])]
    {
        let files = [("a.shp", bytes(name)), ("a.dbf", table(65, rows))];
        let domain = together(&files).expect("lines");
        assert_eq!(left_out(&domain), left_out_of, "{name}");
        let kept = domain.vertices.attributes.iter();
        let kept = kept.filter(|a| a.name.starts_with('c') && a.values[0] == 7.0);
        assert_eq!(kept.count(), 65 - left_out_of.len(), "{name}");
    }
}

/// Replaces a number wherever it stands.
fn replace(bytes: &mut [u8], from: f64, to: f64) {
    let from = from.to_le_bytes();
    let mut found = 0;
    for at in 0..bytes.len() - 7 {
        if bytes[at..].starts_with(&from) {
            bytes[at..at + 8].copy_from_slice(&to.to_le_bytes());
            found += 1;
        }
    }
    assert!(found > 0, "the number is not there");
}

#[cfg(feature = "parquet")]
#[test]
fn a_place_that_lacks_one_coordinate_is_refused() {
    let mut table = bytes("places-native.parquet");
    replace(&mut table, 8.0, f64::NAN);
    let message = message(together(&[("a.parquet", table)]));
    assert!(message.contains("point 2: y is NaN or null"), "{message}");
}

#[test]
fn hexadecimal_geometries_are_those_of_the_words() {
    let hex = domain("postgis.wkt");
    let words = "POLYGON ((0 0, 8 0, 8 8, 0 8, 0 0), (2 2, 4 2, 3 4, 2 2))\n\
        SRID=4326;MULTIPOINT (1 1, 5 5)\nLINESTRING Z (0 0 1, 8 8 2)\n";
    let same = |text: &str| {
        let (name, bytes) = ("a.wkt".to_owned(), text.as_bytes().to_vec());
        let source = Source::Memory { name, bytes };
        read_domain(&source, &ReadOptions::default(), &()).expect("a domain")
    };
    let words = same(words);
    assert_eq!(hex.vertices.points, words.vertices.points);
    assert_eq!(
        (&hex.segments, &hex.polygons, &hex.segment_markers),
        (&words.segments, &words.polygons, &words.segment_markers)
    );
    let text = String::from_utf8(bytes("postgis.wkt")).expect("text");
    let escaped = text.replace("01", "\\x01").replace("\\x01", "01");
    assert_eq!(same(&escaped).segments, hex.segments);
    let first = text.lines().next().expect("a line");
    assert_eq!(same(&format!("\\x{first}")).segments.len(), 7);
    // Without a name, the content tells.
    let source = Source::Memory {
        name: "-".to_owned(),
        bytes: text.into_bytes(),
    };
    let told = read_domain(&source, &ReadOptions::default(), &()).expect("told");
    assert_eq!(told.segments, hex.segments);
}

#[test]
fn triangles_in_words_are_polygons() {
    let text = "TRIANGLE ((0 0, 1 0, 0 1, 0 0))\nTIN Z (((0 0 1, 1 0 1, 0 1 1, 0 0 1)), \
        ((1 0 1, 1 1 1, 0 1 1, 1 0 1)))\nPOLYHEDRALSURFACE (((5 5, 6 5, 6 6, 5 6, 5 5)))";
    let domain = together(&[("a.wkt", text.into())]).expect("a domain");
    let sizes: Vec<_> = domain.polygons.iter().map(ExactSizeIterator::len).collect();
    assert_eq!(sizes, [3, 3, 3, 4]);
    assert_eq!(
        domain.segment_markers,
        Some([[1; 3].as_slice(), &[2; 6], &[3; 4]].concat())
    );
}

#[test]
fn a_shapefile_needs_no_table_but_a_fitting_one() {
    let alone = together(&[("a.shp", bytes("contours.shp"))]).expect("shapes");
    assert_eq!(alone.segment_markers.as_deref(), Some(&[1, 1, 2][..]));
    assert!(alone.vertices.attributes.is_empty());
    let files = [
        ("a.shp", bytes("contours.shp")),
        ("A.DBF", bytes("contours.dbf")),
    ];
    let both = together(&files).expect("shapes and table");
    assert_eq!(both, domain("contours.shp"));
    let files = [
        ("a.shp", bytes("contours.shp")),
        ("a.dbf", bytes("places.dbf")),
    ];
    let expected = "a.shp at byte 0: 2 shapes, but the .dbf beside it has 3 rows; remove it if it is another's";
    assert_eq!(message(together(&files)), expected);
    // A row that is deleted takes its shape along; other shapes keep their rows.
    let mut table = bytes("contours.dbf");
    let start = usize::from(u16::from_le_bytes([table[8], table[9]]));
    table[start] = b'*';
    let files = [("a.shp", bytes("contours.shp")), ("a.dbf", table)];
    let rest = together(&files).expect("the second line");
    assert_eq!(rest.segments.len(), 1);
    assert_eq!(rest.vertices.attributes[0].values, [20.0, 20.0]);
}

#[test]
fn null_shapes_are_skipped_and_multipatches_refused() {
    let shapes = |kind: i32| {
        let mut shp = bytes("places.shp");
        let size = 4 + 4;
        shp.truncate(100);
        for number in 1..3_u32 {
            shp.extend(number.to_be_bytes());
            shp.extend((size as u32 / 2).to_be_bytes());
            shp.extend(kind.to_le_bytes());
            shp.extend([0; 4]);
        }
        let words = shp.len() as u32 / 2;
        shp[24..28].copy_from_slice(&words.to_be_bytes());
        together(&[("a.shp", shp)])
    };
    assert!(shapes(0).expect("nothing").vertices.points.is_empty());
    assert_eq!(
        message(shapes(31)),
        "a.shp at byte 100: record 1: a multipatch, which is a surface in space; only points, lines and polygons are read"
    );
    assert_eq!(
        message(shapes(9)),
        "a.shp at byte 100: record 1: type 9 is none of a shapefile's"
    );
    assert_eq!(
        message(shapes(1)),
        "a.shp at byte 100: record 1: too short: 8 bytes are needed, 4 are left"
    );
}

#[test]
fn counts_of_shapefiles_are_not_trusted() {
    let with = |file: &str, at: usize, value: [u8; 4]| {
        let mut shp = bytes(file);
        shp[at..at + 4].copy_from_slice(&value);
        message(together(&[("a.shp", shp)]))
    };
    let huge = i32::MAX.to_le_bytes();
    // The first record begins at 100, its shape at 108, its box at 112, its counts at 144.
    for (at, value, expected) in [
        (
            0,
            [0; 4],
            "a.shp at byte 0: no shapefile: it does not begin with the number 9994",
        ),
        (
            24,
            [0x7f; 4],
            "a.shp at byte 0: truncated: header says 4278124286 bytes, file has 508",
        ),
        (
            104,
            [0x7f; 4],
            "a.shp at byte 100: record 1: truncated: header says 4278124286 bytes, file has 400",
        ),
        (
            144,
            huge,
            "a.shp at byte 100: record 1: truncated: header says 2147483647 parts, file has 38",
        ),
        (
            144,
            [0xff; 4],
            "a.shp at byte 100: record 1: truncated: header says 4294967295 parts, file has 38",
        ),
        (
            148,
            huge,
            "a.shp at byte 100: record 1: truncated: header says 2147483647 points, file has 9",
        ),
        (
            156,
            huge,
            "a.shp at byte 100: record 1: part 1 begins at point 2147483647 of 9",
        ),
        (
            152,
            [1, 0, 0, 0],
            "a.shp at byte 100: record 1: points before the first part",
        ),
        (
            156,
            [2, 0, 0, 0],
            "a.shp at byte 100: record 1: ring 0 has 2 positions; at least 4 are needed, the last like the first",
        ),
        (
            166,
            [0xf0, 0x7f, 0, 0],
            "a.shp at byte 100: record 1: point 0: x is inf, coordinates must be finite; repair or remove it",
        ),
    ] {
        assert_eq!(with("fields.shp", at, value), expected);
    }
}

#[test]
fn tables_beside_shapes_are_not_trusted() {
    let with = |at: usize, value: &[u8]| {
        let mut dbf = bytes("contours.dbf");
        dbf[at..at + value.len()].copy_from_slice(value);
        message(together(&[
            ("a.shp", bytes("contours.shp")),
            ("a.dbf", dbf),
        ]))
    };
    assert_eq!(
        with(4, &[0xff; 4]),
        "a.dbf at byte 4: truncated: header says 4294967295 rows, file has 2"
    );
    assert!(
        with(8, &[0xff; 2]).starts_with("a.dbf at byte 0: no table: the header is not complete")
    );
    assert!(with(10, &[0; 2]).starts_with("a.dbf at byte 32: fields of "));
    assert!(with(32 + 16, &[0xff]).starts_with("a.dbf at byte 32: fields of "));
    let empty = together(&[("a.shp", bytes("contours.shp")), ("a.dbf", Vec::new())]);
    assert!(message(empty).starts_with("a.dbf at byte 0: no table"));
}

/// Reads every beginning of a file, and the file with every byte changed: what comes is a domain or an error.
#[test]
fn no_cut_and_no_change_does_harm() {
    let mut names = vec!["fields.shp", "places.shp", "measured.shp", "postgis.wkt"];
    if cfg!(feature = "parquet") {
        names.extend([
            "fields.parquet",
            "places-native.parquet",
            "pandas-snappy.parquet",
            "duckdb.parquet",
        ]);
    }
    // What a foreign reader panics about is caught; the messages would fill the screen.
    std::panic::set_hook(Box::new(|_| {}));
    for name in names {
        let whole = bytes(name);
        let step = (whole.len() / 1500).max(1);
        let read =
            |content: Vec<u8>| together(&[(name, content), ("fields.dbf", bytes("fields.dbf"))]);
        for end in (0..whole.len()).step_by(step) {
            let result = read(whole[..end].to_vec());
            let is_text = name.ends_with("wkt");
            assert!(is_text || result.is_err(), "{name} cut at {end}");
        }
        for at in (0..whole.len()).step_by(step) {
            for change in [0xff, 0x80, 1] {
                let mut damaged = whole.clone();
                damaged[at] ^= change;
                drop(read(damaged));
            }
        }
    }
    drop(std::panic::take_hook());
}

#[test]
fn damaged_tables_beside_shapes_do_no_harm() {
    let whole = bytes("places.dbf");
    for at in 0..whole.len() {
        for change in [0xff, 0x80, 1] {
            let mut damaged = whole.clone();
            damaged[at] ^= change;
            drop(together(&[
                ("a.shp", bytes("places.shp")),
                ("a.dbf", damaged),
            ]));
        }
    }
}
