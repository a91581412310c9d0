//! Well-known binary: the geometries of databases and GeoParquet as bytes.
//!
//! OGC 06-103r4, *Simple feature access*, in either byte order, with Z and M as ISO numbers them (1001 is a
//! point with z) and as PostGIS flags them (EWKB, whose SRID is passed over). Triangles, and those of a TIN or
//! a polyhedral surface, are polygons. Curves are refused. An empty point is one whose coordinates are NaN.

use crate::shapes::{Position, Shapes};
use crate::{Problem, scan};
use delone::{Point, Watch};

/// Deepest nesting of collections, so that hostile bytes cannot exhaust the stack.
const MAX_DEPTH: usize = 100;

/// Positions between two looks at the watch.
const POSITIONS_PER_POLL: u64 = 4096;

/// EWKB's flags in the type.
const HAS_Z: u32 = 0x8000_0000;
const HAS_M: u32 = 0x4000_0000;
const HAS_SRID: u32 = 0x2000_0000;

/// Bytes before the content of a geometry: byte order and type.
const HEADER: usize = 5;

/// Names of the types, by number; the empty ones are those that have no instances.
const NAMES: [&str; 18] = [
    "",
    "Point",
    "LineString",
    "Polygon",
    "MultiPoint",
    "MultiLineString",
    "MultiPolygon",
    "GeometryCollection",
    "CircularString",
    "CompoundCurve",
    "CurvePolygon",
    "MultiCurve",
    "MultiSurface",
    "Curve",
    "Surface",
    "PolyhedralSurface",
    "TIN",
    "Triangle",
];

/// Why reading stopped.
#[derive(Debug, PartialEq)]
pub(crate) enum Stop {
    /// At this byte something is wrong.
    Problem(usize, Problem),
    Cancelled,
}

/// What a geometry begins with.
#[derive(Clone, Copy)]
struct Header {
    is_little: bool,
    kind: u32,
    has_z: bool,
    has_m: bool,
}

impl Header {
    /// Returns the bytes of one position.
    fn position_size(self) -> usize {
        8 * (2 + usize::from(self.has_z) + usize::from(self.has_m))
    }
}

/// Adds the one geometry that the bytes are.
pub(crate) fn read(bytes: &[u8], shapes: &mut Shapes, watch: &dyn Watch) -> Result<(), Stop> {
    let mut reader = Reader {
        bytes,
        at: 0,
        shapes,
        positions: 0,
        watch,
    };
    reader.geometry(0)?;
    match bytes.len() - reader.at {
        0 => Ok(()),
        rest => Err(reader.other(format!("{rest} bytes behind the geometry"))),
    }
}

/// Tells whether a word is a geometry in hexadecimal digits, at least the beginning of one.
pub(crate) fn is_hex(word: &[u8]) -> bool {
    let Some(digits) = word.get(..2 * HEADER) else {
        return false;
    };
    let Some(header) = from_hex(digits) else {
        return false;
    };
    header_of(&header).is_some_and(|h| (1..NAMES.len() as u32).contains(&h.kind))
        && word.iter().all(u8::is_ascii_hexdigit)
}

/// Turns hexadecimal digits into bytes.
pub(crate) fn from_hex(digits: &[u8]) -> Option<Vec<u8>> {
    let value = |digit: u8| char::from(digit).to_digit(16).map(|d| d as u8);
    let pairs = digits.chunks_exact(2);
    if !pairs.remainder().is_empty() {
        return None;
    }
    pairs
        .map(|pair| Some(value(pair[0])? << 4 | value(pair[1])?))
        .collect()
}

/// Takes the first bytes apart, those of the SRID excepted.
fn header_of(bytes: &[u8]) -> Option<Header> {
    let &[order, a, b, c, d, ..] = bytes else {
        return None;
    };
    let code = match order {
        0 => u32::from_be_bytes([a, b, c, d]),
        1 => u32::from_le_bytes([a, b, c, d]),
        _ => return None,
    };
    let plain = code & !(HAS_Z | HAS_M | HAS_SRID);
    let (thousands, kind) = (plain / 1000, plain % 1000);
    (thousands < 4).then_some(Header {
        is_little: order == 1,
        kind,
        has_z: code & HAS_Z != 0 || thousands & 1 != 0,
        has_m: code & HAS_M != 0 || thousands & 2 != 0,
    })
}

struct Reader<'a> {
    bytes: &'a [u8],
    at: usize,
    shapes: &'a mut Shapes,
    /// Positions read so far, for messages.
    positions: u64,
    watch: &'a dyn Watch,
}

