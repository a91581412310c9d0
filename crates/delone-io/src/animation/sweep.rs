//! What a sweep is like. Steps tell a number alone: an abscissa, an ordinate or a radius.
//!
//! It is found out by what sweeps do: they come to points. A line that comes to most points at their
//! abscissas is vertical, at their ordinates horizontal; else it is a circle, around the point from which the
//! distances fit.

use super::mark::{Look, Mark};
use super::pen::Pen;
use delone::{Cut, Event, Log, Point};

/// Points that are looked at.
const LOOKED_AT: usize = 2000;

/// What sweeps the plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Sweep {
    Vertical,
    Horizontal,
    Circle(Point),
}

impl Sweep {
    /// Finds out what the sweep of a log is like, if it has one.
    pub fn of(log: &Log) -> Option<Self> {
        let meetings = meetings(log);
        let most = |meets: fn(&(Point, f64)) -> bool| {
            2 * meetings.iter().filter(|meeting| meets(meeting)).count() > meetings.len()
        };
        if most(|&(p, at)| p.x == at) {
            return Some(Self::Vertical);
        }
        if most(|&(p, at)| p.y == at) {
            return Some(Self::Horizontal);
        }
        center(&meetings).map(Self::Circle)
    }

    /// Draws it where it is.
    pub fn mark(self, pen: &Pen, at: f64) -> Mark {
        match self {
            Self::Vertical => pen.cut(Look::Sweep, Cut::Vertical(at)),
            Self::Horizontal => pen.cut(Look::Sweep, Cut::Horizontal(at)),
            Self::Circle(center) => {
                let through = Point::new(center.x + at, center.y);
                pen.circle_around(Look::Sweep, center, through)
            }
        }
    }
}

/// Lists to which point the sweep has come where.
fn meetings(log: &Log) -> Vec<(Point, f64)> {
    let mut points = log.points.clone();
    let mut at = None;
    let mut meetings = Vec::new();
    for step in &log.steps {
        match step.event {
            Event::VertexCreated { vertex, at } if vertex.index() == points.len() => {
                points.push(at);
            }
            Event::SweptTo { to, .. } => at = to,
            Event::PointConsidered { vertex } | Event::FrontEntered { vertex, .. } => {
                let met = points.get(vertex.index()).copied().zip(at.take());
                meetings.extend(met);
            }
            _ => {}
        }
        if meetings.len() == LOOKED_AT {
            break;
        }
    }
    meetings
}

/// Finds the point from which points are as far as numbers say: the solution of the linear equations
/// that are left when those for the first are taken from the others, by least squares.
fn center(meetings: &[(Point, f64)]) -> Option<Point> {
    let (&(p0, r0), others) = meetings.split_first()?;
    let mut normal = [0.0; 3];
    let mut right = [0.0; 2];
    for &(p, r) in others {
        let (x, y) = (p.x - p0.x, p.y - p0.y);
        let value = (x * x + y * y - (r * r - r0 * r0)) / 2.0;
        let sums = [x * x, x * y, y * y];
        (0..3).for_each(|k| normal[k] += sums[k]);
        (0..2).for_each(|k| right[k] += [x, y][k] * value);
    }
    let [xx, xy, yy] = normal;
    let determinant = xx * yy - xy * xy;
    let x = (yy * right[0] - xy * right[1]) / determinant;
    let y = (xx * right[1] - xy * right[0]) / determinant;
    let center = Point::new(p0.x + x, p0.y + y);
    center.is_finite().then_some(center)
}

#[cfg(test)]
mod tests {
    use super::*;
    use delone::{Step, VertexId};

    fn swept(points: &[(f64, f64)], at: impl Fn(Point) -> f64) -> Option<Sweep> {
        let mut log = Log::new("", points.iter().map(|&p| p.into()).collect::<Vec<_>>());
        for (i, p) in log.points.clone().into_iter().enumerate() {
            let to = Some(at(p));
            let vertex = VertexId::new(i);
            let events = [
                Event::SweptTo { from: None, to },
                Event::PointConsidered { vertex },
            ];
            log.steps
                .extend(events.map(|event| Step { line: 1, event }));
        }
        Sweep::of(&log)
    }

    #[test]
    fn the_sweep_is_told_by_where_it_meets_points() {
        let points = [(0.0, 3.0), (1.0, 7.0), (4.0, 1.0), (5.0, 5.0)];
        assert_eq!(swept(&points, |p| p.x), Some(Sweep::Vertical));
        assert_eq!(swept(&points, |p| p.y), Some(Sweep::Horizontal));
        let around = swept(&points, |p| (p.x - 2.0).hypot(p.y - 3.0));
        let Some(Sweep::Circle(center)) = around else {
            panic!("a circle: {around:?}");
        };
        assert!((center.x - 2.0).hypot(center.y - 3.0) < 1e-9, "{center:?}");
        assert_eq!(swept(&[], |p| p.x), None);
    }
}
