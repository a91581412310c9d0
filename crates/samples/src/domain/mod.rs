//! Domains as data: points and segments between them.
//!
//! Three are clean and come in any size, for benchmarks: scattered segments, a coast, a spiral. Their
//! segments meet at common ends only, by construction. The others cross, for tests and for the
//! benchmark of splitting.
//!
//! All coordinates but the lattice's are multiples of 2⁻⁵³ in the unit square: whatever the tests
//! here claim of a drawing they decide in 128-bit integers.

mod coast;
mod exact;
mod lattice;
mod scatter;
mod spiral;

use crate::{Random, UnknownName, names};
use std::fmt;
use std::str::FromStr;

/// What is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Domain {
    /// Short segments scattered in the unit square; none touches another.
    Segments,
    /// A closed fractal coast line, its vertices in ring order: bays in bays.
    Coast,
    /// A closed band wound up as a spiral: long, nearly parallel runs side by side, each edge twice
    /// as long as the gap to its neighbours, so the points alone would be joined across.
    Spiral,
    /// Segments between random points of the unit square: about 0.115 n² crossings.
    CrossingSegments,
    /// Segments of a few mean spacings: about 5 n crossings.
    Tangle,
    /// Segments between points of an integer lattice: shared ends, overlaps, T-junctions, crossings
    /// in vertices and beside them.
    LatticeLines,
}

/// Points, and segments between them.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Drawing {
    /// The points, ends of segments and loose ones alike.
    pub points: Vec<[f64; 2]>,
    /// The two ends of each segment, as indices of points.
    pub segments: Vec<[u32; 2]>,
}

impl Domain {
    /// All domains, in the order of the table.
    pub const ALL: [Self; 6] = [
        Self::Segments,
        Self::Coast,
        Self::Spiral,
        Self::CrossingSegments,
        Self::Tangle,
        Self::LatticeLines,
    ];

    /// Returns the name by which commands and tables call it.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Segments => "segments",
            Self::Coast => "coast",
            Self::Spiral => "spiral",
            Self::CrossingSegments => "crossing-segments",
            Self::Tangle => "tangle",
            Self::LatticeLines => "lattice-lines",
        }
    }

    /// Says in a few words what it is and why it is there.
    pub const fn about(self) -> &'static str {
        match self {
            Self::Segments => "short segments scattered in the unit square, none touches another",
            Self::Coast => "a closed fractal coast line: bays in bays",
            Self::Spiral => "a closed band wound up as a spiral: long parallel runs",
            Self::CrossingSegments => "segments across the unit square, about 0.115 n² crossings",
            Self::Tangle => "segments of a few mean spacings, about 5 n crossings",
            Self::LatticeLines => {
                "segments on an integer lattice: overlaps, T-junctions, crossings"
            }
        }
    }

    /// Tells whether the segments form one closed ring, in order.
    pub const fn is_ring(self) -> bool {
        matches!(self, Self::Coast | Self::Spiral)
    }

    /// Tells whether segments cross in points that are no vertices.
    pub const fn crosses(self) -> bool {
        matches!(
            self,
            Self::CrossingSegments | Self::Tangle | Self::LatticeLines
        )
    }

    /// Draws `count` segments, the same ones for the same `seed` on every machine. A ring of fewer
    /// than three segments is empty.
    ///
    /// # Panics
    /// If there would be more points than 32 bits can number.
    pub fn draw(self, count: usize, seed: u64) -> Drawing {
        let mut random = Random::named(self.name(), seed);
        match self {
            Self::Segments => scatter::apart(count, &mut random),
            Self::Coast => ring(count, |count| coast::vertices(count, &mut random)),
            Self::Spiral => ring(count, |count| spiral::vertices(count, &mut random)),
            Self::CrossingSegments => scatter::across(count, &mut random),
            Self::Tangle => scatter::tangled(count, &mut random),
            Self::LatticeLines => lattice::lines(count, &mut random),
        }
    }
}

impl fmt::Display for Domain {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}

impl FromStr for Domain {
    type Err = UnknownName;

    fn from_str(name: &str) -> Result<Self, Self::Err> {
        names::find("domain", &Self::ALL, Self::name, name)
    }
}

/// Joins `count` vertices, each to the next and the last to the first.
fn ring(count: usize, vertices: impl FnOnce(usize) -> Vec<[f64; 2]>) -> Drawing {
    if count < 3 {
        return Drawing::default();
    }
    let points: Vec<_> = vertices(count)
        .into_iter()
        .map(|p| p.map(exact::snap))
        .collect();
    let last = index(points.len() - 1);
    let segments = (0..last).map(|i| [i, i + 1]).chain([[last, 0]]).collect();
    Drawing { points, segments }
}

