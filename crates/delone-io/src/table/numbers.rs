//! How the numbers of a table are written: with a decimal point, or with a decimal comma.
//!
//! A comma is tried only where it sets no cells apart, in tables whose cells are set apart by semicolons or tabs,
//! and only when a coordinate is no number otherwise; then every coordinate of the table must be such a number,
//! though whole ones may lack the comma. `1,234` may also be a thousand: where nothing tells, it is refused.

use crate::{Problem, scan};

/// How numbers are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Numbers {
    Point,
    Comma,
}

impl Numbers {
    /// Reads a number.
    pub fn read(self, cell: &[u8]) -> Option<f64> {
        match self {
            Self::Point => scan::number(cell),
            Self::Comma if cell.contains(&b'.') => None,
            Self::Comma => match memchr::memchr(b',', cell) {
                None => scan::number(cell),
                Some(place) => {
                    let mut cell = cell.to_vec();
                    cell[place] = b'.';
                    scan::number(&cell)
                }
            },
        }
    }

    /// Reads a coordinate, which must be a finite number.
    pub fn coordinate(self, cell: &[u8], axis: char, index: u64) -> Result<f64, Problem> {
        match self.read(cell) {
            Some(value) if value.is_finite() => Ok(value),
            Some(_) => scan::coordinate(cell, axis, index),
            None => Err(Problem::NotANumber {
                what: axis.to_string(),
                text: scan::show(cell),
            }),
        }
    }
}

/// Tells whether a cell is a number only if its comma is a decimal one.
pub(super) fn has_decimal_comma(cell: &[u8]) -> bool {
    cell.contains(&b',') && Numbers::Comma.read(cell).is_some()
}

/// What the coordinates of a table with decimal commas look like, all together.
#[derive(Default)]
pub(super) struct Thousands {
    /// Some coordinate can only be one with a decimal comma, because of the digits behind it or before it.
    is_excluded: bool,
    /// Some coordinate has no comma.
    has_whole: bool,
}

impl Thousands {
    /// Looks at a coordinate.
    pub fn look_at(&mut self, cell: &[u8]) {
        let Some(place) = memchr::memchr(b',', cell) else {
            self.has_whole = true;
            return;
        };
        let (before, after) = (&cell[..place], &cell[place + 1..]);
        let before = before.strip_prefix(b"-").unwrap_or(before);
        let could_be = after.len() == 3 && (1..=3).contains(&before.len()) && before[0] != b'0';
        self.is_excluded |= !could_be;
    }

    /// Fails if the commas could as well set thousands apart.
    pub fn check(&self) -> Result<(), Problem> {
        if self.is_excluded || !self.has_whole {
            return Ok(());
        }
        Err(Problem::Other(
            "commas in the coordinates may be decimal ones or set thousands apart; write decimal points"
                .to_owned(),
        ))
    }
}

#[cfg(test)]
mod tests {
    use super::{Numbers, Thousands, has_decimal_comma};

    #[test]
    fn a_comma_stands_for_the_point() {
        for (cell, expected) in [
            ("1,5", Some(1.5)),
            ("-,25e3", Some(-250.0)),
            ("7", Some(7.0)),
            ("1,2,3", None),
            ("1.234,5", None),
            ("1.5", None),
            ("a,b", None),
            (",", None),
        ] {
            assert_eq!(Numbers::Comma.read(cell.as_bytes()), expected, "{cell}");
        }
        assert!(has_decimal_comma(b"1,5") && !has_decimal_comma(b"15"));
    }

    #[test]
    fn thousands_are_told_by_the_digits() {
        let check = |cells: &[&str]| {
            let mut thousands = Thousands::default();
            cells
                .iter()
                .for_each(|cell| thousands.look_at(cell.as_bytes()));
            thousands.check().is_ok()
        };
        assert!(check(&["1,234", "12,345"]), "all have three digits");
        assert!(!check(&["1,234", "567"]));
        assert!(check(&["1,234", "567", "0,125"]));
        assert!(check(&["1,234", "567", "1,5"]));
        assert!(check(&["1234,125", "567"]));
    }
}
