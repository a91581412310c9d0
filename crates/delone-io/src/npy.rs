//! `.npy`: NumPy's array format, versions 1 to 3.
//!
//! NumPy documentation, `numpy.lib.format`. Points are a float or integer array of shape (n, 2) or
//! (n, k), in C or Fortran order and either byte order; further columns become attributes.
//! Triangles are an integer array of shape (m, 3), constrained
//! edges one of shape (k, 3), ends and marker. Structured arrays, complex numbers, half and
//! extended precision are not read. Written is version 1, C order, little-endian.

mod segments;
mod write;

pub(crate) use segments::read_segments;
pub(crate) use write::{write_links, write_points, write_raster, write_segments, write_triangles};

use crate::{Attribute, Column, Error, MeshData, Place, PointSet, Problem};
use crate::{exact, node, points, table};
use delone::{Phase, Point, VertexId, Watch};

const MAGIC: &[u8] = b"\x93NUMPY";

/// Values between two looks at the watch.
const VALUES_PER_POLL: usize = 1 << 14;

/// Tells whether the bytes begin like an array.
pub(crate) fn sniff(head: &[u8]) -> bool {
    head.starts_with(MAGIC)
}

/// Reads points; `columns` chooses those of x and y.
pub(crate) fn read_points(
    file: &str,
    bytes: &[u8],
    columns: Option<&[Column; 2]>,
    watch: &dyn Watch,
) -> Result<PointSet, Error> {
    let array = Array::parse(file, bytes)?;
    if array.columns < 2 {
        return Err(array.problem(format!(
            "shape {} holds no points: must be (n, 2) or more columns",
            array.shape
        )));
    }
    let names: Vec<String> = (0..array.columns).map(table::unnamed).collect();
    let [x, y] = match columns {
        Some(columns) => table::choose(file, columns, &names)?,
        None => [0, 1],
    };
    let mut set = PointSet::default();
    if array.rows as u64 > node::MAX_POINTS {
        return Err(array.malformed(Place::File, node::too_many(array.rows as u64)));
    }
    set.points = array.points([x, y], watch)?;
    for (column, name) in names.into_iter().enumerate() {
        if column != x && column != y {
            let values = array.column(column, watch)?;
            set.attributes.push(Attribute { name, values });
        }
    }
    Ok(set)
}

/// Reads triangles over given vertices.
pub(crate) fn read_mesh(
    file: &str,
    bytes: &[u8],
    vertices: PointSet,
    watch: &dyn Watch,
) -> Result<MeshData, Error> {
    let array = Array::parse(file, bytes)?;
    if array.columns != 3 || array.kind == Kind::Float {
        return Err(array.problem(format!(
            "shape {} holds no triangles: must be integers (m, 3)",
            array.shape
        )));
    }
    let num_vertices = vertices.points.len();
    let mut triangles = Vec::with_capacity(array.rows);
    for row in 0..array.rows {
        array.poll(row * 3, watch)?;
        let corner = |k| array.vertex((row, k), "triangle", num_vertices);
        triangles.push([corner(0)?, corner(1)?, corner(2)?]);
    }
    Ok(MeshData {
        vertices,
        triangles,
        ..MeshData::default()
    })
}

/// What the numbers of an array are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    Float,
    Signed,
    Unsigned,
}

/// An array of two dimensions, its data not yet decoded.
struct Array<'a> {
    file: &'a str,
    /// The shape as the file writes it.
    shape: String,
    rows: usize,
    columns: usize,
    kind: Kind,
    /// Bytes of one number.
    width: usize,
    big_endian: bool,
    fortran_order: bool,
    /// Where the data begin in the file.
    start: usize,
    data: &'a [u8],
}

