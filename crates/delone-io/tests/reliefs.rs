//! Rasters and contour lines in files.

use delone::surface::{Contour, Evaluation, Grid, Linear, Raster, Samples, contours, round_levels};
use delone::{Point, Triangulation, Watch};
use delone_io::{Error, PictureOptions, Relief, ReliefOptions, Target, write_relief};
use std::fs;
use std::path::Path;

/// A hill, on scattered points that do not quite cover the unit square.
fn hill() -> (Triangulation, Vec<f64>) {
    let mut state = 9_u64;
    let mut unit = move || {
        state = state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1);
        (state >> 33) as f64 / (1_u64 << 31) as f64
    };
    let points: Vec<Point> = (0..300).map(|_| Point::new(unit(), unit())).collect();
    let height = |p: &Point| 100.0 * (1.0 - (p.x - 0.5).powi(2) - (p.y - 0.4).powi(2)) - 60.0;
    let values = points.iter().map(height).collect();
    (delone::triangulate(points).expect("points"), values)
}

fn surface(columns: usize, rows: usize) -> (Raster, Vec<Contour>) {
    let (t, values) = hill();
    let samples = Samples::new(&t, values).expect("values");
    let grid = Grid::with_size(Point::new(0.0, 0.0), Point::new(1.0, 1.0), columns, rows);
    let raster = Evaluation::new().raster(&Linear::new(&samples), grid.expect("a grid"));
    let levels = round_levels(20, samples.range().expect("values")).expect("levels");
    let lines = contours(&samples, &levels, &()).expect("lines");
    (raster.expect("a raster"), lines)
}

fn write(path: &Path, relief: Relief<'_>) -> Result<(), Error> {
    let options = ReliefOptions {
        picture: PictureOptions {
            size: 300,
            ..PictureOptions::default()
        },
        ..ReliefOptions::default()
    };
    write_relief(&[Target::from_arg(path, None)], relief, &options, &()).map(drop)
}

#[test]
fn ascii_grids_read_back_as_they_were() {
    let folder = tempfile::tempdir().expect("a folder");
    for (columns, rows) in [(7, 7), (5, 9)] {
        let (raster, _) = surface(columns, rows);
        let path = folder.path().join("hill.asc");
        let relief = Relief {
            raster: Some(&raster),
            contours: &[],
        };
        write(&path, relief).expect("written");
        let text = fs::read_to_string(&path).expect("there");
        let (header, body): (Vec<&str>, Vec<&str>) = text
            .lines()
            .partition(|line| line.starts_with(char::is_alphabetic));
        assert_eq!(
            header[..2],
            [format!("ncols {columns}"), format!("nrows {rows}")]
        );
        assert_eq!(header[2..4], ["xllcorner 0", "yllcorner 0"]);
        assert_eq!(header.len(), if columns == rows { 6 } else { 7 });
        assert!(header.contains(&"NODATA_value -9999"));
        let mut missing = 0;
        for (row, line) in body.iter().enumerate() {
            let numbers: Vec<f64> = line
                .split(' ')
                .map(|n| n.parse().expect("a number"))
                .collect();
            assert_eq!(numbers.len(), columns);
            for (column, number) in numbers.into_iter().enumerate() {
                assert_eq!(number, raster.value(column, row).unwrap_or(-9999.0));
                missing += usize::from(number == -9999.0);
            }
        }
        assert_eq!(body.len(), rows);
        assert!(missing < columns * rows / 4);
    }
}

#[test]
fn no_cell_has_the_value_that_means_none() {
    let t = delone::triangulate([(0.0, 0.0), (1.0, 0.0), (0.0, 1.0)]).expect("points");
    let samples = Samples::new(&t, [-9999.0; 3]).expect("values");
    let grid = Grid::with_size(Point::new(0.0, 0.0), Point::new(1.0, 1.0), 2, 2).expect("a grid");
    let raster = Evaluation::new()
        .raster(&Linear::new(&samples), grid)
        .expect("a raster");
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("pit.ASC");
    let relief = Relief {
        raster: Some(&raster),
        contours: &[],
    };
    write(&path, relief).expect("written");
    let text = fs::read_to_string(&path).expect("there");
    assert!(text.contains("NODATA_value -99999\n"));
    assert!(text.ends_with("-9999 -99999\n-9999 -9999\n"), "{text}");
}

