//! Domains as data: points and segments between them.
//!
//! Most are clean: their segments meet at common ends only, by construction. Three cross, for tests and
//! for the benchmark of splitting. Those that [enclose](Domain::encloses) an area can be meshed; each is
//! hard in another way.
//!
//! All coordinates but the lattice's are multiples of 2⁻⁵³ in the closed unit square: whatever the tests
//! here claim of a drawing they decide in 128-bit integers.

mod coast;
mod exact;
mod holes;
mod lattice;
mod rings;
mod scatter;
mod shapes;
mod spiral;

use self::coast::Character;
use self::rings::Rings;
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
    /// A coast whose segments are of unequal lengths, with bays that end in acute corners.
    Fjords,
    /// The unit square, its sides cut into equal pieces.
    Square,
    /// The unit square with round holes of 18 sides in the mean: 1000 of them with 18,004 segments.
    Holes,
    /// An airfoil in a square channel: a sharp trailing edge, vertices crowded at both ends.
    Airfoil,
    /// A gear with a hole for the shaft: many equal features.
    Gear,
    /// A star whose spikes end in acute corners, which nobody can improve.
    Star,
    /// A comb: long thin teeth, side by side.
    Comb,
    /// Rings in rings, every other one left out: thin channels.
    Rings,
    /// The joints between paving stones: narrow gaps of all widths between convex holes.
    Joints,
    /// A town of rectangular buildings, each district turned in another direction.
    Town,
}

/// Points, and segments between them.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Drawing {
    /// The points, ends of segments and loose ones alike.
    pub points: Vec<[f64; 2]>,
    /// The two ends of each segment, as indices of points.
    /// Those of an outline run with the domain on their left, all others in any direction.
    pub segments: Vec<[u32; 2]>,
    /// A point in each hole.
    pub holes: Vec<[f64; 2]>,
}

impl Drawing {
    /// Returns the area of a domain that the segments [enclose](Domain::encloses).
    pub fn area(&self) -> f64 {
        let twice = self.segments.iter().map(|ends| {
            let [[ax, ay], [bx, by]] = ends.map(|v| self.points[v as usize]);
            ax * by - ay * bx
        });
        0.5 * twice.sum::<f64>()
    }
}

