//! Reading: keywords, each with what follows it.

use super::values::{self, Kind};
use crate::cursor::Cursor;
use crate::vtu::{Data, Grid, Stop};
use crate::{Error, MeshData, Place, Problem, ReadOptions, points, scan};
use delone::Watch;

/// Reads a mesh; triangles there may be none.
pub(crate) fn read_mesh(
    file: &str,
    bytes: &[u8],
    _options: &ReadOptions,
    watch: &dyn Watch,
) -> Result<MeshData, Error> {
    let mut cursor = Cursor::new(file, bytes, watch);
    if bytes.trim_ascii().is_empty() {
        return Err(cursor.fail_whole(Problem::Empty));
    }
    let version = cursor.line();
    let number = version.strip_prefix(b"# vtk DataFile Version ");
    let Some(major) = number.and_then(|n| n.trim_ascii().first()) else {
        return Err(cursor.refuse("expected \"# vtk DataFile Version …\""));
    };
    if !(b'1'..=b'5').contains(major) {
        let version = scan::show(version);
        return Err(cursor.refuse(format!("{version:?}: versions up to 5.1 are understood")));
    }
    cursor.line();
    let is_binary = match cursor.line().to_ascii_uppercase().as_slice() {
        b"ASCII" => false,
        b"BINARY" => true,
        _ => return Err(cursor.refuse("expected ASCII or BINARY")),
    };
    cursor.in_bytes = is_binary;
    let mut reader = Reader {
        cursor,
        is_binary,
        has_offsets: *major >= b'5',
        grid: Grid::default(),
        lists: Default::default(),
        section: Section::None,
        has_points: false,
    };
    reader.read()?;
    let Reader {
        mut grid, lists, ..
    } = reader;
    for list in lists {
        let behind = grid.connectivity.len() as f64;
        grid.connectivity.extend(list.corners);
        grid.types.extend(list.ends.iter().map(|_| list.kind));
        grid.offsets
            .extend(list.ends.iter().map(|end| end + behind));
    }
    grid.into_mesh(watch).map_err(|stop| match stop {
        Stop::Cancelled => Error::Cancelled,
        Stop::Problem(problem) => Error::Malformed {
            file: file.to_owned(),
            place: Place::File,
            problem,
        },
    })
}

/// What data belong to.
#[derive(Clone, Copy, PartialEq)]
enum Section {
    None,
    Points(u64),
    Cells(u64),
}

/// Cells of one kind, in files that keep kinds apart.
#[derive(Default)]
struct List {
    kind: f64,
    corners: Vec<f64>,
    /// Where each cell ends in them.
    ends: Vec<f64>,
}

/// The keywords of such lists, in the order of their cells, and VTK's numbers for them.
const LISTS: [(&[u8], f64); 4] = [
    (b"VERTICES", 2.0),
    (b"LINES", 4.0),
    (b"POLYGONS", 7.0),
    (b"TRIANGLE_STRIPS", 6.0),
];

struct Reader<'a> {
    cursor: Cursor<'a>,
    is_binary: bool,
    /// Whether cells have their ends apart from their corners.
    has_offsets: bool,
    grid: Grid,
    lists: [List; 4],
    section: Section,
    has_points: bool,
}

impl<'a> Reader<'a> {
    fn read(&mut self) -> Result<(), Error> {
        while let Some(line) = self.cursor.full_line()? {
            let words: Vec<&[u8]> = words(line);
            let keyword = words[0].to_ascii_uppercase();
            match keyword.as_slice() {
                b"DATASET" => self.dataset(&words)?,
                b"POINTS" => {
                    let (count, kind) = (self.count(&words, 1)?, self.kind(&words, 2)?);
                    self.grid.points = self.values(kind, count.saturating_mul(3))?;
                    self.has_points = true;
                }
                b"CELLS" => {
                    let list = self.list(&words, 0.0)?;
                    (self.grid.connectivity, self.grid.offsets) = (list.corners, list.ends);
                }
                b"CELL_TYPES" => {
                    let count = self.count(&words, 1)?;
                    self.grid.types = self.values(Kind::Signed(4), count)?;
                }
                b"POINT_DATA" => self.section = Section::Points(self.count(&words, 1)?),
                b"CELL_DATA" => self.section = Section::Cells(self.count(&words, 1)?),
                b"METADATA" => self.skip_metadata()?,
                // Of lists without cells there is nothing between these.
                b"OFFSETS" | b"CONNECTIVITY" => {}
                keyword => match LISTS.iter().position(|list| list.0 == keyword) {
                    Some(place) => self.lists[place] = self.list(&words, LISTS[place].1)?,
                    None => self.data(keyword, &words)?,
                },
            }
        }
        match self.has_points {
            true => Ok(()),
            false => Err(self
                .cursor
                .fail_whole(Problem::Other("no POINTS in the file".to_owned()))),
        }
    }