impl<'a> Array<'a> {
    fn parse(file: &'a str, bytes: &'a [u8]) -> Result<Self, Error> {
        let problem = |place, problem| Error::Malformed {
            file: file.to_owned(),
            place,
            problem,
        };
        let other = |text: &str| problem(Place::Byte(0), Problem::Other(text.to_owned()));
        if bytes.is_empty() {
            return Err(problem(Place::File, Problem::Empty));
        }
        let (header, start) = header(bytes).map_err(other)?;
        let entry = |key| value_of(header, key);
        let descr = entry("descr").ok_or_else(|| other("the header names no 'descr'"))?;
        let (kind, width, big_endian) = element(descr).ok_or_else(|| {
            let text = format!("numbers of type {descr} are not understood; save as float64");
            problem(Place::Byte(0), Problem::Other(text))
        })?;
        let fortran_order = match entry("fortran_order") {
            Some("True") => true,
            Some("False") => false,
            _ => {
                return Err(other(
                    "the header's 'fortran_order' is neither True nor False",
                ));
            }
        };
        let shape = entry("shape").ok_or_else(|| other("the header names no 'shape'"))?;
        let &[rows, columns] = dimensions(shape)
            .ok_or_else(|| other("the header's 'shape' is malformed"))?
            .as_slice()
        else {
            let text = format!("shape {shape}: must be two-dimensional, (n, 2) or more columns");
            return Err(problem(Place::Byte(0), Problem::Other(text)));
        };
        let columns = points::check_columns(columns).map_err(|p| problem(Place::Byte(0), p))?;
        let data = &bytes[start..];
        let row_size = (columns * width) as u64;
        if row_size
            .checked_mul(rows)
            .is_none_or(|size| size > data.len() as u64)
        {
            return Err(problem(
                Place::Byte(bytes.len() as u64),
                Problem::Truncated {
                    items: "rows",
                    declared: rows,
                    found: data.len() as u64 / row_size,
                },
            ));
        }
        // A shape like (10^18, 0) fits any file; nothing is to be had from it.
        let rows = if columns == 0 { 0 } else { rows as usize };
        Ok(Self {
            file,
            shape: shape.to_owned(),
            rows,
            columns,
            kind,
            width,
            big_endian,
            fortran_order,
            start,
            data,
        })
    }

    fn points(&self, [x, y]: [usize; 2], watch: &dyn Watch) -> Result<Vec<Point>, Error> {
        let mut points = Vec::with_capacity(self.rows);
        for row in 0..self.rows {
            self.poll(row, watch)?;
            let p = Point::new(self.number(row, x)?, self.number(row, y)?);
            if !p.is_finite() {
                let (axis, column, value) = if p.x.is_finite() {
                    ('y', y, p.y)
                } else {
                    ('x', x, p.x)
                };
                let problem = Problem::NotFinite {
                    index: row as u64,
                    axis,
                    text: value.to_string(),
                };
                return Err(self.malformed(Place::Byte(self.offset(row, column) as u64), problem));
            }
            points.push(p);
        }
        Ok(points)
    }

    fn column(&self, column: usize, watch: &dyn Watch) -> Result<Vec<f64>, Error> {
        let mut values = Vec::with_capacity(self.rows);
        for row in 0..self.rows {
            self.poll(row, watch)?;
            values.push(self.number(row, column)?);
        }
        Ok(values)
    }

    fn poll(&self, done: usize, watch: &dyn Watch) -> Result<(), Error> {
        if !done.is_multiple_of(VALUES_PER_POLL) {
            return Ok(());
        }
        if watch.is_cancelled() {
            return Err(Error::Cancelled);
        }
        let bytes = done.min(self.rows) as u64 * (self.columns * self.width) as u64;
        watch.progress(Phase::Read, bytes, self.data.len() as u64);
        Ok(())
    }

    /// Returns where in the file a number stands.
    fn offset(&self, row: usize, column: usize) -> usize {
        let place = if self.fortran_order {
            column * self.rows + row
        } else {
            row * self.columns + column
        };
        self.start + place * self.width
    }

    /// Returns the bits of a number, as many as its width says.
    fn bits(&self, row: usize, column: usize) -> u64 {
        let at = self.offset(row, column) - self.start;
        let bytes = &self.data[at..at + self.width];
        let mut little = [0; 8];
        little[..self.width].copy_from_slice(bytes);
        if self.big_endian {
            little[..self.width].reverse();
        }
        u64::from_le_bytes(little)
    }

    /// Returns a number of an array of integers.
    fn integer(&self, row: usize, column: usize) -> i128 {
        let bits = self.bits(row, column);
        if self.kind == Kind::Unsigned {
            return bits.into();
        }
        // Up to the top and back again carries the sign.
        let unused = 64 - 8 * self.width as u32;
        (((bits << unused) as i64) >> unused).into()
    }

