//! `.dat`: outlines of airfoils, as UIUC's collection and the programs XFOIL and MSES have them, read only.
//!
//! A line with the name comes first, then one point a line, x and y:
//! - around the outline, from the trailing edge over the upper side and back (*Selig*);
//! - or two numbers of points, then the upper and the lower side, each from the leading edge (*Lednicer*);
//! - or four numbers, the box of a grid, then elements around as in the first, set apart by `999.0 999.0`
//!   (*MSES*).
//!
//! Each element becomes a closed ring of one polygon, by the rule even–odd. If the trailing edge is open, a
//! segment closes it; points that repeat the one before are left out. Text behind the points is none of them.

use crate::scan::{self, Row, Scanner};
use crate::shapes::{Position, Shapes};
use crate::{DomainData, Error, Place, Problem, ReadOptions, words};
use delone::{Point, Watch};

/// What sets elements apart.
const APART: f64 = 999.0;

/// Words of headers of tables, which no airfoil is called.
const COLUMNS: [&str; 14] = [
    "x",
    "y",
    "z",
    "lon",
    "lat",
    "long",
    "longitude",
    "latitude",
    "easting",
    "northing",
    "east",
    "north",
    "id",
    "index",
];

/// Tells whether the bytes begin like one: a line that is no numbers and does not name columns, then points of
/// which the first is at the trailing edge of a chord of 1, or the counts of two sides.
pub(crate) fn sniff(head: &[u8]) -> bool {
    let head = scan::without_mark(head);
    // Numbers have no zeros, and the last line may be cut.
    if memchr::memchr(0, head).is_some() {
        return false;
    }
    let end = memchr::memrchr(b'\n', head).unwrap_or(head.len());
    let mut lines = head[..end].split(|b| matches!(b, b'\n' | b'\r'));
    let title = lines.next().unwrap_or_default().trim_ascii();
    let names_column = |word: &&str| COLUMNS.iter().any(|c| word.eq_ignore_ascii_case(c));
    let text = String::from_utf8_lossy(title);
    let words = text.split(|c: char| !c.is_alphanumeric());
    // One may be the letter of a name, as in Clark Y.
    let names_columns = words.filter(names_column).count() > 1;
    if title.is_empty() || title.starts_with(b"#") || numbers(title).is_some() || names_columns {
        return false;
    }
    let mut rows = lines
        .filter(|line| !line.trim_ascii().is_empty())
        .map(numbers);
    let row = |row: Option<Option<Vec<f64>>>| row.flatten().unwrap_or_default();
    let mut first = row(rows.next());
    if first.len() == 4 {
        first = row(rows.next());
    }
    let second = row(rows.next());
    let ([x, y], [_, _]) = (&first[..], &second[..]) else {
        return false;
    };
    let is_trailing_edge = (0.9..=1.1).contains(x) && y.abs() <= 0.5;
    let is_count = |n: &f64| n.fract() == 0.0 && *n >= 3.0;
    let is_leading_edge = second.iter().all(|v| v.abs() <= 0.1);
    is_trailing_edge || (is_count(x) && is_count(y) && is_leading_edge)
}

/// Reads the numbers of a line; none if it holds something else, too.
fn numbers(line: &[u8]) -> Option<Vec<f64>> {
    let is_between = |b: &u8| b.is_ascii_whitespace() || *b == b',';
    let words = line.split(is_between).filter(|word| !word.is_empty());
    words.map(number).collect()
}

/// Reads a number; Fortran writes exponents with a D, and `3.` for 3.
fn number(word: &[u8]) -> Option<f64> {
    scan::number(word).or_else(|| {
        let text = std::str::from_utf8(word).ok()?;
        text.replace(['d', 'D'], "e").parse().ok()
    })
}

