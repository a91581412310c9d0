//! The geometries.

use super::dbf::{self, Table};
use crate::features::Features;
use crate::shapes::Position;
use crate::{DomainData, Error, Place, Problem, ReadOptions, Source, cancel};
use delone::{Phase, Point, Watch};

/// Bytes of the file's header, and of a record's.
const HEADER: usize = 100;
const RECORD_HEADER: usize = 8;

/// Bytes of the box in which a line, a polygon or a multipoint lies.
const BOX: usize = 32;

/// What is less is no number, in M.
const NO_DATA: f64 = -1e38;

/// Reads a domain.
pub(crate) fn read_domain(
    source: &Source,
    bytes: &[u8],
    _options: &ReadOptions,
    watch: &dyn Watch,
) -> Result<DomainData, Error> {
    let file = source.to_string();
    let mut table = match source.beside_if_any("dbf") {
        Some(table) => dbf::read(&table.to_string(), &table.load(watch)?, watch)?,
        None => Table::default(),
    };
    let malformed = |at: usize, problem| Error::Malformed {
        file: file.clone(),
        place: Place::Byte(at as u64),
        problem,
    };
    let bytes = content(bytes).map_err(|p| malformed(0, p))?;
    let mut features = Features::new(std::mem::take(&mut table.columns));
    let mut at = HEADER;
    let mut records = 0;
    while at < bytes.len() {
        cancel::check(watch, records)?;
        if records.is_multiple_of(1024) {
            watch.progress(Phase::Read, at as u64, bytes.len() as u64);
        }
        records += 1;
        let in_record = |problem: Problem| {
            malformed(at, Problem::Other(format!("record {records}: {problem}")))
        };
        let record = record(&bytes[at..]).map_err(in_record)?;
        if !table.is_deleted(records - 1) {
            add(record, &mut features).map_err(in_record)?;
        }
        features.end();
        at += RECORD_HEADER + record.len();
    }
    if let Some(rows) = table.rows.filter(|&rows| rows != records) {
        let text = format!(
            "{records} shapes, but the .dbf beside it has {rows} rows; remove it if it is another's"
        );
        return Err(malformed(0, Problem::Other(text)));
    }
    features.finish(watch)
}

/// Checks the header and returns as much as it declares.
fn content(bytes: &[u8]) -> Result<&[u8], Problem> {
    if bytes.is_empty() {
        return Err(Problem::Empty);
    }
    if !super::sniff(bytes) {
        let text = "no shapefile: it does not begin with the number 9994";
        return Err(Problem::Other(text.to_owned()));
    }
    let declared = bytes.get(24..28).map(|b| 2 * u64::from(big(b)));
    match declared {
        Some(declared) if bytes.len() < HEADER || declared > bytes.len() as u64 => {
            Err(Problem::Truncated {
                items: "bytes",
                declared,
                found: bytes.len() as u64,
            })
        }
        None => Err(Problem::Other("truncated within the header".to_owned())),
        // Who did not live to write the length has left it as it was.
        Some(declared) if declared < HEADER as u64 => Ok(bytes),
        Some(declared) => Ok(&bytes[..declared as usize]),
    }
}

/// Returns the content of the record that the bytes begin with.
fn record(bytes: &[u8]) -> Result<&[u8], Problem> {
    let found = bytes.len().saturating_sub(RECORD_HEADER) as u64;
    let declared = bytes
        .get(4..RECORD_HEADER)
        .map_or(4, |b| 2 * u64::from(big(b)));
    if declared > found {
        return Err(Problem::Truncated {
            items: "bytes",
            declared,
            found,
        });
    }
    Ok(&bytes[RECORD_HEADER..][..declared as usize])
}

fn big(bytes: &[u8]) -> u32 {
    u32::from_be_bytes(bytes.try_into().expect("bug: four bytes"))
}

/// Adds the shape of a record.
fn add(record: &[u8], features: &mut Features) -> Result<(), Problem> {
    let mut cursor = Cursor { rest: record };
    let kind = cursor.integer()?;
    // Z, M and neither are numbered in the same way.
    let extra = match kind {
        0..10 => Extra::None,
        10..20 => Extra::Z,
        20..30 => Extra::M,
        _ => Extra::None,
    };
    let shapes = &mut features.shapes;
    match kind {
        0 => Ok(()),
        1 | 11 | 21 => {
            let position = cursor.point(extra)?;
            check(&[position], shapes.num_points())?;
            shapes.point(position)
        }
        8 | 18 | 28 => {
            cursor.take(BOX)?;
            let count = cursor.count(16, "points")?;
            let positions = cursor.positions(count, extra)?;
            check(&positions, shapes.num_points())?;
            positions.into_iter().try_for_each(|p| shapes.point(p))
        }
        3 | 13 | 23 | 5 | 15 | 25 => {
            cursor.take(BOX)?;
            let (parts, positions) = cursor.parts(extra)?;
            check(&positions, shapes.num_points())?;
            let mut parts = parts.into_iter().map(|part| &positions[part]);
            match kind % 10 {
                3 => parts.try_for_each(|part| shapes.line(part)),
                _ => shapes.polygon(parts),
            }
        }
        31 => Err(Problem::Other(
            "a multipatch, which is a surface in space; only points, lines and polygons are read"
                .to_owned(),
        )),
        kind => Err(Problem::Other(format!(
            "type {kind} is none of a shapefile's"
        ))),
    }
}

