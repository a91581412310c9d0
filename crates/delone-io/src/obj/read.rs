//! Reading: statement by statement; indices are checked when all vertices are known, for files may name those to come.

use super::groups::{Groups, Names};
use super::{MARKER, REGION, SEGMENTS, TRIANGLES};
use crate::scan::{self, Row, Scanner};
use crate::space::Columns;
use crate::{Attribute, Constraints, Error, MeshData, Place, PointSet, Problem, ReadOptions, node};
use delone::{Point, VertexId, Watch};
use std::borrow::Cow;

/// Statements about the looks of what is there, and parts of curves and surfaces, which have statements of their own.
const SKIPPED: [&str; 29] = [
    "vt",
    "vn",
    "vp",
    "s",
    "mg",
    "mtllib",
    "usemap",
    "maplib",
    "bevel",
    "c_interp",
    "d_interp",
    "lod",
    "shadow_obj",
    "trace_obj",
    "ctech",
    "stech",
    "cstype",
    "deg",
    "bmat",
    "step",
    "parm",
    "trim",
    "hole",
    "scrv",
    "sp",
    "end",
    "con",
    "call",
    "csh",
];

/// Statements that make something that is not understood.
const REFUSED: [&str; 7] = ["curv", "curv2", "surf", "bsp", "bzp", "cdc", "res"];

/// Tells whether the bytes begin like one: statements of the format, and one of them a vertex.
pub(crate) fn sniff(head: &[u8]) -> bool {
    let mut scanner = Scanner::new("", head, &());
    while let Ok(Some(row)) = scanner.next_full_row() {
        let mut words = row.words();
        let keyword = words.next().and_then(|w| std::str::from_utf8(w).ok());
        match keyword {
            Some("v") => return words.take(3).filter_map(scan::number).count() == 3,
            Some("g" | "o" | "usemtl") => {}
            Some(other) if SKIPPED.contains(&other) => {}
            _ => return false,
        }
    }
    false
}

/// Reads a mesh; triangles there may be none.
pub(crate) fn read_mesh(
    file: &str,
    bytes: &[u8],
    _options: &ReadOptions,
    watch: &dyn Watch,
) -> Result<MeshData, Error> {
    let mut scanner = Scanner::new(file, bytes, watch);
    let mut reader = Reader::default();
    let mut names = Names::new();
    let mut is_empty = true;
    while let Some((row, text)) = next_statement(&mut scanner)? {
        is_empty = false;
        let mut words = words(&text);
        let Some(keyword) = words.next() else {
            continue;
        };
        let known = match keyword {
            b"v" => reader.vertex(words, row.line),
            b"f" => reader.face(words, &names, row.line),
            b"l" => reader.line(words, &names, row.line),
            b"p" => reader.points(words, row.line),
            b"g" | b"o" | b"usemtl" => {
                // Names are not continued.
                let name = row.text[keyword.len()..].trim_ascii();
                names.set(
                    [&b"g"[..], b"o", b"usemtl"]
                        .iter()
                        .position(|k| *k == keyword)
                        .unwrap_or(0),
                    name,
                );
                Ok(())
            }
            other => skip(other),
        };
        known.map_err(|problem| scanner.at(row, problem))?;
    }
    if is_empty {
        return Err(scanner.malformed(Place::File, Problem::Empty));
    }
    let finished = reader.finish(&names);
    finished.map_err(|(line, problem)| scanner.malformed(Place::Line(line), problem))
}

/// The first row of a statement, and its text with that of the rows on which it goes on.
type Statement<'a> = (Row<'a>, Cow<'a, [u8]>);

/// Returns the next statement.
fn next_statement<'a>(scanner: &mut Scanner<'a>) -> Result<Option<Statement<'a>>, Error> {
    let Some(mut row) = scanner.next_full_row()? else {
        return Ok(None);
    };
    row.text = row.text.trim_ascii();
    let Some(begin) = row.text.strip_suffix(b"\\") else {
        return Ok(Some((row, Cow::Borrowed(row.text))));
    };
    row.text = begin;
    let mut text = begin.to_vec();
    while let Some(next) = scanner.next_full_row()? {
        text.push(b' ');
        let more = next.text.trim_ascii();
        text.extend_from_slice(more.strip_suffix(b"\\").unwrap_or(more));
        if !more.ends_with(b"\\") {
            break;
        }
    }
    Ok(Some((row, Cow::Owned(text))))
}