impl<'a> Reader<'a> {
    fn geometry(&mut self, depth: usize) -> Result<(), Stop> {
        let start = self.at;
        let header = self.header()?;
        match header.kind {
            1 => {
                let at = self.at;
                let position = self.position(header)?;
                if position.point.x.is_nan() && position.point.y.is_nan() {
                    return Ok(());
                }
                self.check(position, at)?;
                self.shapes.point(position).map_err(|p| self.problem(p))
            }
            2 => {
                let line = self.positions(header)?;
                self.shapes.line(&line).map_err(|p| self.problem(p))
            }
            3 | 17 => self.polygon(header),
            4..=7 | 15 | 16 => self.parts(header, depth),
            8..=14 => {
                let name = NAMES[header.kind as usize];
                self.at = start;
                Err(self.other(format!(
                    "a {name}: curves are not read; replace them by lines, as ST_CurveToLine does"
                )))
            }
            kind => {
                self.at = start;
                Err(self.other(format!("type {kind} is none of well-known binary's")))
            }
        }
    }

    fn header(&mut self) -> Result<Header, Stop> {
        let start = self.at;
        let bytes = self.take(HEADER)?;
        let has_srid = |header: Header| {
            let flag = if header.is_little { bytes[4] } else { bytes[1] };
            u32::from(flag) << 24 & HAS_SRID != 0
        };
        match header_of(bytes) {
            Some(header) if has_srid(header) => self.take(4).map(|_| header),
            Some(header) => Ok(header),
            None => {
                let shown = scan::show(format!("{bytes:02x?}").as_bytes());
                self.at = start;
                Err(self.other(format!("no byte order and type of a geometry: {shown}")))
            }
        }
    }

    /// Reads the parts of a collection, each of which is a geometry.
    fn parts(&mut self, header: Header, depth: usize) -> Result<(), Stop> {
        if depth == MAX_DEPTH {
            return Err(self.other(format!(
                "collections within collections, deeper than {MAX_DEPTH}"
            )));
        }
        for _ in 0..self.count(header, HEADER, "geometries")? {
            self.geometry(depth + 1)?;
        }
        Ok(())
    }

    fn polygon(&mut self, header: Header) -> Result<(), Stop> {
        let mut rings = Vec::new();
        for _ in 0..self.count(header, 4, "rings")? {
            rings.push(self.positions(header)?);
        }
        let rings = rings.iter().map(Vec::as_slice);
        self.shapes.polygon(rings).map_err(|p| self.problem(p))
    }

    fn positions(&mut self, header: Header) -> Result<Vec<Position>, Stop> {
        let count = self.count(header, header.position_size(), "positions")?;
        let mut positions = Vec::with_capacity(count);
        for _ in 0..count {
            let at = self.at;
            let position = self.position(header)?;
            self.check(position, at)?;
            positions.push(position);
        }
        Ok(positions)
    }

    /// Reads a count of items, none of which can be smaller than `size`.
    fn count(&mut self, header: Header, size: usize, items: &'static str) -> Result<usize, Stop> {
        let at = self.at;
        let bytes = self.take(4)?.try_into().expect("bug: four bytes");
        let declared = match header.is_little {
            true => u32::from_le_bytes(bytes),
            false => u32::from_be_bytes(bytes),
        };
        let possible = (self.bytes.len() - self.at) / size;
        if declared as usize <= possible {
            return Ok(declared as usize);
        }
        let problem = Problem::Truncated {
            items,
            declared: declared.into(),
            found: possible as u64,
        };
        Err(Stop::Problem(at, problem))
    }

    fn position(&mut self, header: Header) -> Result<Position, Stop> {
        if self.positions.is_multiple_of(POSITIONS_PER_POLL) && self.watch.is_cancelled() {
            return Err(Stop::Cancelled);
        }
        let bytes = self.take(header.position_size())?;
        let mut numbers = bytes.chunks_exact(8).map(|bytes| {
            let bytes = bytes.try_into().expect("bug: eight bytes");
            match header.is_little {
                true => f64::from_le_bytes(bytes),
                false => f64::from_be_bytes(bytes),
            }
        });
        let mut next = |is_there: bool| numbers.next().filter(|_| is_there).unwrap_or(f64::NAN);
        let point = Point::new(next(true), next(true));
        let extras = [
            if header.has_z { next(true) } else { f64::NAN },
            if header.has_m { next(true) } else { f64::NAN },
        ];
        self.positions += 1;
        Ok(Position { point, extras })
    }

    /// Checks that a position has finite coordinates.
    fn check(&self, position: Position, at: usize) -> Result<(), Stop> {
        let Point { x, y } = position.point;
        let (axis, value, at) = match (x.is_finite(), y.is_finite()) {
            (true, true) => return Ok(()),
            (false, _) => ('x', x, at),
            (true, false) => ('y', y, at + 8),
        };
        let problem = Problem::NotFinite {
            index: self.positions - 1,
            axis,
            text: value.to_string(),
        };
        Err(Stop::Problem(at, problem))
    }

