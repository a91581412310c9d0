//! Seeded point sets of many kinds, the degenerate ones first.
//!
//! The generator is SplitMix64 (Steele, Lea and Flood, *Fast splittable pseudorandom number
//! generators*, 2014), so that a seed names the same points on every machine and for ever.

use delone::Point;

/// A deterministic source of random numbers.
#[derive(Clone, Debug)]
pub struct Random(u64);

impl Random {
    /// Starts the sequence that `seed` names.
    pub fn new(seed: u64) -> Self {
        Self(seed)
    }

    /// Draws 64 random bits.
    #[inline]
    pub fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// Draws from 0..`bound`, which must not be 0.
    #[inline]
    pub fn below(&mut self, bound: usize) -> usize {
        ((u128::from(self.bits()) * bound as u128) >> 64) as usize
    }

    /// Draws from [0, 1), multiples of 2⁻⁵³.
    #[inline]
    pub fn unit(&mut self) -> f64 {
        (self.bits() >> 11) as f64 * (0.5f64).powi(53)
    }

    /// Draws a finite `f64`, every bit pattern alike.
    pub fn finite(&mut self) -> f64 {
        loop {
            let value = f64::from_bits(self.bits());
            if value.is_finite() {
                return value;
            }
        }
    }

    /// Draws one of `items`.
    pub fn choose<T: Copy>(&mut self, items: &[T]) -> T {
        items[self.below(items.len())]
    }

    /// Puts `items` into random order.
    pub fn shuffle<T>(&mut self, items: &mut [T]) {
        for i in (1..items.len()).rev() {
            items.swap(i, self.below(i + 1));
        }
    }

    /// Draws a permutation of 0..`n`.
    pub fn permutation(&mut self, n: usize) -> Vec<usize> {
        let mut order: Vec<_> = (0..n).collect();
        self.shuffle(&mut order);
        order
    }
}

/// A kind of point set.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Kind {
    /// Evenly in the unit square.
    Uniform,
    /// On the integer lattice {0, …, `side` − 1}²; many duplicates and cocircular points if small.
    Lattice {
        /// Points on a side.
        side: u32,
    },
    /// On the unit circle as well as `f64` can: nearly cocircular.
    Circle,
    /// Exactly on circles about the origin, integer coordinates.
    CocircularRings,
    /// Integer points on one line through the origin of random direction.
    Collinear,
    /// On two lines that cross.
    Cross,
    /// Few places, each many times.
    Duplicates,
    /// Tight clusters far apart.
    Clusters,
    /// A unit square 10⁹ away, where the last bits decide.
    HugeOffset,
    /// A lattice whose coordinates are moved by a few units in the last place.
    UlpLattice,
    /// A lattice scaled by a random power of two, down to subnormals and up to overflow's edge.
    ScaledLattice,
    /// Any finite bit pattern.
    RawBits,
    /// Exponents between −40 and 40, alike.
    WideExponents,
    /// A tiny lattice, some of its points moved in the last place, with a few points at the borders
    /// of the classes of coordinates and of the range of `f64`.
    Borders,
}

impl Kind {
    /// Every kind, small and degenerate ones first.
    pub const ALL: [Self; 16] = [
        Self::Lattice { side: 3 },
        Self::Lattice { side: 5 },
        Self::Lattice { side: 20 },
        Self::Collinear,
        Self::Cross,
        Self::CocircularRings,
        Self::Duplicates,
        Self::UlpLattice,
        Self::ScaledLattice,
        Self::HugeOffset,
        Self::Clusters,
        Self::Circle,
        Self::Uniform,
        Self::WideExponents,
        Self::Borders,
        Self::RawBits,
    ];

    /// Makes the `n` points of this kind that `seed` names.
    pub fn points(self, n: usize, seed: u64) -> Vec<Point> {
        let mut points = Vec::with_capacity(n);
        self.fill(&mut points, n, &mut Random::new(seed));
        points
    }

    /// Replaces `points` by `n` points of this kind.
    pub fn fill(self, points: &mut Vec<Point>, n: usize, random: &mut Random) {
        points.clear();
        let salt = random.bits();
        let draw = |_| self.sample(&mut Random::new(salt), random);
        points.extend((0..n).map(draw));
    }