/// Splits a statement at blanks; a comment may end it.
fn words(text: &[u8]) -> impl Iterator<Item = &[u8]> + Clone {
    let words = text
        .split(u8::is_ascii_whitespace)
        .filter(|w| !w.is_empty());
    words.take_while(|word| !word.starts_with(b"#"))
}

/// Passes over a statement that makes nothing.
fn skip(keyword: &[u8]) -> Result<(), Problem> {
    let text = std::str::from_utf8(keyword).unwrap_or("?");
    if SKIPPED.contains(&text) {
        return Ok(());
    }
    let shown = scan::show(keyword);
    Err(Problem::Other(match REFUSED.contains(&text) {
        true => format!(
            "{shown}: curves and surfaces of free form are not understood; export lines or triangles"
        ),
        false => format!("unknown statement {shown:?}; is this a Wavefront .obj?"),
    }))
}

/// A reference that is beyond all vertices so far, and the statement that has it.
struct Beyond {
    line: u64,
    item: &'static str,
    row: u64,
    index: u64,
}

/// What has been read so far.
#[derive(Default)]
struct Reader {
    set: PointSet,
    /// z, and the colour.
    columns: Columns,
    triangles: Vec<[VertexId; 3]>,
    regions: Groups,
    edges: Vec<[VertexId; 2]>,
    markers: Groups,
    faces: u64,
    polylines: u64,
    /// The first face of more than three corners, and its line.
    polygon: Option<(u64, Vec<VertexId>)>,
    /// The farthest reference.
    beyond: Option<Beyond>,
}

