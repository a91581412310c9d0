//! Point sets and domains as data: a name, a number and a seed fix every bit of every coordinate.
//!
//! The points of a [`Distribution`] come in random order, so no builder profits from the order they
//! were made in; a [`Domain`] has segments as well. What each one is there for stands at its variant. Line and Kuzmin follow Blelloch, Miller,
//! Hardwick, Talmor, *Design and implementation of a practical parallel Delaunay algorithm*,
//! Algorithmica 24 (1999).
//!
//! *Cost*: 5–60 ns a point; one allocation, of the points themselves. Domains cost up to 1 µs
//! a segment.

mod domain;
mod names;
mod random;
mod scene;

pub use domain::{Domain, Drawing};
pub use names::UnknownName;
pub use random::Random;
pub use scene::{Scene, Sheet};
use std::fmt;
use std::str::FromStr;

/// How the points are spread.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Distribution {
    /// Uniform in the unit square: what everyone measures.
    Uniform,
    /// Normal about the origin: density falls off smoothly, the hull is small.
    Gauss,
    /// Kuzmin's disk: density grows without bound towards the centre; starves fixed-width keys.
    Kuzmin,
    /// A line singularity: most points crowd along a vertical line.
    Line,
    /// Integer lattice of about √n by √n points, shuffled: every in-circle test is zero.
    Grid,
    /// The lattice rotated by 0.3: every in-circle test is nearly zero, with rounding noise.
    TiltedGrid,
    /// The lattice with spacing 0.1, rounded to the nearest `f64` as a parser would.
    DecimalGrid,
    /// On the unit circle: all points lie on the hull, all in-circle tests are nearly zero.
    Circle,
    /// Longitude and latitude in degrees, six decimals, clustered around random cities.
    LonLat,
    /// Uniform single-precision coordinates; a quarter of the points repeat an earlier one.
    F32Duplicates,
}

impl Distribution {
    /// All distributions, in the order of the table.
    pub const ALL: [Self; 10] = [
        Self::Uniform,
        Self::Gauss,
        Self::Kuzmin,
        Self::Line,
        Self::Grid,
        Self::TiltedGrid,
        Self::DecimalGrid,
        Self::Circle,
        Self::LonLat,
        Self::F32Duplicates,
    ];

    /// Returns the name by which commands and tables call it.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Uniform => "uniform",
            Self::Gauss => "gauss",
            Self::Kuzmin => "kuzmin",
            Self::Line => "line",
            Self::Grid => "grid",
            Self::TiltedGrid => "tilted-grid",
            Self::DecimalGrid => "decimal-grid",
            Self::Circle => "circle",
            Self::LonLat => "lonlat",
            Self::F32Duplicates => "f32-duplicates",
        }
    }

    /// Says in a few words what it is and why it is there.
    pub const fn about(self) -> &'static str {
        match self {
            Self::Uniform => "uniform in the unit square",
            Self::Gauss => "normal about the origin, standard deviation 1",
            Self::Kuzmin => "Kuzmin's disk: as dense at its centre as one likes, far outliers",
            Self::Line => "crowded along a vertical line",
            Self::Grid => "square integer lattice, shuffled: all is cocircular",
            Self::TiltedGrid => "square lattice, rotated: all is nearly cocircular",
            Self::DecimalGrid => "square lattice of spacing 0.1, as a parser rounds it",
            Self::Circle => "on the unit circle: all points lie on the hull",
            Self::LonLat => "around cities, degrees of longitude and latitude, six decimals",
            Self::F32Duplicates => "uniform in single precision, a quarter of them duplicates",
        }
    }

    /// Makes `count` points, the same ones for the same `seed` on every machine.
    pub fn points(self, count: usize, seed: u64) -> Vec<[f64; 2]> {
        let mut random = Random::named(self.name(), seed);
        match self {
            Self::Uniform => draw(count, || [random.unit(), random.unit()]),
            Self::Gauss => draw(count, || random.normal_pair()),
            Self::Kuzmin => draw(count, || kuzmin(&mut random)),
            Self::Line => draw(count, || line_singularity(&mut random)),
            Self::Grid => lattice(count, &mut random, |x, y| [x, y]),
            Self::TiltedGrid => {
                let (sin, cos) = libm::sincos(0.3);
                lattice(count, &mut random, |x, y| {
                    [cos * x - sin * y, sin * x + cos * y]
                })
            }
            Self::DecimalGrid => lattice(count, &mut random, |x, y| [x / 10.0, y / 10.0]),
            Self::Circle => draw(count, || random.on_circle(1.0)),
            Self::LonLat => cities(count, &mut random),
            Self::F32Duplicates => f32_duplicates(count, &mut random),
        }
    }
}

impl fmt::Display for Distribution {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}

impl FromStr for Distribution {
    type Err = UnknownName;

    fn from_str(name: &str) -> Result<Self, Self::Err> {
        names::find("distribution", &Self::ALL, Self::name, name)
    }
}

fn draw(count: usize, mut point: impl FnMut() -> [f64; 2]) -> Vec<[f64; 2]> {
    (0..count).map(|_| point()).collect()
}

/// Inverts Kuzmin's distribution of radii, M(r) = 1 − 1/√(1 + r²).
fn kuzmin(random: &mut Random) -> [f64; 2] {
    let beyond = 1.0 - random.unit();
    let radius = (1.0 / (beyond * beyond) - 1.0).sqrt();
    random.on_circle(radius)
}