/// Joins each of `segments`' own two ends.
fn loose(segments: Vec<[[f64; 2]; 2]>) -> Drawing {
    let ends = |i| [index(2 * i), index(2 * i + 1)];
    Drawing {
        segments: (0..segments.len()).map(ends).collect(),
        points: segments.into_flattened(),
    }
}

fn index(i: usize) -> u32 {
    u32::try_from(i).expect("points are numbered by 32 bits")
}

#[cfg(test)]
mod tests {
    use super::{Domain, Drawing, exact};
    use std::collections::HashSet;

    fn ends(drawing: &Drawing) -> Vec<[[f64; 2]; 2]> {
        let point = |v: u32| drawing.points[v as usize];
        drawing.segments.iter().map(|s| s.map(point)).collect()
    }

    /// Counts the pairs of segments that have a point in common but no end.
    fn meetings(drawing: &Drawing) -> usize {
        let ends = ends(drawing);
        let meet = |&(i, j): &(usize, usize)| {
            let apart = drawing.segments[i]
                .iter()
                .all(|v| !drawing.segments[j].contains(v));
            apart && exact::meet(ends[i], ends[j])
        };
        (0..ends.len())
            .flat_map(|j| (0..j).map(move |i| (i, j)))
            .filter(meet)
            .count()
    }

    #[test]
    fn every_domain_has_the_number_of_segments_asked_for_between_its_own_points() {
        for domain in Domain::ALL {
            for count in [3, 4, 5, 10, 99, 100, 101, 2000] {
                let drawing = domain.draw(count, 1);
                assert_eq!(drawing.segments.len(), count, "{domain}");
                let points = drawing.points.len() as u32;
                let ends = drawing.segments.as_flattened();
                assert!(ends.iter().all(|&v| v < points), "{domain}");
                assert!(drawing.segments.iter().all(|[a, b]| a != b), "{domain}");
                let bits: HashSet<_> = drawing.points.iter().map(|p| p.map(f64::to_bits)).collect();
                assert_eq!(bits.len(), drawing.points.len(), "{domain}");
            }
        }
    }

    #[test]
    fn the_seed_fixes_the_drawing_and_another_seed_changes_it() {
        for domain in Domain::ALL {
            let drawing = domain.draw(300, 1);
            assert_eq!(drawing, domain.draw(300, 1), "{domain}");
            assert_ne!(drawing, domain.draw(300, 2), "{domain}");
            for few in 0..3 {
                let expected = if domain.is_ring() { 0 } else { few };
                assert_eq!(domain.draw(few, 1).segments.len(), expected, "{domain}");
            }
        }
    }

    #[test]
    fn coordinates_are_exact_in_128_bits() {
        for domain in Domain::ALL
            .into_iter()
            .filter(|&d| d != Domain::LatticeLines)
        {
            let drawing = domain.draw(1000, 3);
            let coordinates = drawing.points.as_flattened();
            assert!(
                coordinates
                    .iter()
                    .all(|&c| (0.0..1.0).contains(&c) && exact::snap(c) == c),
                "{domain}"
            );
        }
    }

    #[test]
    fn clean_domains_meet_at_common_ends_only_and_the_others_elsewhere_too() {
        for domain in Domain::ALL {
            for (count, seed) in [(17, 2), (40, 3), (400, 4), (1500, 5)] {
                let meetings = meetings(&domain.draw(count, seed));
                let expected = domain.crosses();
                assert_eq!(meetings > 0, expected, "{domain} {count}: {meetings}");
            }
        }
    }

    #[test]
    fn crossings_are_as_many_as_described() {
        let across = meetings(&Domain::CrossingSegments.draw(1000, 6));
        assert!((100_000..130_000).contains(&across), "{across}");
        let tangled = meetings(&Domain::Tangle.draw(3000, 6));
        assert!((12_000..18_000).contains(&tangled), "{tangled}");
    }

    #[test]
    fn rings_run_in_order_and_counter_clockwise() {
        for domain in Domain::ALL.into_iter().filter(|d| d.is_ring()) {
            let drawing = domain.draw(500, 8);
            let next = |i: u32| [i, (i + 1) % 500];
            assert!(drawing.segments.iter().copied().eq((0..500).map(next)));
            let twice_area: f64 = ends(&drawing)
                .iter()
                .map(|[a, b]| a[0] * b[1] - a[1] * b[0])
                .sum();
            assert!(twice_area > 0.1, "{domain}: {twice_area}");
        }
    }

    #[test]
    fn names_parse_back() {
        for domain in Domain::ALL {
            assert_eq!(domain.name().parse(), Ok(domain));
        }
        let error = "cost".parse::<Domain>().unwrap_err().to_string();
        assert!(error.contains("`cost`") && error.contains("coast"));
    }
}
