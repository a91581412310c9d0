//! Reading: arrays are collected as numbers, then put together.

use super::TRIANGLE;
use crate::scan;
use crate::{Attribute, Error, MeshData, Place, PointSet, Problem, node};
use base64::prelude::{BASE64_STANDARD, Engine};
use delone::{Phase, Point, VertexId, Watch};
use quick_xml::Reader;
use quick_xml::events::{BytesStart, Event};

/// Tells whether the bytes begin like a VTK file.
pub(crate) fn sniff(head: &[u8]) -> bool {
    memchr::memmem::find(head, b"<VTKFile").is_some()
}

/// Reads points, triangles and point data.
pub(crate) fn read_mesh(file: &str, bytes: &[u8], watch: &dyn Watch) -> Result<MeshData, Error> {
    let mut grid = Grid::default();
    let mut reader = Reader::from_reader(bytes);
    let outcome = grid.read(&mut reader, watch);
    let place = Place::Byte(reader.buffer_position());
    let at = |place: Place, problem| Error::Malformed {
        file: file.to_owned(),
        place,
        problem,
    };
    match outcome {
        Err(Stop::Cancelled) => Err(Error::Cancelled),
        Err(Stop::Problem(problem)) => Err(at(place, problem)),
        Ok(()) => grid.into_mesh().map_err(|problem| at(Place::File, problem)),
    }
}

/// Why reading stopped early.
enum Stop {
    Problem(Problem),
    Cancelled,
}

impl From<Problem> for Stop {
    fn from(problem: Problem) -> Self {
        Self::Problem(problem)
    }
}

fn other(text: impl Into<String>) -> Problem {
    Problem::Other(text.into())
}

/// The arrays of a file as they come.
#[derive(Default)]
struct Grid {
    encoding: Encoding,
    /// The element that the arrays belong to: `Points`, `Cells`, `PointData` …
    section: String,
    pieces: usize,
    points: Option<Vec<f64>>,
    connectivity: Vec<f64>,
    offsets: Vec<f64>,
    types: Vec<f64>,
    point_data: Vec<Attribute>,
    markers: Option<Vec<i32>>,
    cell_data: Vec<Attribute>,
}

/// How binary arrays are written, from the root element.
#[derive(Clone, Copy, Default)]
struct Encoding {
    big_endian: bool,
    /// Whether the count of bytes takes eight bytes instead of four.
    wide_counts: bool,
}

impl Grid {
    fn read(&mut self, reader: &mut Reader<&[u8]>, watch: &dyn Watch) -> Result<(), Stop> {
        let total = reader.get_ref().len() as u64;
        let mut array = None;
        loop {
            if watch.is_cancelled() {
                return Err(Stop::Cancelled);
            }
            watch.progress(Phase::Read, reader.buffer_position(), total);
            let event = reader
                .read_event()
                .map_err(|e| other(format!("broken XML: {e}")))?;
            match event {
                Event::Start(start) => array = self.open(&start)?,
                Event::Empty(start) => {
                    if let Some(array) = self.open(&start)? {
                        self.keep(array, Vec::new())?;
                    }
                }
                Event::Text(text) => {
                    if let Some(array) = array.take() {
                        let values = array.decode(self.encoding, text.trim_ascii())?;
                        self.keep(array, values)?;
                    }
                }
                Event::Eof => return self.finish().map_err(Stop::from),
                _ => {}
            }
        }
    }

    /// Notes an element; returns what it says if it is an array of interest.
    fn open(&mut self, start: &BytesStart<'_>) -> Result<Option<ArrayHead>, Problem> {
        match start.name().as_ref() {
            b"VTKFile" => self.root(start)?,
            b"Piece" => self.pieces += 1,
            b"DataArray" => {
                let section = self.section.as_str();
                if matches!(section, "Points" | "Cells" | "PointData" | "CellData") {
                    return ArrayHead::read(start).map(Some);
                }
            }
            name => self.section = String::from_utf8_lossy(name).into_owned(),
        }
        Ok(None)
    }

    fn root(&mut self, start: &BytesStart<'_>) -> Result<(), Problem> {
        if let Some(kind) = attribute(start, "type")?
            && kind != "UnstructuredGrid"
        {
            return Err(other(format!(
                "VTK type {kind}: only UnstructuredGrid is understood"
            )));
        }
        if attribute(start, "compressor")?.is_some() {
            return Err(other(
                "compressed data are not understood; write without compression",
            ));
        }
        self.encoding = Encoding {
            big_endian: attribute(start, "byte_order")?.as_deref() == Some("BigEndian"),
            wide_counts: attribute(start, "header_type")?.as_deref() == Some("UInt64"),
        };
        Ok(())
    }

