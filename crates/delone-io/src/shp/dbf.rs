//! The table beside the shapes: dBase III and its successors, as far as shapefiles use them.
//!
//! *dBASE .DBF file structure*, dBASE LLC. Numbers (`N`, `F`, and `I` of four bytes) and truth values (`L`) are
//! read; empty cells and those full of asterisks, which is how too large a number is stored, are NaN. Texts, dates
//! and memos are left out, and named.

use crate::features::Columns;
use crate::{Attribute, Error, LeftOut, Place, Problem, cancel, scan};
use delone::Watch;

/// Bytes of the header before the fields, and of a field.
const HEADER: usize = 32;
const FIELD: usize = 32;

/// What a table says.
#[derive(Debug, Default)]
pub(super) struct Table {
    pub columns: Columns,
    /// The number of rows, if there is a table.
    pub rows: Option<usize>,
    /// Rows that are deleted, in order.
    deleted: Vec<usize>,
}

impl Table {
    /// Tells whether a row is deleted.
    pub fn is_deleted(&self, row: usize) -> bool {
        self.deleted.binary_search(&row).is_ok()
    }
}

/// One column as it fills up.
struct Field {
    name: String,
    kind: u8,
    start: usize,
    length: usize,
    /// What it holds, or the first row for which it holds no number, and what stands there.
    values: Result<Vec<f64>, (usize, String)>,
}

/// Reads a table.
pub(super) fn read(file: &str, bytes: &[u8], watch: &dyn Watch) -> Result<Table, Error> {
    let malformed = |at: usize, problem| Error::Malformed {
        file: file.to_owned(),
        place: Place::Byte(at as u64),
        problem,
    };
    let short = || {
        let text = "no table: the header is not complete; without the file, shapes are read alone";
        malformed(0, Problem::Other(text.to_owned()))
    };
    let head = bytes.get(..HEADER).ok_or_else(short)?;
    let declared = u32::from_le_bytes([head[4], head[5], head[6], head[7]]) as usize;
    let start = usize::from(u16::from_le_bytes([head[8], head[9]]));
    let width = usize::from(u16::from_le_bytes([head[10], head[11]]));
    let fields = bytes.get(HEADER..start).ok_or_else(short)?;
    let mut fields = fields_of(fields, width).map_err(|p| malformed(HEADER, p))?;
    let rows = &bytes[start..];
    let found = rows.len().checked_div(width).unwrap_or(0);
    if declared > found {
        let problem = Problem::Truncated {
            items: "rows",
            declared: declared as u64,
            found: found as u64,
        };
        return Err(malformed(4, problem));
    }
    let mut deleted = Vec::new();
    for (row, cells) in rows.chunks_exact(width.max(1)).take(declared).enumerate() {
        cancel::check(watch, row)?;
        if cells[0] == b'*' {
            deleted.push(row);
        }
        for field in &mut fields {
            field.push(row, &cells[field.start..][..field.length]);
        }
    }
    let mut columns = Columns::default();
    for Field { name, values, .. } in fields {
        match values {
            Ok(values) => columns.numbers.push(Attribute { name, values }),
            Err((point, text)) => columns.left_out.push(LeftOut { name, point, text }),
        }
    }
    Ok(Table {
        columns,
        rows: Some(declared),
        deleted,
    })
}

/// Reads what the header says about the fields; each row has a byte before them. A header of 16 bits has no room for more
/// fields than there may be columns.
fn fields_of(bytes: &[u8], width: usize) -> Result<Vec<Field>, Problem> {
    let mut fields = Vec::new();
    let mut start = 1;
    for field in bytes.chunks_exact(FIELD) {
        if field[0] == b'\r' {
            break;
        }
        let name = &field[..11];
        let end = memchr::memchr(0, name).unwrap_or(name.len());
        let kind = field[11].to_ascii_uppercase();
        // A long text has the higher byte of its length where numbers have their decimals.
        let high = if kind == b'C' { field[17] } else { 0 };
        let length = usize::from(u16::from_le_bytes([field[16], high]));
        fields.push(Field {
            name: String::from_utf8_lossy(&name[..end]).trim().to_owned(),
            kind,
            start,
            length,
            values: Ok(Vec::new()),
        });
        start += length;
    }
    if start > width {
        let text = format!("fields of {start} bytes in rows of {width}");
        return Err(Problem::Other(text));
    }
    Ok(fields)
}

impl Field {
    /// Adds a value, or gives the column up if it holds something else.
    fn push(&mut self, row: usize, cell: &[u8]) {
        let Ok(values) = &mut self.values else {
            return;
        };
        match value(self.kind, cell) {
            Some(value) => values.push(value),
            None => self.values = Err((row, scan::show(cell.trim_ascii()))),
        }
    }
}

/// Reads a cell; `None` is something else than a number.
fn value(kind: u8, cell: &[u8]) -> Option<f64> {
    let is_blank = |b: &u8| matches!(b, b' ' | b'*' | 0);
    match kind {
        b'N' | b'F' if cell.iter().all(is_blank) => Some(f64::NAN),
        b'N' | b'F' => {
            let end = memchr::memchr(0, cell).unwrap_or(cell.len());
            scan::number(cell[..end].trim_ascii())
        }
        b'I' => Some(i32::from_le_bytes(cell.try_into().ok()?).into()),
        b'L' => Some(match cell.first()? {
            b'T' | b't' | b'Y' | b'y' => 1.0,
            b'F' | b'f' | b'N' | b'n' => 0.0,
            _ => f64::NAN,
        }),
        _ => None,
    }
}
