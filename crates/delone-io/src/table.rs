//! Text tables: CSV, TSV, XYZ, and columns set apart by blanks.
//!
//! The first rows tell the delimiter: tab, semicolon, comma, or else blanks. The first row is a
//! header if it names the columns asked for, or x and y, or holds no number. A header without rows is
//! an empty table only if it names the columns of points. Lines that begin with `#` are comments; in
//! tables with blanks, so is the rest of a line from `#` on. Cells may be quoted as in CSV
//! (RFC 4180), but not run over a line end. x, y and every further column of numbers are read;
//! columns that hold text are left out, and their names kept. An empty cell of a further column is
//! NaN. Where cells are set apart by semicolons or tabs, [decimal commas](numbers) are understood, for all of
//! the table; separators of thousands are not.
//!
//! A text that begins with `ncols` or `nrows` is [ESRI's ASCII grid](crate::asc).
//!
//! Written are commas, tabs or blanks, as the extension has it.
//!
//! *Cost*: about 100 ns a row of three numbers.

mod delimiter;
mod numbers;
mod write;

pub(crate) use write::{write_links, write_points};

use crate::scan::{self, Row, Scanner};
use crate::{
    Attribute, Column, Error, LeftOut, Lines, Place, PointSet, Problem, asc, node, points,
};
use delimiter::{Delimiter, ROWS_LOOKED_AT};
use delone::{Point, Watch};
use numbers::{Numbers, Thousands, has_decimal_comma};
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

/// Reads a whole table; `columns` chooses those of x and y.
pub(crate) fn read_points(
    file: &str,
    bytes: &[u8],
    columns: Option<&[Column; 2]>,
    watch: &dyn Watch,
) -> Result<PointSet, Error> {
    if asc::sniff(bytes) {
        return asc::read_points(file, bytes, watch);
    }
    match read_as(file, bytes, Numbers::Point, columns, watch)? {
        Outcome::Points(set) => Ok(set),
        // What has been read is no loss: it ends with the first such number.
        Outcome::DecimalComma => match read_as(file, bytes, Numbers::Comma, columns, watch)? {
            Outcome::Points(set) => Ok(set),
            Outcome::DecimalComma => unreachable!("bug: commas were understood"),
        },
    }
}

/// What became of an attempt to read a table.
enum Outcome {
    Points(PointSet),
    /// A coordinate would be a number if its comma were understood.
    DecimalComma,
}

/// Reads a whole table whose numbers are written in one way.
fn read_as(
    file: &str,
    bytes: &[u8],
    numbers: Numbers,
    columns: Option<&[Column; 2]>,
    watch: &dyn Watch,
) -> Result<Outcome, Error> {
    let mut reader = Reader::new(file, bytes, watch)?;
    let Some(first) = reader.next_row()? else {
        return Err(reader.scanner.malformed(Place::File, Problem::Empty));
    };
    let width = reader.cells.len();
    check_possible(width).map_err(|p| reader.scanner.at(first, p))?;
    let header = is_header(&reader.cells, numbers, columns).then(|| names_of(&reader.cells));
    let mut pending = Some(first);
    if header.is_some() {
        pending = reader.next_row()?;
    }
    if let Some(row) = pending {
        check_width(width, reader.cells.len()).map_err(|p| reader.scanner.at(row, p))?;
    } else if !header.as_deref().is_some_and(|h| names_points(h, columns)) {
        return Err(reader.scanner.malformed(Place::File, no_numbers()));
    }
    let mut table = Table::new(file, &reader.cells, header, numbers, columns)?;
    let bytes_per_row = (2 * width).max(first.text.len() / 2);
    reader
        .scanner
        .reserve(&mut table.points, bytes_per_row, u64::MAX);
    while let Some(row) = pending {
        if let Err(problem) = table.push(&reader.cells, row.line) {
            if numbers == Numbers::Point
                && reader.may_have_commas()
                && table.has_commas(&reader.cells)
            {
                return Ok(Outcome::DecimalComma);
            }
            return Err(reader.scanner.at(row, problem));
        }
        pending = reader.next_row()?;
    }
    if numbers == Numbers::Comma {
        let checked = table.thousands.check();
        checked.map_err(|p| reader.scanner.malformed(Place::File, p))?;
    }
    table.points.shrink_to_fit();
    Ok(Outcome::Points(table.finish()))
}

