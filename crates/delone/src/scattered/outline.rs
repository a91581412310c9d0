//! The outer polygon (stub).
use crate::predicates::{Orientation, orient2d};
use crate::{Error, Point};

#[derive(Clone)]
pub(super) struct Outline {
    corners: Vec<Point>,
    data: Vec<Point>,
}

pub(super) enum Reduction {
    Edge([usize; 2]),
    Enclosed,
}

impl Outline {
    pub fn around(data: &[Point], factor: f64) -> Result<Self, Error> {
        let t = crate::triangulate(data.iter().copied())?;
        let hull: Vec<_> = t.hull().map(|v| t.point(v)).collect();
        let n = hull.len() as f64;
        let m = hull
            .iter()
            .fold((0.0, 0.0), |m, p| (m.0 + p.x / n, m.1 + p.y / n));
        let at = |p: &Point| Point::new(m.0 + factor * (p.x - m.0), m.1 + factor * (p.y - m.1));
        let mut corners: Vec<_> = hull.iter().map(at).collect();
        let mut i = 0;
        while i < corners.len() && corners.len() > 3 {
            let k = corners.len();
            let [a, c] = [corners[i], corners[(i + 2) % k]];
            if hull.iter().all(|&p| orient2d(a, c, p) == Orientation::Left) {
                corners.remove((i + 1) % k);
            } else {
                i += 1;
            }
        }
        Ok(Self {
            corners,
            data: data.to_vec(),
        })
    }

    pub fn of_domain(corners: &[Point]) -> Result<Self, Error> {
        Ok(Self {
            corners: corners.to_vec(),
            data: Vec::new(),
        })
    }

    pub fn corners(&self) -> &[Point] {
        &self.corners
    }

    pub fn reduce(&mut self) -> Reduction {
        let none = [
            f64::INFINITY,
            f64::INFINITY,
            f64::NEG_INFINITY,
            f64::NEG_INFINITY,
        ];
        let [x, y, z, w] = self.data.iter().fold(none, |[x, y, z, w], p| {
            [x.min(p.x), y.min(p.y), z.max(p.x), w.max(p.y)]
        });
        let [dx, dy] = [z - x, w - y];
        let [x, y] = [x - 0.01 * dx, y - 0.01 * dy];
        self.corners = vec![
            Point::new(x, y),
            Point::new(x + 2.1 * dx, y),
            Point::new(x, y + 2.1 * dy),
        ];
        Reduction::Enclosed
    }
}