impl Reader {
    /// Takes `x y z`, perhaps a weight, or a colour of three or four numbers.
    fn vertex<'w>(
        &mut self,
        words: impl Iterator<Item = &'w [u8]> + Clone,
        line: u64,
    ) -> Result<(), Problem> {
        let number = self.set.points.len() as u64 + 1;
        if number > node::MAX_POINTS {
            return Err(node::too_many(number));
        }
        let found = words.clone().count();
        if !matches!(found, 3 | 4 | 6 | 7) {
            let expected = 3;
            return Err(Problem::Columns { expected, found });
        }
        let mut words = words;
        let mut next = || words.next().unwrap_or_default();
        let x = scan::coordinate(next(), 'x', number)?;
        let y = scan::coordinate(next(), 'y', number)?;
        let mut numbers = [0.0; 5];
        // The fourth of four is the weight of a rational curve, and says nothing about the point.
        let further = if found == 4 { 1 } else { found - 2 };
        for (number, what) in numbers[..further].iter_mut().zip(COLUMNS) {
            let word = next();
            *number = scan::number(word).ok_or_else(|| Problem::NotANumber {
                what: what.to_owned(),
                text: scan::show(word),
            })?;
        }
        self.set.points.push(Point::new(x, y));
        self.set.lines.push(line);
        self.columns.push(numbers[..further].iter().copied());
        Ok(())
    }

    fn face<'w>(
        &mut self,
        words: impl Iterator<Item = &'w [u8]> + Clone,
        names: &Names<'_>,
        line: u64,
    ) -> Result<(), Problem> {
        self.faces += 1;
        let item = ("face", self.faces);
        let corners = words.clone().count();
        if corners < 3 {
            let text = format!(
                "face {} has {corners} corners: at least 3 are needed",
                self.faces
            );
            return Err(Problem::Other(text));
        }
        if corners > 3 {
            return self.outline(words, line);
        }
        let mut corners = [VertexId::new(0); 3];
        for (corner, word) in corners.iter_mut().zip(words) {
            *corner = self.reference(word, item, line)?;
        }
        self.triangles.push(corners);
        self.regions.push(names);
        Ok(())
    }

    /// Keeps the first face of more than three corners; beside it there may be no other.
    fn outline<'w>(
        &mut self,
        words: impl Iterator<Item = &'w [u8]>,
        line: u64,
    ) -> Result<(), Problem> {
        let item = ("face", self.faces);
        let mut ring = Vec::new();
        for word in words {
            ring.push(self.reference(word, item, line)?);
        }
        match self.faces {
            1 => self.polygon = Some((line, ring)),
            face => return Err(not_a_triangle(face, ring.len())),
        }
        Ok(())
    }

    fn line<'w>(
        &mut self,
        words: impl Iterator<Item = &'w [u8]>,
        names: &Names<'_>,
        line: u64,
    ) -> Result<(), Problem> {
        self.polylines += 1;
        let item = ("line", self.polylines);
        let mut last = None;
        let mut found = 0;
        for word in words {
            let vertex = self.reference(word, item, line)?;
            if let Some(last) = last.replace(vertex) {
                self.edges.push([last, vertex]);
                self.markers.push(names);
            }
            found += 1;
        }
        if found < 2 {
            let text = format!(
                "line {} has {found} points: at least 2 are needed",
                self.polylines
            );
            return Err(Problem::Other(text));
        }
        Ok(())
    }

    /// Takes references to points, which are there already.
    fn points<'w>(
        &mut self,
        words: impl Iterator<Item = &'w [u8]>,
        line: u64,
    ) -> Result<(), Problem> {
        for word in words {
            self.reference(word, ("point", line), line)?;
        }
        Ok(())
    }

    /// Reads the vertex of `v`, `v/vt`, `v//vn` or `v/vt/vn`; back from the last if negative.
    fn reference(
        &mut self,
        word: &[u8],
        (item, row): (&'static str, u64),
        line: u64,
    ) -> Result<VertexId, Problem> {
        let vertices = self.set.points.len() as i64;
        let digits = word.split(|&b| b == b'/').next().unwrap_or_default();
        let Some(index) = scan::integer(digits) else {
            return Err(Problem::NotANumber {
                what: format!("vertex of {item} {row}"),
                text: scan::show(word),
            });
        };
        let from_zero = if index < 0 {
            vertices.checked_add(index)
        } else {
            index.checked_sub(1)
        };
        match from_zero {
            Some(v) if (0..vertices).contains(&v) => Ok(VertexId::new(v as usize)),
            Some(v) if v >= vertices => {
                let index = v as u64 + 1;
                if self.beyond.as_ref().is_none_or(|b| b.index < index) {
                    self.beyond = Some(Beyond {
                        line,
                        item,
                        row,
                        index,
                    });
                }
                // Too large a number is refused in the end, and needs no place until then.
                Ok(VertexId::new(v.min(node::MAX_POINTS as i64 - 1) as usize))
            }
            _ => Err(bad_index((item, row), index, vertices as u64)),
        }
    }

    /// Makes the mesh, or says what is wrong and in which line.
    fn finish(mut self, names: &Names<'_>) -> Result<MeshData, (u64, Problem)> {
        let vertices = self.set.points.len() as u64;
        if let Some(Beyond {
            line,
            item,
            row,
            index,
        }) = self.beyond
            && index > vertices
        {
            let index = i64::try_from(index).unwrap_or(i64::MAX);
            return Err((line, bad_index((item, row), index, vertices)));
        }
        if let Some((line, ring)) = self.polygon {
            if self.faces > 1 {
                return Err((line, not_a_triangle(1, ring.len())));
            }
            self.markers.mark_rest(ring.len());
            let ends = ring.iter().zip(ring.iter().cycle().skip(1));
            self.edges.extend(ends.map(|(&a, &b)| [a, b]));
        }
        let regions = self.regions.numbers(names, REGION, (TRIANGLES, -1));
        let regions = regions.map(|regions| Attribute {
            name: "region".to_owned(),
            values: regions.into_iter().map(f64::from).collect(),
        });
        let markers = self.markers.numbers(names, MARKER, (SEGMENTS, 0));
        self.set.attributes = self.columns.into_attributes(COLUMNS);
        self.set.base = 1;
        Ok(MeshData {
            vertices: self.set,
            triangles: self.triangles,
            triangle_attributes: regions.into_iter().collect(),
            constraints: (!self.edges.is_empty()).then_some(Constraints {
                edges: self.edges,
                markers,
                ..Constraints::default()
            }),
            quadratic: false,
        })
    }
}

/// What stands behind y in a vertex.
const COLUMNS: [&str; 5] = ["z", "red", "green", "blue", "alpha"];

fn not_a_triangle(face: u64, corners: usize) -> Problem {
    Problem::Other(format!(
        "face {face} has {corners} corners: beside other faces only triangles are understood; have the program that \
         wrote this triangulate faces, or give outlines as lines (l)"
    ))
}

fn bad_index((item, row): (&'static str, u64), index: i64, limit: u64) -> Problem {
    Problem::BadIndex {
        item,
        row,
        target: "vertex",
        index,
        limit,
        base: 1,
    }
}