/// Reads a domain.
pub(crate) fn read_domain(
    file: &str,
    bytes: &[u8],
    _options: &ReadOptions,
    watch: &dyn Watch,
) -> Result<DomainData, Error> {
    let mut rows = Scanner::new(file, bytes, watch);
    let mut outlines = Outlines::default();
    let mut is_first = true;
    while let Some(row) = rows.next_full_row()? {
        let found = numbers(row.text);
        match found.as_deref() {
            // The name is whatever stands in the first line.
            _ if std::mem::take(&mut is_first) && found.as_ref().is_none_or(|n| n.len() != 2) => {}
            Some(&[x, y]) => outlines.add([x, y], row, &rows)?,
            Some(&[_, _, _, _]) if outlines.is_empty() => {}
            None if !outlines.is_empty() => {
                outlines.behind(row, &rows)?;
                break;
            }
            found => {
                let shown = scan::show(row.text);
                let problem = match found {
                    Some(found) => Problem::Columns {
                        expected: 2,
                        found: found.len(),
                    },
                    None => Problem::NotANumber {
                        what: "x and y of a point".to_owned(),
                        text: shown,
                    },
                };
                return Err(rows.at(row, problem));
            }
        }
    }
    outlines
        .finish()
        .map_err(|problem| rows.malformed(Place::File, problem))
}

/// The points so far.
#[derive(Default)]
struct Outlines {
    /// The numbers of points of the upper and the lower side, if the file has them.
    counts: Option<[usize; 2]>,
    elements: Vec<Vec<Point>>,
    num_points: u64,
    note: Option<String>,
}

impl Outlines {
    fn is_empty(&self) -> bool {
        self.elements.is_empty() && self.counts.is_none()
    }

    fn add(&mut self, [x, y]: [f64; 2], row: Row<'_>, rows: &Scanner<'_>) -> Result<(), Error> {
        let is_count = |n: f64| n.fract() == 0.0 && (3.0..1e9).contains(&n);
        if self.is_empty() && is_count(x) && is_count(y) {
            self.counts = Some([x as usize, y as usize]);
            return Ok(());
        }
        if [x, y] == [APART; 2] {
            self.elements.push(Vec::new());
            return Ok(());
        }
        for (axis, value) in [('x', x), ('y', y)] {
            if !value.is_finite() {
                let problem = Problem::NotFinite {
                    index: self.num_points,
                    axis,
                    text: value.to_string(),
                };
                return Err(rows.at(row, problem));
            }
        }
        if self.elements.is_empty() {
            self.elements.push(Vec::new());
        }
        self.num_points += 1;
        self.elements
            .last_mut()
            .expect("bug: there is one")
            .push(Point::new(x, y));
        Ok(())
    }

    /// Takes note of text behind the points, which must not be cut short by it.
    fn behind(&mut self, row: Row<'_>, rows: &Scanner<'_>) -> Result<(), Error> {
        let declared = self
            .counts
            .map_or(0, |[upper, lower]| upper as u64 + lower as u64);
        if self.num_points < declared {
            let problem = Problem::NotANumber {
                what: "x and y of a point".to_owned(),
                text: scan::show(row.text),
            };
            return Err(rows.at(row, problem));
        }
        let text = format!(
            "the text from line {} on is left out: {:?} …",
            row.line,
            scan::show(row.text)
        );
        self.note = Some(text);
        Ok(())
    }

    fn finish(mut self) -> Result<DomainData, Problem> {
        if let Some([upper, lower]) = self.counts {
            let declared = upper as u64 + lower as u64;
            if self.num_points != declared || self.elements.len() != 1 {
                return Err(Problem::Truncated {
                    items: "points",
                    declared,
                    found: self.num_points,
                });
            }
            // Around: from the trailing edge over the upper side, and back over the lower one.
            self.elements[0][..upper].reverse();
        }
        let mut rings = Vec::new();
        for mut element in self.elements {
            element.dedup();
            if element.first() == element.last() {
                element.pop();
            }
            if element.len() < 3 {
                let points = words::counted(element.len(), "distinct point", "distinct points");
                let text = format!("an outline of {points}; at least 3 are needed");
                return Err(Problem::Other(text));
            }
            element.push(element[0]);
            let positions = element.into_iter().map(|point| Position {
                point,
                extras: [f64::NAN; 2],
            });
            rings.push(positions.collect::<Vec<_>>());
        }
        if rings.is_empty() {
            return Err(Problem::Empty);
        }
        let mut shapes = Shapes::default();
        for ring in &rings {
            shapes.polygon([&ring[..]])?;
            shapes.end_feature(None);
        }
        let mut domain = shapes.finish();
        domain.vertices.notes.extend(self.note);
        Ok(domain)
    }
}
