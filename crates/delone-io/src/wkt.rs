//! `.wkt`: well-known text, points, lines and polygons as databases write them, read only.
//!
//! OGC 06-103r4, *Simple feature access*, with Z, M and ZM, and PostGIS' `SRID=n;` before a geometry.
//! A file may hold many geometries, set apart by line ends, blanks or semicolons; `#` begins a
//! comment. Z and M become the attributes `z` and `m`. Without a tag, a third number is z, a fourth m.
//! Triangles, and those of a TIN or a polyhedral surface, are polygons; curves are refused. In place of a
//! geometry may stand the hexadecimal digits of its [well-known binary](crate::wkb), as PostGIS prints them,
//! also behind `\\x`. Collections may lie in one another to [`MAX_DEPTH`].

mod token;

use crate::shapes::{Position, Shapes};
use crate::{DomainData, Error, Place, Problem, scan, wkb};
use delone::{Point, Watch};
use token::{Stop, Text, Token};

/// Deepest nesting of collections, so that hostile text cannot exhaust the stack.
const MAX_DEPTH: usize = 100;

/// The kinds of geometry.
const KINDS: [(&str, Kind); 10] = [
    ("POINT", Kind::Point),
    ("LINESTRING", Kind::Line),
    ("POLYGON", Kind::Polygon),
    ("MULTIPOINT", Kind::MultiPoint),
    ("MULTILINESTRING", Kind::MultiLine),
    ("MULTIPOLYGON", Kind::MultiPolygon),
    ("GEOMETRYCOLLECTION", Kind::Collection),
    ("TRIANGLE", Kind::Polygon),
    ("TIN", Kind::MultiPolygon),
    ("POLYHEDRALSURFACE", Kind::MultiPolygon),
];

/// What is known and not read.
const CURVES: [&str; 5] = [
    "CIRCULARSTRING",
    "COMPOUNDCURVE",
    "CURVEPOLYGON",
    "MULTICURVE",
    "MULTISURFACE",
];

#[derive(Clone, Copy)]
enum Kind {
    Point,
    Line,
    Polygon,
    MultiPoint,
    MultiLine,
    MultiPolygon,
    Collection,
}

/// What the numbers of a position are, beyond x and y.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Tag {
    /// None is named: as many as there are.
    Open,
    Z,
    M,
    Zm,
}

const TAGS: [(&str, Tag); 4] = [
    ("", Tag::Open),
    ("Z", Tag::Z),
    ("M", Tag::M),
    ("ZM", Tag::Zm),
];

impl Tag {
    /// Sorts the numbers behind x and y into z and m.
    fn extras(self, numbers: &[f64]) -> Option<[f64; 2]> {
        match (self, numbers) {
            (Self::Open, []) => Some([f64::NAN; 2]),
            (Self::Open | Self::Z, &[z]) => Some([z, f64::NAN]),
            (Self::M, &[m]) => Some([f64::NAN, m]),
            (Self::Open | Self::Zm, &[z, m]) => Some([z, m]),
            _ => None,
        }
    }
}

/// Finds the kind and tag that a word such as `POINT` or `pointZM` names.
fn kind(word: &[u8]) -> Option<(Kind, Tag)> {
    let word = std::str::from_utf8(word).ok()?.to_ascii_uppercase();
    let tag_of = |name| {
        let rest = word.strip_prefix(name)?;
        find(&TAGS, rest.as_bytes())
    };
    KINDS
        .iter()
        .find_map(|&(name, kind)| Some((kind, tag_of(name)?)))
}

/// Tells whether a word such as `CurvePolygonZ` names a curve.
fn is_curve(word: &[u8]) -> bool {
    let begins = |name: &&&str| {
        let head = word.get(..name.len());
        head.is_some_and(|h| h.eq_ignore_ascii_case(name.as_bytes()))
    };
    CURVES
        .iter()
        .find(begins)
        .is_some_and(|name| find(&TAGS, &word[name.len()..]).is_some())
}

/// Returns the digits of a geometry in PostgreSQL's notation of bytes, `\x01…`, whose backslash is a sign.
fn bytea(word: &[u8]) -> Option<&[u8]> {
    let digits = word.strip_prefix(b"x")?;
    wkb::is_hex(digits).then_some(digits)
}

/// Finds a word in a table, in any case.
fn find<T: Copy>(table: &[(&str, T)], word: &[u8]) -> Option<T> {
    let is_word = |(name, _): &&(&str, T)| word.eq_ignore_ascii_case(name.as_bytes());
    table.iter().find(is_word).map(|&(_, found)| found)
}

