//! The predicates in rational arithmetic: slow, obviously right, sharing no code and no formula with
//! the library. Determinants are expanded without moving the origin.

use dashu_ratio::Relaxed;
use delone::Point;
use delone::predicates::Weighted;
use std::cmp::Ordering;

struct Exact {
    x: Relaxed,
    y: Relaxed,
}

impl Exact {
    fn new(p: Point) -> Self {
        let rational = |c: f64| Relaxed::try_from(c).expect("finite");
        Self {
            x: rational(p.x),
            y: rational(p.y),
        }
    }

    fn lift(&self) -> Relaxed {
        &self.x * &self.x + &self.y * &self.y
    }
}

fn sign(value: &Relaxed) -> Ordering {
    value.cmp(&Relaxed::ZERO)
}

fn orient(a: &Exact, b: &Exact, c: &Exact) -> Relaxed {
    &a.x * (&b.y - &c.y) + &b.x * (&c.y - &a.y) + &c.x * (&a.y - &b.y)
}

pub fn orient2d([a, b, c]: [Point; 3]) -> Ordering {
    let [a, b, c] = [a, b, c].map(Exact::new);
    sign(&orient(&a, &b, &c))
}

/// The cofactors of the lifts in the 4×4 determinant with rows (x, y, x² + y², 1).
fn cofactors([a, b, c, d]: &[Exact; 4]) -> [Relaxed; 4] {
    [
        orient(b, c, d),
        -orient(a, c, d),
        orient(a, b, d),
        -orient(a, b, c),
    ]
}

pub struct InCircle {
    pub exact: Ordering,
    /// With each lift raised by its own infinitesimal, the largest point's dominating.
    pub perturbed: Ordering,
}

pub fn in_circle(points: [Point; 4]) -> InCircle {
    let rows = points.map(Exact::new);
    let cofactors = cofactors(&rows);
    let terms = rows.iter().zip(&cofactors).map(|(p, k)| p.lift() * k);
    let exact = sign(&terms.fold(Relaxed::ZERO, |sum, term| sum + term));
    let mut order = [0, 1, 2, 3];
    order.sort_by(|&i, &j| points[j].lex_cmp(&points[i]));
    let perturbed = order
        .iter()
        .fold(exact, |s, &i| s.then(sign(&cofactors[i])));
    InCircle { exact, perturbed }
}

pub fn compare_distances([p, a, b]: [Point; 3]) -> Ordering {
    let [p, a, b] = [p, a, b].map(Exact::new);
    let square = |q: &Exact| {
        let (x, y) = (&q.x - &p.x, &q.y - &p.y);
        &x * &x + &y * &y
    };
    square(&a).cmp(&square(&b))
}

pub fn compare_lengths(segments: [[Point; 2]; 2]) -> Ordering {
    let [s, t] = segments.map(|ends| squared_length(&ends.map(Exact::new)));
    s.cmp(&t)
}

fn squared_length([a, b]: &[Exact; 2]) -> Relaxed {
    let (x, y) = (&a.x - &b.x, &a.y - &b.y);
    &x * &x + &y * &y
}

pub fn squared_length_of(ends: [Point; 2]) -> Relaxed {
    squared_length(&ends.map(Exact::new))
}

/// |ab|²|bc|²|ca|² / (2·orient)²; `None` if the points are collinear.
pub fn squared_circumradius([a, b, c]: [Point; 3]) -> Option<Relaxed> {
    let [p, q, r] = [a, b, c].map(Exact::new);
    let area = orient(&p, &q, &r);
    if area == Relaxed::ZERO {
        return None;
    }
    let [u, v, w] = [[a, b], [b, c], [c, a]].map(squared_length_of);
    let square = &area * &area;
    Some(u * v * w / (&square + &square + &square + &square))
}

/// Compares the distance from `center` to `p` with `radius`.
pub fn in_disc(center: Point, radius: f64, p: Point) -> Ordering {
    let arm = Exact::new(Point::new(radius, 0.0)).x;
    squared_length_of([center, p]).cmp(&(&arm * &arm))
}

/// The sign of |p − m|² − r² for the circle with diameter `ab`: negative inside.
pub fn in_diametral_circle([a, b, p]: [Point; 3]) -> Ordering {
    let [a, b, p] = [a, b, p].map(Exact::new);
    let ([x, y], [u, v]) = (
        [&p.x + &p.x - &a.x - &b.x, &p.y + &p.y - &a.y - &b.y],
        [&a.x - &b.x, &a.y - &b.y],
    );
    (&x * &x + &y * &y).cmp(&(&u * &u + &v * &v))
}

/// Points with weights, lifted.
pub struct Lifted;

pub struct Power {
    pub exact: Ordering,
    /// With each height raised by its own infinitesimal, the largest point's dominating.
    pub perturbed: Ordering,
    /// How many infinitesimals it took.
    pub steps: usize,
}

impl Lifted {
    /// The 4×4 determinant with rows (x, y, x² + y² − weight, 1).
    pub fn determinant(sites: [Weighted; 4]) -> Power {
        let rows = sites.map(|s| Exact::new(s.point));
        let heights = sites.map(Self::height);
        Self::expanded(sites.map(|s| s.point), &heights, &cofactors(&rows))
    }