/// Walks over the rows of a table.
struct Reader<'a> {
    scanner: Scanner<'a>,
    delimiter: Delimiter,
    /// The cells of the row just read.
    cells: Vec<Cow<'a, [u8]>>,
}

impl<'a> Reader<'a> {
    fn new(file: &'a str, bytes: &'a [u8], watch: &'a dyn Watch) -> Result<Self, Error> {
        let scanner = Scanner::new(file, bytes, watch);
        if let Some(place) = memchr::memchr(0, bytes) {
            let problem = "a zero byte: this is no text, or not in UTF-8".to_owned();
            return Err(scanner.malformed(Place::Byte(place as u64), Problem::Other(problem)));
        }
        Ok(Self {
            scanner,
            delimiter: Delimiter::detect(file, bytes)?,
            cells: Vec::new(),
        })
    }

    /// Tells whether a comma within a cell may be a decimal one.
    fn may_have_commas(&self) -> bool {
        matches!(self.delimiter, Delimiter::Byte(b';' | b'\t'))
    }

    /// Reads a row and takes it apart.
    fn next_row(&mut self) -> Result<Option<Row<'a>>, Error> {
        let row = self.delimiter.next_row(&mut self.scanner)?;
        if let Some(row) = row {
            let split = self.delimiter.split(row, &mut self.cells);
            split.map_err(|p| self.scanner.at(row, p))?;
        }
        Ok(row)
    }
}

/// Checks that a table of this many columns can hold points.
fn check_possible(width: usize) -> Result<(), Problem> {
    if width < 2 {
        return Err(too_few(width));
    }
    points::check_columns(width as u64).map(drop)
}