#[test]
fn arrays_hold_rows_from_the_top_and_nan() {
    let (raster, _) = surface(6, 4);
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("hill.npy");
    let relief = Relief {
        raster: Some(&raster),
        contours: &[],
    };
    write(&path, relief).expect("written");
    let bytes = fs::read(&path).expect("there");
    let data = bytes.len() - 8 * 24;
    let header = String::from_utf8_lossy(&bytes[..data]).into_owned();
    assert!(
        header.contains("'descr': '<f8'") && header.contains("'shape': (4, 6)"),
        "{header}"
    );
    for (i, value) in bytes[data..].chunks(8).enumerate() {
        let value = f64::from_le_bytes(value.try_into().expect("eight bytes"));
        let expected = raster.value(i % 6, i / 6);
        assert_eq!((!value.is_nan()).then_some(value), expected);
    }
}

#[test]
fn lines_of_geojson_have_their_levels_and_close() {
    let (_, lines) = surface(2, 2);
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("hill.geojson");
    let relief = Relief {
        raster: None,
        contours: &lines,
    };
    write(&path, relief).expect("written");
    let text = fs::read_to_string(&path).expect("there");
    let object: serde_json::Value = serde_json::from_str(&text).expect("JSON");
    let features = object["features"].as_array().expect("features");
    assert_eq!(features.len(), lines.len());
    for (feature, line) in features.iter().zip(&lines) {
        assert_eq!(feature["properties"]["level"], line.value);
        let places = feature["geometry"]["coordinates"]
            .as_array()
            .expect("places");
        assert_eq!(
            places.len(),
            line.points.len() + usize::from(line.is_closed)
        );
        let is_ring = places.first() == places.last();
        assert_eq!(is_ring, line.is_closed);
        assert_eq!(places[1][0], line.points[1].x);
    }
    assert!(lines.iter().any(|line| line.is_closed));
}

#[test]
fn pictures_show_cells_lines_and_a_legend() {
    let (raster, lines) = surface(40, 40);
    let folder = tempfile::tempdir().expect("a folder");
    let reliefs = [
        (Some(&raster), &lines[..]),
        (Some(&raster), &[]),
        (None, &lines[..]),
        (None, &[]),
    ];
    let mut sizes = Vec::new();
    for (i, (raster, contours)) in reliefs.into_iter().enumerate() {
        for extension in ["png", "svg"] {
            let path = folder.path().join(format!("{i}.{extension}"));
            write(&path, Relief { raster, contours }).expect("written");
            sizes.push(fs::read(&path).expect("there").len());
        }
        let svg = fs::read_to_string(folder.path().join(format!("{i}.svg"))).expect("there");
        assert_eq!(svg.contains("<image"), raster.is_some());
        let strokes = svg.matches("stroke-width").count();
        assert!(strokes >= contours.len(), "{strokes}");
        assert!(svg.ends_with("</svg>\n"));
    }
    // Every part adds something.
    assert!(sizes[0] > sizes[2] && sizes[2] > sizes[6] && sizes[4] > sizes[6]);
}

#[test]
fn what_a_format_cannot_hold_is_refused() {
    let (raster, lines) = surface(3, 3);
    let folder = tempfile::tempdir().expect("a folder");
    let both = Relief {
        raster: Some(&raster),
        contours: &lines,
    };
    let only = Relief {
        raster: None,
        ..both
    };
    for (name, relief) in [
        ("a.csv", both),
        ("a.vtu", both),
        ("a.asc", only),
        ("a.npy", only),
    ] {
        let path = folder.path().join(name);
        let error = write(&path, relief).expect_err("refused");
        assert!(
            matches!(error, Error::Unsupported { .. }),
            "{name}: {error}"
        );
        assert!(!path.exists());
    }
}

struct Impatient;

impl Watch for Impatient {
    fn is_cancelled(&self) -> bool {
        true
    }
}

#[test]
fn cancelling_leaves_no_file() {
    let (raster, lines) = surface(20, 20);
    let folder = tempfile::tempdir().expect("a folder");
    let relief = Relief {
        raster: Some(&raster),
        contours: &lines,
    };
    for name in ["a.asc", "a.npy", "a.png", "a.svg", "a.geojson"] {
        let target = Target::from_arg(folder.path().join(name), None);
        let options = ReliefOptions::default();
        let result = write_relief(&[target], relief, &options, &Impatient);
        assert!(matches!(result, Err(Error::Cancelled)), "{name}");
    }
    assert_eq!(fs::read_dir(folder.path()).expect("there").count(), 0);
}