/// Maps the unit square by x = b/(u − bu + b), y = v with b = 0.001.
fn line_singularity(random: &mut Random) -> [f64; 2] {
    const B: f64 = 0.001;
    let u = random.unit();
    [B / (u - B * u + B), random.unit()]
}

/// Takes the first `count` places of the smallest square lattice that has so many, shuffled.
fn lattice(
    count: usize,
    random: &mut Random,
    place: impl Fn(f64, f64) -> [f64; 2],
) -> Vec<[f64; 2]> {
    let side = count.saturating_sub(1).isqrt() + 1;
    let mut points: Vec<_> = (0..count)
        .map(|i| place((i % side) as f64, (i / side) as f64))
        .collect();
    random.shuffle(&mut points);
    points
}

/// A cluster of places.
struct City {
    center: [f64; 2],
    /// Standard deviation, degrees.
    spread: f64,
}

impl City {
    fn found(random: &mut Random) -> Self {
        Self {
            center: [random.between(-170.0, 170.0), random.between(-55.0, 70.0)],
            // Between a village of 0.003° and a region of 0.3°.
            spread: 0.3 * libm::pow(0.01, random.unit()),
        }
    }

    fn place(&self, random: &mut Random) -> [f64; 2] {
        let offset = random.normal_pair();
        [0, 1].map(|k| {
            let degrees = self.center[k] + self.spread * offset[k];
            (degrees * 1e6).round() / 1e6
        })
    }
}

fn cities(count: usize, random: &mut Random) -> Vec<[f64; 2]> {
    let number = (count / 500).clamp(8, 2000);
    let cities: Vec<City> = (0..number).map(|_| City::found(random)).collect();
    draw(count, || {
        // The square makes the first cities the larger ones.
        let rank = random.unit() * random.unit() * number as f64;
        cities[rank as usize].place(random)
    })
}

fn f32_duplicates(count: usize, random: &mut Random) -> Vec<[f64; 2]> {
    let mut points = Vec::with_capacity(count);
    for known in 0..count {
        points.push(if known > 0 && random.below(4) == 0 {
            points[random.below(known)]
        } else {
            [0, 1].map(|_| f64::from(random.unit() as f32))
        });
    }
    points
}

#[cfg(test)]
mod tests {
    use super::Distribution;
    use std::collections::HashSet;

    fn distinct(points: &[[f64; 2]]) -> usize {
        let bits: HashSet<_> = points.iter().map(|p| p.map(f64::to_bits)).collect();
        bits.len()
    }

    #[test]
    fn every_distribution_gives_the_count_asked_for_all_finite() {
        for distribution in Distribution::ALL {
            for count in [0, 1, 2, 3, 10, 99, 100, 101, 5000] {
                let points = distribution.points(count, 1);
                assert_eq!(points.len(), count, "{distribution}");
                assert_eq!(points.capacity(), count, "{distribution} over-allocates");
                assert!(points.iter().flatten().all(|c| c.is_finite()));
            }
        }
    }

    #[test]
    fn the_seed_fixes_the_points_and_another_seed_changes_them() {
        for distribution in Distribution::ALL {
            let points = distribution.points(500, 1);
            assert_eq!(points, distribution.points(500, 1), "{distribution}");
            assert_ne!(points, distribution.points(500, 2), "{distribution}");
        }
    }

    #[test]
    fn names_parse_back() {
        for distribution in Distribution::ALL {
            assert_eq!(distribution.name().parse(), Ok(distribution));
        }
        let error = "unifrom".parse::<Distribution>().unwrap_err().to_string();
        assert!(error.contains("unifrom") && error.contains("lonlat"));
    }

    #[test]
    fn lattices_are_lattices() {
        let points = Distribution::Grid.points(10_000, 4);
        assert_eq!(distinct(&points), 10_000);
        assert!(
            points
                .iter()
                .flatten()
                .all(|&c| c.fract() == 0.0 && c < 100.0)
        );
        let tenths = Distribution::DecimalGrid.points(10_000, 4);
        assert!(tenths.contains(&[0.3, 0.7]) && !tenths.contains(&[0.1 + 0.2, 0.7]));
    }

    #[test]
    fn shapes_are_as_described() {
        let on_circle = Distribution::Circle.points(1000, 5);
        assert!(
            on_circle
                .iter()
                .all(|[x, y]| (x.hypot(*y) - 1.0).abs() < 1e-15)
        );
        let lonlat = Distribution::LonLat.points(1000, 5);
        assert!(
            lonlat
                .iter()
                .all(|[x, y]| x.abs() <= 180.0 && y.abs() <= 90.0)
        );
        let line = Distribution::Line.points(1000, 5);
        assert!(line.iter().filter(|[x, _]| *x < 0.01).count() > 800);
        let kuzmin = Distribution::Kuzmin.points(1000, 5);
        let inner = kuzmin.iter().filter(|[x, y]| x.hypot(*y) < 1.0).count();
        assert!(
            (230..350).contains(&inner),
            "29 % lie within 1, not {inner}/1000"
        );
    }

    #[test]
    fn a_quarter_of_f32_points_are_duplicates() {
        let points = Distribution::F32Duplicates.points(10_000, 6);
        assert!((7_300..7_700).contains(&distinct(&points)));
        assert!(points.iter().flatten().all(|&c| f64::from(c as f32) == c));
    }
}