    /// Draws a point from `r`; what `common` yields is the same for all points of the set.
    fn sample(self, common: &mut Random, r: &mut Random) -> Point {
        match self {
            Self::Uniform => Point::new(r.unit(), r.unit()),
            Self::Lattice { side } => lattice(r, side as usize),
            Self::Circle => {
                let (y, x) = (std::f64::consts::TAU * r.unit()).sin_cos();
                Point::new(x, y)
            }
            Self::CocircularRings => ring(r),
            Self::Collinear => along(lattice(common, 7), r),
            Self::Cross => {
                let directions = [lattice(common, 4), lattice(common, 4)];
                along(r.choose(&directions), r)
            }
            Self::Duplicates => {
                let places = [0; 4].map(|_| lattice(common, 9));
                r.choose(&places)
            }
            Self::Clusters => {
                let centres = [0; 5].map(|_| lattice(common, 1000));
                let (centre, offset) = (r.choose(&centres), Point::new(r.unit(), r.unit()));
                moved(centre, [offset.x * 1e-9, offset.y * 1e-9])
            }
            Self::HugeOffset => moved(Point::new(1e9, -1e9), [r.unit(), r.unit()]),
            Self::UlpLattice => {
                let p = lattice(r, 4);
                Point::new(nudged(p.x + 1.0, r), nudged(p.y + 1.0, r))
            }
            Self::ScaledLattice => {
                let exponent = common.below(2089) as i32 - 1070;
                let p = lattice(r, 5);
                Point::new(scaled(p.x, exponent), scaled(p.y, exponent))
            }
            Self::RawBits => Point::new(r.finite(), r.finite()),
            Self::WideExponents => Point::new(wide(r), wide(r)),
            Self::Borders => border(common, r),
        }
    }
}

fn lattice(r: &mut Random, side: usize) -> Point {
    Point::new(r.below(side) as f64, r.below(side) as f64)
}

fn along(direction: Point, r: &mut Random) -> Point {
    let step = r.below(41) as f64 - 20.0;
    Point::new(direction.x * step, direction.y * step)
}

/// One of the 12 lattice points on the circle of radius √25, or of the 24 on that of radius √325.
fn ring(r: &mut Random) -> Point {
    let (x, y) = r.choose(&[
        (5.0, 0.0),
        (3.0, 4.0),
        (1.0, 18.0),
        (6.0, 17.0),
        (10.0, 15.0),
    ]);
    let (x, y) = if r.below(2) == 0 { (x, y) } else { (y, x) };
    let mut sign = || 1.0 - 2.0 * r.below(2) as f64;
    Point::new(x * sign(), y * sign())
}

fn moved(p: Point, [dx, dy]: [f64; 2]) -> Point {
    Point::new(p.x + dx, p.y + dy)
}

/// Moves a positive number by at most two units in the last place.
fn nudged(value: f64, r: &mut Random) -> f64 {
    f64::from_bits(value.to_bits() + r.below(5) as u64 - 2)
}

/// `value · 2^exponent`, in two steps since 2^exponent alone may leave the range.
pub fn scaled(value: f64, exponent: i32) -> f64 {
    let half = exponent / 2;
    value * 2f64.powi(half) * 2f64.powi(exponent - half)
}

fn border(common: &mut Random, r: &mut Random) -> Point {
    const EXPONENTS: [i32; 10] = [-1074, -1000, -262, -201, -200, 0, 249, 250, 1000, 1023];
    let (size, far) = (common.choose(&EXPONENTS), common.choose(&EXPONENTS));
    if r.below(6) == 0 {
        let [x, y] = [0; 2].map(|_| r.below(3) as f64 - 1.0);
        return Point::new(scaled(x, far), scaled(y, far));
    }
    let p = lattice(r, 4);
    let [x, y] = [p.x, p.y].map(|c| if c > 0.0 { nudged(c, r) } else { c });
    // Less than 4 times the size; and lattice points on both sides of zero.
    Point::new(scaled(x - 1.5, size - 1), scaled(y - 1.5, size - 1))
}

fn wide(r: &mut Random) -> f64 {
    scaled(r.unit() - 0.5, r.below(81) as i32 - 40)
}

#[cfg(test)]
mod tests {
    use super::*;
    use delone::predicates::{CircleSide, Orientation, in_circle, orient2d};

    #[test]
    fn every_kind_is_finite_and_named_by_its_seed() {
        for kind in Kind::ALL {
            for seed in 0..50 {
                let points = kind.points(20, seed);
                assert_eq!(points.len(), 20);
                assert!(points.iter().all(Point::is_finite), "{kind:?} {seed}");
                assert_eq!(points, kind.points(20, seed));
            }
        }
    }

    #[test]
    fn collinear_is_and_rings_are_cocircular() {
        for seed in 0..20 {
            let p = Kind::Collinear.points(3, seed);
            assert_eq!(orient2d(p[0], p[1], p[2]), Orientation::Collinear);
        }
        let norms = Kind::CocircularRings.points(40, 1);
        let norms = norms.iter().map(|p| p.x * p.x + p.y * p.y);
        assert!(norms.into_iter().all(|n| n == 25.0 || n == 325.0));
        let [a, b, c, d] = [(5.0, 0.0), (0.0, 5.0), (-3.0, -4.0), (4.0, -3.0)].map(Point::from);
        assert_eq!(in_circle(a, b, c, d), CircleSide::On);
    }

    #[test]
    fn shuffling_permutes() {
        let mut order = Random::new(3).permutation(100);
        assert!(!order.is_sorted());
        order.sort();
        assert!(order.into_iter().eq(0..100));
    }
}
