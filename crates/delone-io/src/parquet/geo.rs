//! GeoParquet: a column of geometries, and columns that describe them.

use super::columns::Kind;
use super::file::File;
use crate::features::{Columns, Features};
use crate::shapes::Position;
use crate::{Attribute, DomainData, Error, LeftOut, Place, Problem, cancel, wkb};
use delone::{Point, Watch};

/// Where the geometries are.
pub(super) enum Geometry {
    /// In a column of well-known binary.
    Binary { field: usize, leaf: usize },
    /// In a struct of coordinates.
    Points { field: usize },
}

/// Finds the column of geometries, if the file has one that is known to be.
pub(super) fn find(file: &File<'_>) -> Result<Option<Geometry>, Error> {
    let Some(text) = file.value_of("geo") else {
        let is_geometry = |kind| matches!(kind, Kind::Bytes { is_geometry: true });
        let field = file.fields.iter().position(|field| is_geometry(field.kind));
        return Ok(field.and_then(|field| binary(file, field)));
    };
    let wrong = |text: &str| file.other(format!("the metadata \"geo\" {text}"));
    let metadata: serde_json::Value =
        serde_json::from_str(text).map_err(|e| wrong(&format!("are broken: {e}")))?;
    let column = metadata["primary_column"].as_str();
    let column = column.ok_or_else(|| wrong("name no primary column"))?;
    let field = file.field(column);
    let field =
        field.ok_or_else(|| wrong(&format!("name the column {column:?}, which is not there")))?;
    let encoding = metadata["columns"][column]["encoding"].as_str();
    let found = match encoding.unwrap_or("WKB") {
        "WKB" => binary(file, field),
        "point" => Some(Geometry::Points { field }),
        other => {
            return Err(wrong(&format!(
                "say that geometries are encoded as {other:?}; save them as WKB"
            )));
        }
    };
    let found =
        found.ok_or_else(|| wrong(&format!("name the column {column:?}, which holds no bytes")))?;
    Ok(Some(found))
}

fn binary(file: &File<'_>, field: usize) -> Option<Geometry> {
    let leaf = file.fields[field].leaf?;
    let is_bytes = matches!(file.fields[field].kind, Kind::Bytes { .. });
    is_bytes.then_some(Geometry::Binary { field, leaf })
}

/// Reads the geometries and what describes them.
pub(super) fn read(
    name: &str,
    file: &mut File<'_>,
    geometry: &Geometry,
    watch: &dyn Watch,
) -> Result<DomainData, Error> {
    let (Geometry::Binary { field, .. } | Geometry::Points { field }) = *geometry;
    let mut features = Features::new(columns(file, field)?);
    match *geometry {
        Geometry::Points { field } => points(file, field, &mut features, watch)?,
        Geometry::Binary { leaf, .. } => file.bytes(leaf, |row, bytes| {
            let at_row = |at: usize, problem: Problem| Error::Malformed {
                file: name.to_owned(),
                place: Place::File,
                problem: Problem::Other(format!("row {row}: byte {at} of the geometry: {problem}")),
            };
            match wkb::read(bytes.unwrap_or_default(), &mut features.shapes, watch) {
                Err(_) if bytes.is_none_or(<[u8]>::is_empty) => {}
                Err(wkb::Stop::Cancelled) => return Err(Error::Cancelled),
                Err(wkb::Stop::Problem(at, problem)) => return Err(at_row(at, problem)),
                Ok(()) => {}
            }
            features.end();
            Ok(())
        })?,
    }
    features.finish(watch)
}

/// Reads the columns besides the geometries; their boxes tell nothing new.
fn columns(file: &mut File<'_>, geometry: usize) -> Result<Columns, Error> {
    let mut columns = Columns::default();
    for field in 0..file.fields.len() {
        let (name, kind) = (file.fields[field].name.clone(), file.fields[field].kind);
        if field == geometry || name == "bbox" && file.fields[field].leaf.is_none() {
            continue;
        }
        match file.fields[field].leaf.filter(|_| kind.is_number()) {
            Some(leaf) => match file.numbers(leaf, kind)? {
                Ok(values) => columns.numbers.push(Attribute { name, values }),
                Err((point, text)) => columns.left_out.push(LeftOut { name, point, text }),
            },
            None => columns.left_out.push(LeftOut {
                name,
                point: 0,
                text: kind.name().to_owned(),
            }),
        }
    }
    Ok(columns)
}

/// Reads points that are structs of coordinates; one without x and y is empty.
fn points(
    file: &mut File<'_>,
    field: usize,
    features: &mut Features,
    watch: &dyn Watch,
) -> Result<(), Error> {
    let mut read = |name: &str| match file.leaf_within(field, name) {
        Some((leaf, kind)) if kind.is_number() => file.numbers(leaf, kind).map(Result::ok),
        _ => Ok(None),
    };
    let (x, y, z, m) = (read("x")?, read("y")?, read("z")?, read("m")?);
    let (Some(x), Some(y)) = (x, y) else {
        return Err(file.other("points without x and y"));
    };
    let at = |column: &Option<Vec<f64>>, row: usize| {
        let value = column.as_ref().and_then(|values| values.get(row));
        value.copied().unwrap_or(f64::NAN)
    };
    for (row, (&x, &y)) in x.iter().zip(&y).enumerate() {
        cancel::check(watch, row)?;
        let position = Position {
            point: Point::new(x, y),
            extras: [at(&z, row), at(&m, row)],
        };
        if !(x.is_nan() && y.is_nan()) {
            finite(row, x, y)
                .and_then(|()| features.shapes.point(position))
                .map_err(|problem| file.malformed(problem))?;
        }
        features.end();
    }
    Ok(())
}

/// Checks that coordinates are finite.
pub(super) fn finite(row: usize, x: f64, y: f64) -> Result<(), Problem> {
    let (axis, value) = match (x.is_finite(), y.is_finite()) {
        (true, true) => return Ok(()),
        (false, _) => ('x', x),
        (true, false) => ('y', y),
    };
    Err(Problem::NotFinite {
        index: row as u64,
        axis,
        text: match value.is_nan() {
            true => "NaN or null".to_owned(),
            false => value.to_string(),
        },
    })
}