    /// Returns the vertex that stands in a row and a column.
    fn vertex(
        &self,
        (row, column): (usize, usize),
        item: &'static str,
        num_vertices: usize,
    ) -> Result<VertexId, Error> {
        let value = self.integer(row, column);
        if (0..num_vertices as i128).contains(&value) {
            return Ok(VertexId::new(value as usize));
        }
        Err(self.malformed(
            Place::Byte(self.offset(row, column) as u64),
            Problem::BadIndex {
                item,
                row: row as u64,
                target: "vertex",
                index: value.clamp(i64::MIN.into(), i64::MAX.into()) as i64,
                limit: num_vertices as u64,
                base: 0,
            },
        ))
    }

    /// Returns a number as a double.
    ///
    /// # Errors
    /// If it is an integer that no double equals.
    fn number(&self, row: usize, column: usize) -> Result<f64, Error> {
        match (self.kind, self.width) {
            (Kind::Float, 4) => Ok(f32::from_bits(self.bits(row, column) as u32).into()),
            (Kind::Float, _) => Ok(f64::from_bits(self.bits(row, column))),
            _ => {
                let value = self.integer(row, column);
                exact::to_double(value).ok_or_else(|| {
                    let place = Place::Byte(self.offset(row, column) as u64);
                    self.malformed(place, exact::inexact(row, value))
                })
            }
        }
    }

    fn malformed(&self, place: Place, problem: Problem) -> Error {
        Error::Malformed {
            file: self.file.to_owned(),
            place,
            problem,
        }
    }

    fn problem(&self, text: String) -> Error {
        self.malformed(Place::Byte(0), Problem::Other(text))
    }
}

/// Returns the header's dictionary and the place where the data begin.
fn header(bytes: &[u8]) -> Result<(&str, usize), &'static str> {
    let truncated = "truncated: the file ends within the header";
    if !bytes.starts_with(MAGIC) {
        return Err("not an array: the file does not begin with \\x93NUMPY");
    }
    let rest = &bytes[MAGIC.len()..];
    let (length, start) = match *rest {
        [1, _, a, b, ..] => (u32::from(u16::from_le_bytes([a, b])), 10),
        [2 | 3, _, a, b, c, d, ..] => (u32::from_le_bytes([a, b, c, d]), 12),
        [1..=3, ..] | [] => return Err(truncated),
        _ => return Err("unknown version of the array format; known are 1, 2 and 3"),
    };
    let end = start + length as usize;
    let text = bytes.get(start..end).ok_or(truncated)?;
    let text = std::str::from_utf8(text).map_err(|_| "the header is not text")?;
    Ok((text, end))
}

/// Returns the value of a key in a flat Python dictionary; quotes of a string are removed.
fn value_of<'a>(dictionary: &'a str, key: &str) -> Option<&'a str> {
    let quoted = |q| format!("{q}{key}{q}");
    let (_, rest) = dictionary
        .split_once(&quoted('\''))
        .or_else(|| dictionary.split_once(&quoted('"')))?;
    let rest = rest.trim_start().strip_prefix(':')?.trim_start();
    let (skip, end) = match rest.chars().next()? {
        q @ ('\'' | '"') => (1, 1 + rest[1..].find(q)?),
        '(' => (0, 1 + rest.find(')')?),
        _ => (0, rest.find([',', '}'])?),
    };
    Some(rest[skip..end].trim())
}

/// Tells kind, width in bytes and whether big-endian from a type such as `<f8`.
fn element(descr: &str) -> Option<(Kind, usize, bool)> {
    let mut letters = descr.chars();
    let big_endian = match letters.next()? {
        '<' | '|' => false,
        '>' => true,
        '=' => cfg!(target_endian = "big"),
        _ => return None,
    };
    let kind = match letters.next()? {
        'f' => Kind::Float,
        'i' => Kind::Signed,
        'u' => Kind::Unsigned,
        _ => return None,
    };
    let width = letters.as_str().parse().ok()?;
    let widths: &[usize] = if kind == Kind::Float {
        &[4, 8]
    } else {
        &[1, 2, 4, 8]
    };
    widths.contains(&width).then_some((kind, width, big_endian))
}

/// Reads a Python tuple of numbers.
fn dimensions(shape: &str) -> Option<Vec<u64>> {
    let inner = shape.strip_prefix('(')?.strip_suffix(')')?.trim();
    let inner = inner.strip_suffix(',').unwrap_or(inner);
    if inner.is_empty() {
        return Some(Vec::new());
    }
    inner.split(',').map(|n| n.trim().parse().ok()).collect()
}
