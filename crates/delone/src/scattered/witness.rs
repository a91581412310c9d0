//! Why polygons need not be tried one by one: a triangle that cannot hold enough, and stays.
//!
//! Where data crowd along their hull, the outer polygon has to lose thousands of corners before any triangulation of it
//! can be good, and to try each would take quadratic time. But each triangulation of a trial that fails has a triangle
//! that holds too few. As long as its corners are there and no new corner lies in its circle, it is in the
//! triangulation with the same centers that the next trial would make; what its closure holds does not change. So if
//! that is so for all of them, that trial would fail as well, and is left out.
//!
//! The shortest edge shrinks first. So triangles whose corners have long edges beside them are taken: on a circle
//! most edges shrink before one goes, and the number of trials is about the logarithm of that of corners.

use super::field::Field;
use super::outline::{Outline, Reduction};
use crate::predicates::in_circle_perturbed;
use crate::{Observer, Point, VertexId};

/// A triangle that holds too few.
pub(super) struct Witness {
    /// Where its corners are, counter-clockwise, and their numbers in the outline, unless they are centers.
    corners: [(Option<usize>, Point); 3],
}

/// How many triangles are looked at.
const PATIENCE: usize = 16;

impl Witness {
    /// Looks for one in a triangulation whose first vertices are the corners of an outline; all others are centers.
    ///
    /// *Cost*: O(m log m) for m triangles.
    pub fn find(field: &Field<impl Observer>, outline: &Outline, least: usize) -> Option<Self> {
        let corners: Vec<_> = outline.corners().collect();
        let clearance = |v: VertexId| match v.index() < corners.len() {
            true => clearance(&corners, v.index()),
            false => f64::INFINITY,
        };
        let mesh = &field.draft.mesh;
        let short = mesh
            .triangles()
            .filter(|&t| field.stock.count(t) < least)
            .map(|t| {
                let all = mesh.corners(t).map(clearance).into_iter();
                (all.fold(f64::INFINITY, f64::min), t)
            });
        let mut candidates: Vec<_> = short.collect();
        candidates.sort_by(|a, b| b.0.total_cmp(&a.0).then(a.1.cmp(&b.1)));
        let mut candidates = candidates.into_iter().take(PATIENCE).map(|(_, t)| t);
        let found = candidates.find(|&t| field.most_that_could_be_held(t) < least)?;
        let corner = |v: VertexId| {
            let number = corners.get(v.index()).map(|&(number, _)| number);
            (number, field.draft.point(v))
        };
        Some(Self {
            corners: mesh.corners(found).map(corner),
        })
    }

    /// Tells whether it is still there after a reduction, so that the next trial would fail.
    pub fn survives(&self, outline: &Outline, reduction: &Reduction) -> bool {
        let Reduction::Edge { at, .. } = *reduction else {
            return false;
        };
        let is_there = |&(number, at): &(Option<usize>, Point)| {
            number.is_none_or(|number| outline.has((number, at)))
        };
        let are_there = self.corners.iter().all(is_there);
        are_there && !self.is_disturbed_by(at)
    }

    fn is_disturbed_by(&self, p: Point) -> bool {
        let [a, b, c] = self.corners.map(|(_, p)| p);
        ![a, b, c].contains(&p) && in_circle_perturbed(a, b, c, p)
    }
}

/// The squared length of the shorter edge in a corner. Rounded: it decides nothing but which triangle is looked at.
fn clearance(corners: &[(usize, Point)], i: usize) -> f64 {
    let n = corners.len();
    let at = corners[i].1;
    let squared = |k: usize| {
        let other = corners[k % n].1;
        let [x, y] = [other.x - at.x, other.y - at.y];
        x * x + y * y
    };
    squared(i + 1).min(squared(i + n - 1))
}

#[cfg(test)]
mod tests {
    use crate::scattered::{Cover, samples};
    use crate::{Event, Observer, Step};
    use delone_testkit::generate::Kind;

    #[derive(Default)]
    struct Reductions(usize);

    impl Observer for Reductions {
        fn observe(&mut self, step: Step) {
            self.0 += usize::from(matches!(step.event, Event::OuterReduced { .. }));
        }
    }

    /// Who is watched tries every polygon.
    #[test]
    fn what_is_left_out_changes_nothing() {
        let mut reductions = Reductions::default();
        for (kind, n) in [
            (Kind::Circle, 150),
            (Kind::CocircularRings, 120),
            (Kind::Uniform, 90),
            (Kind::Lattice { side: 20 }, 200),
            (Kind::UlpLattice, 80),
        ] {
            for seed in 0..3 {
                let data = samples(kind, n, seed);
                for (factor, least) in [(1.0, 3), (1.0, 8), (1.001, 5), (1.1, 20)] {
                    let cover = Cover::new(least).factor(factor);
                    let watched = cover.observe(data.iter().copied(), &mut reductions);
                    assert_eq!(watched, cover.cover(data.iter().copied()));
                }
            }
        }
        assert!(reductions.0 > 500, "{}", reductions.0);
    }

    #[test]
    fn many_corners_take_few_trials() {
        let data = samples(Kind::Circle, 5000, 1);
        let cover = Cover::new(10).factor(1.0).cover(data).unwrap();
        assert!(cover.counts().into_iter().all(|count| count >= 10));
    }
}
