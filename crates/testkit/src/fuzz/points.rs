//! Small point sets, triangulated by both builders, and compared with each other and with the
//! definition.

use super::{Case, array, guarded, without_one};
use crate::generate::{Kind, Random};
use crate::naive::{naive_delaunay, sorted_triangles};
use delone::delaunay::Incremental;
use delone::{Delaunay, Error, Point, Triangulation};

/// With what a result is compared.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Depth {
    /// Its topology is validated.
    Topology,
    /// Also, the incremental builder must agree, in an order drawn from this seed.
    Incremental(u64),
    /// Also, the definition must agree; O(n⁴).
    Naive(u64),
}

/// Fills `points` with the case that `seed` names, of at least one point and at most `max_points`:
/// mostly small integer lattices, now and then something worse.
pub fn case(seed: u64, max_points: usize, points: &mut Vec<Point>) {
    let mut random = Random::new(seed);
    let n = 1 + random.below(max_points);
    kind(&mut random).fill(points, n, &mut random);
}

/// Draws a kind. Exponents outside the ordinary class make arithmetic slow, so those are rare.
pub(super) fn kind(random: &mut Random) -> Kind {
    let side = 3 + random.below(6) as u32;
    match random.below(64) {
        0..48 => Kind::Lattice { side },
        48..52 => Kind::UlpLattice,
        52..54 => Kind::CocircularRings,
        54..56 => Kind::Cross,
        56..58 => Kind::WideExponents,
        58..60 => Kind::Circle,
        60 => Kind::Collinear,
        61 => Kind::Borders,
        62 => Kind::ScaledLattice,
        _ => Kind::RawBits,
    }
}

/// Reads points from a fuzzer's bytes: the first says how the others are to be read.
///
/// A byte a coordinate on a lattice of 2 to 16 points a side, eight bytes a coordinate as raw bits
/// (NaN and infinities too), or a byte a coordinate whose high half is a lattice coordinate and
/// whose low half moves it in the last place.
pub fn points_from_bytes(bytes: &[u8]) -> Vec<Point> {
    let Some((&mode, rest)) = bytes.split_first() else {
        return Vec::new();
    };
    let rest = &rest[..rest.len().min(MAX_BYTES)];
    let from_pairs = |coordinate: &dyn Fn(u8) -> f64| {
        let pairs = rest.chunks_exact(2);
        pairs
            .map(|pair| Point::new(coordinate(pair[0]), coordinate(pair[1])))
            .collect()
    };
    match mode % 3 {
        0 => {
            let side = 2 + mode / 3 % 15;
            from_pairs(&|byte| f64::from(byte % side))
        }
        1 => from_pairs(&|byte| {
            let place = f64::from(1 + (byte >> 4));
            f64::from_bits(place.to_bits() + u64::from(byte & 15))
        }),
        _ => rest.chunks_exact(16).map(point_from_bits).collect(),
    }
}

/// The most bytes that [`points_from_bytes`] reads as coordinates.
const MAX_BYTES: usize = 1024;

fn point_from_bits(bytes: &[u8]) -> Point {
    let (x, y) = bytes.split_at(8);
    let coordinate = |b: &[u8]| f64::from_le_bytes(b.try_into().expect("eight bytes"));
    Point::new(coordinate(x), coordinate(y))
}

/// Triangulates `points` and checks the result to the given depth; a panic is a failure too.
///
/// # Errors
/// What went wrong.
pub fn check(points: &[Point], depth: Depth) -> Result<(), String> {
    guarded(|| check_result(points, depth))
}

fn check_result(points: &[Point], depth: Depth) -> Result<(), String> {
    let t = match Delaunay::new()
        .threads(1)
        .triangulate(points.iter().copied())
    {
        Err(Error::NotFinite { index, .. }) if !points[index].is_finite() => return Ok(()),
        result => result.map_err(|error| error.to_string())?,
    };
    t.mesh().validate().map_err(|error| error.to_string())?;
    let (Depth::Incremental(seed) | Depth::Naive(seed)) = depth else {
        return Ok(());
    };
    compare_incremental(&t, points, seed)?;
    match depth {
        Depth::Naive(_) if sorted_triangles(&t) != naive_delaunay(points) => {
            Err("the definition yields other triangles".to_owned())
        }
        _ => Ok(()),
    }
}

fn compare_incremental(t: &Triangulation, points: &[Point], seed: u64) -> Result<(), String> {
    let order = Random::new(seed).permutation(points.len());
    let other = Incremental::triangulate_in_order(points, &order);
    let other = other.map_err(|error| error.to_string())?;
    other
        .mesh()
        .validate()
        .map_err(|error| format!("incremental: {error}"))?;
    let counts = |t: &Triangulation| (t.num_triangles(), t.mesh().num_faces());
    if t.duplicates() != other.duplicates() {
        Err(format!(
            "incremental merges other duplicates, inserting in order {order:?}"
        ))
    } else if counts(t) != counts(&other) || t.hash() != other.hash() {
        Err(format!(
            "incremental yields other triangles, inserting in order {order:?}"
        ))
    } else {
        Ok(())
    }
}

impl Case for Vec<Point> {
    fn smaller(&self) -> Vec<Self> {
        without_one(self).collect()
    }

    fn as_source(&self) -> String {
        format!("let points = {};", array(self))
    }
}

#[cfg(test)]
mod tests {
    use super::super::shrink;
    use super::*;

    #[test]
    fn cases_are_named_by_their_seeds_and_pass() {
        let (mut points, mut again) = (Vec::new(), Vec::new());
        for seed in 0..500 {
            case(seed, 14, &mut points);
            case(seed, 14, &mut again);
            assert_eq!(points, again);
            assert!((1..=14).contains(&points.len()));
            assert_eq!(check(&points, Depth::Naive(seed)), Ok(()), "{points:?}");
        }
    }

    #[test]
    fn bytes_become_points_in_three_ways() {
        assert!(points_from_bytes(&[]).is_empty());
        let on_lattice = points_from_bytes(&[3 * 3, 4, 5, 6, 1, 9]);
        assert_eq!(on_lattice, [(4.0, 0.0), (1.0, 1.0)].map(Point::from));
        let nudged = points_from_bytes(&[1, 0x00, 0x31]);
        assert_eq!(nudged, [Point::new(1.0, 4.0f64.next_up())]);
        let mut raw = vec![2];
        raw.extend([1e300f64, f64::NAN].map(f64::to_le_bytes).as_flattened());
        let raw = points_from_bytes(&raw);
        assert!(raw[0].x == 1e300 && raw[0].y.is_nan());
        assert_eq!(check(&raw, Depth::Naive(0)), Ok(()));
    }

    #[test]
    fn shrinking_keeps_what_matters() {
        let points: Vec<_> = (0..10).map(|i| Point::new(f64::from(i), 0.0)).collect();
        let culprits = [points[3], points[7]];
        let fails = |left: &Vec<Point>| culprits.iter().all(|p| left.contains(p));
        assert_eq!(shrink(&points, fails), culprits);
    }

    #[test]
    fn source_is_exact() {
        let points = vec![Point::new(0.1 + 0.2, 5e-324), Point::new(-1e300, 2.0)];
        assert_eq!(
            points.as_source(),
            "let points = [\n    (0.30000000000000004, 5e-324),\n    (-1e300, 2.0),\n];"
        );
    }
}
