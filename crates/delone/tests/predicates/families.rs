//! Families of near-degenerate quadruples, and which stages each must and must not need.

use crate::random::Random;
use delone::Point;
use delone::predicates::stage::Stage::{self, BigInteger, Filter, Integer};

pub struct Family {
    pub name: &'static str,
    pub make: fn(&mut Random) -> [Point; 4],
    /// Stages that decide some in-circle test of this family.
    pub uses: &'static [Stage],
    /// Stages that may decide any predicate of this family; constructions may need others.
    pub stays_in: &'static [Stage],
}

const ANY: &[Stage] = &[Filter, Integer, BigInteger];
const FIXED: &[Stage] = &[Filter, Integer];
const UNFILTERED: &[Stage] = &[Integer, BigInteger];

pub const FAMILIES: &[Family] = &[
    family("uniform", uniform, &[Filter], FIXED),
    family("small lattice", small_lattice, FIXED, FIXED),
    family("lattice far away", far_lattice, FIXED, FIXED),
    family("lattice of 0.1", decimal_lattice, FIXED, FIXED),
    family("wide lattice", wide_lattice, FIXED, FIXED),
    family("integer circle", integer_circle, &[Integer], FIXED),
    family("shared coordinates", shared, &[Integer], ANY),
    family("nearly collinear", near_line, ANY, ANY),
    family("nearly collinear, thin", thin_line, ANY, ANY),
    family("nearly cocircular", near_circle, ANY, ANY),
    family("nearly cocircular far away", far_circle, FIXED, FIXED),
    family("Thales", thales, &[Filter], ANY),
    family("subnormal", subnormal, &[BigInteger], UNFILTERED),
    family("close to 0", close_to_zero, &[BigInteger], ANY),
    family("close to overflow", close_to_overflow, &[BigInteger], ANY),
    family("1e±300", mixture, ANY, ANY),
    family("any bits", any_bits, &[Filter, BigInteger], ANY),
];

const fn family(
    name: &'static str,
    make: fn(&mut Random) -> [Point; 4],
    uses: &'static [Stage],
    stays_in: &'static [Stage],
) -> Family {
    Family {
        name,
        make,
        uses,
        stays_in,
    }
}

/// Makes four points by the same recipe.
fn four(mut make: impl FnMut() -> (f64, f64)) -> [Point; 4] {
    std::array::from_fn(|_| make().into())
}

fn uniform(random: &mut Random) -> [Point; 4] {
    four(|| (random.unit(), random.unit()))
}

fn small_lattice(random: &mut Random) -> [Point; 4] {
    let scale = random.power(-500, 500);
    let size = random.within(1, 8);
    let mut c = || random.within(-size, size) as f64 * scale;
    four(|| (c(), c()))
}

fn far_lattice(random: &mut Random) -> [Point; 4] {
    let far = [0; 2].map(|_| random.within(-(1 << 52), 1 << 52));
    let scale = random.power(-300, 300);
    let size = random.pick(&[2, 5, 1 << 12, 1 << 28]);
    let mut c = |far: i64| (far + random.within(-size, size)) as f64 * scale;
    four(|| (c(far[0]), c(far[1])))
}

fn decimal_lattice(random: &mut Random) -> [Point; 4] {
    let (x, y) = (random.within(0, 1000), random.within(0, 1000));
    let mut c = |from: i64| (1000 + from + random.within(0, 3)) as f64 * 0.1;
    four(|| (c(x), c(y)))
}

/// Cocircular up to a few steps of a lattice that needs between 40 and 61 bits.
fn wide_lattice(random: &mut Random) -> [Point; 4] {
    let radius = 2_f64.powi(random.within(40, 60) as i32 - 1);
    four(|| {
        let turn = random.unit() * std::f64::consts::TAU;
        ((radius * turn.cos()).round(), (radius * turn.sin()).round())
    })
}

/// Four of the 48 integer points with x² + y² = 5525, enlarged and moved.
fn integer_circle(random: &mut Random) -> [Point; 4] {
    const OCTANT: [(i64, i64); 6] = [(7, 74), (14, 73), (22, 71), (25, 70), (41, 62), (50, 55)];
    let factor = random.pick(&[1, 1, 1 << 10, 1 << 30]);
    let [x, y] = [0; 2].map(|_| random.within(-(1 << 40), 1 << 40));
    let scale = random.power(-300, 300);
    four(|| {
        let (u, v) = random.pick(&OCTANT);
        let (u, v) = random.pick(&[(u, v), (v, u)]);
        let [u, v] = [u, v].map(|c| random.pick(&[-c, c]) * factor);
        ((x + u) as f64 * scale, (y + v) as f64 * scale)
    })
}

