//! Reading: tables of points, geometries, and the tables of a mesh.

use super::file::File;
use super::geo::{self, finite};
use crate::features::{MARKER, as_marker};
use crate::{
    Attribute, Column, Constraints, DomainData, Error, LeftOut, MeshData, PointSet, Problem,
    ReadOptions, Source, cancel, exact, table,
};
use delone::{Point, VertexId, Watch};

/// What the corners of triangles are called.
const CORNERS: [&str; 3] = ["a", "b", "c"];

/// Reads a domain.
pub(crate) fn read_domain(
    name: &str,
    bytes: &[u8],
    options: &ReadOptions,
    watch: &dyn Watch,
) -> Result<DomainData, Error> {
    let mut file = File::open(name, bytes, watch)?;
    if options.columns.is_none()
        && let Some(geometry) = geo::find(&file)?
    {
        return geo::read(name, &mut file, &geometry, watch);
    }
    read_points(name, &mut file, options.columns.as_ref(), watch).map(DomainData::from)
}

/// Reads a table of points.
fn read_points(
    name: &str,
    file: &mut File<'_>,
    columns: Option<&[Column; 2]>,
    watch: &dyn Watch,
) -> Result<PointSet, Error> {
    let [x, y] = coordinates(name, file, columns)?;
    let (xs, ys) = (coordinate(file, x)?, coordinate(file, y)?);
    let mut set = PointSet::default();
    drop(set.points.try_reserve_exact(xs.len()));
    for (row, (&x, &y)) in xs.iter().zip(&ys).enumerate() {
        cancel::check(watch, row)?;
        finite(row, x, y).map_err(|problem| file.malformed(problem))?;
        set.points.push(Point::new(x, y));
    }
    drop((xs, ys));
    for field in 0..file.fields.len() {
        if field != x && field != y {
            add_column(&mut set, file, field)?;
        }
    }
    take_markers(&mut set);
    Ok(set)
}

/// Finds the columns of x and y.
fn coordinates(
    name: &str,
    file: &File<'_>,
    columns: Option<&[Column; 2]>,
) -> Result<[usize; 2], Error> {
    let names = file.names();
    if let Some(columns) = columns {
        return table::choose(name, columns, &names);
    }
    if let Some(known) = table::known_columns(&names) {
        return Ok(known);
    }
    if holds_corners(file) {
        let text = "corners of triangles, whose points are in the file .points.parquet beside it";
        return Err(file.other(text));
    }
    let is_number = |&field: &usize| file.fields[field].kind.is_number();
    let mut numbers = (0..names.len()).filter(is_number);
    match (numbers.next(), numbers.next()) {
        (Some(x), Some(y)) => Ok([x, y]),
        _ => {
            let names = names.join(", ");
            Err(file.other(format!("no two columns of numbers; there are {names}")))
        }
    }
}

/// Reads a coordinate of all points.
fn coordinate(file: &mut File<'_>, field: usize) -> Result<Vec<f64>, Error> {
    let (name, kind) = (file.fields[field].name.clone(), file.fields[field].kind);
    let leaf = file.fields[field].leaf.filter(|_| kind.is_number());
    let leaf = leaf.ok_or_else(|| {
        file.other(format!(
            "column {name:?} holds no coordinates but {}",
            kind.name()
        ))
    })?;
    file.numbers(leaf, kind)?.map_err(|(row, text)| {
        let value = text.parse().unwrap_or(i128::MAX);
        file.malformed(exact::inexact(row, value))
    })
}

/// Adds a column beside x and y to the points.
fn add_column(set: &mut PointSet, file: &mut File<'_>, field: usize) -> Result<(), Error> {
    let (name, kind) = (file.fields[field].name.clone(), file.fields[field].kind);
    let Some(leaf) = file.fields[field].leaf.filter(|_| kind.is_number()) else {
        let text = kind.name().to_owned();
        set.left_out.push(LeftOut {
            name,
            point: 0,
            text,
        });
        return Ok(());
    };
    match file.numbers(leaf, kind)? {
        Ok(values) => set.attributes.push(Attribute { name, values }),
        Err((point, text)) => set.left_out.push(LeftOut { name, point, text }),
    }
    Ok(())
}