/// Tells whether the bytes begin like a geometry.
pub(crate) fn sniff(head: &[u8]) -> bool {
    let mut text = Text::new(scan::without_mark(head), &());
    match text.next() {
        Ok(Token::Word(word)) => {
            kind(word).is_some() || is_curve(word) || word.eq_ignore_ascii_case(b"SRID")
        }
        Ok(Token::Number(word)) => wkb::is_hex(word),
        Ok(Token::Sign(b'\\')) => {
            matches!(text.next(), Ok(Token::Word(word)) if bytea(word).is_some())
        }
        _ => false,
    }
}

/// Reads a domain.
pub(crate) fn read_domain(
    file: &str,
    bytes: &[u8],
    watch: &dyn Watch,
) -> Result<DomainData, Error> {
    let malformed = |place, problem| Error::Malformed {
        file: file.to_owned(),
        place,
        problem,
    };
    let bytes = scan::without_mark(bytes);
    let mut reader = Reader {
        text: Text::new(bytes, watch),
        shapes: Shapes::default(),
        positions: 0,
        watch,
    };
    match reader.read_all() {
        Ok(0) => Err(malformed(Place::File, Problem::Empty)),
        Ok(_) => Ok(reader.shapes.finish()),
        Err(Stop::Cancelled) => Err(Error::Cancelled),
        Err(Stop::Problem(problem)) => {
            Err(malformed(Place::in_text(bytes, reader.text.start), problem))
        }
    }
}

/// Reads geometries, each by its grammar.
struct Reader<'a> {
    text: Text<'a>,
    shapes: Shapes,
    /// Positions read so far, for messages.
    positions: u64,
    watch: &'a dyn Watch,
}

impl<'a> Reader<'a> {
    /// Reads all geometries and counts them.
    fn read_all(&mut self) -> Result<usize, Stop> {
        let mut count = 0;
        loop {
            match self.text.next()? {
                Token::End => return Ok(count),
                Token::Sign(b';') => continue,
                Token::Word(word) if word.eq_ignore_ascii_case(b"SRID") => self.srid()?,
                Token::Number(digits) if wkb::is_hex(digits) => {
                    self.binary(digits)?;
                    count += 1;
                }
                Token::Sign(b'\\') => {
                    let token = self.text.next()?;
                    let Token::Word(word) = token else {
                        return Err(self.unexpected("x and hexadecimal digits", token));
                    };
                    let digits = bytea(word)
                        .ok_or_else(|| self.unexpected("x and hexadecimal digits", token))?;
                    self.binary(digits)?;
                    count += 1;
                }
                _ => {
                    self.text.back();
                    self.geometry(0)?;
                    self.shapes.end_feature(None);
                    count += 1;
                }
            }
        }
    }

    /// Skips the rest of `SRID=4326;`.
    fn srid(&mut self) -> Result<(), Stop> {
        self.expect(b'=')?;
        match self.text.next()? {
            Token::Number(_) => self.expect(b';'),
            token => Err(self.unexpected("a number", token)),
        }
    }

    /// Reads a geometry that is written in hexadecimal digits.
    fn binary(&mut self, digits: &[u8]) -> Result<(), Stop> {
        let other = |text: String| Stop::Problem(Problem::Other(text));
        let bytes = wkb::from_hex(digits)
            .ok_or_else(|| other("an odd number of hexadecimal digits".to_owned()))?;
        match wkb::read(&bytes, &mut self.shapes, self.watch) {
            Ok(()) => {
                self.shapes.end_feature(None);
                Ok(())
            }
            Err(wkb::Stop::Cancelled) => Err(Stop::Cancelled),
            Err(wkb::Stop::Problem(at, problem)) => {
                Err(other(format!("byte {at} of the geometry: {problem}")))
            }
        }
    }

    fn geometry(&mut self, depth: usize) -> Result<(), Stop> {
        let token = self.text.next()?;
        let Token::Word(word) = token else {
            return Err(self.unexpected("a geometry", token));
        };
        if is_curve(word) {
            let text = format!(
                "{:?}: curves are not read; replace them by lines, as ST_CurveToLine does",
                scan::show(word)
            );
            return Err(Problem::Other(text).into());
        }
        let Some((kind, mut tag)) = kind(word) else {
            let known = KINDS.map(|(name, _)| name).join(", ");
            let text = format!(
                "{:?} is not understood; known are {known}",
                scan::show(word)
            );
            return Err(Problem::Other(text).into());
        };
        if tag == Tag::Open {
            tag = self.tag()?;
        }
        match kind {
            Kind::Point => self.point(tag),
            Kind::MultiPoint => self.parts(|reader| reader.point_of_many(tag)),
            Kind::Line => self.line(tag),
            Kind::MultiLine => self.parts(|reader| reader.line(tag)),
            Kind::Polygon => self.polygon(tag),
            Kind::MultiPolygon => self.parts(|reader| reader.polygon(tag)),
            Kind::Collection if depth == MAX_DEPTH => {
                let text = format!("collections within collections, deeper than {MAX_DEPTH}");
                Err(Problem::Other(text).into())
            }
            Kind::Collection => self.parts(|reader| reader.geometry(depth + 1)),
        }
    }