/// All coordinates from a pool of three numbers.
fn shared(random: &mut Random) -> [Point; 4] {
    let spread = random.pick(&[1, 30, 300]);
    let pool = [0; 3].map(|_| random.signed() * random.power(-spread, spread));
    four(|| (random.pick(&pool), random.pick(&pool)))
}

fn near_line(random: &mut Random) -> [Point; 4] {
    line(random, 1.0)
}

fn thin_line(random: &mut Random) -> [Point; 4] {
    let aspect = random.power(-40, 40);
    line(random, aspect)
}

fn line(random: &mut Random, aspect: f64) -> [Point; 4] {
    let [x, y, u, v] = [0; 4].map(|_| random.signed());
    four(|| {
        let t = random.signed() * random.power(-20, 1);
        let (x, y) = (x + t * u, aspect * (y + t * v));
        (random.jitter(x), random.jitter(y))
    })
}

fn near_circle(random: &mut Random) -> [Point; 4] {
    let radius = random.power(-200, 200);
    circle(random, (0.0, 0.0), radius)
}

fn far_circle(random: &mut Random) -> [Point; 4] {
    let centre = (4.0 + random.unit(), -4.0 - random.unit());
    let radius = random.power(-20, 1);
    circle(random, centre, radius)
}

fn circle(random: &mut Random, (x, y): (f64, f64), radius: f64) -> [Point; 4] {
    four(|| {
        let (sin, cos) = (random.unit() * std::f64::consts::TAU).sin_cos();
        let (x, y) = (x + radius * cos, y + radius * sin);
        (random.jitter(x), random.jitter(y))
    })
}

/// A diameter, a point that sees it under a right angle, and the centre, last or first.
fn thales(random: &mut Random) -> [Point; 4] {
    let [x, y, u, v] = [0; 4].map(|_| random.signed());
    let (sin, cos) = (random.unit() * std::f64::consts::TAU).sin_cos();
    let mut at = |a: f64, b: f64| Point::new(random.jitter(x + a), random.jitter(y + b));
    let diameter = [at(u, v), at(-u, -v)];
    let seen = at(u * cos - v * sin, u * sin + v * cos);
    let centre = at(0.0, 0.0);
    let [a, b] = diameter;
    random.pick(&[[a, b, seen, centre], [centre, a, b, seen]])
}

/// Subnormal numbers, also next to the smallest normal ones.
fn subnormal(random: &mut Random) -> [Point; 4] {
    let size = random.pick(&[2, 9, 1 << 20, 1 << 53]);
    let mut c = || random.within(-size, size) as f64 * 5e-324;
    four(|| (c(), c()))
}

/// Where squares underflow, or nearly.
fn close_to_zero(random: &mut Random) -> [Point; 4] {
    let scale = random.power(-1000, -180);
    let [x, y] = [0; 2].map(|_| random.within(-2, 2) as f64);
    let moved = |p: Point| Point::new((p.x + x) * scale, (p.y + y) * scale);
    match random.within(0, 2) {
        0 => near_line(random).map(moved),
        1 => circle(random, (0.0, 0.0), 1.0).map(moved),
        _ => four(|| {
            (
                random.signed() * random.power(-1000, -100),
                random.signed() * random.power(-1000, -100),
            )
        }),
    }
}

/// Where lifts, products or even differences overflow, or nearly.
fn close_to_overflow(random: &mut Random) -> [Point; 4] {
    let scale = random.power(250, 1021);
    match random.within(0, 2) {
        0 => near_line(random),
        1 => circle(random, (0.0, 0.0), 1.0),
        _ => uniform(random),
    }
    .map(|p| Point::new(p.x * scale, p.y * scale))
}

fn mixture(random: &mut Random) -> [Point; 4] {
    let mut c = || random.pick(&[1e300, 1e-300, 1.0, 1e16, 0.0]) * random.within(-3, 3) as f64;
    four(|| (c(), c()))
}

fn any_bits(random: &mut Random) -> [Point; 4] {
    four(|| (random.finite(), random.finite()))
}