/// Checks that all coordinates are finite.
fn check(positions: &[Position], first: usize) -> Result<(), Problem> {
    let Some(bad) = positions.iter().position(|p| !p.point.is_finite()) else {
        return Ok(());
    };
    let Point { x, y } = positions[bad].point;
    let (axis, value) = if x.is_finite() { ('y', y) } else { ('x', x) };
    Err(Problem::NotFinite {
        index: (first + bad) as u64,
        axis,
        text: value.to_string(),
    })
}

/// What positions have beyond x and y.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Extra {
    None,
    /// z, and perhaps m.
    Z,
    M,
}

/// Takes a record apart.
struct Cursor<'a> {
    rest: &'a [u8],
}

impl<'a> Cursor<'a> {
    fn take(&mut self, size: usize) -> Result<&'a [u8], Problem> {
        let (taken, rest) = self.rest.split_at_checked(size).ok_or_else(|| {
            let found = self.rest.len();
            Problem::Other(format!(
                "too short: {size} bytes are needed, {found} are left"
            ))
        })?;
        self.rest = rest;
        Ok(taken)
    }

    fn integer(&mut self) -> Result<i32, Problem> {
        let bytes = self.take(4)?.try_into().expect("bug: four bytes");
        Ok(i32::from_le_bytes(bytes))
    }

    /// Reads a count of items, none of which is smaller than `size`.
    fn count(&mut self, size: usize, items: &'static str) -> Result<usize, Problem> {
        let declared = self.integer()?;
        let found = self.rest.len() / size;
        usize::try_from(declared)
            .ok()
            .filter(|&count| count <= found)
            .ok_or(Problem::Truncated {
                items,
                declared: u64::from(declared as u32),
                found: found as u64,
            })
    }

    fn number(&mut self) -> Result<f64, Problem> {
        let bytes = self.take(8)?.try_into().expect("bug: eight bytes");
        Ok(f64::from_le_bytes(bytes))
    }

    /// Reads a single point; m may be missing behind z.
    fn point(&mut self, extra: Extra) -> Result<Position, Problem> {
        let point = Point::new(self.number()?, self.number()?);
        let mut extras = [f64::NAN; 2];
        if extra == Extra::Z {
            extras[0] = self.number()?;
        }
        if extra == Extra::M || !self.rest.is_empty() && extra == Extra::Z {
            extras[1] = measure(self.number()?);
        }
        Ok(Position { point, extras })
    }

    /// Reads positions: first x and y of all, then z of all, then m of all, which may be missing.
    fn positions(&mut self, count: usize, extra: Extra) -> Result<Vec<Position>, Problem> {
        let mut positions = Vec::with_capacity(count);
        for _ in 0..count {
            positions.push(Position {
                point: Point::new(self.number()?, self.number()?),
                extras: [f64::NAN; 2],
            });
        }
        if extra == Extra::Z {
            self.take(16)?; // the range
            for position in &mut positions {
                position.extras[0] = self.number()?;
            }
        }
        if extra != Extra::None && !self.rest.is_empty() {
            self.take(16)?;
            for position in &mut positions {
                position.extras[1] = measure(self.number()?);
            }
        }
        Ok(positions)
    }

    /// Reads positions in parts.
    fn parts(
        &mut self,
        extra: Extra,
    ) -> Result<(Vec<std::ops::Range<usize>>, Vec<Position>), Problem> {
        let num_parts = self.integer()?;
        let declared = self.integer()?;
        let starts = Cursor { rest: self.rest };
        let truncated = |items, declared: i32, found: usize| Problem::Truncated {
            items,
            declared: u64::from(declared as u32),
            found: found as u64,
        };
        let fits = |count: i32, size: usize, bytes: usize| {
            usize::try_from(count)
                .ok()
                .filter(|c| c.checked_mul(size).is_some_and(|b| b <= bytes))
        };
        let found = starts.rest.len() / 4;
        let parts = fits(num_parts, 4, starts.rest.len());
        let parts = parts.ok_or_else(|| truncated("parts", num_parts, found))?;
        let mut starts = Cursor {
            rest: self.take(4 * parts)?,
        };
        let found = self.rest.len() / 16;
        let count = fits(declared, 16, self.rest.len());
        let count = count.ok_or_else(|| truncated("points", declared, found))?;
        let mut bounds = Vec::with_capacity(parts + 1);
        for part in 0..parts {
            let start = starts.integer()?;
            let lowest = bounds.last().copied().unwrap_or(0);
            let is_good = |start: &usize| (lowest..=count).contains(start);
            let good = usize::try_from(start).ok().filter(is_good).ok_or_else(|| {
                Problem::Other(format!("part {part} begins at point {start} of {count}"))
            })?;
            bounds.push(good);
        }
        if bounds.first().is_some_and(|&first| first > 0) || bounds.is_empty() && count > 0 {
            return Err(Problem::Other("points before the first part".to_owned()));
        }
        bounds.push(count);
        let parts = bounds.windows(2).map(|pair| pair[0]..pair[1]);
        Ok((parts.collect(), self.positions(count, extra)?))
    }
}

/// Takes what is no measure for none.
fn measure(value: f64) -> f64 {
    if value < NO_DATA { f64::NAN } else { value }
}
