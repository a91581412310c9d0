//! What an engine gets: points, and what it is asked about them.

use super::bounds::Bounds;
use super::question::{COMPARED, Question};
use std::f64::consts::PI;

/// Points, and points that are asked about.
#[derive(Clone, Debug)]
pub struct Input {
    /// What is asked.
    pub question: Question,
    /// The points: vertices, sites, places of values.
    pub points: Vec<[f64; 2]>,
    /// Those that are asked about.
    pub asked: Vec<[f64; 2]>,
    /// Shall the answers be summed up?
    pub check: bool,
}

impl Input {
    /// Sums up answers, `each` for every query, if that is asked for: those to the first [`COMPARED`].
    pub fn sum(&self, each: usize, answers: impl Iterator<Item = f64>) -> Option<f64> {
        self.check.then(|| answers.take(each * COMPARED).sum())
    }

    /// Returns the value at each point.
    pub fn values(&self) -> Vec<f64> {
        values(&self.points, Shape::of(self.question, self.check))
    }
}

/// What is interpolated.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shape {
    /// A tilted plane.
    Plane,
    /// Some waves, wherever the points lie.
    Waves,
}

impl Shape {
    /// Returns what is interpolated. Gradients are estimated in different ways, so where they matter answers
    /// are compared on a plane, which all must get right.
    pub fn of(question: Question, check: bool) -> Self {
        match (question, check) {
            (Question::CloughTocher, true) => Self::Plane,
            _ => Self::Waves,
        }
    }

    fn at(self, [u, v]: [f64; 2]) -> f64 {
        match self {
            Self::Plane => 1.0 + u + 2.0 * v,
            Self::Waves => 2.0 + (3.0 * PI * u).sin() * (2.0 * PI * v).cos(),
        }
    }
}

/// Returns the value of a shape at each point; it spans the bounds of all.
pub fn values(points: &[[f64; 2]], shape: Shape) -> Vec<f64> {
    let bounds = Bounds::of(points);
    let share = |p: &[f64; 2]| shape.at(bounds.share(*p));
    points.iter().map(share).collect()
}

#[cfg(test)]
mod tests {
    use super::{COMPARED, Input, Question, Shape, values};

    #[test]
    fn only_the_first_answers_are_summed_up() {
        let input = |check| Input {
            question: Question::TenNearest,
            points: Vec::new(),
            asked: Vec::new(),
            check,
        };
        let ones = || std::iter::repeat_n(1.0, 20 * COMPARED);
        assert_eq!(input(true).sum(10, ones()), Some(10.0 * COMPARED as f64));
        assert_eq!(input(false).sum(10, ones()), None);
    }

    #[test]
    fn shapes_span_the_points() {
        let corners = [[-5.0, 1e6], [5.0, 1e6], [5.0, 3e6]];
        assert_eq!(values(&corners, Shape::Plane), [1.0, 2.0, 4.0]);
        assert!(
            values(&corners, Shape::Waves)
                .iter()
                .all(|z| (1.0..=3.0).contains(z))
        );
    }
}
