//! The predicates in rational arithmetic: slow, obviously right, sharing no code and no formula with
//! the library. Determinants are expanded without moving the origin.

use dashu_ratio::Relaxed;
use delone::Point;
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

/// Compares the distance from `center` to `p` with `radius`.
pub fn in_disc(center: Point, radius: f64, p: Point) -> Ordering {
    let [center, p, arm] = [center, p, Point::new(radius, 0.0)].map(Exact::new);
    let (x, y) = (&p.x - &center.x, &p.y - &center.y);
    (&x * &x + &y * &y).cmp(&(&arm.x * &arm.x))
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