    /// Reads a tag that stands alone, if there is one.
    fn tag(&mut self) -> Result<Tag, Stop> {
        if let Token::Word(word) = self.text.next()?
            && let Some(tag) = find(&TAGS, word)
        {
            return Ok(tag);
        }
        self.text.back();
        Ok(Tag::Open)
    }

    /// Reads `EMPTY`, or parts in brackets with commas between them.
    fn parts(&mut self, mut part: impl FnMut(&mut Self) -> Result<(), Stop>) -> Result<(), Stop> {
        match self.text.next()? {
            Token::Word(word) if word.eq_ignore_ascii_case(b"EMPTY") => return Ok(()),
            Token::Sign(b'(') => {}
            token => return Err(self.unexpected("'(' or EMPTY", token)),
        }
        loop {
            part(self)?;
            match self.text.next()? {
                Token::Sign(b',') => {}
                Token::Sign(b')') => return Ok(()),
                token => return Err(self.unexpected("',' or ')'", token)),
            }
        }
    }

    /// Reads a point of many, which may or may not stand in brackets.
    fn point_of_many(&mut self, tag: Tag) -> Result<(), Stop> {
        let token = self.text.next()?;
        self.text.back();
        if let Token::Number(_) = token {
            let position = self.position(tag)?;
            return Ok(self.shapes.point(position)?);
        }
        self.point(tag)
    }

    fn point(&mut self, tag: Tag) -> Result<(), Stop> {
        match *self.positions(tag)? {
            [] => Ok(()),
            [position] => Ok(self.shapes.point(position)?),
            ref several => {
                let text = format!("a point of {} positions", several.len());
                Err(Problem::Other(text).into())
            }
        }
    }

    fn line(&mut self, tag: Tag) -> Result<(), Stop> {
        let positions = self.positions(tag)?;
        Ok(self.shapes.line(&positions)?)
    }

    fn polygon(&mut self, tag: Tag) -> Result<(), Stop> {
        let mut rings = Vec::new();
        self.parts(|reader| {
            rings.push(reader.positions(tag)?);
            Ok(())
        })?;
        Ok(self.shapes.polygon(rings.iter().map(Vec::as_slice))?)
    }

    fn positions(&mut self, tag: Tag) -> Result<Vec<Position>, Stop> {
        let mut positions = Vec::new();
        self.parts(|reader| {
            positions.push(reader.position(tag)?);
            Ok(())
        })?;
        Ok(positions)
    }

    fn position(&mut self, tag: Tag) -> Result<Position, Stop> {
        let point = Point::new(self.coordinate('x')?, self.coordinate('y')?);
        self.positions += 1;
        let (mut numbers, mut count) = ([f64::NAN; 2], 0);
        while let Token::Number(word) = self.text.next()? {
            let number = scan::number(word).ok_or_else(|| Problem::NotANumber {
                what: "coordinate".to_owned(),
                text: scan::show(word),
            })?;
            if let Some(place) = numbers.get_mut(count) {
                *place = number;
            }
            count += 1;
        }
        self.text.back();
        let extras = numbers.get(..count).and_then(|n| tag.extras(n));
        let extras = extras.ok_or_else(|| {
            let found = count + 2;
            Problem::Other(format!(
                "a position of {found} numbers, which its tag does not allow"
            ))
        })?;
        Ok(Position { point, extras })
    }

    fn coordinate(&mut self, axis: char) -> Result<f64, Stop> {
        match self.text.next()? {
            Token::Number(word) | Token::Word(word) => {
                Ok(scan::coordinate(word, axis, self.positions)?)
            }
            token => Err(self.unexpected("a number", token)),
        }
    }

    fn expect(&mut self, sign: u8) -> Result<(), Stop> {
        match self.text.next()? {
            Token::Sign(found) if found == sign => Ok(()),
            token => Err(self.unexpected(&format!("{:?}", char::from(sign)), token)),
        }
    }

    fn unexpected(&self, expected: &str, token: Token<'a>) -> Stop {
        let text = format!("expected {expected}, found {}", token.show());
        Stop::Problem(Problem::Other(text))
    }
}