impl Domain {
    /// All domains, in the order of the table.
    pub const ALL: [Self; 16] = [
        Self::Segments,
        Self::Coast,
        Self::Spiral,
        Self::CrossingSegments,
        Self::Tangle,
        Self::LatticeLines,
        Self::Fjords,
        Self::Square,
        Self::Holes,
        Self::Airfoil,
        Self::Gear,
        Self::Star,
        Self::Comb,
        Self::Rings,
        Self::Joints,
        Self::Town,
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
            Self::Fjords => "fjords",
            Self::Square => "square",
            Self::Holes => "holes",
            Self::Airfoil => "airfoil",
            Self::Gear => "gear",
            Self::Star => "star",
            Self::Comb => "comb",
            Self::Rings => "rings",
            Self::Joints => "joints",
            Self::Town => "town",
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
            Self::Fjords => "a coast of unequal segments, with bays that end in acute corners",
            Self::Square => "the unit square, its sides cut into equal pieces",
            Self::Holes => "round holes in the unit square: 1000 with 18004 segments",
            Self::Airfoil => "an airfoil in a square channel: a sharp trailing edge",
            Self::Gear => "a gear with a hole for the shaft",
            Self::Star => "a star: spikes that end in acute corners",
            Self::Comb => "a comb: long thin teeth side by side",
            Self::Rings => "rings in rings, every other one left out: thin channels",
            Self::Joints => "the joints between paving stones: narrow gaps of all widths",
            Self::Town => "rectangular buildings, turned with their districts",
        }
    }

    /// Tells whether the segments form one closed ring, in order.
    pub const fn is_ring(self) -> bool {
        matches!(
            self,
            Self::Coast | Self::Spiral | Self::Fjords | Self::Square | Self::Star | Self::Comb
        )
    }

    /// Tells whether the segments enclose an area: what lies behind an odd number of them. Carving
    /// from outside and from the drawing's holes leaves the same.
    pub const fn encloses(self) -> bool {
        !matches!(self, Self::Segments) && !self.crosses()
    }

    /// Tells whether segments cross in points that are no vertices.
    pub const fn crosses(self) -> bool {
        matches!(
            self,
            Self::CrossingSegments | Self::Tangle | Self::LatticeLines
        )
    }

    /// Draws `count` segments, the same ones for the same `seed` on every machine. What encloses an
    /// area is empty if they are fewer than three, and has no holes if they are too few.
    ///
    /// # Panics
    /// If there would be more points than 32 bits can number.
    pub fn draw(self, count: usize, seed: u64) -> Drawing {
        if self.encloses() && count < 3 {
            return Drawing::default();
        }
        let mut random = Random::named(self.name(), seed);
        match self {
            Self::Segments => scatter::apart(count, &mut random),
            Self::Coast => ring(coast::vertices(count, Character::EVEN, &mut random)),
            Self::Spiral => ring(spiral::vertices(count, &mut random)),
            Self::CrossingSegments => scatter::across(count, &mut random),
            Self::Tangle => scatter::tangled(count, &mut random),
            Self::LatticeLines => lattice::lines(count, &mut random),
            Self::Fjords => ring(coast::vertices(count, Character::UNEVEN, &mut random)),
            Self::Square => ring(rings::square(count)),
            Self::Holes => holes::round(count, &mut random),
            Self::Airfoil => shapes::airfoil(count, &mut random),
            Self::Gear => shapes::gear(count, &mut random),
            Self::Star => ring(shapes::star(count, &mut random)),
            Self::Comb => ring(shapes::comb(count, &mut random)),
            Self::Rings => shapes::nested(count, &mut random),
            Self::Joints => holes::joints(count, &mut random),
            Self::Town => holes::town(count, &mut random),
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

/// Joins vertices, each to the next and the last to the first.
fn ring(vertices: Vec<[f64; 2]>) -> Drawing {
    let mut rings = Rings::default();
    rings.add(vertices);
    rings.finish()
}

/// Joins each of `segments`' own two ends.
fn loose(segments: Vec<[[f64; 2]; 2]>) -> Drawing {
    let ends = |i| [index(2 * i), index(2 * i + 1)];
    Drawing {
        segments: (0..segments.len()).map(ends).collect(),
        points: segments.into_flattened(),
        holes: Vec::new(),
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
            let is_fixed = domain == Domain::Square;
            assert_eq!(drawing == domain.draw(300, 2), is_fixed, "{domain}");
            for few in 0..3 {
                let expected = if domain.encloses() { 0 } else { few };
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
                    .all(|&c| (0.0..=1.0).contains(&c) && exact::snap(c) == c),
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

    /// Counts the segments that the ray from a point to the right crosses.
    fn behind(drawing: &Drawing, [x, y]: [f64; 2]) -> usize {
        let crosses = |&[a, b]: &[[f64; 2]; 2]| {
            (a[1] > y) != (b[1] > y) && a[0] + (b[0] - a[0]) * (y - a[1]) / (b[1] - a[1]) > x
        };
        ends(drawing).iter().filter(|s| crosses(s)).count()
    }

    #[test]
    fn every_hole_lies_behind_an_even_number_of_rings_and_is_named_once() {
        for (domain, count, holes) in [
            (Domain::Holes, 18_004, 1000),
            (Domain::Holes, 9000, 499),
            (Domain::Airfoil, 300, 1),
            (Domain::Gear, 500, 1),
            (Domain::Rings, 5000, 12),
            (Domain::Rings, 6000, 13),
            (Domain::Joints, 1000, 249),
            (Domain::Town, 1003, 249),
        ] {
            let drawing = domain.draw(count, 4);
            assert_eq!(drawing.holes.len(), holes, "{domain}");
            for &hole in &drawing.holes {
                assert_eq!(behind(&drawing, hole) % 2, 0, "{domain}: {hole:?}");
                assert!(behind(&drawing, hole) > 0, "{domain}: {hole:?}");
            }
        }
    }

    #[test]
    fn areas_are_those_of_the_domain_without_its_holes() {
        let area = |domain: Domain, count| domain.draw(count, 5).area();
        assert_eq!(area(Domain::Square, 4), 1.0);
        assert!((area(Domain::Square, 399) - 1.0).abs() < 1e-12);
        assert!((0.74..0.77).contains(&area(Domain::Holes, 18_004)));
        assert!((0.97..0.999).contains(&area(Domain::Airfoil, 200)));
        for domain in Domain::ALL.into_iter().filter(|d| d.encloses()) {
            let area = area(domain, 1000);
            assert!((0.05..1.0 + 1e-12).contains(&area), "{domain}: {area}");
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
