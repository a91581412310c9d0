//! Text tables: CSV, TSV, XYZ, and columns set apart by blanks.
//!
//! The first rows tell the delimiter: tab, semicolon, comma, or else blanks. The first row is a
//! header if it names x and y or holds no number. Lines that begin with `#` are comments; in
//! tables with blanks, so is the rest of a line from `#` on. Cells may be quoted as in CSV
//! (RFC 4180), but not run over a line end. x, y and every further column of numbers are read;
//! columns that hold text are left out, and their names kept. An empty cell of a further column is
//! NaN. Decimal commas and separators of thousands are not understood.
//!
//! *Cost*: about 100 ns a row of three numbers.

use crate::scan::{self, Row, Scanner};
use crate::target::Output;
use crate::{Attribute, Column, Error, Place, PointSet, Problem, node};
use delone::{Point, Watch};
use std::borrow::Cow;

/// Names that mean x and y when a header has both.
const KNOWN_NAMES: [[&str; 2]; 6] = [
    ["x", "y"],
    ["longitude", "latitude"],
    ["lon", "lat"],
    ["lng", "lat"],
    ["easting", "northing"],
    ["e", "n"],
];

/// Rows that are looked at to tell the delimiter.
const ROWS_FOR_DELIMITER: usize = 8;

/// Reads a whole table; `columns` chooses those of x and y.
pub(crate) fn read_points(
    file: &str,
    bytes: &[u8],
    columns: Option<&[Column; 2]>,
    watch: &dyn Watch,
) -> Result<PointSet, Error> {
    let delimiter = Delimiter::detect(file, bytes)?;
    let mut scanner = Scanner::new(file, bytes, watch);
    let Some(first) = delimiter.next_row(&mut scanner)? else {
        return Err(scanner.malformed(Place::File, Problem::Empty));
    };
    let mut cells = Vec::new();
    delimiter
        .split(first, &mut cells)
        .map_err(|p| scanner.at(first, p))?;
    let header = is_header(&cells).then(|| names_of(&cells));
    let mut pending = Some(first);
    if header.is_some() {
        pending = delimiter.next_row(&mut scanner)?;
        if let Some(row) = pending {
            let width = cells.len();
            delimiter
                .split(row, &mut cells)
                .map_err(|p| scanner.at(row, p))?;
            check_width(width, cells.len()).map_err(|p| scanner.at(row, p))?;
        }
    }
    let mut table = Table::new(file, &cells, header, columns)
        .map_err(|e| e.unwrap_or_else(|| scanner.at(first, too_few(cells.len()))))?;
    let rows = scanner.rows_left_at_most(first.text.len() / 2 + 1);
    table.points.reserve(rows);
    while let Some(row) = pending {
        delimiter
            .split(row, &mut cells)
            .map_err(|p| scanner.at(row, p))?;
        table.push(&cells).map_err(|p| scanner.at(row, p))?;
        pending = delimiter.next_row(&mut scanner)?;
    }
    table.points.shrink_to_fit();
    Ok(table.finish())
}

fn too_few(found: usize) -> Problem {
    Problem::Other(format!(
        "found {found} column{}: a table of points needs two, set apart by comma, semicolon, tab or blank",
        if found == 1 { "" } else { "s" }
    ))
}

fn check_width(expected: usize, found: usize) -> Result<(), Problem> {
    if expected == found {
        return Ok(());
    }
    Err(Problem::Columns { expected, found })
}

/// Tells whether text looks like a table: whether some row of the first has two numbers.
pub(crate) fn sniff(head: &[u8]) -> bool {
    if head.contains(&0) {
        return false;
    }
    // The last line may be cut off.
    let lines = head.split(|&b| b == b'\n').take(ROWS_FOR_DELIMITER);
    lines.into_iter().any(|line| {
        let cells = line.split(|b| b",;\t \r".contains(b));
        cells.filter(|cell| scan::number(cell).is_some()).count() >= 2
    })
}

/// Names a column without a header.
pub(crate) fn unnamed(column: usize) -> String {
    match column {
        0..3 => ["x", "y", "z"][column].to_owned(),
        _ => format!("column{}", column + 1),
    }
}

/// Finds the columns asked for among those that exist.
pub(crate) fn choose(
    file: &str,
    columns: &[Column; 2],
    names: &[String],
) -> Result<[usize; 2], Error> {
    let find = |column: &Column| match column {
        Column::Index(i) => (*i < names.len()).then_some(*i),
        Column::Name(name) => names
            .iter()
            .position(|n| n.eq_ignore_ascii_case(name.trim())),
    };
    let found = |column| {
        find(column).ok_or_else(|| Error::NoSuchColumn {
            file: file.to_owned(),
            column: column.to_string(),
            available: available(names),
        })
    };
    Ok([found(&columns[0])?, found(&columns[1])?])
}