/// Makes the column `marker` markers, if it holds nothing but integers.
fn take_markers(set: &mut PointSet) {
    let is_marker = |column: &Attribute| column.name.eq_ignore_ascii_case(MARKER);
    let Some(place) = set.attributes.iter().position(is_marker) else {
        return;
    };
    let values = &set.attributes[place].values;
    set.markers = values.iter().map(|&value| as_marker(value)).collect();
    if set.markers.is_some() {
        set.attributes.remove(place);
    }
}

/// Tells whether the columns are those of triangles.
fn holds_corners(file: &File<'_>) -> bool {
    let is_corner = |name: &str| {
        let field = file.field(name);
        field.is_some_and(|field| file.fields[field].kind.is_integer())
    };
    CORNERS.iter().all(|name| is_corner(name))
}

/// Reads the corners of triangles and what goes with them; `segments` is the table of constrained edges.
pub(crate) fn read_mesh(
    name: &str,
    bytes: &[u8],
    vertices: PointSet,
    segments: Option<Source>,
    watch: &dyn Watch,
) -> Result<MeshData, Error> {
    let mut file = File::open(name, bytes, watch)?;
    if !holds_corners(&file) {
        let text = "no triangles: the columns a, b and c of integers are missing";
        return Err(file.other(text));
    }
    let num_vertices = vertices.points.len();
    let triangles = ids(&mut file, CORNERS, "triangle", num_vertices, watch)?;
    let mut rest = PointSet::default();
    for field in 0..file.fields.len() {
        if !CORNERS.contains(&file.fields[field].name.as_str()) {
            add_column(&mut rest, &mut file, field)?;
        }
    }
    let constraints = match segments {
        Some(segments) => Some(read_segments(&segments, num_vertices, watch)?),
        None => None,
    };
    let mut vertices = vertices;
    vertices.left_out.extend(rest.left_out);
    Ok(MeshData {
        vertices,
        triangles,
        triangle_attributes: rest.attributes,
        constraints,
        ..MeshData::default()
    })
}

/// Reads constrained edges and their markers.
fn read_segments(
    source: &Source,
    num_vertices: usize,
    watch: &dyn Watch,
) -> Result<Constraints, Error> {
    let (name, bytes) = (source.to_string(), source.load(watch)?);
    let mut file = File::open(&name, &bytes, watch)?;
    let edges = ids(&mut file, ["a", "b"], "segment", num_vertices, watch)?;
    let marker = file.field(MARKER);
    let markers = match marker.and_then(|m| file.fields[m].leaf.map(|leaf| (leaf, m))) {
        Some((leaf, field)) => file.numbers(leaf, file.fields[field].kind)?.ok(),
        None => None,
    };
    let markers = markers.and_then(|m| m.into_iter().map(as_marker).collect());
    Ok(Constraints {
        edges,
        markers,
        ..Constraints::default()
    })
}

/// Reads columns of indices of vertices.
fn ids<const N: usize>(
    file: &mut File<'_>,
    names: [&str; N],
    item: &'static str,
    num_vertices: usize,
    watch: &dyn Watch,
) -> Result<Vec<[VertexId; N]>, Error> {
    let mut ids = vec![[VertexId::INFINITE; N]; 0];
    for (k, name) in names.into_iter().enumerate() {
        let field = file.field(name);
        let field = field.ok_or_else(|| file.other(format!("no column {name}")))?;
        let values = coordinate(file, field)?;
        if k == 0 {
            ids.resize(values.len(), [VertexId::INFINITE; N]);
        }
        for (row, (&value, ids)) in values.iter().zip(&mut ids).enumerate() {
            cancel::check(watch, row)?;
            if !(value >= 0.0 && value < num_vertices as f64 && value.fract() == 0.0) {
                return Err(file.malformed(Problem::BadIndex {
                    item,
                    row: row as u64,
                    target: "vertex",
                    index: value as i64,
                    limit: num_vertices as u64,
                    base: 0,
                }));
            }
            ids[k] = VertexId::new(value as usize);
        }
    }
    Ok(ids)
}
