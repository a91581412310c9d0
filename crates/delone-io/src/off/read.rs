//! Reading: rows, as the header has them.

use crate::scan::{self, Row, Scanner};
use crate::space::Columns;
use crate::triangle_files::{expect_end, vertex};
use crate::{Error, MeshData, Place, PointSet, Problem, ReadOptions, node, points};
use delone::{Point, VertexId, Watch};

/// Tells whether the bytes begin like one.
pub(crate) fn sniff(head: &[u8]) -> bool {
    let first = Scanner::new("", head, &()).next_row();
    let row = first.ok().flatten();
    row.and_then(|row| {
        row.words()
            .next()
            .map(|word| word.ends_with(b"OFF") && Kind::of(word).is_ok())
    })
    .unwrap_or(false)
}

/// What vertices have behind x, y and z.
#[derive(Clone, Copy, Default)]
struct Kind {
    has_texture: bool,
    has_colour: bool,
    has_normal: bool,
}

impl Kind {
    /// Reads the keyword: `ST`, `C`, `N`, each or none, before `OFF`.
    fn of(keyword: &[u8]) -> Result<Self, Problem> {
        let mut kind = Self::default();
        let Some(mut rest) = keyword.strip_suffix(b"OFF") else {
            let text = format!("header must be OFF, not {:?}", scan::show(keyword));
            return Err(Problem::Other(text));
        };
        for (prefix, has) in [
            (&b"ST"[..], &mut kind.has_texture),
            (b"C", &mut kind.has_colour),
            (b"N", &mut kind.has_normal),
        ] {
            if let Some(others) = rest.strip_prefix(prefix) {
                *has = true;
                rest = others;
            }
        }
        match rest {
            b"" => Ok(kind),
            _ => Err(Problem::Other(format!(
                "{}: of the headers only OFF with ST, C, N before it are understood; write points of 3 coordinates",
                scan::show(keyword)
            ))),
        }
    }

    /// Names the columns of vertices that have so many of them.
    fn names(self, columns: usize) -> Vec<String> {
        let colours = columns.saturating_sub(
            3 + 3 * usize::from(self.has_normal) + 2 * usize::from(self.has_texture),
        );
        let colours = if self.has_colour { colours.min(4) } else { 0 };
        let mut names = vec!["z"];
        names.extend(["nx", "ny", "nz"].iter().filter(|_| self.has_normal));
        names.extend(&["red", "green", "blue", "alpha"][..colours]);
        names.extend(["s", "t"].iter().filter(|_| self.has_texture));
        let named = names.into_iter().map(str::to_owned);
        let unnamed = (1..).map(|place| format!("column{place}"));
        let mut all: Vec<String> = named.take(columns - 2).collect();
        all.extend(unnamed.skip(all.len() + 2).take(columns - 2 - all.len()));
        all
    }
}

/// Reads a mesh; triangles there may be none.
pub(crate) fn read_mesh(
    file: &str,
    bytes: &[u8],
    _options: &ReadOptions,
    watch: &dyn Watch,
) -> Result<MeshData, Error> {
    let mut scanner = Scanner::new(file, bytes, watch);
    let (kind, declared) = read_header(&mut scanner)?;
    let vertices = read_vertices(&mut scanner, kind, declared[0])?;
    let mut triangles = Vec::new();
    scanner.reserve(&mut triangles, 8, declared[1]);
    for number in 0..declared[1] {
        let Some(row) = scanner.next_row()? else {
            return Err(scanner.here(truncated("faces", declared[1], number)));
        };
        let face = face(row, number, vertices.points.len());
        triangles.push(face.map_err(|problem| scanner.at(row, problem))?);
    }
    expect_end(&mut scanner, "faces", declared[1])?;
    Ok(MeshData {
        vertices,
        triangles,
        ..MeshData::default()
    })
}