    fn keep(&mut self, array: ArrayHead, values: Vec<f64>) -> Result<(), Problem> {
        match (self.section.as_str(), array.name.as_str()) {
            ("Points", _) if array.components == 3 => self.points = Some(values),
            ("Points", _) => return Err(other("points must have 3 components")),
            ("Cells", "connectivity") => self.connectivity = values,
            ("Cells", "offsets") => self.offsets = values,
            ("Cells", "types") => self.types = values,
            ("PointData", "marker") => {
                self.markers = Some(values.into_iter().map(|v| v as i32).collect());
            }
            (section @ ("PointData" | "CellData"), _) if array.components == 1 => {
                let data = if section == "PointData" {
                    &mut self.point_data
                } else {
                    &mut self.cell_data
                };
                let name = array.name;
                data.push(Attribute { name, values });
            }
            _ => {}
        }
        Ok(())
    }

    fn finish(&self) -> Result<(), Problem> {
        match self.pieces {
            0 => Err(other("no <Piece> of an unstructured grid in the file")),
            1 => Ok(()),
            n => Err(other(format!(
                "{n} pieces: only one is understood; merge them"
            ))),
        }
    }

    fn into_mesh(self) -> Result<MeshData, Problem> {
        let coordinates = self.points.unwrap_or_default();
        if !coordinates.len().is_multiple_of(3) {
            return Err(other(format!(
                "{} coordinates: not a multiple of 3",
                coordinates.len()
            )));
        }
        let mut vertices = PointSet {
            attributes: self.point_data,
            markers: self.markers,
            ..PointSet::default()
        };
        let (rows, _) = coordinates.as_chunks::<3>();
        if rows.len() as u64 > node::MAX_POINTS {
            return Err(node::too_many(rows.len() as u64));
        }
        for (index, &[x, y, _]) in rows.iter().enumerate() {
            for (axis, value) in [('x', x), ('y', y)] {
                if !value.is_finite() {
                    let (index, text) = (index as u64, value.to_string());
                    return Err(Problem::NotFinite { index, axis, text });
                }
            }
            vertices.points.push(Point::new(x, y));
        }
        let triangles = triangles(&self.connectivity, &self.offsets, &self.types, rows.len())?;
        let lengths = [rows.len(), triangles.len()];
        for (data, len) in [&vertices.attributes, &self.cell_data]
            .into_iter()
            .zip(lengths)
        {
            for Attribute { name, values } in data {
                check_length(name, values.len(), len)?;
            }
        }
        if let Some(markers) = &vertices.markers {
            check_length("marker", markers.len(), rows.len())?;
        }
        Ok(MeshData {
            vertices,
            triangles,
            triangle_attributes: self.cell_data,
        })
    }
}

fn check_length(name: &str, found: usize, expected: usize) -> Result<(), Problem> {
    if found == expected {
        return Ok(());
    }
    Err(other(format!(
        "array {name:?} has {found} values, expected {expected}"
    )))
}

fn triangles(
    connectivity: &[f64],
    offsets: &[f64],
    types: &[f64],
    num_vertices: usize,
) -> Result<Vec<[VertexId; 3]>, Problem> {
    if let Some(cell) = types.iter().position(|&kind| kind != f64::from(TRIANGLE)) {
        let kind = types[cell];
        return Err(other(format!(
            "cell {cell} has VTK type {kind}: only triangles (5) are understood"
        )));
    }
    if let Some(cell) = (0..offsets.len()).find(|&i| offsets[i] != (3 * (i + 1)) as f64) {
        return Err(other(format!(
            "cell {cell} ends at offset {}, expected {}",
            offsets[cell],
            3 * (cell + 1)
        )));
    }
    if types.len() != offsets.len() || connectivity.len() != 3 * types.len() {
        return Err(other(format!(
            "{} types, {} offsets and {} corners do not fit together",
            types.len(),
            offsets.len(),
            connectivity.len()
        )));
    }
    let (rows, _) = connectivity.as_chunks::<3>();
    let mut triangles = Vec::with_capacity(rows.len());
    for (row, &corners) in rows.iter().enumerate() {
        if let Some(index) = corners
            .into_iter()
            .find(|v| !(0.0..num_vertices as f64).contains(v))
        {
            return Err(Problem::BadIndex {
                item: "triangle",
                row: row as u64,
                target: "vertex",
                index: index as i64,
                limit: num_vertices as u64,
                base: 0,
            });
        }
        triangles.push(corners.map(|v| VertexId::new(v as usize)));
    }
    Ok(triangles)
}