    fn take(&mut self, size: usize) -> Result<&'a [u8], Stop> {
        match self.bytes.get(self.at..self.at + size) {
            Some(bytes) => {
                self.at += size;
                Ok(bytes)
            }
            None => {
                let text = "truncated: the geometry ends too early".to_owned();
                Err(self.other(text))
            }
        }
    }

    fn problem(&self, problem: Problem) -> Stop {
        Stop::Problem(self.at, problem)
    }

    fn other(&self, text: String) -> Stop {
        self.problem(Problem::Other(text))
    }
}

#[cfg(test)]
mod tests {
    use super::{Stop, from_hex, is_hex, read};
    use crate::shapes::Shapes;
    use crate::{DomainData, Problem};

    fn domain(hex: &str) -> Result<DomainData, Stop> {
        let bytes = from_hex(hex.as_bytes()).expect("digits");
        let mut shapes = Shapes::default();
        read(&bytes, &mut shapes, &())?;
        shapes.end_feature(None);
        Ok(shapes.finish())
    }

    fn message(hex: &str) -> String {
        match domain(hex) {
            Err(Stop::Problem(at, problem)) => format!("{at}: {problem}"),
            other => panic!("{other:?}"),
        }
    }

    /// `SELECT 'SRID=4326;POINT Z(1 2 3)'::geometry` as PostGIS prints it.
    const POINT_Z: &str = "01010000A0E6100000000000000000F03F00000000000000400000000000000840";

    #[test]
    fn flags_and_thousands_mean_the_same() {
        let iso = "01E9030000000000000000F03F00000000000000400000000000000840";
        let big = "00000003E93FF000000000000040000000000000004008000000000000";
        let expected = domain(POINT_Z).expect("a point");
        assert_eq!(expected.vertices.points, [delone::Point::new(1.0, 2.0)]);
        assert_eq!(expected.vertices.attributes[0].values, [3.0]);
        assert_eq!(domain(iso).as_ref(), Ok(&expected));
        assert_eq!(domain(big).as_ref(), Ok(&expected));
        assert!([POINT_Z, iso, big].iter().all(|hex| is_hex(hex.as_bytes())));
        assert!(!is_hex(b"0100000000") && !is_hex(b"0112345678") && !is_hex(b"12"));
    }

    #[test]
    fn every_cut_is_an_error() {
        let triangle = concat!(
            "0111000000",
            "01000000",
            "04000000",
            "00000000000000000000000000000000",
            "000000000000F03F0000000000000000",
            "0000000000000000000000000000F03F",
            "00000000000000000000000000000000",
        );
        let domain = domain(triangle).expect("a triangle");
        assert_eq!((domain.segments.len(), domain.polygons.len()), (3, 1));
        for end in (0..triangle.len()).step_by(2) {
            let text = message(&triangle[..end]);
            assert!(text.contains("truncated"), "{end}: {text}");
        }
    }

    #[test]
    fn problems_say_where_they_are() {
        for (hex, expected) in [
            (
                "0108000000".to_owned() + "00000000",
                "0: a CircularString: curves are not read; replace them by lines, as ST_CurveToLine does",
            ),
            (
                "0163000000".to_owned(),
                "0: type 99 is none of well-known binary's",
            ),
            (
                "0201000000".to_owned(),
                "0: no byte order and type of a geometry: [02, 01, 00, 00, 00]",
            ),
            (
                "0102000000FFFFFFFF".to_owned(),
                "5: truncated: header says 4294967295 positions, file has 0",
            ),
            (
                "0107000000FFFFFFFF".to_owned() + "010400000000000000",
                "5: truncated: header says 4294967295 geometries, file has 1",
            ),
            (POINT_Z.to_owned() + "00", "33: 1 bytes behind the geometry"),
            (
                "0101000000000000000000F03F000000000000F07F".to_owned(),
                "13: point 0: y is inf, coordinates must be finite; repair or remove it",
            ),
        ] {
            assert_eq!(message(&hex), expected, "{hex}");
        }
        let empty = domain("0101000000000000000000F87F000000000000F87F").expect("no point");
        assert!(empty.vertices.points.is_empty());
    }

    #[test]
    fn collections_are_bounded() {
        let nested = |depth| "010700000001000000".repeat(depth) + "010400000000000000";
        assert!(domain(&nested(99)).is_ok());
        let text = message(&nested(100));
        assert!(
            text.ends_with("collections within collections, deeper than 100"),
            "{text}"
        );
        let Err(Stop::Problem(_, Problem::Other(_))) = domain(&nested(100_000)) else {
            panic!("no error");
        };
    }
}