    /// The 3×3 determinant with rows (position on the line, x² + y² − weight, 1), turned so that what
    /// lies below the line of the first two is positive.
    pub fn determinant_on_line(sites: [Weighted; 3]) -> Power {
        let points = sites.map(|s| s.point);
        // Along any direction that tells the ends apart: the lexicographic one, with x before y.
        let is_vertical = points[0].x == points[1].x;
        let [a, b, p] = points
            .map(Exact::new)
            .map(|e| if is_vertical { e.y } else { e.x });
        let sign = if a < b { Relaxed::ONE } else { -Relaxed::ONE };
        let cofactors = [(&b - &p) * &sign, (&p - &a) * &sign, (&a - &b) * &sign];
        Self::expanded(points, &sites.map(Self::height), &cofactors)
    }

    pub fn power(p: Point, s: Weighted) -> Relaxed {
        let [p, q] = [p, s.point].map(Exact::new);
        let (x, y) = (q.x - p.x, q.y - p.y);
        &x * &x + &y * &y - Relaxed::try_from(s.weight).expect("finite")
    }

    fn height(s: Weighted) -> Relaxed {
        Exact::new(s.point).lift() - Relaxed::try_from(s.weight).expect("finite")
    }

    fn expanded<const N: usize>(
        points: [Point; N],
        heights: &[Relaxed; N],
        cofactors: &[Relaxed; N],
    ) -> Power {
        let terms = heights.iter().zip(cofactors).map(|(h, k)| h * k);
        let exact = sign(&terms.fold(Relaxed::ZERO, |sum, term| sum + term));
        let mut order: Vec<usize> = (0..N).collect();
        order.sort_by(|&i, &j| points[j].lex_cmp(&points[i]));
        let signs = order.iter().map(|&i| sign(&cofactors[i]));
        let zeros = signs.clone().take_while(|s| s.is_eq()).count();
        Power {
            exact,
            perturbed: signs.fold(exact, Ordering::then),
            steps: if exact.is_eq() { zeros + 1 } else { 0 },
        }
    }

    /// The solution q of 2(p − a)·q = heights' difference, for p = b and p = c, by Cramer's rule.
    pub fn center(sites: [Weighted; 3]) -> Option<[Relaxed; 2]> {
        let [a, b, c] = sites.map(|s| Exact::new(s.point));
        let [ha, hb, hc] = sites.map(Self::height);
        let two = || Relaxed::ONE + Relaxed::ONE;
        let row = |p: &Exact| [(&p.x - &a.x) * two(), (&p.y - &a.y) * two()];
        let ([p, q], [r, s]) = (row(&b), row(&c));
        let (u, v) = (hb - &ha, hc - ha);
        let det = &p * &s - &q * &r;
        (det != Relaxed::ZERO).then(|| [(&u * s - q * &v) / &det, (p * v - u * r) / det])
    }

    /// Tells whether no `f64` is nearer to `exact`.
    pub fn is_nearest(found: f64, exact: &Relaxed) -> bool {
        let rational = |c: f64| Relaxed::try_from(c).expect("finite");
        let distance = |c: f64| {
            let difference = rational(c) - exact;
            if difference < Relaxed::ZERO {
                -difference
            } else {
                difference
            }
        };
        if found.abs() == f64::MAX {
            let is_beyond = if found > 0.0 {
                *exact >= rational(found)
            } else {
                *exact <= rational(found)
            };
            if is_beyond {
                return true;
            }
        }
        let best = distance(found);
        let others = [found.next_up(), found.next_down()];
        others.into_iter().filter(|c| c.is_finite()).all(|c| {
            let other = distance(c);
            best < other || (best == other && found.to_bits().is_multiple_of(2))
        })
    }
}

/// Compares |a − p|²/(a.y − p.y) with the same of b, which are twice the heights above `p`; both denominators
/// must be positive.
pub fn compare_parabolas([p, a, b]: [Point; 3]) -> Ordering {
    let height = |focus: Point| {
        let arm = squared_length_of([p, focus]);
        let [p, focus] = [p, focus].map(Exact::new);
        arm / (focus.y - p.y)
    };
    height(a).cmp(&height(b))
}

/// A circle: the ordinate of its center, and its squared radius.
pub fn circle(corners: [Point; 3]) -> Option<[Relaxed; 2]> {
    let [_, y] = Lifted::center(corners.map(|p| Weighted::new(p, 0.0)))?;
    Some([y, squared_circumradius(corners)?])
}

/// Compares y − √r with y′ − √r′, where r is a squared radius.
pub fn compare_bottoms([t, u]: [&[Relaxed; 2]; 2]) -> Ordering {
    let [[y, square], [other, other_square]] = [t, u];
    let offset = y - other;
    if offset < Relaxed::ZERO {
        return compare_bottoms([u, t]).reverse();
    }
    // With d = y − y′ ≥ 0: compares (d + √r′)² = d² + r′ + 2d√r′ with r.
    let rational = &offset * &offset + other_square - square;
    let doubled = &offset + &offset;
    if rational >= Relaxed::ZERO {
        return sign(&(rational + doubled * other_square));
    }
    (&doubled * &doubled * other_square).cmp(&(&rational * &rational))
}

/// A point, as a circle without extent.
pub fn point_circle(p: Point) -> [Relaxed; 2] {
    [Exact::new(p).y, Relaxed::ZERO]
}