/// Lists the columns for a message, the first few of them.
fn available(names: &[String]) -> String {
    let shown = names.iter().take(12).enumerate();
    let mut list: Vec<String> = shown
        .map(|(i, name)| format!("{} ({name})", i + 1))
        .collect();
    if names.len() > list.len() {
        list.push(format!("… {}", names.len()));
    }
    list.join(", ")
}

fn is_header(cells: &[Cow<'_, [u8]>]) -> bool {
    known_columns(&names_of(cells)).is_some()
        || cells.iter().all(|cell| scan::number(cell).is_none())
            && cells
                .iter()
                .any(|cell| cell.iter().any(u8::is_ascii_alphabetic))
            && cells.len() >= 2
}

fn names_of(cells: &[Cow<'_, [u8]>]) -> Vec<String> {
    let name = |cell: &Cow<'_, [u8]>| String::from_utf8_lossy(cell).into_owned();
    cells.iter().map(name).collect()
}

fn known_columns(names: &[String]) -> Option<[usize; 2]> {
    let find = |known: &str| names.iter().position(|n| n.eq_ignore_ascii_case(known));
    KNOWN_NAMES
        .iter()
        .find_map(|[x, y]| Some([find(x)?, find(y)?]))
}

/// What sets cells apart.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Delimiter {
    Byte(u8),
    Blanks,
}

impl Delimiter {
    /// Takes the first of tab, semicolon and comma that divides the first rows into equally many
    /// cells, otherwise blanks.
    fn detect(file: &str, bytes: &[u8]) -> Result<Self, Error> {
        let mut scanner = Scanner::new(file, bytes, &());
        let mut rows = Vec::new();
        while rows.len() < ROWS_FOR_DELIMITER
            && let Some(row) = scanner.next_full_row()?
        {
            rows.push(row);
        }
        let divides = |&byte: &u8| {
            let mut widths = rows.iter().map(|row| Cells::new(row.text, byte).count());
            widths
                .next()
                .is_some_and(|first| first > 1 && widths.all(|w| w == first))
        };
        // Rows of unequal width are an error soon; the delimiter that stands in the first row
        // makes the best message.
        let stands = |byte: &&u8| rows.first().is_some_and(|row| row.text.contains(byte));
        let found = b"\t;,".iter().find(|byte| divides(byte));
        let found = found.or_else(|| b";,".iter().find(stands));
        Ok(found.map_or(Self::Blanks, |&byte| Self::Byte(byte)))
    }

    fn next_row<'a>(self, scanner: &mut Scanner<'a>) -> Result<Option<Row<'a>>, Error> {
        match self {
            Self::Byte(_) => scanner.next_full_row(),
            Self::Blanks => scanner.next_row(),
        }
    }

    /// Splits a row into `cells`.
    fn split<'a>(self, row: Row<'a>, cells: &mut Vec<Cow<'a, [u8]>>) -> Result<(), Problem> {
        cells.clear();
        match self {
            Self::Blanks => cells.extend(row.words().map(Cow::Borrowed)),
            Self::Byte(byte) => {
                for cell in Cells::new(row.text, byte) {
                    cells.push(unquote(cell)?);
                }
            }
        }
        Ok(())
    }
}

/// Splits a line at a delimiter that does not stand between quotes.
struct Cells<'a> {
    rest: Option<&'a [u8]>,
    delimiter: u8,
}

impl<'a> Cells<'a> {
    fn new(line: &'a [u8], delimiter: u8) -> Self {
        let rest = Some(line);
        Self { rest, delimiter }
    }
}

impl<'a> Iterator for Cells<'a> {
    type Item = &'a [u8];

    fn next(&mut self) -> Option<&'a [u8]> {
        let line = self.rest?;
        let mut quoted = false;
        let end = line.iter().position(|&b| {
            quoted ^= b == b'"';
            b == self.delimiter && !quoted
        });
        let end = end.unwrap_or(line.len());
        self.rest = line.get(end + 1..);
        Some(line[..end].trim_ascii())
    }
}

