//! Tables of lineage: words as texts, numbers as such, empty cells null.

use super::file::File;
use super::write::{Table, write};
use crate::certificate::{COLUMNS, ELEMENTS, Lineage, ORIGINS, Row};
use crate::target::Output;
use crate::{Error, cancel};
use delone::Watch;
use parquet::basic::Type as Physical;

/// Where the cells of numbers begin that may be empty.
const NUMBERS: usize = 3;

/// Writes the table.
pub(crate) fn write_lineage(out: &mut Output<'_>, lineage: &Lineage) -> Result<(), Error> {
    let rows = &lineage.rows();
    let mut table = Table::new(rows.len());
    table.push_words(COLUMNS[0], &ELEMENTS, |i| rows.get(i).element);
    let number = |i| rows.get(i).number as f64;
    table.push(COLUMNS[1], Physical::INT64, number);
    table.push_words(COLUMNS[2], &ORIGINS, |i| rows.get(i).origin);
    for (k, &name) in COLUMNS[NUMBERS..].iter().enumerate() {
        let physical = match name {
            "at" | "to" | "other_at" => Physical::DOUBLE,
            _ => Physical::INT64,
        };
        let cell = move |i| rows.get(i).numbers()[k].unwrap_or(f64::NAN);
        table.push_nullable(name, physical, cell);
    }
    write(out, &table)
}

/// Reads a table, row by row; what is wrong with a row `take` says in words.
pub(crate) fn read_lineage(
    name: &str,
    bytes: &[u8],
    watch: &dyn Watch,
    mut take: impl FnMut(&Row<'_>) -> Result<(), String>,
) -> Result<(), Error> {
    let mut file = File::open(name, bytes, watch)?;
    let elements = words(&mut file, COLUMNS[0], &ELEMENTS)?;
    let numbers = numbers(&mut file, COLUMNS[1])?;
    let origins = words(&mut file, COLUMNS[2], &ORIGINS)?;
    let mut cells = Vec::new();
    for column in &COLUMNS[NUMBERS..] {
        cells.push(self::numbers(&mut file, column)?);
    }
    for i in 0..file.rows {
        cancel::check(watch, i)?;
        let whole = |k: usize| whole(COLUMNS[NUMBERS + k], cells[k][i]);
        let fraction = |k: usize| Some(cells[k][i]).filter(|t: &f64| !t.is_nan());
        let row = || {
            Ok(Row {
                element: ELEMENTS[usize::from(elements[i])],
                number: self::whole(COLUMNS[1], numbers[i])?.ok_or("a row without number")?,
                origin: ORIGINS[usize::from(origins[i])],
                feature: whole(0)?,
                at: fraction(1),
                to: fraction(2),
                other: whole(3)?,
                other_at: fraction(4),
                from_vertex: whole(5)?,
                to_vertex: whole(6)?,
            })
        };
        let taken: Result<(), String> = row().and_then(|row| take(&row));
        taken.map_err(|problem| file.other(format!("row {i} (from 0): {problem}")))?;
    }
    Ok(())
}

/// Reads a column of words, as their places among those that are known.
fn words(file: &mut File<'_>, column: &str, known: &[&str]) -> Result<Vec<u8>, Error> {
    let leaf = leaf(file, column)?;
    file.take(file.rows as u64)?;
    let mut places = Vec::new();
    let mut unknown = None;
    file.bytes(leaf, |row, bytes| {
        let word = bytes.unwrap_or_default();
        let place = known.iter().position(|known| known.as_bytes() == word);
        if place.is_none() {
            unknown.get_or_insert((row, String::from_utf8_lossy(word).into_owned()));
        }
        places.push(place.unwrap_or_default() as u8);
        Ok(())
    })?;
    if places.len() < file.rows {
        return Err(file.other(format!("column {column} holds no words")));
    }
    match unknown {
        None => Ok(places),
        Some((row, word)) => {
            let known = known.join(", ");
            Err(file.other(format!(
                "row {row} (from 0): {column} is {word:?}, it must be one of {known}"
            )))
        }
    }
}

/// Reads a column of numbers; those that are missing are NaN.
fn numbers(file: &mut File<'_>, column: &str) -> Result<Vec<f64>, Error> {
    let leaf = leaf(file, column)?;
    let kind = file.field(column).map(|field| file.fields[field].kind);
    let kind = kind.filter(|kind| kind.is_number());
    let kind = kind.ok_or_else(|| file.other(format!("column {column} holds no numbers")))?;
    file.numbers(leaf, kind)?.map_err(|(row, text)| {
        file.other(format!(
            "row {row} (from 0): {column} is {text}, which is too large"
        ))
    })
}

/// Finds where the values of a column are.
fn leaf(file: &File<'_>, column: &str) -> Result<usize, Error> {
    let leaf = file.field(column).and_then(|f| file.fields[f].leaf);
    leaf.ok_or_else(|| {
        let all = COLUMNS.join(", ");
        file.other(format!("no column {column}: a table of lineage has {all}"))
    })
}

/// Takes a number for a whole one; NaN is none.
fn whole(column: &str, number: f64) -> Result<Option<usize>, String> {
    match number {
        number if number.is_nan() => Ok(None),
        number if number >= 0.0 && number.fract() == 0.0 => Ok(Some(number as usize)),
        number => Err(format!(
            "{column} is {number}, it must be a number from 0 on"
        )),
    }
}