    fn dataset(&self, words: &[&[u8]]) -> Result<(), Error> {
        let kind = words.get(1).copied().unwrap_or_default();
        match kind.to_ascii_uppercase().as_slice() {
            b"UNSTRUCTURED_GRID" | b"POLYDATA" => Ok(()),
            _ => {
                let kind = scan::show(kind);
                Err(self.cursor.refuse(format!(
                    "dataset {kind}: only UNSTRUCTURED_GRID and POLYDATA are understood"
                )))
            }
        }
    }

    /// Reads cells: the number of corners and these, row by row, or ends and corners apart.
    fn list(&mut self, words: &[&[u8]], kind: f64) -> Result<List, Error> {
        let (count, size) = (self.count(words, 1)?, self.count(words, 2)?);
        let mut list = List {
            kind,
            ..List::default()
        };
        if self.has_offsets {
            if count == 0 {
                return Ok(list);
            }
            let ends = self.named_array(b"OFFSETS", count)?;
            list.corners = self.named_array(b"CONNECTIVITY", size)?;
            if ends[0] != 0.0 {
                return Err(self.cursor.refuse("offsets must begin with 0"));
            }
            list.ends = ends[1..].to_vec();
            return Ok(list);
        }
        let rows = self.values(Kind::Signed(4), size)?;
        let mut rest = rows.as_slice();
        for cell in 0..count {
            let [corners, others @ ..] = rest else {
                let text = format!("truncated: {count} cells declared, {cell} found");
                return Err(self.cursor.refuse(text));
            };
            let Some((row, others)) = others.split_at_checked(*corners as usize) else {
                let text = format!("cell {cell} has {corners} corners, more than there are");
                return Err(self.cursor.refuse(text));
            };
            list.corners.extend_from_slice(row);
            list.ends.push(list.corners.len() as f64);
            rest = others;
        }
        match rest.len() {
            0 => Ok(list),
            left => Err(self
                .cursor
                .refuse(format!("{left} numbers behind the last of {count} cells"))),
        }
    }

    fn named_array(&mut self, name: &[u8], count: u64) -> Result<Vec<f64>, Error> {
        let line = self.cursor.full_line()?.unwrap_or_default();
        let words = words(line);
        if !words.first().is_some_and(|w| w.eq_ignore_ascii_case(name)) {
            let (name, found) = (scan::show(name), scan::show(line));
            return Err(self
                .cursor
                .refuse(format!("expected {name}, found {found:?}")));
        }
        let kind = self.kind(&words, 1)?;
        self.values(kind, count)
    }

    /// Reads data of points or cells.
    fn data(&mut self, keyword: &[u8], words: &[&[u8]]) -> Result<(), Error> {
        let rows = match self.section {
            Section::None => 0,
            Section::Points(rows) | Section::Cells(rows) => rows,
        };
        let name = || words.get(1).map_or_else(String::new, |name| decoded(name));
        match keyword {
            b"SCALARS" => {
                let kind = self.kind(words, 2)?;
                let components = if words.len() > 3 {
                    self.count(words, 3)?
                } else {
                    1
                };
                let table = self.cursor.peek_line()?.unwrap_or_default();
                if table.to_ascii_uppercase().starts_with(b"LOOKUP_TABLE") {
                    self.cursor.full_line()?;
                }
                self.keep(name(), kind, components, rows)
            }
            b"VECTORS" | b"NORMALS" => {
                let kind = self.kind(words, 2)?;
                self.keep(name(), kind, 3, rows)
            }
            b"TENSORS" | b"TENSORS6" => {
                let kind = self.kind(words, 2)?;
                let components = if keyword == b"TENSORS" { 9 } else { 6 };
                self.keep(name(), kind, components, rows)
            }
            b"GLOBAL_IDS" | b"PEDIGREE_IDS" | b"EDGE_FLAGS" => {
                let kind = self.kind(words, 2)?;
                self.keep(name(), kind, 1, rows)
            }
            b"TEXTURE_COORDINATES" => {
                let (components, kind) = (self.count(words, 2)?, self.kind(words, 3)?);
                self.keep(name(), kind, components, rows)
            }
            b"COLOR_SCALARS" => {
                let components = self.count(words, 2)?;
                let kind = if self.is_binary {
                    Kind::Unsigned(1)
                } else {
                    Kind::Float(4)
                };
                self.keep(name(), kind, components, rows)
            }
            b"LOOKUP_TABLE" => {
                let count = self.count(words, 2)?.saturating_mul(4);
                let kind = if self.is_binary {
                    Kind::Unsigned(1)
                } else {
                    Kind::Float(4)
                };
                self.values(kind, count).map(drop)
            }
            b"FIELD" => {
                for _ in 0..self.count(words, 2)? {
                    self.field()?;
                }
                Ok(())
            }
            _ => {
                let keyword = scan::show(keyword);
                Err(self
                    .cursor
                    .refuse(format!("expected a keyword, found {keyword:?}")))
            }
        }
    }