/// Removes the quotes around a cell; doubled ones within stand for one.
fn unquote(cell: &[u8]) -> Result<Cow<'_, [u8]>, Problem> {
    let Some(inner) = cell.strip_prefix(b"\"") else {
        return Ok(Cow::Borrowed(cell));
    };
    let Some(inner) = inner.strip_suffix(b"\"") else {
        let text = scan::show(cell);
        return Err(Problem::Other(format!("quote without end: {text}")));
    };
    if !inner.contains(&b'"') {
        return Ok(Cow::Borrowed(inner.trim_ascii()));
    }
    let mut kept = Vec::with_capacity(inner.len());
    let mut after_quote = false;
    for &b in inner {
        after_quote = b == b'"' && !after_quote;
        if !after_quote {
            kept.push(b);
        }
    }
    Ok(Cow::Owned(kept))
}

/// The columns as they fill up.
struct Table {
    width: usize,
    x: usize,
    y: usize,
    points: Vec<Point>,
    /// For each column that is neither x nor y: its place, and its values unless it holds text.
    others: Vec<Other>,
}

struct Other {
    column: usize,
    name: String,
    values: Option<Vec<f64>>,
}

impl Table {
    /// Decides on columns by the first row of data. `None` as error means too few columns.
    fn new(
        file: &str,
        cells: &[Cow<'_, [u8]>],
        header: Option<Vec<String>>,
        columns: Option<&[Column; 2]>,
    ) -> Result<Self, Option<Error>> {
        let width = cells.len();
        if width < 2 {
            return Err(None);
        }
        let known = header.as_deref().and_then(known_columns);
        let names = header.unwrap_or_else(|| (0..width).map(unnamed).collect());
        let [x, y] = match columns {
            Some(columns) => choose(file, columns, &names)?,
            None => known.unwrap_or_else(|| first_numbers(cells)),
        };
        let others = names.into_iter().enumerate();
        let others = others.filter(|&(column, _)| column != x && column != y);
        Ok(Self {
            width,
            x,
            y,
            points: Vec::new(),
            others: others
                .map(|(column, name)| Other {
                    column,
                    name,
                    values: Some(Vec::new()),
                })
                .collect(),
        })
    }

    fn push(&mut self, cells: &[Cow<'_, [u8]>]) -> Result<(), Problem> {
        check_width(self.width, cells.len())?;
        let index = self.points.len() as u64;
        if index == node::MAX_POINTS {
            return Err(node::too_many(index + 1));
        }
        let x = scan::coordinate(&cells[self.x], 'x', index)?;
        let y = scan::coordinate(&cells[self.y], 'y', index)?;
        self.points.push(Point::new(x, y));
        for other in &mut self.others {
            other.push(&cells[other.column]);
        }
        Ok(())
    }

    fn finish(self) -> PointSet {
        let mut set = PointSet {
            points: self.points,
            ..PointSet::default()
        };
        for Other { name, values, .. } in self.others {
            match values {
                Some(values) => set.attributes.push(Attribute { name, values }),
                None => set.left_out.push(name),
            }
        }
        set
    }
}

impl Other {
    /// Adds a value, or gives the column up if it holds text.
    fn push(&mut self, cell: &[u8]) {
        let Some(values) = &mut self.values else {
            return;
        };
        match scan::number(cell) {
            Some(value) => values.push(value),
            None if cell.is_empty() => values.push(f64::NAN),
            None => self.values = None,
        }
    }
}

/// Returns the first two columns that hold numbers, or else the first two.
fn first_numbers(cells: &[Cow<'_, [u8]>]) -> [usize; 2] {
    let mut numbers = (0..cells.len()).filter(|&i| scan::number(&cells[i]).is_some());
    match (numbers.next(), numbers.next()) {
        (Some(x), Some(y)) => [x, y],
        _ => [0, 1],
    }
}

/// Writes points as CSV with a header.
pub(crate) fn write_points(out: &mut Output<'_>, set: &PointSet) -> Result<(), Error> {
    out.text(format_args!("x,y"))?;
    for attribute in &set.attributes {
        out.text(format_args!(",{}", quoted(&attribute.name)))?;
    }
    if set.markers.is_some() {
        out.text(format_args!(",marker"))?;
    }
    out.end_line()?;
    for (i, p) in set.points.iter().enumerate() {
        out.number(p.x);
        out.comma();
        out.number(p.y);
        for attribute in &set.attributes {
            out.comma();
            out.number(attribute.values[i]);
        }
        if let Some(markers) = &set.markers {
            out.comma();
            out.integer(markers[i].into());
        }
        out.end_line()?;
    }
    Ok(())
}

fn quoted(name: &str) -> Cow<'_, str> {
    // A line end within quotes would not be read back.
    let name = name.replace(['\n', '\r'], " ");
    if name.contains([',', '"', ';', '\t', '#']) {
        return Cow::Owned(format!("\"{}\"", name.replace('"', "\"\"")));
    }
    Cow::Owned(name)
}