fn no_numbers() -> Problem {
    Problem::Other("no row of numbers, and no columns x and y".to_owned())
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
    if asc::sniff(head) {
        return true;
    }
    // The last line may be cut off.
    let lines = scan::without_mark(head).split(|b| b"\n\r".contains(b));
    lines.take(2 * ROWS_LOOKED_AT).any(|line| {
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
    let [x, y] = [found(&columns[0])?, found(&columns[1])?];
    if x == y {
        return Err(Error::SameColumn {
            file: file.to_owned(),
            column: columns[0].to_string(),
        });
    }
    Ok([x, y])
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

/// Tells whether a row names columns: those asked for, known ones, or nothing but text.
fn is_header(cells: &[Cow<'_, [u8]>], numbers: Numbers, columns: Option<&[Column; 2]>) -> bool {
    names_points(&names_of(cells), columns)
        || cells.iter().all(|cell| numbers.read(cell).is_none())
            && cells
                .iter()
                .any(|cell| cell.iter().any(u8::is_ascii_alphabetic))
            && cells.len() >= 2
}

/// Tells whether the columns of points are among these names.
fn names_points(names: &[String], columns: Option<&[Column; 2]>) -> bool {
    let by_name = |columns: &&[Column; 2]| columns.iter().any(|c| matches!(c, Column::Name(_)));
    let asked = columns.filter(by_name);
    known_columns(names).is_some() || asked.is_some_and(|c| choose("", c, names).is_ok())
}

fn names_of(cells: &[Cow<'_, [u8]>]) -> Vec<String> {
    let name = |cell: &Cow<'_, [u8]>| String::from_utf8_lossy(cell).into_owned();
    cells.iter().map(name).collect()
}

/// Finds the columns of x and y by their names.
pub(crate) fn known_columns(names: &[String]) -> Option<[usize; 2]> {
    let find = |known: &str| names.iter().position(|n| n.eq_ignore_ascii_case(known));
    KNOWN_NAMES
        .iter()
        .find_map(|[x, y]| Some([find(x)?, find(y)?]))
}

/// The columns as they fill up.
struct Table {
    width: usize,
    numbers: Numbers,
    thousands: Thousands,
    x: usize,
    y: usize,
    points: Vec<Point>,
    lines: Lines,
    /// For each column that is neither x nor y: its place and its values.
    others: Vec<Other>,
}

struct Other {
    column: usize,
    name: String,
    /// What it holds; if it holds text, the first point for which it does, and the text.
    values: Result<Vec<f64>, (usize, String)>,
}

impl Table {
    /// Decides on columns by the first row of data.
    fn new(
        file: &str,
        cells: &[Cow<'_, [u8]>],
        header: Option<Vec<String>>,
        numbers: Numbers,
        columns: Option<&[Column; 2]>,
    ) -> Result<Self, Error> {
        let width = cells.len();
        let known = header.as_deref().and_then(known_columns);
        let names = header.unwrap_or_else(|| (0..width).map(unnamed).collect());
        let [x, y] = match columns {
            Some(columns) => choose(file, columns, &names)?,
            None => known.unwrap_or_else(|| first_numbers(cells, numbers)),
        };
        let others = names.into_iter().enumerate();
        let others = others.filter(|&(column, _)| column != x && column != y);
        Ok(Self {
            width,
            numbers,
            thousands: Thousands::default(),
            x,
            y,
            points: Vec::new(),
            lines: Lines::default(),
            others: others
                .map(|(column, name)| Other {
                    column,
                    name,
                    values: Ok(Vec::new()),
                })
                .collect(),
        })
    }

    fn push(&mut self, cells: &[Cow<'_, [u8]>], line: u64) -> Result<(), Problem> {
        check_width(self.width, cells.len())?;
        let index = self.points.len() as u64;
        if index == node::MAX_POINTS {
            return Err(node::too_many(index + 1));
        }
        let x = self.numbers.coordinate(&cells[self.x], 'x', index)?;
        let y = self.numbers.coordinate(&cells[self.y], 'y', index)?;
        if self.numbers == Numbers::Comma {
            self.thousands.look_at(&cells[self.x]);
            self.thousands.look_at(&cells[self.y]);
        }
        self.points.push(Point::new(x, y));
        self.lines.push(line);
        for other in &mut self.others {
            other.push(&cells[other.column], self.numbers);
        }
        Ok(())
    }

    /// Tells whether a coordinate of a row would be a number if its comma were understood.
    fn has_commas(&self, cells: &[Cow<'_, [u8]>]) -> bool {
        let is_one = |&column: &usize| {
            cells
                .get(column)
                .is_some_and(|cell| has_decimal_comma(cell))
        };
        [self.x, self.y].iter().any(is_one)
    }

    fn finish(self) -> PointSet {
        let mut set = PointSet {
            points: self.points,
            lines: self.lines,
            ..PointSet::default()
        };
        for Other { name, values, .. } in self.others {
            match values {
                Ok(values) => set.attributes.push(Attribute { name, values }),
                Err((point, text)) => set.left_out.push(LeftOut { name, point, text }),
            }
        }
        set
    }
}

impl Other {
    /// Adds a value, or gives the column up if it holds text.
    fn push(&mut self, cell: &[u8], numbers: Numbers) {
        let Ok(values) = &mut self.values else {
            return;
        };
        match numbers.read(cell) {
            Some(value) => values.push(value),
            None if cell.is_empty() => values.push(f64::NAN),
            None => self.values = Err((values.len(), scan::show(cell))),
        }
    }
}

/// Returns the first two columns that hold numbers, or else the first two.
fn first_numbers(cells: &[Cow<'_, [u8]>], numbers: Numbers) -> [usize; 2] {
    let mut found = (0..cells.len()).filter(|&i| numbers.read(&cells[i]).is_some());
    match (found.next(), found.next()) {
        (Some(x), Some(y)) => [x, y],
        _ => [0, 1],
    }
}