    /// Reads an array of a field.
    fn field(&mut self) -> Result<(), Error> {
        let mut line = self.cursor.full_line()?;
        while line == Some(b"METADATA") {
            self.skip_metadata()?;
            line = self.cursor.full_line()?;
        }
        let Some(line) = line else {
            return Err(self
                .cursor
                .refuse("truncated: the file ends within a field"));
        };
        let words = words(line);
        let (components, rows) = (self.count(&words, 1)?, self.count(&words, 2)?);
        let kind = self.kind(&words, 3)?;
        self.keep(decoded(words[0]), kind, components, rows)
    }

    /// Reads rows of data and keeps them, if they belong to points or cells.
    fn keep(&mut self, name: String, kind: Kind, components: u64, rows: u64) -> Result<(), Error> {
        let width = points::check_columns(components).map_err(|p| self.cursor.fail(p))?;
        let values = self.values(kind, rows.saturating_mul(components))?;
        let what = match self.section {
            _ if kind == Kind::Text => Some("strings"),
            Section::None => Some("data of the whole file"),
            _ if width == 0 => Some("data without components"),
            _ => None,
        };
        if let Some(what) = what {
            self.grid
                .notes
                .push(format!("{what} are not kept: {name:?}"));
            return Ok(());
        }
        let data = Data {
            name,
            components: width,
            are_integers: kind.is_integer(),
            values,
        };
        let kept = match self.section {
            Section::Points(_) => self.grid.add_point_data(data),
            _ => self.grid.add_cell_data(data),
        };
        kept.map_err(|problem| self.cursor.fail(problem))
    }

    /// Passes over what is said about an array; a blank line ends it.
    fn skip_metadata(&mut self) -> Result<(), Error> {
        while self.cursor.left() > 0 && !self.cursor.line().is_empty() {
            self.cursor.poll()?;
        }
        Ok(())
    }

    fn values(&mut self, kind: Kind, count: u64) -> Result<Vec<f64>, Error> {
        values::read(&mut self.cursor, self.is_binary, kind, count)
    }

    fn count(&self, words: &[&[u8]], place: usize) -> Result<u64, Error> {
        let word = words.get(place).copied().unwrap_or_default();
        let count = scan::integer(word).and_then(|n| u64::try_from(n).ok());
        count.ok_or_else(|| {
            let (what, text) = ("count".to_owned(), scan::show(word));
            self.cursor.fail(Problem::NotANumber { what, text })
        })
    }

    fn kind(&self, words: &[&[u8]], place: usize) -> Result<Kind, Error> {
        let word = words.get(place).copied().unwrap_or_default();
        Kind::from_name(word).ok_or_else(|| {
            let word = scan::show(word);
            self.cursor
                .refuse(format!("type {word:?} is not understood"))
        })
    }
}

fn words(line: &[u8]) -> Vec<&[u8]> {
    let words = line.split(u8::is_ascii_whitespace);
    words.filter(|word| !word.is_empty()).collect()
}

/// Reads a name, in which `%20` stands for a blank, and so on.
fn decoded(name: &[u8]) -> String {
    let digit = |b: &u8| char::from(*b).to_digit(16);
    let mut bytes = Vec::with_capacity(name.len());
    let mut rest = name;
    while let [first, others @ ..] = rest {
        rest = others;
        match others {
            [high, low, behind @ ..] if *first == b'%' => match (digit(high), digit(low)) {
                (Some(high), Some(low)) => {
                    bytes.push((high * 16 + low) as u8);
                    rest = behind;
                }
                _ => bytes.push(*first),
            },
            _ => bytes.push(*first),
        }
    }
    String::from_utf8_lossy(&bytes).into_owned()
}

#[cfg(test)]
mod tests {
    #[test]
    fn names_are_decoded() {
        let names = ["a%20b", "100%", "%zz", "%C3%BC", "%2"];
        let decoded = names.map(|name| super::decoded(name.as_bytes()));
        assert_eq!(decoded, ["a b", "100%", "%zz", "ü", "%2"]);
    }
}