/// What an element says about its array.
struct ArrayHead {
    name: String,
    kind: String,
    components: usize,
    format: String,
}

impl ArrayHead {
    fn read(start: &BytesStart<'_>) -> Result<Self, Problem> {
        let get = |key| attribute(start, key);
        let components = get("NumberOfComponents")?.unwrap_or_else(|| "1".to_owned());
        let what = "NumberOfComponents".to_owned();
        Ok(Self {
            name: get("Name")?.unwrap_or_default(),
            kind: get("type")?.unwrap_or_default(),
            format: get("format")?.unwrap_or_else(|| "ascii".to_owned()),
            components: components.parse().map_err(|_| Problem::NotANumber {
                what,
                text: scan::show(components.as_bytes()),
            })?,
        })
    }

    fn decode(&self, encoding: Encoding, text: &[u8]) -> Result<Vec<f64>, Problem> {
        match self.format.as_str() {
            "ascii" => self.decode_ascii(text),
            "binary" => self.decode_binary(encoding, text),
            format => Err(other(format!(
                "array {:?} is in format {format}: only inline ascii and binary are understood",
                self.name
            ))),
        }
    }

    fn decode_ascii(&self, text: &[u8]) -> Result<Vec<f64>, Problem> {
        let words = text
            .split(u8::is_ascii_whitespace)
            .filter(|word| !word.is_empty());
        words
            .map(|word| {
                scan::number(word).ok_or_else(|| Problem::NotANumber {
                    what: format!("value of array {:?}", self.name),
                    text: scan::show(word),
                })
            })
            .collect()
    }

    fn decode_binary(&self, encoding: Encoding, text: &[u8]) -> Result<Vec<f64>, Problem> {
        let broken = |what: &str| other(format!("array {:?}: {what}", self.name));
        let bytes = BASE64_STANDARD
            .decode(text)
            .map_err(|e| broken(&format!("broken base64: {e}")))?;
        let count_width = if encoding.wide_counts { 8 } else { 4 };
        let (count, data) = bytes
            .split_at_checked(count_width)
            .ok_or_else(|| broken("shorter than its count"))?;
        let count = unsigned(count, encoding.big_endian);
        if count != data.len() as u64 {
            return Err(broken(&format!(
                "truncated: declares {count} bytes, has {}",
                data.len()
            )));
        }
        let (width, decode) = element(&self.kind)
            .ok_or_else(|| broken(&format!("type {:?} is not understood", self.kind)))?;
        if !data.len().is_multiple_of(width) {
            return Err(broken("ends within a number"));
        }
        let numbers = data.chunks_exact(width);
        Ok(numbers
            .map(|n| decode(unsigned(n, encoding.big_endian)))
            .collect())
    }
}

/// Joins up to eight bytes.
fn unsigned(bytes: &[u8], big_endian: bool) -> u64 {
    let join = |sum: u64, &b: &u8| sum << 8 | u64::from(b);
    if big_endian {
        bytes.iter().fold(0, join)
    } else {
        bytes.iter().rev().fold(0, join)
    }
}

/// Makes a number from its bits.
type Meaning = fn(u64) -> f64;

/// Returns width and meaning of a VTK number type.
fn element(kind: &str) -> Option<(usize, Meaning)> {
    Some(match kind {
        "Float64" => (8, f64::from_bits),
        "Float32" => (4, |bits| f32::from_bits(bits as u32).into()),
        "Int8" => (1, |bits| (bits as i8).into()),
        "Int16" => (2, |bits| (bits as i16).into()),
        "Int32" => (4, |bits| (bits as i32).into()),
        "Int64" => (8, |bits| bits as i64 as f64),
        "UInt8" => (1, |bits| bits as f64),
        "UInt16" => (2, |bits| bits as f64),
        "UInt32" => (4, |bits| bits as f64),
        "UInt64" => (8, |bits| bits as f64),
        _ => return None,
    })
}

/// Returns the value of an attribute of an element.
fn attribute(start: &BytesStart<'_>, key: &str) -> Result<Option<String>, Problem> {
    let broken = |e: &dyn std::fmt::Display| other(format!("broken XML: {e}"));
    let Some(found) = start.try_get_attribute(key).map_err(|e| broken(&e))? else {
        return Ok(None);
    };
    let value = found.unescape_value().map_err(|e| broken(&e))?;
    Ok(Some(value.into_owned()))
}