/// Reads the keyword, if there is one, and the counts of vertices and faces, on the same line or the next.
fn read_header(scanner: &mut Scanner<'_>) -> Result<(Kind, [u64; 2]), Error> {
    let mut row = header_row(scanner)?;
    let mut words = row.words().peekable();
    let mut kind = Kind::default();
    if let Some(keyword) = words.next_if(|word| scan::integer(word).is_none()) {
        kind = Kind::of(keyword).map_err(|problem| scanner.at(row, problem))?;
        if words.peek() == Some(&&b"BINARY"[..]) {
            let text = "binary .off is not understood; write text, or .ply";
            return Err(scanner.at(row, Problem::Other(text.to_owned())));
        }
        if words.peek().is_none() {
            row = header_row(scanner)?;
        }
    }
    let mut counts = row.words().skip_while(|word| scan::integer(word).is_none());
    let mut count = |what: &str| {
        let word = counts.next().unwrap_or_default();
        let count = scan::integer(word).and_then(|n| u64::try_from(n).ok());
        count.ok_or_else(|| {
            let (what, text) = (format!("count of {what}"), scan::show(word));
            scanner.at(row, Problem::NotANumber { what, text })
        })
    };
    Ok((kind, [count("vertices")?, count("faces")?]))
}

fn header_row<'a>(scanner: &mut Scanner<'a>) -> Result<Row<'a>, Error> {
    let row = scanner.next_row()?;
    row.ok_or_else(|| scanner.malformed(Place::File, Problem::Empty))
}

fn read_vertices(scanner: &mut Scanner<'_>, kind: Kind, declared: u64) -> Result<PointSet, Error> {
    if declared > node::MAX_POINTS {
        return Err(scanner.here(node::too_many(declared)));
    }
    let mut set = PointSet::default();
    let mut columns = Columns::default();
    let mut width = 3;
    scanner.reserve(&mut set.points, 6, declared);
    for number in 0..declared {
        let Some(row) = scanner.next_row()? else {
            return Err(scanner.here(truncated("points", declared, number)));
        };
        if number == 0 {
            let found = row.words().count();
            let found = points::check_columns(found as u64).map_err(|p| scanner.at(row, p))?;
            width = found.max(width);
        }
        let read = point(row, number, width, &mut columns);
        set.points
            .push(read.map_err(|problem| scanner.at(row, problem))?);
        set.lines.push(row.line);
    }
    let names = kind.names(width);
    set.attributes = columns.into_attributes(names.iter().map(String::as_str));
    Ok(set)
}

fn point(row: Row<'_>, number: u64, width: usize, columns: &mut Columns) -> Result<Point, Problem> {
    let found = row.words().count();
    if found != width {
        let expected = width;
        return Err(Problem::Columns { expected, found });
    }
    let mut words = row.words();
    let mut next = || words.next().unwrap_or_default();
    let x = scan::coordinate(next(), 'x', number)?;
    let y = scan::coordinate(next(), 'y', number)?;
    let mut further = Vec::with_capacity(width - 2);
    for word in words {
        further.push(scan::number(word).ok_or_else(|| Problem::NotANumber {
            what: "column of a vertex".to_owned(),
            text: scan::show(word),
        })?);
    }
    columns.push(further);
    Ok(Point::new(x, y))
}

/// Reads `3 a b c`, and passes over the colour behind it.
fn face(row: Row<'_>, number: u64, num_vertices: usize) -> Result<[VertexId; 3], Problem> {
    let mut words = row.words();
    let corners = words.next().unwrap_or_default();
    match scan::integer(corners) {
        Some(3) => {}
        Some(corners) => {
            return Err(Problem::Other(format!(
                "face {number} has {corners} corners: only triangles are understood; have the program that wrote this \
                 triangulate faces"
            )));
        }
        None => {
            return Err(Problem::NotANumber {
                what: format!("number of corners of face {number}"),
                text: scan::show(corners),
            });
        }
    }
    let mut triangle = [VertexId::new(0); 3];
    for (found, corner) in triangle.iter_mut().enumerate() {
        let Some(word) = words.next() else {
            let expected = 4;
            let found = found + 1;
            return Err(Problem::Columns { expected, found });
        };
        *corner = vertex(word, ("face", number), 0, num_vertices)?.into();
    }
    Ok(triangle)
}

fn truncated(items: &'static str, declared: u64, found: u64) -> Problem {
    Problem::Truncated {
        items,
        declared,
        found,
    }
}
