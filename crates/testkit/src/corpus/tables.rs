//! Formats made of rows: points first, then segments, holes and regions by index.

use delone::{Point, Pslg, Region};

/// Tells whether a `.poly` leaves its points to the `.node` of the same name.
pub(super) fn has_points_elsewhere(text: &str) -> bool {
    numbered_rows(text)
        .next()
        .is_some_and(|header| header[0] == "0")
}

/// Reads a `.node`, a `.poly`, or the two joined.
pub(super) fn node(text: &str) -> Pslg {
    let mut rows = numbered_rows(text).peekable();
    let mut section = move || {
        if let Some([no_points, ..]) = rows.peek().and_then(|row| row.first_chunk::<4>())
            && *no_points == "0"
        {
            // The points were in the `.node`.
            rows.next();
        }
        let count = rows.next().map_or(0, |header| index(header[0]));
        rows.by_ref().take(count).collect::<Vec<_>>()
    };
    let points = section();
    let base = points.first().map_or(0, |row| index(row[0]));
    let mut pslg = Pslg::from_points(points.iter().map(|row| point(&row[1..])));
    for row in section() {
        add_edge(&mut pslg, &row[1..], base);
    }
    pslg.holes = section().iter().map(|row| point(&row[1..])).collect();
    pslg.regions = section().iter().map(|row| region(&row[1..])).collect();
    pslg
}

/// Reads JIGSAW's `.msh`.
pub(super) fn msh(text: &str) -> Pslg {
    let section = |heading: &str| {
        let mut lines = text.lines();
        let count = lines.find_map(|line| line.to_lowercase().strip_prefix(heading).map(index));
        let rows = lines.take(count.expect("a section"));
        rows.map(|line| line.split(';').collect::<Vec<_>>())
    };
    let mut pslg = Pslg::from_points(section("point=").map(|row| point(&row)));
    section("edge2=").for_each(|row| add_edge(&mut pslg, &row, 0));
    pslg
}

/// Reads CDT's text.
pub(super) fn cdt(text: &str) -> Pslg {
    let mut rows = rows(text);
    let header = rows.next().expect("a header");
    let [points, edges] = [0, 1].map(|i| index(header[i]));
    let mut pslg = Pslg::from_points(rows.by_ref().take(points).map(|row| point(&row)));
    rows.take(edges)
        .for_each(|row| add_edge(&mut pslg, &row, 0));
    pslg
}

/// Reads loose points.
pub(super) fn points(text: &str) -> Pslg {
    Pslg::from_points(rows(text).filter_map(|row| first_two(&row)))
}

/// Reads poly2tri's rings and Steiner points; all rings bound one polygon.
pub(super) fn outline(text: &str) -> Pslg {
    let mut pslg = Pslg::default();
    let mut is_ring = true;
    let mut ring = Vec::new();
    for row in rows(text) {
        match first_two(&row) {
            Some(p) if is_ring => ring.push(p),
            Some(p) => pslg.points.push(p),
            None => {
                add_ring(&mut pslg, &std::mem::take(&mut ring));
                is_ring = row[0] == "HOLE";
            }
        }
    }
    add_ring(&mut pslg, &ring);
    close_polygon(&mut pslg, 0);
    pslg
}

/// Reads the outline of an airfoil.
pub(super) fn airfoil(text: &str) -> Pslg {
    let pairs = rows(text).filter(|row| row.len() == 2);
    let ring: Vec<_> = pairs.filter_map(|row| first_two(&row)).collect();
    let mut pslg = Pslg::default();
    add_ring(&mut pslg, &ring);
    close_polygon(&mut pslg, 0);
    pslg
}

/// Reads a LAS point cloud.
pub(super) fn las(bytes: &[u8]) -> Pslg {
    let u32_at = |at: usize| u32::from_le_bytes(bytes[at..at + 4].try_into().unwrap());
    let f64_at = |at: usize| f64::from_le_bytes(bytes[at..at + 8].try_into().unwrap());
    assert_eq!(&bytes[..4], b"LASF");
    let first = u32_at(96) as usize;
    let length = usize::from(u16::from_le_bytes([bytes[105], bytes[106]]));
    let (scale, offset) = ([131, 139].map(f64_at), [155, 163].map(f64_at));
    let coordinate = |record: usize, axis: usize| {
        let raw = u32_at(record + 4 * axis).cast_signed();
        f64::from(raw) * scale[axis] + offset[axis]
    };
    let records = (0..u32_at(107) as usize).map(|i| first + i * length);
    Pslg::from_points(records.map(|r| Point::new(coordinate(r, 0), coordinate(r, 1))))
}

/// Reads the points of test cases of predicates.
pub(super) fn cases(text: &str) -> Pslg {
    let coordinates = |row: &Vec<&str>| row[1..row.len() - 1].iter().map(|f| number(f)).collect();
    let cases = rows(text).map(|row| coordinates(&row));
    let pairs = |case: Vec<f64>| case.as_chunks::<2>().0.to_vec();
    Pslg::from_points(cases.flat_map(pairs))
}

/// Adds new points and the closed ring that they form; a last point equal to the first is kept.
/// Fewer than three points bound nothing, and stay loose.
pub(super) fn add_ring(pslg: &mut Pslg, ring: &[Point]) {
    let first = pslg.points.len();
    pslg.points.extend(ring);
    let indices = first as u32..pslg.points.len() as u32;
    if ring.len() < 3 {
        return;
    }
    if ring.first() == ring.last() {
        pslg.add_polyline(indices);
    } else {
        pslg.add_ring(indices);
    }
}

/// Makes a polygon of all segments from `first` on.
pub(super) fn close_polygon(pslg: &mut Pslg, first: usize) {
    if first < pslg.segments.len() {
        pslg.polygons.push(first..pslg.segments.len());
    }
}

fn region(row: &[&str]) -> Region {
    Region {
        at: point(row),
        attribute: number(row[2]),
        max_area: row.get(3).map(|field| number(field)),
    }
}

fn add_edge(pslg: &mut Pslg, row: &[&str], base: usize) {
    let [a, b] = [0, 1].map(|i| (index(row[i]) - base) as u32);
    pslg.add_segment(a, b);
}

fn numbered_rows(text: &str) -> impl Iterator<Item = Vec<&str>> {
    let lines = text.lines();
    let lines = lines.map(|line| line.split('#').next().unwrap_or(""));
    lines.map(fields).filter(|row| !row.is_empty())
}

fn rows(text: &str) -> impl Iterator<Item = Vec<&str>> {
    text.lines().map(fields).filter(|row| !row.is_empty())
}

/// Splits at white space and commas.
pub(super) fn fields(line: &str) -> Vec<&str> {
    let separators = |c: char| c.is_whitespace() || c == ',';
    line.split(separators).filter(|f| !f.is_empty()).collect()
}

/// Reads a point if the row begins with two numbers.
pub(super) fn first_two(row: &[&str]) -> Option<Point> {
    let [x, y] = row.first_chunk()?;
    Some(Point::new(x.parse().ok()?, y.parse().ok()?))
}

fn point(row: &[&str]) -> Point {
    Point::new(number(row[0]), number(row[1]))
}

fn number(field: &str) -> f64 {
    let number = field.trim().parse();
    number.unwrap_or_else(|_| panic!("{field:?} is no number"))
}

fn index(field: &str) -> usize {
    let index = field.trim().parse();
    index.unwrap_or_else(|_| panic!("{field:?} is no index"))
}
