//! Centers of clusters (stub).
use crate::predicates::compare_distances;
use crate::{Cut, Point};

#[derive(Clone)]
pub(super) struct Centers {
    data: Vec<Point>,
    positions: Vec<Point>,
    held: Vec<Vec<usize>>,
}

pub(super) struct Split {
    pub clusters: [u32; 2],
    pub from: Point,
    pub to: [Point; 2],
    pub cut: Cut,
}

fn mean(data: &[Point], held: &[usize]) -> Point {
    let n = held.len() as f64;
    held.iter().fold(Point::new(0.0, 0.0), |m, &i| {
        Point::new(m.x + data[i].x / n, m.y + data[i].y / n)
    })
}

impl Centers {
    pub fn new(data: &[Point]) -> Self {
        let held: Vec<_> = (0..data.len()).collect();
        Self {
            data: data.to_vec(),
            positions: vec![mean(data, &held)],
            held: vec![held],
        }
    }

    pub fn positions(&self) -> &[Point] {
        &self.positions
    }

    pub fn split(&mut self) -> Option<Split> {
        let (i, _) = self
            .held
            .iter()
            .enumerate()
            .rev()
            .max_by_key(|(_, h)| h.len())?;
        if self.held[i].len() < 2 {
            return None;
        }
        let none = [
            f64::INFINITY,
            f64::INFINITY,
            f64::NEG_INFINITY,
            f64::NEG_INFINITY,
        ];
        let [x, y, z, w] = self.held[i].iter().fold(none, |[x, y, z, w], &k| {
            let p = self.data[k];
            [x.min(p.x), y.min(p.y), z.max(p.x), w.max(p.y)]
        });
        let cut = if z - x >= w - y {
            Cut::Vertical((x + z) / 2.0)
        } else {
            Cut::Horizontal((y + w) / 2.0)
        };
        let (low, high): (Vec<_>, Vec<_>) = self.held[i].iter().partition(|&&k| match cut {
            Cut::Vertical(at) => self.data[k].x <= at,
            Cut::Horizontal(at) => self.data[k].y <= at,
        });
        let to = [mean(&self.data, &low), mean(&self.data, &high)];
        let from = self.positions[i];
        self.positions[i] = to[0];
        self.positions.push(to[1]);
        self.held = vec![Vec::new(); self.positions.len()];
        for k in 0..self.data.len() {
            let mut best = 0;
            for j in 1..self.positions.len() {
                if compare_distances(self.data[k], self.positions[j], self.positions[best]).is_lt()
                {
                    best = j;
                }
            }
            self.held[best].push(k);
        }
        Some(Split {
            clusters: [i as u32, self.positions.len() as u32 - 1],
            from,
            to,
            cut,
        })
    }
}
